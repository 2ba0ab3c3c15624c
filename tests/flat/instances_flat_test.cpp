// Meshes kept once: which, where, how many things to hit, and what they cost.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "render/flatten/flatten.h"
#include "render/flatten/instances.h"
#include "render/launch/rows.h"
#include "render/prepare/scene_cache.h"
#include "tests/scenes/placed_meshes.h"

using namespace ropelight;

TEST_CASE("placed meshes count in everything that a scene is asked for") {
  Scene const scene = placedBalls();
  FlatScene const flat = flatten(scene, Instancing::always), baked = flatten(scene, Instancing::never);
  CHECK(baked.instances.empty());
  CHECK(baked.hitCount() == baked.primitiveCount());
  CHECK(flat.triangles.empty());
  CHECK(flat.meshes.size() == 2);
  CHECK(flat.primitiveCount() == 6 + 1 + 12);
  CHECK(flat.hitCount() - flat.primitiveCount() == baked.triangles.size());
  CHECK(glm::length(flat.bounds.min - baked.bounds.min) < 1e-12);
  CHECK(glm::length(flat.bounds.max - baked.bounds.max) < 1e-12);
  CHECK(flat.reach == doctest::Approx(baked.reach).epsilon(1e-12));
  CHECK(flat.diffuseArea == doctest::Approx(baked.diffuseArea).epsilon(1e-10));
  CHECK(flat.light == baked.light);
  CHECK((featuresOf(flat, scene.camera) & (feature::instances | feature::triangles)) == feature::instances);
  CHECK((featuresOf(baked, scene.camera) & (feature::instances | feature::triangles)) == feature::triangles);
  CHECK(std::string(kernelRows[rowFor(featuresOf(flat, scene.camera))].name) == "full");
  std::uint32_t next = flat.primitiveCount();
  for (std::uint32_t i = 0; i < 12; ++i) {
    CHECK(flat.instances[i].firstHit == next);
    next += flat.meshes[flat.instances[i].mesh]->primitiveCount();
    Bounds const exact = flat.instances[i].bounds, padded = flat.primitiveBounds(7 + i);
    CHECK((padded.min.x < exact.min.x && padded.max.z > exact.max.z));
    CHECK(glm::length(padded.extent() - exact.extent()) < 1e-3);
  }
}

TEST_CASE("a mesh is kept in its own space, centred and scaled to within one") {
  std::vector<FlatTriangle> mesh = bumpyBall(8, 7);
  for (FlatTriangle& t : mesh)
    for (Vec3d* p : {&t.a, &t.b, &t.c}) *p = 1e-7 * *p + Vec3d(5e5, 0, -3);
  Scene const scene = SceneBuilder().mesh(mesh).scene;
  KeptMesh const kept = keepMesh(scene.meshes[0]);
  double largest = 0, off = 0;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    largest = std::max({largest, std::abs(kept.scene->triangles[k].a.x), std::abs(kept.scene->triangles[k].a.y)});
    off = std::max(off, glm::length(transformPoint(kept.toGiven, kept.scene->triangles[k].a) - mesh[k].a));
  }
  CHECK((largest > 0.45 && largest <= 1));
  CHECK(off < 1e-9);
}

TEST_CASE("meshes are kept once where that spares enough and rounding does not grow") {
  std::vector<FlatTriangle> const mesh = bumpyBall(20, 14);  // 520 triangles
  auto const instancesOf = [](const SceneBuilder& b) { return flatten(b.scene).instances.size(); };
  SceneBuilder b;
  CHECK(instancesOf(b.mesh(mesh)) == 0);
  CHECK(instancesOf(b.place(0, translation({3, 0, 0}))) == 0);
  CHECK(instancesOf(b.place(0, translation({6, 0, 0}))) == 3);
  CHECK(instancesOf(b.mesh(mesh, translation({9, 0, 0}))) == 3);
  CHECK(flatten(b.scene).triangles.size() == mesh.size());
  Mat4d const needle = scaling({1, 1e-4, 1}) * rotation({1, 1, 1}, 40);
  CHECK(roundingGrowth(Mat3d(rotation({1, 2, 3}, 40) * scaling({1, 1e-5, 1e3}))).x <= 3);
  CHECK(instancesOf(b.place(0, needle)) == 3);
  CHECK(flatten(b.scene, Instancing::always).instances.size() == 4);
}

TEST_CASE("a hundred placed meshes take a fraction of the memory") {
  SceneBuilder b;
  b.mesh(bumpyBall(20, 16));
  for (int i = 1; i < 100; ++i) b.place(0, translation({3.0 * i, 0, 0}));
  auto const bytes = [&](Instancing instancing, const auto& config) {
    HostScene const host(flatten(b.scene, instancing), config);
    std::uint64_t sum = 0;
    for (const auto& [purpose, count] : host.bytes()) sum += count;
    return sum;
  };
  CHECK(bytes(Instancing::always, BvhConfig{}) * 25 < bytes(Instancing::never, BvhConfig{}));
  CHECK(bytes(Instancing::always, KdConfig{}) * 25 < bytes(Instancing::never, KdConfig{}));
  HostScene const host(flatten(b.scene), BvhConfig{});
  CHECK(host.bytes().at("instances") > 100 * sizeof(cpu::Instance));
}

TEST_CASE("structures of meshes outlast a camera that goes far away") {
  SceneBuilder b;
  b.mesh(bumpyBall(20, 31)).place(0, translation({3, 0, 0}));
  SceneCache cache(b.scene);
  auto const near = cache.flat(b.scene.camera);
  auto const bvhs = cache.meshBvhs(*near, BvhConfig{});
  b.cameraAt({1e4, 0, 0});
  auto const far = cache.flat(b.scene.camera);
  CHECK(far->reach > near->reach);
  REQUIRE(bvhs->size() == 1);
  CHECK(cache.meshBvhs(*far, BvhConfig{}) == bvhs);
  CHECK(far->primitiveBounds(0).min.x < near->primitiveBounds(0).min.x);
}
