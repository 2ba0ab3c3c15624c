// The oracle itself, against closed forms and against an outside renderer's published means.

#include "tests/oracle/oracle.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/oracle/scenes.h"

using namespace oracle;

namespace {

constexpr double pi = std::numbers::pi;

// Slow builds draw fewer samples; every tolerance follows from the variance.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
constexpr int samples(int full) { return full; }
constexpr double slack = 1;
#else
constexpr int samples(int full) { return full / 16 + 1; }
constexpr double slack = 4;
#endif

TileMean mean(Scene const& scene, int samplesPerPixel, int maxEdges = 0, Options options = {}) {
  std::vector<double> variance;
  std::vector<Rgb> const image = render(scene, samplesPerPixel, 7, maxEdges, options, &variance);
  return tileMeans(image, variance, scene.camera.width, std::max(scene.camera.width, scene.camera.height)).front();
}

/// Four standard deviations, which must themselves be below 1% of what is expected.
void checkMean(TileMean const& found, Rgb const& expected) {
  double const sigma = std::sqrt(found.variance);
  for (std::size_t c = 0; c < 3; ++c) {
    CAPTURE(c);
    CAPTURE(found.mean[c]);
    CAPTURE(expected[c]);
    CAPTURE(sigma);
    CHECK(std::abs(found.mean[c] - expected[c]) <= 4 * sigma + 1e-9 * expected[c]);
    CHECK(4 * sigma <= 0.01 * slack * expected[c]);
  }
}

Camera lookAt(Vec position, Vec target, double fov, int size = 1) {
  return {position, target, {0.1, 0.2, 0.97}, fov, size, size};
}

/// Closed sphere that emits inwards.
Scene furnace(Rgb const& albedo) {
  return {lookAt({0.2, 0.1, -0.3}, {0, 1, 0}, 60, 8),
          {{Sphere{{0, 0, 0}, 1.5}, Diffuse{albedo}, {{1, 1.5, 2}, Side::back}}}};
}

/// One pixel on a white floor at the origin, seen from low above it: its radiance is irradiance/π.
Scene floorUnder(std::vector<Shape> const& lights, Vec normalTilt = {0, 0, 1}) {
  Scene scene{lookAt({3, 1, 0.5}, {0, 0, 0}, 0.01), lights};
  Vec const n = normalTilt;
  scene.shapes.push_back({Parallelogram{{-1 * n.z, -1, n.x}, {2 * n.z, 0, -2 * n.x}, {0, 2, 0}}, Diffuse{{1, 1, 1}}});
  return scene;
}

/// Form factor from an element to a parallel rectangle a × b at distance h whose corner lies on the element's normal
/// (Siegel & Howell, Thermal Radiation Heat Transfer, appendix C).
double cornerFormFactor(double a, double b, double h) {
  double const x = a / h, y = b / h;
  double const rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * pi);
}

/// Angles in radians, other than 0 and beyond total reflection.
double fresnelReflectance(double i, double from, double to) {
  double const t = std::asin(std::sin(i) * from / to);
  double const s = std::sin(i - t) / std::sin(i + t), p = std::tan(i - t) / std::tan(i + t);
  return (s * s + p * p) / 2;
}

}  // namespace

TEST_CASE("oracle: a closed emitting sphere of albedo a holds Le/(1-a)") {
  Rgb const a{0.7, 0.6, 0.5};
  checkMean(mean(furnace(a), samples(8000)), {1 / (1 - a[0]), 1.5 / (1 - a[1]), 2 / (1 - a[2])});
}

TEST_CASE("oracle: the furnace falls apart by path length and into direct and indirect light") {
  Scene const scene = furnace({0.5, 0.5, 0.5});
  auto const times = [](double factor) { return Rgb{factor, 1.5 * factor, 2 * factor}; };
  checkMean(mean(scene, samples(4000), 1), times(1));
  checkMean(mean(scene, samples(4000), 2), times(1.5));
  checkMean(mean(scene, samples(4000), 8), times(2 - 1.0 / 128));
  checkMean(mean(scene, samples(4000), 0, {.directOnly = true}), times(1.5));
  checkMean(mean(scene, samples(4000), 0, {.indirectOnly = true}), times(0.5));
}

TEST_CASE("oracle: direct and indirect light sum to the whole, sample by sample") {
  Scene const scene = boxSpheresDiffuse(24, 24);
  auto const whole = render(scene, 16, 3);
  auto const direct = render(scene, 16, 3, 0, {.directOnly = true});
  auto const indirect = render(scene, 16, 3, 0, {.indirectOnly = true});
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      double const sum = direct[i][c] + indirect[i][c];
      CHECK(std::abs(sum - whole[i][c]) <= 1e-9 * (1 + whole[i][c]));
    }
}

