#pragma once
// Scenes made in code, and their flat form on the CPU as kernels see it.

#include <map>
#include <string>
#include <utility>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "render/backend/cpu_backend.h"
#include "render/scene/transform.h"
#include "render/upload/upload.h"

namespace ropelight {

/// Fills a scene shape by shape; material 0 is white and diffuse.
class SceneBuilder {
 public:
  Scene scene;

  SceneBuilder() { scene.materials.push_back({"white", DiffuseParams{}}); }

  SceneBuilder& add(ShapeKind kind, const Mat4d& toWorld, std::optional<Emission> emission = {}) {
    ShapeDesc shape;
    shape.kind = kind;
    shape.toWorld = toWorld;
    shape.emission = emission;
    scene.shapes.push_back(shape);
    return *this;
  }

  SceneBuilder& mesh(const std::vector<FlatTriangle>& triangles, const Mat4d& toWorld = Mat4d(1.0)) {
    Mesh mesh;
    for (const FlatTriangle& t : triangles) {
      std::uint32_t const first = std::uint32_t(mesh.positions.size());
      for (Vec3d p : {t.a, t.b, t.c}) mesh.positions.push_back(p);
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    scene.meshes.push_back(mesh);
    return place(int(scene.meshes.size()) - 1, toWorld);
  }

  /// One more of a mesh that is there.
  SceneBuilder& place(int mesh, const Mat4d& toWorld) {
    add(ShapeKind::mesh, toWorld);
    scene.shapes.back().mesh = mesh;
    return *this;
  }

  SceneBuilder& cameraAt(Vec3d position) {
    scene.camera.position = position;
    return *this;
  }
};

/// A flat scene on the CPU, with a structure where a configuration is given, over each mesh kept once too.
class HostScene {
 public:
  explicit HostScene(const FlatScene& flat) : HostScene(prepared(flat)) {}
  HostScene(const FlatScene& flat, const KdConfig& config, bool shortStack = false)
      : HostScene(withTrees(flat, config, shortStack)) {}
  HostScene(const FlatScene& flat, const BvhConfig& config) : HostScene(withHierarchies(flat, config)) {}

  const cpu::SceneView& view() const { return device_.view; }
  const FlatScene& flat() const { return *prepared_.flat; }
  const KdTree& tree() const { return *prepared_.tree; }
  const Bvh<2>& bvh() const { return *prepared_.bvh; }
  const SceneStructures& parts() const { return prepared_; }
  const std::map<std::string, std::uint64_t>& bytes() const { return backend_.ledger().bytes(); }

 private:
  explicit HostScene(SceneStructures p)
      : prepared_(std::move(p)), backend_(BackendChoice{}), device_(backend_, prepared_) {}

  static SceneStructures prepared(const FlatScene& flat) {
    SceneStructures p;
    p.flat = std::make_shared<FlatScene>(flat);
    p.features = feature::all & ~(feature::tree | feature::shortStack | feature::bvh);
    return p;
  }

  static SceneStructures withTrees(const FlatScene& flat, const KdConfig& config, bool shortStack) {
    SceneStructures p = prepared(flat);
    p.features |= feature::tree | (shortStack ? feature::shortStack : 0);
    p.tree = std::make_shared<KdTree>(buildKdTree(flat, config));
    std::vector<KdTree> meshes;
    for (const auto& mesh : flat.meshes) meshes.push_back(buildKdTree(*mesh, config));
    p.meshTrees = std::make_shared<std::vector<KdTree>>(std::move(meshes));
    return p;
  }

  static SceneStructures withHierarchies(const FlatScene& flat, const BvhConfig& config) {
    SceneStructures p = prepared(flat);
    p.features |= feature::bvh;
    p.bvh = std::make_shared<Bvh<2>>(buildBvh(flat, config));
    std::vector<Bvh<2>> meshes;
    for (const auto& mesh : flat.meshes) meshes.push_back(buildBvh(*mesh, config));
    p.meshBvhs = std::make_shared<std::vector<Bvh<2>>>(std::move(meshes));
    return p;
  }

  SceneStructures prepared_;
  cpu::Backend backend_;
  cpu::DeviceScene<cpu::Backend> device_;
};

}  // namespace ropelight
