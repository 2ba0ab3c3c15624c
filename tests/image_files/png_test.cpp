// PNG files: what the encoder makes of every kind of row, and the colours that a file states.

#include "render/image_files/png.h"

#include <doctest/doctest.h>
#include <oneapi/tbb/global_control.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "render/image_files/image_file.h"
#include "render/image_files/png_colour.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

std::string bigEndian(std::uint32_t v) { return {char(v >> 24), char(v >> 16), char(v >> 8), char(v)}; }

std::string chunk(const std::string& type, const std::string& data) {
  std::string const body = type + data;
  auto const sum = crc32_z(0, reinterpret_cast<const Bytef*>(body.data()), body.size());
  return bigEndian(std::uint32_t(data.size())) + body + bigEndian(std::uint32_t(sum));
}

constexpr std::size_t behindHeader = 8 + 25, srgbBytes = 13;

/// Our file of one grey level of 128 with other chunks in the place of sRGB.
std::string fileWith(const std::string& chunks) {
  TemporaryFolder folder;
  std::vector<std::uint8_t> const grey(4 * 3 * 3, 128);
  writeScreenPng(folder / "a.png", 4, 3, grey);
  std::string bytes = fileBytes(folder / "a.png");
  REQUIRE(bytes.substr(behindHeader + 4, 4) == "sRGB");
  return bytes.replace(behindHeader, srgbBytes, chunks);
}

/// What the grey is read as.
float valueWith(const std::string& chunks) {
  TemporaryFolder folder;
  putBytes(folder / "a.png", fileWith(chunks));
  return readPng(folder / "a.png").at(3, 2).y;
}

std::string ignoredWith(const std::string& chunks) {
  TemporaryFolder folder;
  putBytes(folder / "a.png", fileWith(chunks));
  return ignoredColours(folder / "a.png");
}

std::string gammaChunk(std::uint32_t value) { return chunk("gAMA", bigEndian(value)); }

const float srgbGrey = float(decodeSrgb(128 / 255.0));

}  // namespace

TEST_CASE("A PNG gives back every byte, of rows of every kind and images of many parts") {
  TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 700), std::pair(700, 1), std::pair(1031, 1500)}) {
    std::vector<std::uint8_t> bytes(std::size_t(width) * std::size_t(height) * 3);
    std::uint32_t random = 1;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      random = random * 1664525u + 1013904223u;
      std::size_t const row = i / (std::size_t(width) * 3);
      // Noise, a constant, slopes along x, along y and along both: each is best by another filter.
      bytes[i] = std::uint8_t(row % 5 == 0   ? random >> 24
                              : row % 5 == 1 ? 77
                              : row % 5 == 2 ? i
                              : row % 5 == 3 ? row
                                             : i + row);
    }
    writeScreenPng(folder / "a.png", width, height, bytes);
    Image const image = readPng(folder / "a.png");
    REQUIRE(image.width == width);
    REQUIRE(image.height == height);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      wrong += image.pixels[i / 3][int(i % 3)] != float(decodeSrgb(bytes[i] / 255.0));
    CHECK(wrong == 0);
  }
}

TEST_CASE("A PNG has the same bytes for any number of threads, and tells how far it is") {
  TemporaryFolder folder;
  Image image(900, 1300);
  for (int y = 0; y < 1300; ++y)
    for (int x = 0; x < 900; ++x) image.at(x, y) = Rgb(float(x) / 900, float(y) / 1300, float((x * y) % 97) / 97);
  std::vector<double> shares;
  writePng(folder / "a.png", image, {}, [&](double share) { shares.push_back(share); });
  CHECK(shares.back() == 1);
  oneapi::tbb::global_control const one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  writePng(folder / "b.png", image);
  CHECK(fileBytes(folder / "a.png") == fileBytes(folder / "b.png"));
}

TEST_CASE("A PNG's gamma is heeded, but for one beside sRGB") {
  CHECK(valueWith(chunk("sRGB", std::string(1, '\0'))) == srgbGrey);
  CHECK(valueWith("") == srgbGrey);
  CHECK(valueWith(gammaChunk(100000)) == doctest::Approx(128 / 255.0).epsilon(1e-6));
  CHECK(valueWith(gammaChunk(45455)) == doctest::Approx(std::pow(128 / 255.0, 1 / 0.45455)).epsilon(1e-5));
  CHECK(valueWith(gammaChunk(100000) + chunk("sRGB", std::string(1, '\1'))) == srgbGrey);
  CHECK(valueWith(chunk("sRGB", std::string(1, '\1')) + gammaChunk(100000)) == srgbGrey);
  CHECK(valueWith(chunk("tEXt", "Title") + gammaChunk(100000)) == doctest::Approx(128 / 255.0).epsilon(1e-6));
}

TEST_CASE("What a PNG says of its colours beyond that is named") {
  std::string const rec709 = bigEndian(31270) + bigEndian(32900) + bigEndian(64000) + bigEndian(33000) +
                             bigEndian(30000) + bigEndian(60000) + bigEndian(15000) + bigEndian(6000);
  CHECK(ignoredWith("").empty());
  CHECK(ignoredWith(gammaChunk(45455) + chunk("cHRM", rec709)).empty());
  CHECK(ignoredWith(chunk("cHRM", bigEndian(31270) + bigEndian(32900) + bigEndian(68000) + rec709.substr(12))) ==
        "primaries other than Rec. 709's (cHRM)");
  CHECK(ignoredWith(chunk("iCCP", std::string("Dis\x1bplay P3\0\0xyz", 15))) == "its ICC profile \"Display P3\"");
  CHECK(ignoredWith(chunk("cICP", "\1\1\1\1")).find("cICP") != std::string::npos);
}

TEST_CASE("Damaged colour chunks are named and change nothing") {
  std::string broken = gammaChunk(100000);
  broken.back() ^= 1;
  for (const std::string& chunks : {broken, gammaChunk(0), chunk("gAMA", "abc"), chunk("gAMA", "")}) {
    CHECK(valueWith(chunks) == srgbGrey);
    CHECK(ignoredWith(chunks) == "a damaged gAMA chunk");
  }
}

TEST_CASE("No file, however broken, upsets the search for colours") {
  TemporaryFolder folder;
  std::string const whole = fileWith(gammaChunk(50000) + chunk("iCCP", std::string("a\0\0b", 4)));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    putBytes(folder / "a.png", whole.substr(0, length));
    CHECK_NOTHROW(readPngColour(folder / "a.png"));
  }
  for (std::size_t i = 8; i < std::min<std::size_t>(whole.size(), 120); ++i)
    for (int value : {0, 0x7f, 0xff}) {
      std::string bytes = whole;
      bytes[i] = char(value);
      putBytes(folder / "a.png", bytes);
      CHECK_NOTHROW(readPngColour(folder / "a.png"));
    }
  CHECK(readPngColour(folder / "none.png").ignored.empty());
  CHECK(readPngColour(folder.path()).ignored.empty());
}