TEST_CASE("oracle: a rectangle lights a parallel floor by its form factor") {
  double const f = cornerFormFactor(0.5, 0.4, 1) + cornerFormFactor(0.5, 0.3, 1) + cornerFormFactor(0.2, 0.4, 1) +
                   cornerFormFactor(0.2, 0.3, 1);
  Vec const p{-0.2, -0.3, 1}, q{-0.2, 0.4, 1}, r{0.5, 0.4, 1}, s{0.5, -0.3, 1};
  Emission const emission{{5, 5.5, 6}};
  Rgb const expected{5 * f, 5.5 * f, 6 * f};
  Shape const whole{Parallelogram{p, {0, 0.7, 0}, {0.7, 0, 0}}, Diffuse{}, emission};
  Shape const half1{Triangle{p, q, r}, Diffuse{}, emission}, half2{Triangle{p, r, s}, Diffuse{}, emission};
  checkMean(mean(floorUnder({whole}), samples(50000)), expected);
  checkMean(mean(floorUnder({half1, half2}), samples(50000)), expected);

  SUBCASE("and from behind not at all") {
    Shape const away{Parallelogram{p, {0.7, 0, 0}, {0, 0.7, 0}}, Diffuse{}, emission};
    CHECK(mean(floorUnder({away}), 1000).mean == Rgb{0, 0, 0});
  }
  SUBCASE("as a caustic, and thus indirectly, through an interface that bends nothing") {
    Shape const film{Parallelogram{{-50, -50, 0.9}, {100, 0, 0}, {0, 100, 0}}, Dielectric{1}};
    Scene const scene = floorUnder({whole, film});
    checkMean(mean(scene, samples(2000000), 0, {.indirectOnly = true}), expected);
    CHECK(mean(scene, 1000, 0, {.directOnly = true}).mean == Rgb{0, 0, 0});
  }
}

TEST_CASE("oracle: a sphere light lights a tilted floor by L (R/d)^2 cos") {
  Vec const normal{0.6, 0, 0.8};
  Shape const light{Sphere{{0, 0, 2}, 0.5}, Diffuse{}, {{20, 25, 30}}};
  double const f = 0.5 * 0.5 / 4 * 0.8;
  checkMean(mean(floorUnder({light}, normal), samples(2500000)), {20 * f, 25 * f, 30 * f});
}

TEST_CASE("oracle: a mirror shows its reflectance times the light") {
  Scene const scene{lookAt({2, 0, 1}, {0, 0, 0}, 1),
                    {{Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, Mirror{{0.9, 0.5, 0.2}}},
                     {Sphere{{-2, 0, 1}, 0.3}, Diffuse{}, {{1, 2, 3}}}}};
  checkMean(mean(scene, 100), {0.9, 1, 0.6});
}

