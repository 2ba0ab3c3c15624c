#include "tests/scenes/host_scene.h"

namespace ropelight {
namespace {

SceneStructures prepared(const FlatScene& flat) {
  SceneStructures p;
  p.flat = std::make_shared<FlatScene>(flat);
  p.features = feature::all & ~(feature::tree | feature::shortStack | feature::bvh);
  return p;
}

SceneStructures withTrees(const FlatScene& flat, const KdConfig& config, bool shortStack) {
  SceneStructures p = prepared(flat);
  p.features |= feature::tree | (shortStack ? feature::shortStack : 0);
  p.tree = std::make_shared<KdTree>(buildKdTree(flat, config));
  std::vector<KdTree> meshes;
  for (const auto& mesh : flat.meshes) meshes.push_back(buildKdTree(*mesh, config));
  p.meshTrees = std::make_shared<std::vector<KdTree>>(std::move(meshes));
  return p;
}

SceneStructures withHierarchies(const FlatScene& flat, const BvhConfig& config) {
  SceneStructures p = prepared(flat);
  p.features |= feature::bvh;
  p.bvh = std::make_shared<Bvh<2>>(buildBvh(flat, config));
  std::vector<Bvh<2>> meshes;
  for (const auto& mesh : flat.meshes) meshes.push_back(buildBvh(*mesh, config));
  p.meshBvhs = std::make_shared<std::vector<Bvh<2>>>(std::move(meshes));
  return p;
}

}  // namespace

SceneBuilder::SceneBuilder() { scene.materials.push_back({"white", DiffuseParams{}}); }
SceneBuilder::~SceneBuilder() = default;

SceneBuilder& SceneBuilder::add(ShapeKind kind, const Mat4d& toWorld, std::optional<Emission> emission) {
  ShapeDesc shape;
  shape.kind = kind;
  shape.toWorld = toWorld;
  shape.emission = emission;
  scene.shapes.push_back(shape);
  return *this;
}

SceneBuilder& SceneBuilder::mesh(const std::vector<FlatTriangle>& triangles, const Mat4d& toWorld) {
  Mesh mesh;
  for (const FlatTriangle& t : triangles) {
    std::uint32_t const first = std::uint32_t(mesh.positions.size());
    for (Vec3d p : {t.a, t.b, t.c}) mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  scene.meshes.push_back(mesh);
  return place(int(scene.meshes.size()) - 1, toWorld);
}

SceneBuilder& SceneBuilder::place(int mesh, const Mat4d& toWorld) {
  add(ShapeKind::mesh, toWorld);
  scene.shapes.back().mesh = mesh;
  return *this;
}

SceneBuilder& SceneBuilder::cameraAt(Vec3d position) {
  scene.camera.position = position;
  return *this;
}

HostScene::HostScene(SceneStructures p)
    : prepared_(std::move(p)), backend_(BackendChoice{}), device_(backend_, prepared_) {}
HostScene::HostScene(const FlatScene& flat) : HostScene(prepared(flat)) {}
HostScene::HostScene(const FlatScene& flat, const KdConfig& config, bool shortStack)
    : HostScene(withTrees(flat, config, shortStack)) {}
HostScene::HostScene(const FlatScene& flat, const BvhConfig& config) : HostScene(withHierarchies(flat, config)) {}
HostScene::~HostScene() = default;

}  // namespace ropelight
