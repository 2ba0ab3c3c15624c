// `ropelight compare` against sums over the same numbers, and against OpenImageIO's idiff.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/film/flip.h"
#include "render/film/metrics.h"
#include "render/image_files/exr.h"
#include "tests/support/outside_tool.h"
#include "tests/support/program.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

struct Pair {
  Image image, reference;
};

/// Values over four decades, some negative, with noise of a fifth and a slight tint; the reference has the peak.
Pair noisyPair() {
  TestRandom random(2013);
  Pair pair{Image(61, 47), Image(61, 47)};
  for (std::size_t i = 0; i < pair.image.pixels.size(); ++i) {
    const Vec3d b = Vec3d(std::pow(10.0, random.between(-3, 1))) + random.inBox(0.05);
    pair.reference.pixels[i] = Rgb(b);
    pair.image.pixels[i] = Rgb(b * (Vec3d(1.02, 1.0, 0.99) + random.inBox(0.2)));
  }
  pair.reference.at(7, 5).y = 30.0f;
  return pair;
}

/// All digits but the last of the six that idiff prints; doctest's Approx is absolute for small numbers.
bool agreeToFiveDigits(double a, double b) { return std::abs(a - b) <= 1e-5 * std::abs(b); }

/// The figures as their definitions say, added up in the simplest way.
nlohmann::json simpleFigures(const Pair& pair) {
  std::vector<long double> relative;
  long double squares = 0, signedSum = 0, largest = 0, peak = 0, absolute = 0, power = 0;
  const long double values = 3 * pair.image.pixels.size();
  for (const Rgb& b : pair.reference.pixels)
    for (int c = 0; c < 3; ++c) power += (long double)b[c] * b[c], peak = std::max(peak, (long double)b[c]);
  for (std::size_t i = 0; i < pair.image.pixels.size(); ++i) {
    relative.push_back(0);
    for (int c = 0; c < 3; ++c) {
      const long double b = pair.reference.pixels[i][c], error = pair.image.pixels[i][c] - b;
      squares += error * error, signedSum += error, absolute += std::abs(error),
          largest = std::max(largest, std::abs(error));
      relative.back() += error * error / (b * b + 0.01L * power / values) / 3;
    }
  }
  std::sort(relative.begin(), relative.end());
  const auto meanOfFirst = [&](std::size_t n) {
    long double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += relative[i];
    return double(sum / n);
  };
  return {{"mse", double(squares / values)},
          {"rmse", double(std::sqrt(squares / values))},
          {"relmse", meanOfFirst(relative.size())},
          {"relmse-trimmed", meanOfFirst(relative.size() - 2)},  // 0.1% of 2867 pixels
          {"psnr", double(10 * std::log10(peak * peak * values / squares))},
          {"mean", double(signedSum / values)},
          {"max", double(largest)},
          {"epsilon", double(0.01L * power / values)},
          {"absolute", double(absolute / values)}};
}

/// What idiff prints behind a label.
double printed(const std::string& output, const std::string& label) {
  const std::size_t place = output.find(label);
  REQUIRE_MESSAGE(place != std::string::npos, output);
  return std::stod(output.substr(place + label.size()));
}

}  // namespace

TEST_CASE("idiff finds the same root mean square, peak and largest error") {
  const Pair pair = noisyPair();
  const Metrics metrics = compareImages(pair.image, pair.reference);
  const nlohmann::json simple = simpleFigures(pair);
  CHECK(agreeToFiveDigits(metrics.mse, simple["mse"]));
  if (!toolOnPath("idiff")) {
    MESSAGE("skipped: idiff (package openimageio-tools) is not installed");
    return;
  }
  TemporaryFolder folder;
  writeExr(folder / "a.exr", pair.image);
  writeExr(folder / "b.exr", pair.reference);
  const std::string output = toolOutput("idiff -a " + (folder / "a.exr").string() + " " + (folder / "b.exr").string());
  const double rms = printed(output, "RMS error = ");
  CHECK(agreeToFiveDigits(metrics.rmse, rms));
  CHECK(agreeToFiveDigits(std::sqrt(metrics.mse), rms));
  CHECK(agreeToFiveDigits(metrics.psnr, printed(output, "Peak SNR = ")));
  CHECK(agreeToFiveDigits(metrics.maxError, printed(output, "Max error  = ")));
  CHECK(agreeToFiveDigits(simple["absolute"], printed(output, "Mean error = ")));  // of |a − b|, unlike our mean
}

#ifdef ROPELIGHT_PROGRAM

namespace {

/// Runs `ropelight compare a.exr b.exr` in a folder with this pair.
int compareFiles(const TemporaryFolder& folder, const Pair& pair, const std::vector<std::string>& options) {
  writeExr(folder / "a.exr", pair.image);
  writeExr(folder / "b.exr", pair.reference);
  std::vector<std::string> arguments = {"compare", "a.exr", "b.exr"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return Program(ROPELIGHT_PROGRAM, arguments, folder.path()).exitCode();
}

}  // namespace

TEST_CASE("compare's JSON holds the sums over the files' numbers") {
  const Pair pair = noisyPair();
  TemporaryFolder folder;
  REQUIRE(compareFiles(folder, pair, {"--json", "c.json"}) == 0);
  const nlohmann::json found = nlohmann::json::parse(fileBytes(folder / "c.json")), simple = simpleFigures(pair);
  for (const char* name : {"mse", "rmse", "relmse", "relmse-trimmed", "psnr", "mean", "max", "epsilon"}) {
    CAPTURE(name);
    CHECK(agreeToFiveDigits(found[name], simple[name]));
  }
  CHECK(found["pixels"] == 61 * 47);
  CHECK(found["flip"] == flip(pair.image, pair.reference).mean);
}

TEST_CASE("compare takes FLIP for a threshold and writes its map") {
  const Pair pair = noisyPair();
  const FlipResult expected = flip(pair.image, pair.reference);
  TemporaryFolder folder;
  const auto exitCode = [&](double threshold) {
    return compareFiles(folder, pair,
                        {"--metric", "flip", "--threshold", std::to_string(threshold), "--flip-image", "map.exr"});
  };
  CHECK(exitCode(expected.mean + 0.001) == 0);
  CHECK(exitCode(expected.mean - 0.001) == 6);
  CHECK(readExr(folder / "map.exr").pixels == expected.map.pixels);
  CHECK(compareFiles(folder, pair, {"--flip-image", "map.jpg"}) == 3);
  CHECK(compareFiles(folder, pair, {"--flip-image", "missing/map.png"}) == 3);
}

#endif