TEST_CASE("oracle: a glass slab transmits the sum over its inner reflections") {
  double const angle = 0.9;
  Rgb const t{0.9, 0.8, 0.7};
  Dielectric const glass{1.5, {0.6, 0.8, 1}, t};
  Scene const scene{lookAt({3 * std::sin(angle), 0, 3 * std::cos(angle)}, {0, 0, 0}, 1e-3),
                    {{Parallelogram{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, glass},
                     {Parallelogram{{-9, -9, -0.2}, {0, 18, 0}, {18, 0, 0}}, glass},
                     {Parallelogram{{-9, -9, -1}, {18, 0, 0}, {0, 18, 0}}, Diffuse{}, {{1, 1, 1}}}}};
  double const r = fresnelReflectance(angle, 1, 1.5);
  Rgb expected;
  for (std::size_t c = 0; c < 3; ++c) {
    double const inner = r * glass.reflectance[c];
    expected[c] = t[c] * t[c] * (1 - r) * (1 - r) / (1 - inner * inner);
  }
  checkMean(mean(scene, samples(200000)), expected);
}

TEST_CASE("oracle: radiance grows by the squared index when it enters a denser medium, and falls when it leaves") {
  double const angle = 0.5;
  auto const seenThrough = [&](bool fromInside) {
    double const up = fromInside ? -1 : 1;
    return Scene{lookAt({3 * std::sin(angle), 0, 3 * up * std::cos(angle)}, {0, 0, 0}, 1e-3),
                 {{Parallelogram{{-9, -9, 0}, {18, 0, 0}, {0, 18, 0}}, Dielectric{1.5}},
                  {Parallelogram{{-9, -9, -up}, {18, 0, 0}, {0, 18, 0}}, Diffuse{}, {{1, 1, 1}, Side::both}}}};
  };
  double const entering = 2.25 * (1 - fresnelReflectance(angle, 1.5, 1));
  double const leaving = (1 - fresnelReflectance(angle, 1, 1.5)) / 2.25;
  checkMean(mean(seenThrough(true), samples(40000)), {entering, entering, entering});
  checkMean(mean(seenThrough(false), samples(40000)), {leaving, leaving, leaving});
}

TEST_CASE("oracle: a pool in equilibrium shows the same radiance everywhere") {
  Scene scene = pool(8, 8);
  double const squared = 1.33 * 1.33;
  scene.shapes = {scene.shapes[6]};
  auto const wall = [&](Vec corner, Vec edge1, Vec edge2, double radiance) {
    double const emitted = radiance * (1 - 0.5);
    scene.shapes.push_back(
        {Parallelogram{corner, edge1, edge2}, Diffuse{{0.5, 0.5, 0.5}}, {{emitted, emitted, emitted}, Side::both}});
  };
  auto const sides = [&](double low, double high, double radiance) {
    wall({-1, low, -1}, {2, 0, 0}, {0, high - low, 0}, radiance);
    wall({-1, low, 1}, {2, 0, 0}, {0, high - low, 0}, radiance);
    wall({-1, low, -1}, {0, 0, 2}, {0, high - low, 0}, radiance);
    wall({1, low, -1}, {0, 0, 2}, {0, high - low, 0}, radiance);
  };
  sides(0, 0.6, squared);
  sides(0.6, 2, 1);
  wall({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}, squared);
  wall({-1, 2, -1}, {2, 0, 0}, {0, 0, 2}, 1);
  checkMean(mean(scene, samples(10000)), {1, 1, 1});
}

TEST_CASE("oracle: row 0 is the top and column 0 the left") {
  Scene const scene{{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 60, 4, 2},
                    {{Parallelogram{{-9, 0, 0}, {9, 0, 0}, {0, 9, 0}}, Diffuse{}, {{1, 1, 1}}}}};
  auto const image = render(scene, 16, 1);
  for (std::size_t i = 0; i < image.size(); ++i) CHECK(image[i][0] == (i < 2 ? 1 : 0));
}

TEST_CASE("oracle: a thin lens blurs an edge by its circle of confusion") {
  double const offset = 0.04;
  Scene scene{{{0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 1e-3, 1, 1, 0.2, 3},
              {{Parallelogram{{offset, -9, 0}, {9, 0, 0}, {0, 18, 0}}, Diffuse{}, {{1, 1, 1}}}}};
  double const x = offset / (0.2 * (4 - 3) / 3);
  double const covered = (std::acos(x) - x * std::sqrt(1 - x * x)) / pi;
  checkMean(mean(scene, samples(2000000)), {covered, covered, covered});
  scene.camera.focus = 0;
  CHECK(mean(scene, 1000).mean == Rgb{0, 0, 0});
}

TEST_CASE("oracle: the variance that it states is the one between seeds") {
  Scene scene = furnace({0.6, 0.6, 0.6});
  scene.camera.width = scene.camera.height = 32;
  std::vector<double> varianceA, varianceB;
  auto const a = render(scene, 64, 1, 0, {}, &varianceA);
  auto const b = render(scene, 64, 2, 0, {}, &varianceB);
  double ratio = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    ratio += std::pow(a[i][2] - b[i][2], 2) / (varianceA[i] + varianceB[i]) / static_cast<double>(a.size());
  CHECK(ratio == doctest::Approx(1).epsilon(0.2));
}

TEST_CASE("oracle: the image depends on the seed and not on the threads") {
  Scene const scene = diffuseBox(16, 16);
  auto const image = render(scene, 8, 1, 0, {.threads = 1});
  CHECK(image == render(scene, 8, 1, 0, {.threads = 3}));
  CHECK(image != render(scene, 8, 2, 0, {.threads = 1}));
}

TEST_CASE("oracle: tiles average their own pixels") {
  std::vector<Rgb> const image{{1, 0, 0}, {3, 0, 0}, {5, 0, 0}, {7, 0, 0}, {9, 0, 0}, {11, 0, 0}};
  auto const tiles = tileMeans(image, {4, 4, 8, 4, 4, 8}, 3, 2);
  REQUIRE(tiles.size() == 2);
  CHECK(tiles[0].mean[0] == 5);
  CHECK(tiles[0].variance == 1);
  CHECK(tiles[1].mean[0] == 8);
  CHECK(tiles[1].variance == 4);
}

TEST_CASE("oracle: what cannot be rendered is refused") {
  Scene const good = diffuseBox(2, 2);
  Scene flat = good, blind = good;
  flat.shapes.push_back({Triangle{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, Diffuse{}});
  blind.camera.target = blind.camera.position;
  CHECK_THROWS_AS(render(flat, 2, 1), std::invalid_argument);
  CHECK_THROWS_AS(render(blind, 2, 1), std::invalid_argument);
  CHECK_THROWS_AS(render(good, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(render(good, 2, 1, 0, {.directOnly = true, .indirectOnly = true}), std::invalid_argument);
}

TEST_CASE("oracle: the box with spheres has the outside reference's mean") {
  TileMean const found = mean(boxSpheresDiffuse(64, 64), samples(1536));
  Rgb const reference{0.36065, 0.35793, 0.27986};
  double const sigma = std::sqrt(found.variance);
  MESSAGE("mean " << found.mean[0] << " " << found.mean[1] << " " << found.mean[2] << ", sigma " << sigma);
  for (std::size_t c = 0; c < 3; ++c) {
    CAPTURE(c);
    CHECK(std::abs(found.mean[c] - reference[c]) <= 3 * sigma + 0.001 * reference[c]);
  }
  CHECK(3 * sigma <= 0.005 * slack * reference[1]);
}
