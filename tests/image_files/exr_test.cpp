// OpenEXR files: exact round trips, files of others, damaged files.

#include "render/image_files/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledRgbaFile.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "render/core/error.h"
#include "render/film/metrics.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/outside_tool.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

/// Every pixel and channel different, all exact in half precision: x + y/16, and its negative, and 64 more.
Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float value = float(x) + float(y) / 16.0f;
      image.at(x, y) = Rgb(value, -value, value + 64.0f);
    }
  return image;
}

std::vector<Imf::Rgba> toRgba(const Image& image) {
  std::vector<Imf::Rgba> result;
  for (Rgb p : image.pixels) result.emplace_back(p.x, p.y, p.z);
  return result;
}

bool sameBits(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb)) == 0;
}

/// The image as another program would write it: half floats, with the data window's corner at `origin`.
void writeHalf(const std::filesystem::path& path, const Image& image, Imf::RgbaChannels channels, Imath::V2i origin,
               Imath::Box2i display) {
  const Imath::Box2i window(origin, origin + Imath::V2i(image.width - 1, image.height - 1));
  const std::vector<Imf::Rgba> pixels = toRgba(image);
  Imf::RgbaOutputFile file(path.c_str(), display, window, channels);
  file.setFrameBuffer(pixels.data() - origin.x - std::ptrdiff_t(origin.y) * image.width, 1, std::size_t(image.width));
  file.writePixels(image.height);
}

/// The same with both windows where the image is.
void writeHalf(const std::filesystem::path& path, const Image& image, Imf::RgbaChannels channels) {
  writeHalf(path, image, channels, {0, 0}, {{0, 0}, {image.width - 1, image.height - 1}});
}

/// Channels of these names, each pixel 1.
void writeNamed(const std::filesystem::path& path, const std::vector<std::string>& names) {
  const std::vector<float> ones(4, 1.0f);
  Imf::Header header(2, 2);
  Imf::FrameBuffer frame;
  for (const std::string& name : names) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, ones.data(), header.dataWindow()));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(2);
}

void writeTiled(const std::filesystem::path& path, const Image& image) {
  const std::vector<Imf::Rgba> pixels = toRgba(image);
  Imf::TiledRgbaOutputFile file(path.c_str(), image.width, image.height, 8, 8, Imf::ONE_LEVEL);
  file.setFrameBuffer(pixels.data(), 1, std::size_t(image.width));
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

/// A pixel whose header states these colours.
void writeWithColours(const std::filesystem::path& path, const Imf::Chromaticities& colours) {
  const Imf::Rgba pixel(1.0f, 1.0f, 1.0f);
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, colours);
  Imf::RgbaOutputFile file(path.c_str(), header, Imf::WRITE_RGB);
  file.setFrameBuffer(&pixel, 1, 1);
  file.writePixels(1);
}

}  // namespace

TEST_CASE("An EXR keeps every bit of every float") {
  using Limits = std::numeric_limits<float>;
  Image image = gradient(37, 21);
  image.at(0, 0) = Rgb(Limits::denorm_min(), -0.0f, Limits::max());
  image.at(1, 0) = Rgb(Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity());
  image.at(2, 0) = Rgb(0.1f, 1.0f / 3.0f, 1e-30f);
  TemporaryFolder folder;
  writeExr(folder / "a.exr", image);
  CHECK(sameBits(readExr(folder / "a.exr"), image));
  CHECK(folder.entries() == 1);
}

TEST_CASE("Metadata comes back exactly, in alphabetical order") {
  const Metadata metadata = {{"capDate", "2024:02:29 12:00:00"},
                             {"comments", "a Cornell box; r² = 0.1 m²"},
                             {"alpha", 2.0 / 3.0},
                             {"iterations", std::int64_t(2147483647)},
                             {"mode", "sppm"},
                             {"seed", std::int64_t(-2147483648)}};
  Metadata expected = metadata;
  expected.push_back({"photons", "9007199254740993"});
  std::swap(expected[5], expected[6]);  // between mode and seed
  Metadata given = metadata;
  given.push_back({"photons", std::int64_t(9007199254740993)});  // 2⁵³ + 1 fits neither int nor double
  TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(2, 2), given);
  Metadata found = readExrMetadata(folder / "a.exr");
  std::erase_if(found, [](const auto& entry) {
    return entry.first == "pixelAspectRatio" || entry.first == "screenWindowWidth" || entry.first == "type";
  });
  CHECK(found == expected);
}

