// The film's way to the screen: tone mapping, PNG, and files written whole or not at all.

#include "render/film/image.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <limits>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include "render/core/error.h"
#include "render/film/tonemap.h"
#include "render/image_files/atomic_file.h"
#include "render/image_files/image_file.h"
#include "render/image_files/png.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/outside_tool.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// The 8-bit level that a grey radiance is shown at.
int levelOf(float radiance, const Tonemap& tonemap = {}) {
  Image image(1, 1);
  image.at(0, 0) = Rgb(radiance);
  return toScreen(image, tonemap).bytes[0];
}

/// 3 × 2 pixels: red, green, blue above; white, grey 0.18, black below.
Image cornersImage() {
  Image image(3, 2);
  image.at(0, 0) = Rgb(1, 0, 0);
  image.at(1, 0) = Rgb(0, 1, 0);
  image.at(2, 0) = Rgb(0, 0, 1);
  image.at(0, 1) = Rgb(1, 1, 1);
  image.at(1, 1) = Rgb(0.18f);
  return image;
}

/// CRC-32 of PNG (3rd edition, annex D), bit by bit.
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = 0xffffffffu;
  for (unsigned char byte : bytes) {
    sum ^= byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ (sum & 1 ? 0xedb88320u : 0);
  }
  return ~sum;
}

}  // namespace

TEST_CASE("sRGB encodes the values of the standard's table") {
  CHECK(encodeSrgb(0.0) == 0.0);
  CHECK(encodeSrgb(0.0031308) == doctest::Approx(0.040449936).epsilon(1e-8));
  CHECK(encodeSrgb(0.0031309) == doctest::Approx(0.04045116).epsilon(1e-5));
  CHECK(encodeSrgb(0.18) == doctest::Approx(0.46135613).epsilon(1e-7));
  CHECK(encodeSrgb(0.5) == doctest::Approx(0.73535698).epsilon(1e-7));
  CHECK(encodeSrgb(1.0) == doctest::Approx(1.0).epsilon(1e-12));
  const float linear[] = {0.0f, 0.0031308f, 0.18f, 0.5f, 1.0f};
  const int level[] = {0, 10, 118, 188, 255};
  for (int i = 0; i < 5; ++i) CHECK(levelOf(linear[i]) == level[i]);
}

TEST_CASE("Decoding each of the 256 sRGB levels and encoding it again gives the level") {
  for (int level = 0; level < 256; ++level) CHECK(levelOf(float(decodeSrgb(level / 255.0))) == level);
}

TEST_CASE("Tone curves take the values of their formulas") {
  CHECK(levelOf(7.0f) == 255);
  CHECK(levelOf(-1.0f) == 0);
  CHECK(levelOf(1.0f, {ToneCurve::reinhard, 0}) == 188);   // 1/(1 + 1) = 0.5
  CHECK(levelOf(0.25f, {ToneCurve::reinhard, 2}) == 188);  // 0.25·2²
  CHECK(levelOf(1.0f, {ToneCurve::aces, 0}) == 232);       // 2.54/3.16 = 0.8038
  CHECK(levelOf(0.0f, {ToneCurve::aces, 0}) == 0);
  CHECK(levelOf(0.25f, {ToneCurve::linear, 1}) == 188);
  for (const std::string& name : toneCurveNames()) {
    const ToneCurve curve = toneCurveFromName(name);
    CHECK(levelOf(3e38f, {curve, 100}) == 255);
    CHECK(levelOf(3e38f, {curve, 0}) == 255);
    CHECK(levelOf(1.0f, {curve, -100}) == 0);
  }
}

TEST_CASE("Reinhard keeps the ratio of the channels") {
  Image image(1, 1);
  image.at(0, 0) = Rgb(0.4f, 0.2f, 0.1f);  // luminance 0.2126·0.4 + 0.7152·0.2 + 0.0722·0.1 = 0.2353
  const auto bytes = toScreen(image, {ToneCurve::reinhard, 0}).bytes;
  for (int channel = 0; channel < 3; ++channel)
    CHECK(bytes[std::size_t(channel)] == levelOf(image.at(0, 0)[channel] / 1.2353f));
}

TEST_CASE("An unknown tone curve and an exposure out of range are refused") {
  CHECK_THROWS_WITH_AS(toneCurveFromName("filmic"),
                       "tone curve 'filmic': expected linear, reinhard, aces; name one of them", Error);
  CHECK(toneCurveFromName("reinhard") == ToneCurve::reinhard);
  CHECK(toneCurveFromName("aces") == ToneCurve::aces);
  for (double stops : {101.0, -101.0, double(notANumber), double(infinity)})
    CHECK_THROWS_AS(toScreen(Image(1, 1), {ToneCurve::linear, stops}), Error);
}

