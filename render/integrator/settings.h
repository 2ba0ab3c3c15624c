#pragma once
// Everything that a user can set of a rendering. Zero means 'automatic' where the text says so; the resolved value is
// reported and written into the metadata.

#include <cstdint>
#include <string>

#include "render/core/params.h"

namespace ropelight {

struct Settings {
  std::string mode = "sppm";       ///< one of modeNames()
  std::string direct = "shadow";   ///< shadow: shadow rays; photons: the photons carry direct light too
  std::string gather = "radius";   ///< radius or nearest
  std::string accel = "auto";      ///< auto, tree or brute
  std::string split = "sah";       ///< kd-tree builder: sah or midpoint
  std::string sampler = "sobol";   ///< sobol or independent
  int width = 0;                   ///< pixels; 0: the scene's film
  int height = 0;                  ///< pixels; 0: the scene's film
  std::uint64_t photons = 262144;  ///< photon paths an iteration
  double radius = 0;               ///< first gather radius, scene units; 0: from the scene
  double alpha = 2.0 / 3.0;        ///< Knaus & Zwicker's α
  double cellSize = 1;             ///< edge of a grid cell in gather radii
  int nearest = 50;                ///< k of the k-nearest gather
  int maxDepth = 0;                ///< edges of a path; 0: unlimited (cut at hardDepthLimit and counted)
  std::uint64_t seed = 1;
  int bins = 32;                   ///< SAH bins per axis
  int leafSize = 4;                ///< primitives below which a node is not split
  int treeDepth = 0;               ///< 0: 8 + 1.3 log2(primitives)
  std::uint64_t photonMemory = 0;  ///< MiB for photons; 0: a quarter of the device's memory
  bool indirectOnly = false;       ///< leave out emission and direct light (paper, Figure 2's indirect part)

  template <class V>
  void params(V&& v) {
    v("mode", mode, ParamInfo{"ray, path or sppm"});
    v("direct", direct, ParamInfo{"direct light in sppm: shadow or photons"});
    v("gather", gather, ParamInfo{"photon gather: radius or nearest"});
    v("accel", accel, ParamInfo{"ray acceleration: auto, tree or brute"});
    v("split", split, ParamInfo{"kd-tree builder: sah or midpoint"});
    v("sampler", sampler, ParamInfo{"sobol or independent"});
    v("width", width, ParamInfo{"image width; 0: from the scene", 0, 65536, "pixels"});
    v("height", height, ParamInfo{"image height; 0: from the scene", 0, 65536, "pixels"});
    v("photons", photons, ParamInfo{"photon paths an iteration", 1, 4294967295.0});
    v("radius", radius, ParamInfo{"first gather radius; 0: from the scene", 0, 1e30, "scene units"});
    v("alpha", alpha, ParamInfo{"share of photons kept as the radius shrinks", 0.01, 1});
    v("cell-size", cellSize, ParamInfo{"edge of a grid cell", 0.25, 16, "gather radii"});
    v("nearest", nearest, ParamInfo{"k of the k-nearest gather", 2, 128});
    v("max-depth", maxDepth, ParamInfo{"edges of a path; 0: unlimited", 0, 1024});
    v("seed", seed, ParamInfo{"random seed", 0, 18446744073709551615.0});
    v("bins", bins, ParamInfo{"SAH bins per axis", 2, 1024});
    v("leaf-size", leafSize, ParamInfo{"primitives below which a node is not split", 1, 1024});
    v("tree-depth", treeDepth, ParamInfo{"deepest tree level; 0: from the primitive count", 0, 64});
    v("photon-memory", photonMemory, ParamInfo{"memory for photons; 0: a quarter of the device's", 0, 1e9, "MiB"});
    v("indirect-only", indirectOnly, ParamInfo{"leave out emission and direct light"});
  }
};

/// A path of this many edges is ended and counted as truncated even where max-depth is unlimited.
inline constexpr int hardDepthLimit = 1024;

}  // namespace ropelight