TEST_CASE("The EXR header says ZIP, 32-bit floats, Rec. 709 and names our settings") {
  TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(3, 2), {{"mode", "path"}, {"comments", "c"}});
  Imf::InputFile file((folder / "a.exr").c_str());
  const Imf::Header& header = file.header();
  CHECK(header.compression() == Imf::ZIP_COMPRESSION);
  for (const char* channel : {"R", "G", "B"}) {
    REQUIRE(header.channels().findChannel(channel) != nullptr);
    CHECK(header.channels().findChannel(channel)->type == Imf::FLOAT);
  }
  REQUIRE(Imf::hasChromaticities(header));
  CHECK(Imf::chromaticities(header).red == Imath::V2f(0.64f, 0.33f));
  CHECK(Imf::chromaticities(header).white == Imath::V2f(0.3127f, 0.3290f));
  CHECK(Imf::comments(header) == "c");
  CHECK(header.find("ropelight.mode") != header.end());
}

TEST_CASE("OpenEXR's own reader finds row 0 at the top and column 0 at the left") {
  TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(5, 4));
  Imf::RgbaInputFile file((folder / "a.exr").c_str());
  std::vector<Imf::Rgba> pixels(20);
  file.setFrameBuffer(pixels.data(), 1, 5);
  file.readPixels(0, 3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x) {
      const Imf::Rgba pixel = pixels[std::size_t(y * 5 + x)];
      CHECK(float(pixel.r) == float(x) + float(y) / 16.0f);
      CHECK(float(pixel.g) == -(float(x) + float(y) / 16.0f));
      CHECK(float(pixel.b) == float(x) + float(y) / 16.0f + 64.0f);
    }
}

TEST_CASE("Half floats and tiles read the same") {
  const Image image = gradient(19, 13);
  TemporaryFolder folder;
  writeHalf(folder / "half.exr", image, Imf::WRITE_RGBA, {0, 0}, {{0, 0}, {18, 12}});
  CHECK(sameBits(readExr(folder / "half.exr"), image));
  writeTiled(folder / "tiled.exr", image);
  CHECK(sameBits(readExr(folder / "tiled.exr"), image));
}

TEST_CASE("A data window is placed in its display window, black around it, and cut off outside it") {
  const Image image = gradient(6, 5);
  const Imath::Box2i display({-2, 10}, {7, 17});
  TemporaryFolder folder;
  for (const Imath::V2i& origin : {Imath::V2i(-2, 10), Imath::V2i(0, 12), Imath::V2i(-5, 8), Imath::V2i(4, 15),
                                   Imath::V2i(8, 10), Imath::V2i(-100, 500)}) {
    CAPTURE(origin.x);
    writeHalf(folder / "a.exr", image, Imf::WRITE_RGBA, origin, display);
    const Image read = readExr(folder / "a.exr");
    REQUIRE(read.width == 10);
    REQUIRE(read.height == 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 10; ++x) {
        const int dataX = x + display.min.x - origin.x, dataY = y + display.min.y - origin.y;
        const bool inside = dataX >= 0 && dataX < 6 && dataY >= 0 && dataY < 5;
        CHECK(read.at(x, y) == (inside ? image.at(dataX, dataY) : Rgb(0.0f)));
      }
  }
}

TEST_CASE("Equal pixels at different places differ, and display windows are sizes") {
  const Image image = gradient(2, 2);
  TemporaryFolder folder;
  writeHalf(folder / "a.exr", image, Imf::WRITE_RGB, {0, 0}, {{0, 0}, {3, 3}});
  writeHalf(folder / "b.exr", image, Imf::WRITE_RGB, {2, 2}, {{0, 0}, {3, 3}});
  CHECK(compareImages(readExr(folder / "a.exr"), readExr(folder / "b.exr")).mse > 1);
  writeHalf(folder / "c.exr", image, Imf::WRITE_RGB, {0, 0}, {{0, 0}, {3, 4}});
  CHECK_THROWS_AS(compareImages(readExr(folder / "a.exr"), readExr(folder / "c.exr")), Error);
}

