// Surfaces at the same place: which are found, and what is seen of them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "render/coincidence/coincident.h"
#include "render/flatten/flatten.h"
#include "render/scene/transform.h"
#include "tests/oracle/scenes.h"
#include "tests/scenes/coincident_scenes.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

Facet square(Vec3d corner, Vec3d e1, Vec3d e2) {
  return makeFacet(FlatQuad{{corner, corner + e1, corner + e1 + e2, corner + e2}});
}

Facet floorTile(double x, double z, double y = 0) { return square({x, y, z}, {0, 0, 1}, {1, 0, 0}); }

bool stacked(const Scene& scene) { return !flatten(scene).layers.empty(); }

/// Mean of a picture of the furnace in one mode and structure.
double brightness(const Scene& scene, Mode mode, Accel accel, const BackendChoice& backend, int iterations = 64) {
  Settings settings = settingsFor(mode, 32, 32);
  settings.accel = accel;
  settings.photons = 20000;
  settings.radius = 0.05;
  return meanOf(renderImage(scene, settings, iterations, nullptr, backend));
}

}  // namespace

TEST_CASE("facets coincide where they share a plane and more than an edge") {
  Facet const tile = floorTile(0, 0);
  CHECK(coincide(tile, floorTile(0, 0)));
  CHECK(coincide(tile, floorTile(0.9, -0.9)));
  CHECK_FALSE(coincide(tile, floorTile(1, 0)));        // an edge
  CHECK_FALSE(coincide(tile, floorTile(1, 1)));        // a corner
  CHECK_FALSE(coincide(tile, floorTile(0, 0, 1e-4)));  // above
  CHECK(coincide(tile, floorTile(0, 0, 1e-7)));        // by less than a float tells
  CHECK_FALSE(coincide(tile, square({0, 0, 0}, {0, 1, 0}, {1, 0, 0})));
  CHECK_FALSE(coincide(tile, square({0, -0.01, 0}, {0, 0.02, 1}, {1, 0, 0})));  // crosses it
  Facet const corner = makeFacet(FlatTriangle{{0, 0, 0}, {0.5, 0, 0}, {0, 0, 0.5}});
  CHECK(coincide(tile, corner));
  CHECK(coincide(corner, tile));
  CHECK_FALSE(coincide(corner, makeFacet(FlatTriangle{{0.5, 0, 0}, {0.5, 0, 0.5}, {0, 0, 0.5}})));  // its other half
  CHECK_FALSE(coincide(corner, makeFacet(FlatTriangle{{0, 0, 0}, {0.5, 0, 0}, {0.25, 0, 0}})));     // no area
}

TEST_CASE("facets coincide at every scale and place") {
  for (double scale : {1e-6, 1.0, 1e6})
    for (Vec3d at : {Vec3d(0, 0, 0), Vec3d(3, -7, 2)}) {
      CAPTURE(scale);
      Mat3d const turned(rotation({1, 2, 3}, 40));
      auto const tile = [&](double x, double y) {
        return square(scale * (at + turned * Vec3d(x, y, 0)), scale * turned[2], scale * turned[0]);
      };
      CHECK(coincide(tile(0, 0), tile(0.5, 0)));
      CHECK_FALSE(coincide(tile(0, 0), tile(1, 0)));
      CHECK_FALSE(coincide(tile(0, 0), tile(0, 1e-3)));
    }
}

TEST_CASE("ellipsoids coincide where they are one surface, whichever way they are turned") {
  FlatSphere const ball{2.0 * Mat3d(1.0), {1, 2, 3}};
  Mat3d const turned(rotation({1, 1, 0}, 70));
  CHECK(coincide(makeFacet(ball), makeFacet(FlatSphere{2.0 * turned, {1, 2, 3}})));
  CHECK_FALSE(coincide(makeFacet(ball), makeFacet(FlatSphere{2.0001 * turned, {1, 2, 3}})));
  CHECK_FALSE(coincide(makeFacet(ball), makeFacet(FlatSphere{2.0 * turned, {1, 2, 3.0001}})));
  CHECK_FALSE(coincide(makeFacet(ball), floorTile(0, 0)));
}

TEST_CASE("only surfaces whose order matters are put in layers") {
  for (const FurnaceCase& c : furnaceCases()) {
    CAPTURE(c.name);
    CHECK(stacked(c.scene));
  }
  Scene room = emptyScene(0.5f);
  addBox(room, {-1, 0, -1}, {1, 2, 1});
  addBox(room, {-0.2, 0, -0.2}, {0.2, 0.4, 0.2});  // stands on the floor, of the same material
  CHECK_FALSE(stacked(room));
  room.shapes[1].emission = Emission{};
  CHECK(stacked(room));
  Scene apart = furnaceCases().front().scene;
  for (ShapeDesc& s : apart.shapes)
    if (s.kind == ShapeKind::box && s.name == "glass") s.toWorld[3].y += 1e-3;
  CHECK_FALSE(stacked(apart));
}

