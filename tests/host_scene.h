#pragma once
// Scenes made in code, and their flat form on the CPU as kernels see it.

#include <utility>

#include "accel/kd_build.h"
#include "render/backend/cpu_backend.h"
#include "render/scene/transform.h"
#include "render/scene/upload.h"

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
    add(ShapeKind::mesh, toWorld);
    scene.shapes.back().mesh = int(scene.meshes.size());
    scene.meshes.push_back(mesh);
    return *this;
  }

  SceneBuilder& cameraAt(Vec3d position) {
    scene.camera.position = position;
    return *this;
  }
};

/// A flat scene on the CPU, with a tree where a configuration is given.
class HostScene {
 public:
  explicit HostScene(const FlatScene& flat) : HostScene(prepared(flat)) {}
  HostScene(const FlatScene& flat, const KdConfig& config) : HostScene(prepared(flat, &config)) {}

  const cpu::SceneView& view() const { return device_.view; }
  const FlatScene& flat() const { return *prepared_.flat; }
  const KdTree& tree() const { return *prepared_.tree; }

 private:
  explicit HostScene(Prepared p) : prepared_(std::move(p)), backend_(BackendChoice{}), device_(backend_, prepared_) {}

  static Prepared prepared(const FlatScene& flat, const KdConfig* config = nullptr) {
    Prepared p;
    p.flat = std::make_shared<FlatScene>(flat);
    p.features = feature::all & ~feature::tree;
    if (config) {
      p.features |= feature::tree;
      p.tree = std::make_shared<KdTree>(buildKdTree(flat, *config));
    }
    return p;
  }

  Prepared prepared_;
  cpu::Backend backend_;
  cpu::DeviceScene<cpu::Backend> device_;
};

}  // namespace ropelight
