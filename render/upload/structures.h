#pragma once
// A flat scene with the structures over it: what a backend is given to upload.

#include <memory>
#include <vector>

#include "accel/bvh/build.h"
#include "accel/kdtree/kd_tree.h"
#include "render/targets/planes.h"
#include "render/targets/specular_targets.h"

namespace ropelight {

struct SceneStructures {
  std::shared_ptr<const FlatScene> flat;
  FeatureBits features = 0;
  std::shared_ptr<const std::vector<SpecularTarget>> targets;  ///< null without feature::caustics
  std::shared_ptr<const PlaneParts> planes;                    ///< null where no photons are gathered on quads
  std::shared_ptr<const KdTree> tree;                          ///< null without feature::tree
  std::shared_ptr<const Bvh<2>> bvh;                           ///< null without feature::bvh
  std::shared_ptr<const std::vector<KdTree>> meshTrees;        ///< one an instanced mesh; null without feature::tree
  std::shared_ptr<const std::vector<Bvh<2>>> meshBvhs;         ///< likewise without feature::bvh
};

}  // namespace ropelight