TEST_CASE("Luminance alone reads as grey, and other sets of channels are refused by name") {
  Image image(4, 3);
  for (int x = 0; x < 4; ++x) image.at(x, 2) = Rgb(float(x));
  TemporaryFolder folder;
  writeHalf(folder / "y.exr", image, Imf::WRITE_Y);
  const Image grey = readExr(folder / "y.exr");
  CHECK(grey.at(3, 2).x == doctest::Approx(3.0f).epsilon(1e-3));
  CHECK(grey.at(3, 2).y == grey.at(3, 2).x);
  CHECK(grey.at(3, 2).z == grey.at(3, 2).x);
  CHECK(grey.at(3, 0).x == 0.0f);

  const auto refused = [&](Imf::RgbaChannels channels, const std::string& found) {
    writeHalf(folder / "odd.exr", image, channels);
    CHECK_THROWS_WITH_AS(readExr(folder / "odd.exr"),
                         ((folder / "odd.exr").string() + ": channels: expected R, G and B, or Y alone, found " +
                          found + "; write the image with these names")
                             .c_str(),
                         Error);
  };
  refused(Imf::RgbaChannels(Imf::WRITE_R | Imf::WRITE_G), "G, R");
  refused(Imf::WRITE_A, "A");
  writeHalf(folder / "chroma.exr", Image(4, 4), Imf::WRITE_YC);
  CHECK_THROWS_AS(readExr(folder / "chroma.exr"), Error);
}

TEST_CASE("X, Y and Z and channels of layers are refused by name; what is beside R, G and B is left out") {
  TemporaryFolder folder;
  const auto refused = [&](const std::vector<std::string>& names, const std::string& found) {
    writeNamed(folder / "a.exr", names);
    CHECK_THROWS_WITH_AS(readExr(folder / "a.exr"),
                         doctest::Contains(("expected R, G and B, or Y alone, found " + found + "; ").c_str()), Error);
  };
  refused({"X", "Y", "Z"}, "X, Y, Z");
  refused({"beauty.R", "beauty.G", "beauty.B"}, "beauty.B, beauty.G, beauty.R");
  refused({"Y", "Z"}, "Y, Z");
  std::vector<std::string> many;
  for (int i = 10; i < 50; ++i) many.push_back("c" + std::to_string(i));
  writeNamed(folder / "a.exr", many);
  CHECK_THROWS_WITH_AS(readExr(folder / "a.exr"), doctest::Contains(" and 16 more; "), Error);
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"Y", "A"}, {"R", "G", "B", "A", "Z", "beauty.R"}}) {
    writeNamed(folder / "a.exr", names);
    CHECK(readExr(folder / "a.exr").at(1, 1) == Rgb(1.0f));
  }
}

TEST_CASE("A large EXR is written in parts, tells how far it is, and keeps every bit") {
  TemporaryFolder folder;
  const Image image = gradient(33, 2000);
  std::vector<double> shares;
  writeExr(folder / "a.exr", image, {}, [&](double share) { shares.push_back(share); });
  CHECK(shares.size() > 1);
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() == 1);
  CHECK(sameBits(readExr(folder / "a.exr"), image));
}

TEST_CASE("An EXR that meets the end of the disk leaves what was there, wherever it fails") {
  TemporaryFolder folder;
  putBytes(folder / "old.exr", "precious");
  writeExr(folder / "whole.exr", gradient(64, 500));
  const auto whole = std::filesystem::file_size(folder / "whole.exr");
  for (std::uintmax_t room : {std::uintmax_t(0), std::uintmax_t(100), whole / 2, whole - 1}) {
    FileSizeLimit limit(room);
    CHECK_THROWS_AS(writeExr(folder / "old.exr", gradient(64, 500)), Error);
  }
  CHECK(fileBytes(folder / "old.exr") == "precious");
  CHECK(folder.entries() == 2);
}

TEST_CASE("Colours other than those of Rec. 709 are named, and a file that states none is taken as ours") {
  TemporaryFolder folder;
  const auto found = [&](const Imf::Chromaticities& colours) {
    writeWithColours(folder / "a.exr", colours);
    return foreignColours(folder / "a.exr");
  };
  using Imath::V2f;
  const Imf::Chromaticities ours;
  CHECK(found(ours).empty());
  CHECK(found({ours.red + V2f(0.0009f, 0), ours.green, ours.blue, ours.white - V2f(0, 0.0009f)}).empty());
  CHECK(found({ours.red, ours.green, ours.blue, ours.white + V2f(0, 0.0011f)}) ==
        "primaries (0.64 0.33) (0.3 0.6) (0.15 0.06), white (0.3127 0.3301)");
  CHECK(found({{0.680f, 0.320f}, {0.265f, 0.690f}, {0.150f, 0.060f}, {0.3127f, 0.3290f}}) ==  // P3 with D65
        "primaries (0.68 0.32) (0.265 0.69) (0.15 0.06), white (0.3127 0.329)");
  CHECK(found({{0.7347f, 0.2653f}, {0, 1}, {0.0001f, -0.0770f}, {0.32168f, 0.33767f}}) ==  // ACES 2065-1
        "primaries (0.7347 0.2653) (0 1) (0.0001 -0.077), white (0.32168 0.33767)");
  CHECK(!found({ours.red, ours.green, ours.blue, {std::numeric_limits<float>::quiet_NaN(), 0.329f}}).empty());

  writeHalf(folder / "silent.exr", gradient(2, 2), Imf::WRITE_RGB);
  CHECK(foreignColours(folder / "silent.exr").empty());
  writeExr(folder / "own.exr", gradient(2, 2));
  CHECK(foreignColours(folder / "own.exr").empty());
  CHECK_THROWS_AS(foreignColours(folder / "missing.exr"), Error);
}

