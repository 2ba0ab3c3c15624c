// Rays and gathers apart from rendering, on a GPU: every traversal against brute force, every gather against the CPU.
// Needs a GPU; says so and passes where there is none.

#include <doctest/doctest.h>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "measure/rays/meshes.h"
#include "measure/rays/stress_meshes.h"
#include "measure/rays/stress_rays.h"
#include "measure/streams/gather_stream.h"
#include "measure/streams/ray_stream.h"
#include "tests/gpu/device.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

StreamScene structuresOver(const std::vector<FlatTriangle>& triangles) {
  StreamScene scene;
  scene.flat = std::make_shared<FlatScene>(triangleScene(triangles));
  scene.tree = std::make_shared<KdTree>(buildKdTree(*scene.flat, KdConfig{}));
  scene.bvh = std::make_shared<Bvh<2>>(buildBvh(*scene.flat, BvhConfig{}));
  scene.wide = std::make_shared<Bvh<4>>(widen(*scene.bvh));
  return scene;
}

/// On the walls x = 0 and z = 1 of the unit cube.
template <class T>
std::vector<T> onWalls(int count, std::uint32_t seed) {
  TestRandom random(seed);
  std::vector<T> out(std::size_t(count), T{});
  for (int i = 0; i < count; ++i) {
    T& p = out[std::size_t(i)];
    int const axis = i % 2 ? 0 : 2;
    for (int a = 0; a < 3; ++a) p.position[a] = float(random.unit());
    p.position[axis] = axis == 0 ? 0.0f : 1.0f;
    for (int a = 0; a < 3; ++a) p.normal[a] = 0;
    p.normal[axis] = axis == 0 ? 1.0f : -1.0f;
  }
  return out;
}

}  // namespace

TEST_SUITE("gpu") {
  TEST_CASE("CUDA: every traversal finds what testing every triangle finds") {
    if (noGpu()) return;
    for (const StressMesh& mesh : stressMeshes(false)) {
      CAPTURE(mesh.name);
      StreamScene const scene = structuresOver(mesh.triangles);
      auto const stream = makeRayStream(scene, onGpu);
      stream->setRays(StressRays(*scene.flat, scene.tree.get(), 7).make(20000));
      stream->trace(Traversal::brute, false);
      auto const expected = stream->hits();
      for (const TraversalInfo& t : traversals) {
        if (!stream->supports(t.id)) continue;
        CAPTURE(t.name);
        stream->trace(t.id, false);
        auto const closest = stream->hits();
        stream->trace(t.id, true);
        auto const any = stream->hits();
        int wrong = 0;
        for (std::size_t i = 0; i < expected.size(); ++i)
          wrong += closest[i].primitive != expected[i].primitive || any[i].found() != expected[i].found();
        CHECK(wrong == 0);
      }
    }
  }

  TEST_CASE("CUDA: gathers find the photons that the CPU's find") {
    if (noGpu()) return;
    auto photons = onWalls<StreamPhoton>(200000, 71);
    for (StreamPhoton& p : photons) p.flux = Rgb(1.0f);
    auto const queries = onWalls<StreamQuery>(5000, 72);
    Bounds cube;
    cube.grow(Vec3d(0.0));
    cube.grow(Vec3d(1.0));
    auto const gather = [&](const BackendChoice& choice, GatherKind kind, std::uint32_t table) {
      auto const stream = makeGatherStream(choice);
      stream->setPhotons(photons, cube);
      stream->setQueries(queries);
      stream->build(0.02f, table);
      stream->gather(kind, 0.02f, 50);
      return stream->results();
    };
    for (std::uint32_t const table : {0u, 1024u})
      for (GatherKind const kind : {GatherKind::grid, GatherKind::nearest, GatherKind::brute}) {
        CAPTURE(int(kind));
        auto const cpu = gather(onCpu, kind, table), gpu = gather(onGpu, kind, table);
        int different = 0;
        for (std::size_t i = 0; i < cpu.size(); ++i)
          different += cpu[i].count != gpu[i].count || cpu[i].flux != gpu[i].flux;
        CHECK(different <= 5);  // a photon on the disc's rim may round to either side
        CHECK(cpu[0].count > 0);
      }
  }
}
