#pragma once
// Everything that a user can set of a rendering. Zero means 'automatic' where the text says so; the resolved value is
// reported and written into the metadata.

#include <cstdint>

#include "render/core/params.h"
#include "render/settings/choices.h"

namespace ropelight {

/// A path of this many edges is ended and counted as truncated even where max-depth is unlimited.
inline constexpr int hardDepthLimit = 65536;

struct Settings {
  Mode mode = Mode::sppm;
  Aov aov = Aov::radiance;
  DirectLight direct = DirectLight::shadow;
  GatherBy gather = GatherBy::radius;
  Caustics caustics = Caustics::aimed;
  Accel accel = Accel::automatic;
  SplitBy split = SplitBy::sah;
  SamplerKind sampler = SamplerKind::sobol;
  int width = 0;                   ///< pixels; 0: the scene's film
  int height = 0;                  ///< pixels; 0: the scene's film
  std::uint64_t photons = 262144;  ///< photon paths an iteration
  double causticShare = 0;         ///< of the photon paths, for caustics; 0: from the scene
  double radius = 0;               ///< first gather radius, scene units; 0: from the scene
  double quadScale = 1.6;          ///< radius on quads, whose discs are cut at edges, over that on other surfaces
  double causticRadius = 0;        ///< the same for caustics; 0: from the scene
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

  bool operator==(const Settings&) const = default;

  /// Photon paths of an iteration for caustics, where they are apart and the share is known; the others are `photons`
  /// less these. Neither is none.
  std::uint64_t causticPaths() const {
    auto const paths = std::uint64_t(causticShare * double(photons));
    return paths < 1 ? 1 : (paths >= photons && photons > 1 ? photons - 1 : paths);
  }
  std::uint64_t otherPaths() const { return photons > 1 ? photons - causticPaths() : 1; }

  /// Calls v(name, member, info) for every setting in order.
  template <class V>
  void params(V&& v) {
    modeParams(v);
    photonParams(v);
    accelerationParams(v);
    samplingParams(v);
    filmParams(v);
  }

 private:
  using I = ParamInfo;

  template <class V>
  void modeParams(V& v) {
    v("mode", mode, I{.doc = "how light is found", .group = "Mode", .choices = choicesOf<Mode>});
    v("aov", aov, I{.doc = "what the film holds", .group = "Mode", .choices = choicesOf<Aov>});
    v("direct", direct,
      I{.doc = "what brings direct light in sppm", .group = "Mode", .choices = choicesOf<DirectLight>});
    v("indirect-only", indirectOnly, I{.doc = "leave out emission and direct light", .group = "Mode"});
    v("max-depth", maxDepth,
      I{.doc = "edges of a path; 0: unlimited",
        .min = 0,
        .max = hardDepthLimit,
        .group = "Mode",
        .high = 32,
        .zero = "unlimited"});
  }

  template <class V>
  void photonParams(V& v) {
    v("photons", photons,
      I{.doc = "photon paths an iteration",
        .min = 1,
        .max = 4294967295.0,
        .group = "Photons",
        .low = 1024,
        .high = 16777216,
        .logarithmic = true});
    v("radius", radius,
      I{.doc = "first gather radius; 0: from the scene",
        .min = 0,
        .max = 1e30,
        .unit = "scene units",
        .group = "Photons",
        .logarithmic = true,
        .zero = "from the scene"});
    v("quad-scale", quadScale,
      I{.doc = "radius on quads, whose discs are cut at edges, over that elsewhere; not of caustics",
        .min = 0.1,
        .max = 10,
        .group = "Photons",
        .logarithmic = true});
    v("caustics", caustics,
      I{.doc = "where photons of caustics come from", .group = "Photons", .choices = choicesOf<Caustics>});
    v("caustic-share", causticShare,
      I{.doc = "share of the photon paths that are for caustics; 0: from the scene",
        .min = 0,
        .max = 0.99,
        .group = "Photons",
        .zero = "from the scene"});
    v("caustic-radius", causticRadius,
      I{.doc = "first gather radius of caustics; 0: from the scene",
        .min = 0,
        .max = 1e30,
        .unit = "scene units",
        .group = "Photons",
        .logarithmic = true,
        .zero = "from the scene"});
    v("alpha", alpha,
      I{.doc = "share of photons kept as the radius shrinks", .min = 0.01, .max = 1, .group = "Photons"});
    v("gather", gather, I{.doc = "which photons a gather takes", .group = "Photons", .choices = choicesOf<GatherBy>});
    v("nearest", nearest, I{.doc = "k of the k-nearest gather", .min = 2, .max = 128, .group = "Photons"});
    v("cell-size", cellSize,
      I{.doc = "edge of a grid cell; shorter along x, and longer where there is no room for so many",
        .min = 0.25,
        .max = 16,
        .unit = "gather radii",
        .group = "Photons",
        .logarithmic = true});
    v("photon-memory", photonMemory,
      I{.doc = "memory for photons; 0: a quarter of the device's",
        .min = 0,
        .max = 1e9,
        .unit = "MiB",
        .group = "Photons",
        .high = 16384,
        .zero = "a quarter of the device's"});
  }

  template <class V>
  void accelerationParams(V& v) {
    v("accel", accel,
      I{.doc = "what rays go through", .group = "Acceleration", .choices = choicesOf<Accel>, .zero = "auto"});
    v("split", split,
      I{.doc = "where the kd-tree's builder splits a node", .group = "Acceleration", .choices = choicesOf<SplitBy>});
    v("bins", bins,
      I{.doc = "SAH bins per axis of the kd-tree",
        .min = 2,
        .max = 1024,
        .group = "Acceleration",
        .logarithmic = true});
    v("leaf-size", leafSize,
      I{.doc = "primitives below which a node of the kd-tree is not split",
        .min = 1,
        .max = 1024,
        .group = "Acceleration",
        .logarithmic = true});
    v("tree-depth", treeDepth,
      I{.doc = "deepest level of the kd-tree; 0: from the primitive count",
        .min = 0,
        .max = 64,
        .group = "Acceleration",
        .zero = "from the primitive count"});
  }

  template <class V>
  void samplingParams(V& v) {
    v("sampler", sampler,
      I{.doc = "where the numbers of a path come from", .group = "Sampling", .choices = choicesOf<SamplerKind>});
    v("seed", seed, I{.doc = "random seed", .min = 0, .max = 18446744073709551615.0, .group = "Sampling", .high = 100});
  }

  template <class V>
  void filmParams(V& v) {
    v("width", width,
      I{.doc = "image width; 0: from the scene",
        .min = 0,
        .max = 65536,
        .unit = "pixels",
        .group = "Film",
        .high = 3840,
        .zero = "from the scene"});
    v("height", height,
      I{.doc = "image height; 0: from the scene",
        .min = 0,
        .max = 65536,
        .unit = "pixels",
        .group = "Film",
        .high = 2160,
        .zero = "from the scene"});
  }
};

}  // namespace ropelight