TEST_CASE("Pixels that are not finite are shown black and counted") {
  Image image(4, 1);
  image.at(0, 0) = Rgb(notANumber, 1, 1);
  image.at(1, 0) = Rgb(1, infinity, 1);
  image.at(2, 0) = Rgb(1, 1, -infinity);
  image.at(3, 0) = Rgb(1, 1, 1);
  for (const std::string& name : toneCurveNames()) {
    const ScreenImage screen = toScreen(image, {toneCurveFromName(name), 4});
    CHECK(screen.nonFinite == 3);
    for (std::size_t i = 0; i < 9; ++i) CHECK(screen.bytes[i] == 0);
    for (std::size_t i = 9; i < 12; ++i) CHECK(screen.bytes[i] > 240);
  }
  TemporaryFolder folder;
  CHECK(writePng(folder / "a.png", image) == 3);
}

TEST_CASE("A PNG holds row 0 at the top and column 0 at the left") {
  TemporaryFolder folder;
  CHECK(writePng(folder / "corners.png", cornersImage()) == 0);
  int width = 0, height = 0, channels = 0;
  stbi_uc* data = stbi_load((folder / "corners.png").c_str(), &width, &height, &channels, 0);
  REQUIRE(data != nullptr);
  CHECK(width == 3);
  CHECK(height == 2);
  CHECK(channels == 3);
  const int expected[] = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 118, 118, 118, 0, 0, 0};
  for (int i = 0; i < 18; ++i) CHECK(int(data[i]) == expected[i]);
  stbi_image_free(data);
}

TEST_CASE("A PNG says that it is sRGB, with a correct checksum") {
  TemporaryFolder folder;
  writePng(folder / "a.png", cornersImage());
  const std::string bytes = fileBytes(folder / "a.png");
  const std::size_t type = bytes.find("sRGB");
  REQUIRE(type == 8 + 25 + 4);
  CHECK(bytes.substr(type - 4, 4) == std::string("\0\0\0\1", 4));
  std::uint32_t stored = 0;
  for (std::size_t i = 0; i < 4; ++i) stored = stored << 8 | std::uint8_t(bytes[type + 5 + i]);
  CHECK(stored == crc(bytes.substr(type, 5)));
  CHECK(bytes.find("IDAT") > type);
}

TEST_CASE("A PNG in memory has the bytes of the file") {
  TemporaryFolder folder;
  writePng(folder / "a.png", cornersImage(), {.exposure = 1});
  const std::vector<std::uint8_t> bytes = encodePng(cornersImage(), {.exposure = 1});
  CHECK(std::string(bytes.begin(), bytes.end()) == fileBytes(folder / "a.png"));
  CHECK_THROWS_AS(encodePng(Image()), Error);
}

