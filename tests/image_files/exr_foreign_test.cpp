// OpenEXR files of other programs: what is read of them, and what is refused.

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "render/core/error.h"
#include "render/film/metrics.h"
#include "render/image_files/exr.h"
#include "tests/image_files/exr_files.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

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
