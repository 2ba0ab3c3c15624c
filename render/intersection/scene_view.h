#pragma once
// What kernels see of a scene: spans of plain data.

#include "render/bsdf/material.h"
#include "render/core/span.h"
#include "render/flat/layer.h"
#include "render/intersection/instance.h"
#include "render/scene/side.h"

namespace ropelight::RL_TARGET {

/// A light of any kind; `kind` is its index in Emitters. primitive: the surface that emits, of those that have one.
/// side: bits of ropelight::Side. pick: probability that light sampling chooses it, ∝ power.
struct Light {
  std::uint16_t kind = 0;
  std::uint16_t side = 1;
  std::uint32_t primitive = 0;
  Rgb radiance{0.0f};
  Real area = 0;  ///< of one side
  Real pick = 0;
};

/// A ball that photons of caustics are aimed at (render/targets).
struct alignas(16) Target {
  Vec3 center;
  Real radius = 0;
};

/// A quad or what stands on one (render/targets/planes.h). covers: the normal of the side that it hides; 0: none.
struct PlanePiece {
  Vec3 corner[4];
  Vec3 normal{0};  ///< of the corners' order
  Vec3 covers{0};
  Vec3 center{0};
  Real reach = 0;  ///< from the centre to the farthest corner
};

struct SceneView {
  Span<const Quad> quads;
  Span<const Sphere> spheres;
  TriangleList triangles;
  Span<const Instance> instances;
  Span<const MeshView> meshes;         ///< that instances name
  Span<const std::uint32_t> material;  ///< by primitive
  Span<const std::int32_t> lightOf;    ///< by primitive, as far as any emits; −1: none
  Span<const Layer> layers;            ///< by primitive; empty where no surfaces coincide
  Span<const Material> materials;
  Span<const Light> lights;
  Span<const Real> lightCdf;             ///< inclusive sums of Light::pick
  Span<const std::uint32_t> lightGuide;  ///< by which they are searched (render/light/guide_table.h)
  Span<const Target> targets;            ///< together they hold all specular surfaces
  Span<const PlanePiece> planePieces;    ///< quads, each with what stands on it
  Span<const std::uint32_t> planeFirst;  ///< by quad; empty where no gather asks
  Real power = 0;                        ///< of all lights: mean over the channels, watts
  std::uint32_t primitiveCount = 0;      ///< instances included; hits on their triangles have higher numbers
  KdTreeView tree;
  bool shortStack = false;  ///< how the tree is traversed
  BvhView<bvhWidth> bvh;
  Span<const Triangle> bvhTriangles;  ///< by item of the hierarchy; of other primitives the id alone
};

}  // namespace ropelight::RL_TARGET