TEST_CASE("Files that are missing, of another kind or cut short are refused") {
  TemporaryFolder folder;
  const std::string missing = (folder / "missing.exr").string();
  CHECK_THROWS_WITH_AS(readExr(missing),
                       (missing + ": cannot be opened: No such file or directory; give a readable .exr file").c_str(),
                       Error);
  putBytes(folder / "text.exr", "not a picture");
  CHECK_THROWS_AS(readExr(folder / "text.exr"), Error);
  CHECK_THROWS_AS(readExr(folder.path()), Error);

  writeExr(folder / "whole.exr", gradient(16, 40), {{"mode", "sppm"}});
  const std::string bytes = fileBytes(folder / "whole.exr");
  for (std::size_t length = 0; length < bytes.size(); length += length < bytes.size() - 20 ? 13 : 1) {
    putBytes(folder / "cut.exr", bytes.substr(0, length));
    CHECK_THROWS_AS_MESSAGE(readExr(folder / "cut.exr"), Error, "cut to " << length << " bytes");
  }
}

TEST_CASE("A header that claims too many pixels is refused before they are allocated") {
  TemporaryFolder folder;
  {
    Imf::Header header(30000, 30000);
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    Imf::OutputFile file((folder / "huge.exr").c_str(), header);
  }
  CHECK_THROWS_WITH_AS(readExr(folder / "huge.exr"),
                       ((folder / "huge.exr").string() +
                        ": dataWindow: 30000 x 30000 pixels, expected 1 to 268435456 in all; crop or shrink the image")
                           .c_str(),
                       Error);
}

TEST_CASE("An EXR that cannot be written leaves what was there") {
  TemporaryFolder folder;
  putBytes(folder / "old.exr", "precious");
  CHECK_THROWS_AS(writeExr(folder / "old.exr", Image()), Error);
  CHECK_THROWS_AS(writeExr(folder / "old.exr/out.exr", gradient(2, 2)), Error);
  CHECK(fileBytes(folder / "old.exr") == "precious");
  CHECK(folder.entries() == 1);
}

TEST_CASE("The shared reference image reads with its stated means") {
  const std::filesystem::path path =
      std::filesystem::path(ROPELIGHT_SHARED_DATA) / "references/box-spheres-diffuse.exr";
  if (!std::filesystem::exists(path)) {
    MESSAGE("skipped: no " << path.string());
    return;
  }
  const Image image = readExr(path);
  REQUIRE(image.width == 512);
  REQUIRE(image.height == 512);
  const Metrics metrics = compareImages(image, image);
  const double expected[] = {0.36065, 0.35793, 0.27986};
  for (std::size_t channel = 0; channel < 3; ++channel)
    CHECK(metrics.mean[channel] == doctest::Approx(expected[channel]).epsilon(2e-5));
}

TEST_CASE("oiiotool sees the EXR's pixels where we put them") {
  if (!toolOnPath("oiiotool")) {
    MESSAGE("skipped: oiiotool is not on PATH");
    return;
  }
  TemporaryFolder folder;
  writeExr(folder / "a.exr", gradient(3, 2));
  const std::string dump = toolOutput("oiiotool --dumpdata " + (folder / "a.exr").string());
  CHECK(dump.find("Pixel (0, 0): 0.000000000 -0.000000000 64.000000000") != std::string::npos);
  CHECK(dump.find("Pixel (2, 0): 2.000000000 -2.000000000 66.000000000") != std::string::npos);
  CHECK(dump.find("Pixel (0, 1): 0.062500000 -0.062500000 64.062500000") != std::string::npos);
}