TEST_CASE("A PNG reads back as linear values, in place") {
  TemporaryFolder folder;
  writePng(folder / "corners.PNG", cornersImage());
  const Image image = readImage(folder / "corners.PNG");
  REQUIRE(image.width == 3);
  REQUIRE(image.height == 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      for (int channel = 0; channel < 3; ++channel)
        CHECK(image.at(x, y)[channel] == doctest::Approx(cornersImage().at(x, y)[channel]).epsilon(0.01));
  CHECK(image.at(1, 1).x == float(decodeSrgb(118 / 255.0)));
}

TEST_CASE("oiiotool sees the PNG's pixels where we put them, and our reader sees oiiotool's 16 bits") {
  if (!toolOnPath("oiiotool")) {
    MESSAGE("skipped: oiiotool is not on PATH");
    return;
  }
  TemporaryFolder folder;
  writePng(folder / "corners.png", cornersImage());
  const std::string dump = toolOutput("oiiotool --dumpdata " + (folder / "corners.png").string());
  CHECK(dump.find("Pixel (0, 0): 255 0 0 ") != std::string::npos);
  CHECK(dump.find("Pixel (2, 0): 0 0 255 ") != std::string::npos);
  CHECK(dump.find("Pixel (0, 1): 255 255 255 ") != std::string::npos);
  CHECK(dump.find("Pixel (1, 1): 118 118 118 ") != std::string::npos);
  toolOutput("oiiotool --create 2x1 1 --fill:color=0.2001 2x1 -d uint16 -o " + (folder / "grey.png").string());
  const Image grey = readPng(folder / "grey.png");
  CHECK(grey.at(1, 0).x == doctest::Approx(decodeSrgb(0.2001)).epsilon(1e-4));
  CHECK(grey.at(1, 0).z == grey.at(1, 0).x);
}

TEST_CASE("What cannot be read as an image is refused by name") {
  TemporaryFolder folder;
  CHECK_THROWS_AS(readPng(folder / "missing.png"), Error);
  putBytes(folder / "text.png", "not a picture");
  CHECK_THROWS_AS(readPng(folder / "text.png"), Error);
  writePng(folder / "whole.png", Image(40, 40));
  const std::string bytes = fileBytes(folder / "whole.png");
  putBytes(folder / "cut.png", bytes.substr(0, bytes.size() / 2));
  CHECK_THROWS_AS(readPng(folder / "cut.png"), Error);
  CHECK_THROWS_WITH_AS(readImage("a.jpg"),
                       "a.jpg: unknown image format '.jpg'; expected a name that ends in .exr or .png", Error);
  CHECK_THROWS_AS(writeImage(folder / "png", Image(1, 1)), Error);
}

TEST_CASE("A file is replaced whole and leaves nothing beside it") {
  TemporaryFolder folder;
  writeFile(folder / "out", "first");
  CHECK(fileBytes(folder / "out") == "first");
  chmod((folder / "out").c_str(), 0640);
  writeFile(folder / "out", std::string("se\0cond", 7));
  CHECK(fileBytes(folder / "out") == std::string("se\0cond", 7));
  CHECK(folder.entries() == 1);
  struct stat status = {};
  REQUIRE(stat((folder / "out").c_str(), &status) == 0);
  CHECK((status.st_mode & 07777) == 0640);
}

TEST_CASE("Writing through a symbolic link changes the file and keeps the link") {
  TemporaryFolder folder;
  putBytes(folder / "file", "old");
  std::filesystem::create_symlink("file", folder / "link");
  writeFile(folder / "link", "new");
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(fileBytes(folder / "file") == "new");
}

TEST_CASE("A write that fails half-way leaves the old file and no other") {
  TemporaryFolder folder;
  putBytes(folder / "out.png", "precious");
  const std::string bytes(100000, 'x');
  {
    FileSizeLimit limit(4096);
    CHECK_THROWS_AS(writeFile(folder / "out.png", bytes), Error);
  }
  CHECK(fileBytes(folder / "out.png") == "precious");
  CHECK(folder.entries() == 1);
}

TEST_CASE("Paths that cannot be written are refused with the reason, before anything is touched") {
  TemporaryFolder folder;
  const std::string name = folder.path().string();
  CHECK_THROWS_WITH_AS(writeFile(folder.path(), "x"), (name + ": is a folder; name a file in it").c_str(), Error);
  CHECK_THROWS_WITH_AS(writePng(folder / "no/out.png", Image(1, 1)),
                       (name + "/no/out.png: there is no folder " + name + "/no; create it or name another").c_str(),
                       Error);
  CHECK_THROWS_AS(checkWritable(""), Error);
  CHECK_THROWS_WITH_AS(checkWritable("/dev/null"), "/dev/null: is not a regular file; name one, or a new file", Error);
  putBytes(folder / "file", "x");
  CHECK_THROWS_AS(checkWritable(folder / "file/out.png"), Error);
  CHECK_THROWS_AS(checkWritable(folder / std::string(256, 'n')), Error);
  CHECK_NOTHROW(checkWritable(folder / std::string(255, 'n')));
  std::filesystem::create_symlink("circle", folder / "circle");
  CHECK_THROWS_AS(checkWritable(folder / "circle"), Error);
  std::filesystem::remove(folder / "circle");
  CHECK_NOTHROW(checkWritable(folder / "new"));
  CHECK(folder.entries() == 1);
}

TEST_CASE("Write-protected files and folders are refused") {
  if (geteuid() == 0) {
    MESSAGE("skipped: root may write everywhere");
    return;
  }
  TemporaryFolder folder;
  putBytes(folder / "file", "old");
  chmod((folder / "file").c_str(), 0444);
  CHECK_THROWS_AS(writeFile(folder / "file", "new"), Error);
  chmod(folder.path().c_str(), 0555);
  CHECK_THROWS_AS(writeFile(folder / "other", "new"), Error);
  chmod(folder.path().c_str(), 0755);
  CHECK(fileBytes(folder / "file") == "old");
}
