// FLIP against values worked by hand, and against its filters in two dimensions as the paper states them.

#include "render/film/flip.h"

#include <doctest/doctest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "render/core/error.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

using std::numbers::pi;

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

Image filled(int width, int height, Rgb colour) {
  Image image(width, height);
  for (Rgb& pixel : image.pixels) pixel = colour;
  return image;
}

/// Columns from `edge` on are white, the others black.
Image step(int width, int height, int edge) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = edge; x < width; ++x) image.at(x, y) = Rgb(1.0f);
  return image;
}

/// Noise on two bright and dark halves, partly beyond what a screen shows.
Image noisy(int width, int height, std::uint32_t seed) {
  TestRandom random(seed);
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double base = 3 * x > width + 2 * y ? 0.8 : 0.1;
      image.at(x, y) = Rgb(Vec3d(base) * (0.6 + 0.5 * random.unit()) + random.inBox(0.15));
    }
  return image;
}

/// The colours once more. The matrix is the published one for Rec. 709 and D65, in fractions of whole numbers.
Vec3d relativeXyz(Vec3d c) {
  const Vec3d white(23359437.0 / 24577794, 1, 80288307.0 / 73733382);  // the rows' sums
  return Vec3d(10135552 * c.x + 8788810 * c.y + 4435075 * c.z, 2 * (2613072 * c.x + 8788810 * c.y + 887015 * c.z),
               (1425312 * c.x + 8788810 * c.y + 70074185 * c.z) / 3) /
         24577794.0 / white;
}

Vec3d opponents(Vec3d w) { return {116 * w.y - 16, 500 * (w.x - w.y), 200 * (w.y - w.z)}; }

Vec3d huntLab(Vec3d rgb) {
  Vec3d w = relativeXyz(rgb);
  for (int i = 0; i < 3; ++i) w[i] = w[i] > 216.0 / 24389.0 ? std::cbrt(w[i]) : (24389.0 / 27.0 * w[i] + 16) / 116;
  const Vec3d lab = opponents(w);
  return {lab.x, lab.x * lab.y / 100, lab.x * lab.z / 100};
}

double hyab(Vec3d a, Vec3d b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// The colour difference from a HyAB distance.
double remapped(double distance) {
  const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), 0.7), d = std::pow(distance, 0.7);
  return d < 0.4 * largest ? 0.95 / 0.4 * d / largest : 0.95 + 0.05 * (d / largest - 0.4) / 0.6;
}

/// Convolves in two dimensions, pixel by pixel; edges go on. `part` picks what is summed.
double convolve(const Image& image, int x, int y, int radius, const std::function<double(Rgb)>& part,
                const std::function<double(int, int)>& weight) {
  double sum = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx)
      sum += weight(dx, dy) *
             part(image.at(std::clamp(x + dx, 0, image.width - 1), std::clamp(y + dy, 0, image.height - 1)));
  return sum;
}

Vec3d shown(Rgb c) { return glm::clamp(Vec3d(c), 0.0, 1.0); }

/// The Hunt-adjusted colour that is seen at a pixel.
Vec3d seenColour(const Image& image, int x, int y, double perDegree) {
  const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * perDegree));
  const auto gauss = [&](double a, double b, int dx, int dy) {
    return a * std::sqrt(pi / b) * std::exp(-pi * pi * (dx * dx + dy * dy) / (perDegree * perDegree * b));
  };
  const std::function<double(int, int)> filters[] = {
      [&](int dx, int dy) { return gauss(1, 0.0047, dx, dy); },
      [&](int dx, int dy) { return gauss(1, 0.0053, dx, dy); },
      [&](int dx, int dy) { return gauss(34.1, 0.04, dx, dy) + gauss(13.5, 0.025, dx, dy); }};
  Vec3d c;
  for (int i = 0; i < 3; ++i) {
    const double total = convolve(
        image, x, y, radius, [](Rgb) { return 1.0; }, filters[i]);
    const auto part = [i](Rgb rgb) { return opponents(relativeXyz(shown(rgb)))[i]; };
    c[i] = convolve(image, x, y, radius, part, filters[i]) / total;
  }
  const double luminance = (c.x + 16) / 116;
  const Vec3d w(luminance + c.y / 500, luminance, luminance - c.z / 200);
  const Mat3d columns(relativeXyz({1, 0, 0}), relativeXyz({0, 1, 0}), relativeXyz({0, 0, 1}));
  return huntLab(glm::clamp(glm::inverse(columns) * w, 0.0, 1.0));
}