TEST_CASE("faces of opaque solids that something opaque covers are left out, and need no order") {
  Scene scene = emptyScene(0.5f);
  int const clay = addMaterial(scene, DiffuseParams{Rgb(0.2f)});
  addBox(scene, {-2, 0, -2}, {2, 3, 2});
  lookAt(scene, {1, 1, 1.5}, {0, 0, 0}, {0, 1, 0}, 60);
  addQuad(scene, {-0.5, 2.9, -0.5}, {1, 0, 0}, {0, 0, 1}).emission = Emission{Rgb(5), Side::out};
  addBox(scene, {-0.5, 0, -0.5}, {0, 1, 0}, clay);
  addMeshBox(scene, {0.3, 0, 0.3}, {0.8, 0.5, 0.8}, clay);
  FlatScene const flat = flatten(scene);
  CHECK(flat.layers.empty());
  CHECK(flat.quads.size() == 12);
  CHECK(flat.triangles.size() == 10);
  CHECK(flat.material.size() == 22);
  CHECK(flat.light.size() == 12);
  CHECK(flat.lights[0].primitive == 6);

  Scene within = scene;  // a lamp in the block: its bottom is seen
  addSphere(within, {-0.25, 0.5, -0.25}, 0.1).emission = Emission{Rgb(5), Side::out};
  CHECK_FALSE(flatten(within).layers.empty());
  Scene open = scene;  // a carpet is no solid
  open.meshes.back().triangles.resize(10);
  CHECK_FALSE(flatten(open).layers.empty());
  Scene glass = scene;
  glass.materials[std::size_t(clay)].desc = DielectricParams{1.5f};
  CHECK(flatten(glass).quads.size() == 13);
  CHECK_FALSE(flatten(glass).layers.empty());
}

TEST_CASE("blocks on a floor look the same whether their hidden faces are there or not") {
  Scene scene = emptyScene(0.5f);
  int const clay = addMaterial(scene, DiffuseParams{Rgb(0.2f)});
  addBox(scene, {-2, 0, -2}, {2, 3, 2});
  lookAt(scene, {1, 1, 1.5}, {0, 0, 0}, {0, 1, 0}, 60);
  addQuad(scene, {-0.5, 2.9, -0.5}, {1, 0, 0}, {0, 0, 1}).emission = Emission{Rgb(5), Side::out};
  addMeshBox(scene, {-0.5, 0, -0.5}, {0.3, 1, 0.2}, clay);
  Scene above = scene;
  for (Vec3d& p : above.meshes.back().positions)
    if (p.y == 0) p.y = 1e-4;
  Settings settings = settingsFor(Mode::path, 32, 32);
  double const gap = meanOf(renderImage(above, settings, 64)), none = meanOf(renderImage(scene, settings, 64));
  CHECK(none == doctest::Approx(gap).epsilon(0.005));
}

TEST_CASE("a mesh of many triangles is looked at as a few are") {
  Scene scene = furnaceCases().front().scene;
  int const glass = scene.shapes.back().material;
  for (int i = 0; i < 60; ++i)
    addMeshBox(scene, Vec3d(0.05 * i - 1.5, 0, -1), Vec3d(0.05 * i - 1.46, 0.04, -0.9), glass);
  FlatScene const flat = flatten(scene);
  int found = 0;
  for (std::size_t i = 0; i < flat.triangles.size(); ++i)
    found += flat.layers[flat.quads.size() + flat.spheres.size() + i].stacked();
  CHECK(found == 120);  // the two triangles of every bottom
}

