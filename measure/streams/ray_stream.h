#pragma once
// Many rays against one structure, without a rendering around them: what benchmarks time and what the correctness
// checks ask.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "accel/bvh/bvh.h"
#include "accel/kdtree/kd_tree.h"
#include "render/backend/devices.h"
#include "render/flat/flat_scene.h"
#include "render/integrators/integrator.h"

namespace ropelight {

struct alignas(16) StreamRay {
  float origin[3];
  float tMax;
  float direction[3];
  float unused = 0;
};

/// primitive: 0xFFFFFFFF where nothing was hit in (0, tMax]. Of an any-hit query t is 0 and primitive is some hit's.
struct StreamHit {
  float t;
  std::uint32_t primitive;

  bool found() const { return primitive != 0xFFFFFFFFu; }
};

enum class Traversal : std::uint8_t {
  brute,        ///< every primitive
  ropes,        ///< kd-tree, stackless
  ropesShared,  ///< the same, top levels of the tree in shared memory (GPU)
  shortStack,   ///< kd-tree, short stack with push-down and restart
  bvh,          ///< binary BVH, one thread per ray
  bvhRefill,    ///< the same by persistent warps that fetch new rays when lanes run empty (GPU)
  bvhWide,      ///< BVH with four children per node
  embree,       ///< Embree (CPU, where it was built in)
};

struct TraversalInfo {
  Traversal id;
  const char* name;  ///< as the command line and tables have it
  const char* what;
};

inline constexpr TraversalInfo traversals[] = {
    {Traversal::brute, "brute", "every primitive"},
    {Traversal::ropes, "ropes", "kd-tree with ropes"},
    {Traversal::ropesShared, "ropes-shared", "kd-tree with ropes, top levels in shared memory"},
    {Traversal::shortStack, "short-stack", "kd-tree with a short stack"},
    {Traversal::bvh, "bvh", "binary BVH, a thread a ray"},
    {Traversal::bvhRefill, "bvh-refill", "binary BVH, warps refilled"},
    {Traversal::bvhWide, "bvh-wide", "BVH of four children a node"},
    {Traversal::embree, "embree", "Embree"},
};

/// What rays are traced against; a structure that is null cannot be asked for.
struct StreamScene {
  std::shared_ptr<const FlatScene> flat;
  std::shared_ptr<const KdTree> tree;
  std::shared_ptr<const Bvh<2>> bvh;
  std::shared_ptr<const Bvh<4>> wide;
};

class RayStream {
 public:
  virtual ~RayStream() = default;

  /// Whether this backend has the traversal and the scene its structure.
  virtual bool supports(Traversal traversal) const = 0;
  virtual void setRays(std::span<const StreamRay> rays) = 0;
  /// Traces all rays once; seconds on the device, or of wall clock on the CPU. Throws Error where it is not supported.
  virtual double trace(Traversal traversal, bool anyHit) = 0;
  /// Of the last trace, by ray.
  virtual std::vector<StreamHit> hits() = 0;
  virtual DeviceInfo device() const = 0;
};

/// On the backend chosen; throws std::bad_alloc where the memory cannot be had.
std::unique_ptr<RayStream> makeRayStream(const StreamScene& scene, const BackendChoice& choice);

}  // namespace ropelight
