// OpenEXR files: exact round trips, and writing that fails.

#include "render/image_files/exr.h"

#include <ImfChannelList.h>
#include <ImfInputFile.h>
#include <ImfRgbaFile.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "render/core/error.h"
#include "render/film/metrics.h"
#include "tests/image_files/exr_files.h"
#include "tests/support/file_size_limit.h"
#include "tests/support/outside_tool.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

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