TEST_CASE("meshes that touch something are copied, the others placed") {
  Scene scene = emptyScene(1);
  int const glass = addMaterial(scene, DielectricParams{1.5f});
  addQuad(scene, {-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
  for (int i = 0; i < 3; ++i) {
    if (i == 0)
      addMeshBox(scene, {0, 0, 0}, {0.5, 0.5, 0.5}, glass);
    else
      scene.shapes.push_back(scene.shapes.back());
    scene.shapes.back().toWorld = translation({double(i) - 1, i == 1 ? 0 : 0.1, 0});
  }
  FlatScene const flat = flatten(scene, Instancing::always);
  CHECK(flat.instances.size() == 2);
  CHECK(flat.triangles.size() == 12);
  CHECK_FALSE(flat.layers.empty());
}

TEST_CASE("a closed furnace stays at 1 whatever touches in it, in every order and structure" *
          doctest::test_suite("slow")) {
  for (const BackendChoice& backend : everyBackend())
    for (const FurnaceCase& c : furnaceCases())
      for (Accel const accel : {Accel::brute, Accel::bvh, Accel::tree, Accel::shortStack})
        for (Mode const mode : {Mode::path, Mode::sppm}) {
          CAPTURE(nameOf(backend.backend));
          CAPTURE(c.name);
          CAPTURE(nameOf(accel));
          CAPTURE(nameOf(mode));
          CHECK(brightness(c.scene, mode, accel, backend) == doctest::Approx(1).epsilon(0.01));
        }
}

TEST_CASE("a closed furnace stays at 1 in the 24 orders of three touching surfaces") {
  for (const FurnaceCase& c : furnaceTriples()) {
    std::vector<ShapeDesc> shapes(c.scene.shapes.end() - 3, c.scene.shapes.end());
    int order[3] = {0, 1, 2};
    do {
      Scene scene = c.scene;
      for (int i = 0; i < 3; ++i)
        scene.shapes[scene.shapes.size() - 3 + std::size_t(i)] = shapes[std::size_t(order[i])];
      CAPTURE(c.name);
      CAPTURE(order[0]);
      CAPTURE(order[1]);
      CHECK(brightness(scene, Mode::path, Accel::automatic, {BackendKind::cpu, 0, 0, false}) ==
            doctest::Approx(1).epsilon(0.01));
    } while (std::next_permutation(order, order + 3));
  }
}

TEST_CASE("what is seen of opaque surfaces in one plane does not depend on their order") {
  // A lamp that shines down in a black ceiling; from below it is seen, from above the ceiling is.
  for (bool lampFirst : {true, false})
    for (bool fromAbove : {true, false})
      for (Accel const accel : {Accel::brute, Accel::bvh}) {
        Scene scene = emptyScene(0);
        auto const lamp = [&] {
          addQuad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}).emission = Emission{Rgb(1), Side::out};
        };
        if (lampFirst) lamp();
        addQuad(scene, {-2, 1, -2}, {4, 0, 0}, {0, 0, 4}, addMaterial(scene, DiffuseParams{Rgb(0.25f)}));
        if (!lampFirst) lamp();
        lookAt(scene, {0, fromAbove ? 3.0 : -1.0, 0}, {0, 1, 0}, {0, 0, 1}, 10);
        Settings settings = settingsFor(Mode::ray, 32, 32);
        settings.accel = accel;
        CHECK(meanOf(renderImage(scene, settings, 4)) == doctest::Approx(fromAbove ? 0.0 : 1.0));
        settings.aov = Aov::albedo;
        CHECK(meanOf(renderImage(scene, settings, 4)) == doctest::Approx(0.0));  // the smaller, from either side
      }
}

TEST_CASE("of two lamps at the same place one shines") {
  Scene scene = emptyScene(1);
  addQuad(scene, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
  int const black = addMaterial(scene, DiffuseParams{Rgb(0.0f)});
  for (double size : {2.0, 1.0})
    addQuad(scene, {-size / 2, 1, -size / 2}, {size, 0, 0}, {0, 0, size}, black).emission =
        Emission{Rgb(size == 2 ? 1 : 3), Side::out};
  auto const factor = [](double e) {
    double const x = e / 2, p = std::sqrt(1 + x * x);
    return 4 * (2 * x / p * std::atan(x / p)) / (2 * M_PI);
  };
  double const expected = factor(2) - factor(1) + 3 * factor(1);
  lookAt(scene, {0, 0.01, 0}, {0, 0, 0}, {0, 0, 1}, 10);
  for (DirectLight const direct : {DirectLight::shadow, DirectLight::photons})
    for (Mode const mode : {Mode::path, Mode::sppm}) {
      Settings settings = settingsFor(mode, 16, 16);
      settings.direct = direct;
      settings.photons = 200000;
      settings.radius = 0.05;
      CAPTURE(nameOf(mode));
      CAPTURE(nameOf(direct));
      CHECK(meanOf(renderImage(scene, settings, 64)) == doctest::Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("glass on a floor and a lamp in a ceiling are lit as the oracle says of a hair's breadth between them" *
          doctest::test_suite("slow")) {
  constexpr int size = 48, tile = 12;
  std::vector<double> variance;
  auto const image = oracle::render(oracle::touchingRoom(size, size, 1e-5), 1500, 5, 0, {}, &variance);
  auto const expected = oracle::tileMeans(image, variance, size, tile);
  Scene const scene = fromOracle(oracle::touchingRoom(size, size, 0));
  REQUIRE(stacked(scene));
  for (Mode const mode : {Mode::path, Mode::sppm}) {
    Settings settings = settingsFor(mode, size, size);
    settings.photons = 50000;
    settings.radius = 0.02;
    TileStatistics const found = tileStatistics(renderSeeds(scene, settings, 64, 6), tile);
    double const bias = mode == Mode::sppm ? 0.03 : 0.003;  // of discs along edges
    for (std::size_t t = 0; t < expected.size(); ++t)
      for (std::size_t c = 0; c < 3; ++c) {
        CAPTURE(nameOf(mode));
        CAPTURE(t);
        CAPTURE(c);
        double const sigma = std::hypot(std::sqrt(expected[t].variance), found.error[t][c]);
        CHECK(std::abs(found.mean[t][c] - expected[t].mean[c]) < 4 * sigma + bias * expected[t].mean[c]);
      }
  }
}
