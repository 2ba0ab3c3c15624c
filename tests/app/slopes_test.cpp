// The rates at which path and sppm converge, measured: N^−1 for the variance and squared error of path; N^−α for the
// variance and N^−(1−α) for the bias of sppm's indirect light (Knaus and Zwicker 2011).

#include <doctest/doctest.h>

#include "tests/support/slopes.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

// Halves of the edges of horizontal squares around the y axis.
constexpr double floorHalf = 1.5;
constexpr double lampHalf = 0.2;
constexpr double reflectorHalf = 0.7;
constexpr double filmHalf = 0.6;  ///< what the film sees of the floor

ShapeDesc& addSquare(Scene& scene, double half, double y, double up) {
  return addQuad(scene, {-half, y, -half * up}, {0, 0, 2 * half * up}, {2 * half, 0, 0});
}

/// A lamp lying on a floor shines at a reflector one unit above: on the floor its light is a bump of strong curvature,
/// and none of it is direct. The lamp reflects as the floor does and is far thinner than any disc, so photons meet no
/// edge nearer to the film's points than the floor's.
Scene lampOnFloor() {
  Scene scene = emptyScene(1);
  addSquare(scene, floorHalf, 0, 1);
  addSquare(scene, lampHalf, 1e-5, 1).emission = Emission{Rgb(1), Side::out};
  addSquare(scene, reflectorHalf, 1, -1);
  lookAt(scene, {0, 0.9, 0}, {0, 0, 0}, {0, 0, 1}, 2 * std::atan(filmHalf / 0.9) * 180 / M_PI);
  return scene;
}

/// Light, reflector, floor, camera and nothing else, so that the truth is one integral.
Settings oneBounce(Mode mode, int edge) {
  Settings s = settingsFor(mode, edge, edge);
  s.maxDepth = 3;
  s.indirectOnly = true;
  s.sampler = SamplerKind::independent;
  return s;
}

Settings photons(int edge, double alpha, double radius, std::uint64_t count) {
  Settings s = oneBounce(Mode::sppm, edge);
  s.alpha = alpha;
  s.radius = radius;
  s.photons = count;
  s.cellSize = 4;
  return s;
}

struct Node {
  double x, weight;
};

/// Gauss and Legendre's rule of three nodes on each of `cells` parts of [−half, half].
std::vector<Node> nodesOf(double half, int cells) {
  std::vector<Node> nodes;
  double const h = half / cells;
  for (int c = 0; c < cells; ++c)
    for (int k = -1; k <= 1; ++k)
      nodes.push_back({-half + (2 * c + 1 + k * std::sqrt(0.6)) * h, (k == 0 ? 8.0 : 5.0) / 9 * h});
  return nodes;
}

/// Irradiance over π L above the corner of a parallel rectangle a × b at distance 1 (Howell's configuration C-11), odd
/// in a and b.
double cornerFactor(double a, double b) {
  double const p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * M_PI);
}

/// The same above the lamp.
double lampFactor(double x, double z) {
  double const x0 = -lampHalf - x, x1 = lampHalf - x, z0 = -lampHalf - z, z1 = lampHalf - z;
  return cornerFactor(x1, z1) - cornerFactor(x0, z1) - cornerFactor(x1, z0) + cornerFactor(x0, z0);
}

/// Radiance of the floor at (x, z) by one reflection.
double radianceAt(double x, double z) {
  static std::vector<Node> const nodes = nodesOf(reflectorHalf, 8);
  double sum = 0;
  for (Node a : nodes)
    for (Node b : nodes) {
      double const d2 = (x - a.x) * (x - a.x) + (z - b.x) * (z - b.x) + 1;
      sum += a.weight * b.weight * lampFactor(a.x, b.x) / (d2 * d2);
    }
  return sum / M_PI;
}

