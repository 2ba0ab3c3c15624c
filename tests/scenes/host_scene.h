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

  SceneBuilder();
  SceneBuilder(const SceneBuilder&) = default;
  ~SceneBuilder();

  SceneBuilder& add(ShapeKind kind, const Mat4d& toWorld, std::optional<Emission> emission = {});
  SceneBuilder& mesh(const std::vector<FlatTriangle>& triangles, const Mat4d& toWorld = Mat4d(1.0));
  /// One more of a mesh that is there.
  SceneBuilder& place(int mesh, const Mat4d& toWorld);
  SceneBuilder& cameraAt(Vec3d position);
};

/// A flat scene on the CPU, with a structure where a configuration is given, over each mesh kept once too.
class HostScene {
 public:
  explicit HostScene(const FlatScene& flat);
  HostScene(const FlatScene& flat, const KdConfig& config, bool shortStack = false);
  HostScene(const FlatScene& flat, const BvhConfig& config);
  HostScene(const HostScene&) = delete;
  ~HostScene();

  const cpu::SceneView& view() const { return device_.view; }
  const FlatScene& flat() const { return *prepared_.flat; }
  const KdTree& tree() const { return *prepared_.tree; }
  const Bvh<2>& bvh() const { return *prepared_.bvh; }
  const SceneStructures& parts() const { return prepared_; }
  const std::map<std::string, std::uint64_t>& bytes() const { return backend_.ledger().bytes(); }

 private:
  explicit HostScene(SceneStructures p);

  SceneStructures prepared_;
  cpu::Backend backend_;
  cpu::DeviceScene<cpu::Backend> device_;
};

}  // namespace ropelight