/// How strong an edge (or a point) is at a pixel.
double seenFeature(const Image& image, int x, int y, double perDegree, bool point) {
  const double s = 0.041 * perDegree;
  const int radius = int(std::ceil(3 * s));
  const auto weight = [&](int along, int across) {
    return (point ? along * along / (s * s) - 1 : -along) * std::exp(-(along * along + across * across) / (2 * s * s));
  };
  double positive = 0, negative = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) (weight(dx, dy) > 0 ? positive : negative) += std::abs(weight(dx, dy));
  const auto scaled = [&](double w) { return w / (w > 0 ? positive : negative); };
  const auto luminance = [](Rgb rgb) { return relativeXyz(shown(rgb)).y; };
  return std::hypot(convolve(image, x, y, radius, luminance, [&](int dx, int dy) { return scaled(weight(dx, dy)); }),
                    convolve(image, x, y, radius, luminance, [&](int dx, int dy) { return scaled(weight(dy, dx)); }));
}

double directFlip(const Image& a, const Image& b, int x, int y, double perDegree) {
  const double colour = remapped(hyab(seenColour(a, x, y, perDegree), seenColour(b, x, y, perDegree)));
  double feature = 0;
  for (bool point : {false, true})
    feature =
        std::max(feature, std::abs(seenFeature(a, x, y, perDegree, point) - seenFeature(b, x, y, perDegree, point)));
  return std::pow(colour, 1 - std::sqrt(feature / std::sqrt(2.0)));
}

}  // namespace

TEST_CASE("FLIP of equal images is 0, also for what a screen shows alike") {
  const Image image = noisy(31, 17, 1);
  CHECK(flip(image, image).mean == 0.0);
  Image clamped = image;
  for (Rgb& pixel : clamped.pixels) pixel = glm::clamp(pixel, 0.0f, 1.0f);
  CHECK(flip(image, clamped).mean == 0.0);
  CHECK(flip(filled(3, 3, Rgb(1e30f)), filled(3, 3, Rgb(1.0f))).mean == 0.0);
}

TEST_CASE("FLIP of two plain colours is their remapped HyAB distance") {
  const Rgb colours[] = {Rgb(0, 0, 0),          Rgb(1, 1, 1),          Rgb(1, 0, 0),      Rgb(0.2f, 0.2f, 0.2f),
                         Rgb(0.8f, 0.4f, 0.1f), Rgb(0.8f, 0.4f, 0.2f), Rgb(0, 0.005f, 0), Rgb(0.5f, 0.01f, 1)};
  for (Rgb a : colours)
    for (Rgb b : colours) {
      const FlipResult result = flip(filled(5, 4, a), filled(5, 4, b));
      const double expected = remapped(hyab(huntLab(Vec3d(a)), huntLab(Vec3d(b))));
      // The feature term's root makes 10⁻⁹ of the filters' rounding.
      CHECK(result.mean == doctest::Approx(expected).epsilon(1e-8));
      for (Rgb pixel : result.map.pixels) CHECK(pixel == Rgb(float(result.mean)));
    }
}

TEST_CASE("FLIP of green and blue, the most different colours, is 1, and of black and white 0.9674") {
  CHECK(flip(filled(2, 2, Rgb(0, 1, 0)), filled(2, 2, Rgb(0, 0, 1))).mean == doctest::Approx(1.0).epsilon(1e-12));
  // HyAB is 100, all of it lightness: 100^0.7 = 25.1189 of at most 41.276, past the knee at 16.510.
  CHECK(flip(Image(2, 2), filled(2, 2, Rgb(1.0f))).mean == doctest::Approx(0.9674).epsilon(1e-4));
}