/// Mean radiance of each of edge × edge pixels.
std::vector<double> truthOf(int edge) {
  std::vector<Node> const nodes = nodesOf(filmHalf, edge);
  std::size_t const n = std::size_t(edge);
  double const area = 4 * filmHalf * filmHalf / double(n * n);
  std::vector<double> pixels(n * n);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      pixels[i / 3 * n + j / 3] += nodes[i].weight * nodes[j].weight * radianceAt(nodes[i].x, nodes[j].x) / area;
  return pixels;
}

/// theory: as the number of iterations grows; sums: over these numbers, in closed form.
void checkSlope(const std::string& what, const Interval& slope, double theory, double sums, double widest) {
  INFO(what, ": ", slope.value, " ± ", slope.half, ", theory ", theory, ", its sums ", sums);
  CHECK(slope.half <= widest);
  CHECK(slope.contains(sums));
  CHECK(slope.contains(theory));
}

void checkPath(int edge, const Counts& counts, double widest) {
  std::vector<double> const truth = truthOf(edge);
  Courses const courses = runCourses(lampOnFloor(), oneBounce(Mode::path, edge), counts);
  checkSlope("variance", slopeOf(courses, truth, variance), -1, -1, widest);
  checkSlope("squared error", slopeOf(courses, truth, squaredError), -1, -1, widest);
  Interval const error = meanErrorOf(courses, truth);
  INFO("mean error ", error.value, " ± ", error.half);
  CHECK(error.contains(0));
  CHECK(error.half <= 0.3 * widest * truth[0]);
}

/// Discs so small that the light is even over them, and apart from those of other pixels.
Interval checkVariance(double alpha, std::uint64_t photonCount, const Counts& counts, double widest) {
  CAPTURE(alpha);
  Courses const courses = runCourses(lampOnFloor(), photons(16, alpha, 0.035, photonCount), counts);
  double const sums = logSlope(counts, expectedOf(alpha, counts).variance);
  Interval const slope = slopeOf(courses, truthOf(16), variance);
  checkSlope("variance", slope, -alpha, sums, widest);
  return slope;
}

/// Large discs, where the light curves down.
Interval checkBias(double alpha, std::uint64_t photonCount, const Counts& counts, double widest) {
  CAPTURE(alpha);
  Courses const courses = runCourses(lampOnFloor(), photons(8, alpha, 0.6, photonCount), counts);
  double const sums = logSlope(counts, expectedOf(alpha, counts).bias);
  Interval const slope = slopeOf(courses, truthOf(8), bias);
  checkSlope("bias", slope, alpha - 1, sums, widest);
  return slope;
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("the variance and the squared error of path fall as 1/N") { checkPath(16, doublings(4, 512), 0.04); }

  TEST_CASE("the variance of indirect light in sppm falls as N^-alpha") {
    Counts const counts = doublings(64, 1024);
    CHECK_FALSE(checkVariance(1.0 / 2, 256, counts, 0.08).contains(-0.75));
    checkVariance(2.0 / 3, 256, counts, 0.08);
    CHECK_FALSE(checkVariance(3.0 / 4, 256, counts, 0.08).contains(-0.5));
  }

  TEST_CASE("the bias of indirect light in sppm falls as N^-(1 - alpha)") {
    // The larger alpha, the more bias is left to be seen above the noise.
    CHECK_FALSE(checkBias(1.0 / 2, 1280, doublings(64, 2048), 0.2).contains(-0.25));
    checkBias(2.0 / 3, 384, doublings(64, 1024), 0.2);
    CHECK_FALSE(checkBias(3.0 / 4, 384, doublings(64, 1024), 0.2).contains(-0.5));
  }
}

TEST_CASE("a few iterations show the slopes of path and sppm roughly") {
  checkPath(8, doublings(4, 64), 0.12);
  checkVariance(2.0 / 3, 64, doublings(8, 64), 0.25);
  checkBias(2.0 / 3, 512, doublings(16, 128), 0.3);
}
