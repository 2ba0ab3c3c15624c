// Discs cut at the edges of quads, against points counted one by one.

#include <doctest/doctest.h>

#include <cmath>

#include "measure/scenes/scene_kit.h"
#include "render/flatten/flatten.h"
#include "render/kernels/plane_share.h"
#include "render/targets/planes.h"
#include "render/upload/upload.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

struct Planes {
  std::vector<cpu::PlanePiece> pieces;
  std::vector<std::uint32_t> first;

  explicit Planes(const FlatScene& flat) {
    PlaneParts const parts = planeParts(flat);
    for (const PlanePart& p : parts.parts) pieces.push_back(cpu::toTarget(p));
    first = parts.first;
  }
  cpu::PlaneView view() const {
    return {{pieces.data(), std::uint32_t(pieces.size())}, {first.data(), std::uint32_t(first.size())}};
  }
};

}  // namespace

TEST_CASE("the share of a disc on a quad is that of its points") {
  TestRandom random(8);
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    Vec3d const a = random.inBox(3), e = random.direction() * random.between(0.2, 3), f = random.direction();
    Scene scene = emptyScene(0.5f);
    addQuad(scene, a, e, f);
    Planes const planes(flatten(scene));
    Vec3d const origin = flatten(scene).origin;
    double const s = random.between(0, 1), t = random.between(0, 1), radius = std::pow(10, random.between(-2, 0.5));
    Vec3d const p = a + s * e + t * f, n = glm::normalize(glm::cross(e, f));
    Mat3d const toQuad = glm::inverse(Mat3d(e, f, n));
    cpu::Frame const frame{cpu::Vec3(n)};
    int inside = 0;
    int const samples = 40000;
    for (int i = 0; i < samples; ++i) {
      double const r = radius * std::sqrt((i + 0.5) / samples), angle = i * 2.399963229728653;
      Vec3d const q = p + Vec3d(frame.s) * (r * std::cos(angle)) + Vec3d(frame.t) * (r * std::sin(angle));
      Vec3d const at = toQuad * (q - a);
      inside += at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1;
    }
    for (double side : {1.0, -1.0}) {
      double const share =
          double(planes.view().share(0, cpu::Vec3(p - origin), cpu::Vec3(side * n), cpu::Real(radius)));
      CHECK(share == doctest::Approx(double(inside) / samples).epsilon(0.01).scale(1));
    }
  }
}

TEST_CASE("a disc on the floor of a room: corner, edge, middle, and beside what stands there") {
  Scene scene = emptyScene(0.5f);
  addBox(scene, {-1, -1, -1}, {1, 1, 1});
  addBox(scene, {-0.2, -1, -0.3}, {0.2, -0.5, 0.3}, addMaterial(scene, DiffuseParams{Rgb(0.2f)}));
  lookAt(scene, {0, 0.5, 0.8}, {0, 0, 0}, {0, 1, 0}, 60);
  FlatScene const flat = flatten(scene);
  REQUIRE(flat.hiddenFaces.size() == 1);
  Planes const planes(flat);
  std::uint32_t floor = 0;
  while (flat.quads[floor].corner[0].y != -1 || flat.quads[floor].corner[2].y != -1) ++floor;
  auto const share = [&](double x, double z, double side = 1) {
    return double(planes.view().share(floor, cpu::Vec3(Vec3d(x, -1, z)), cpu::Vec3(0, cpu::Real(side), 0), 0.1f));
  };
  CHECK(share(0.6, 0.6) == 1);
  CHECK(share(1, 1) == doctest::Approx(0.25).epsilon(1e-4));
  CHECK(share(1, 0.6) == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(share(0.2, 0) == doctest::Approx(0.5).epsilon(1e-4));     // along the block
  CHECK(share(0.2, 0.3) == doctest::Approx(0.75).epsilon(1e-4));  // at its corner
  CHECK(share(0.2, 0, -1) == 1);                                  // from below nothing stands there
  CHECK(planes.view().holds(floor, cpu::Vec3(0.99f, -1, 0)));
  CHECK_FALSE(planes.view().holds(floor, cpu::Vec3(1.01f, -1, 0)));
  CHECK_FALSE(planes.view().knows(std::uint32_t(flat.quads.size())));
  CHECK_FALSE(cpu::PlaneView{}.knows(0));
}

TEST_CASE("a disc shares the sector or the triangle where one holds the other") {
  cpu::Vec2 const p(1, 0), q(0, 1);
  CHECK(double(cpu::discTriangle(p, q, 4)) == doctest::Approx(1));                    // twice the triangle
  CHECK(double(cpu::discTriangle(p, q, 0.25f)) == doctest::Approx(0.25 * M_PI / 2));  // twice the sector
  CHECK(double(cpu::discTriangle(q, p, 0.25f)) == doctest::Approx(-0.25 * M_PI / 2));
  CHECK(cpu::discTriangle(p, p, 1) == 0);
}