TEST_CASE("An edge where the other image has none counts by the feature term") {
  // With 66 pixels a degree the lightness filter's middle weight is 0.39172750 (J. Ong 2022, "Implementing the FLIP
  // algorithm", sy_kernel), so the filtered luminance beside the edge is (1 ± 0.3917275)/2. There the edge filter,
  // whose halves weigh 1 and −1, finds 1; the point filter finds less. So the colour's power is 1 − √(1/√2).
  const FlipResult result = flip(step(64, 20, 32), Image(64, 20), 66.0);
  const auto expected = [](double luminance) {
    return std::pow(remapped(116.0 * std::cbrt(luminance) - 16.0), 1.0 - std::pow(2.0, -0.25));
  };
  CHECK(result.map.at(32, 9).x == doctest::Approx(expected(0.5 + 0.5 * 0.39172750)).epsilon(1e-5));
  CHECK(result.map.at(31, 9).x == doctest::Approx(expected(0.5 - 0.5 * 0.39172750)).epsilon(1e-5));
  CHECK(result.map.at(0, 9).x == doctest::Approx(0.0).epsilon(1e-6));
  CHECK(result.map.at(63, 9).x == doctest::Approx(remapped(100.0)).epsilon(1e-5));
}

TEST_CASE("The separated filters agree with those in two dimensions") {
  const Image a = noisy(33, 21, 2), b = noisy(33, 21, 3);
  for (double perDegree : {defaultPixelsPerDegree, 25.0}) {
    const FlipResult result = flip(a, b, perDegree);
    for (auto [x, y] : {std::pair(0, 0), {32, 20}, {16, 10}, {9, 2}, {2, 19}, {31, 1}})
      CHECK(result.map.at(x, y).x == doctest::Approx(directFlip(a, b, x, y, perDegree)).epsilon(1e-7));
  }
}

TEST_CASE("FLIP is symmetric, within 0 to 1, and the mean of its map, for any number of threads") {
  const Image a = noisy(40, 30, 4), b = noisy(40, 30, 5);
  const FlipResult result = flip(a, b);
  double sum = 0;
  for (Rgb pixel : result.map.pixels) {
    CHECK((pixel.x >= 0.0f && pixel.x <= 1.0f));
    CHECK((pixel.x == pixel.y && pixel.x == pixel.z));
    sum += pixel.x;
  }
  CHECK(result.mean > 0.0);
  CHECK(result.mean == doctest::Approx(sum / 1200.0).epsilon(1e-6));
  CHECK(flip(b, a).mean == result.mean);
  const oneapi::tbb::global_control alone(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  CHECK(flip(a, b).map.pixels == result.map.pixels);
}

TEST_CASE("A pixel that is not finite counts as 1 and is black to its neighbours") {
  Image a(6, 5);
  a.at(2, 3).y = notANumber;
  a.at(5, 0) = Rgb(std::numeric_limits<float>::infinity());
  const FlipResult result = flip(a, Image(6, 5));
  CHECK(result.mean == 2.0 / 30.0);
  CHECK(result.map.at(2, 3) == Rgb(1.0f));
  CHECK(result.map.at(5, 0) == Rgb(1.0f));
  CHECK(flip(Image(6, 5), a).mean == result.mean);

  Image white = filled(6, 5, Rgb(1.0f)), hole = white;
  hole.at(3, 2) = Rgb(0.0f);
  const Image reference = flip(hole, white).map;
  hole.at(3, 2).z = -notANumber;
  Image map = flip(hole, white).map;
  CHECK(map.at(3, 2) == Rgb(1.0f));
  map.at(3, 2) = reference.at(3, 2);
  CHECK(map.pixels == reference.pixels);
}

TEST_CASE("FLIP refuses images of different sizes, and takes those of a pixel and of none") {
  CHECK_THROWS_WITH_AS(flip(Image(3, 2), Image(2, 3)),
                       "the images differ in size: 3 x 2 and 2 x 3 pixels; compare images of the same film size",
                       Error);
  CHECK(flip(filled(1, 1, Rgb(0, 1, 0)), filled(1, 1, Rgb(0, 0, 1))).mean == doctest::Approx(1.0));
  CHECK(std::isnan(flip(Image(), Image()).mean));
}
