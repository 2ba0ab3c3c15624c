#pragma once
// What the rendering tests share: scenes from the oracle's structs, renderings, regions and their statistics.

#include <array>
#include <string>
#include <vector>

#include "measure/scenes/scene_kit.h"
#include "render/integrators/integrator.h"
#include "tests/oracle/oracle.h"

namespace ropelight::testing {

/// The same scene in the renderer's terms.
Scene fromOracle(const oracle::Scene& scene);

using ropelight::addBox;
using ropelight::addMaterial;
using ropelight::addQuad;
using ropelight::addSphere;
using ropelight::emptyScene;
using ropelight::lookAt;

Settings settingsFor(Mode mode, int width, int height);

/// Image and statistics after `iterations` on the CPU, or on `backend`.
Image renderImage(const Scene& scene, const Settings& settings, int iterations, Stats* stats = nullptr,
                  const BackendChoice& backend = {BackendKind::cpu, 0, 0, false});

/// The CPU, and CUDA where there is a usable device.
std::vector<BackendChoice> everyBackend();

/// Mean of the three channels over all pixels.
double meanOf(const Image& image);

/// Means of square tiles over several independent renderings, with the standard error of each.
struct TileStatistics {
  std::vector<std::array<double, 3>> mean, error;
};
TileStatistics tileStatistics(const std::vector<Image>& renderings, int tile);

/// Renderings that differ by seed alone: seeds 1 … count.
std::vector<Image> renderSeeds(const Scene& scene, Settings settings, int iterations, int count,
                               const BackendChoice& backend = {BackendKind::cpu, 0, 0, false});

/// The tiles where a and b differ by more than `relative` of b and by more than three standard errors of the
/// difference, in words; empty where all agree.
std::string disagreement(const TileStatistics& a, const TileStatistics& b, double relative);

}  // namespace ropelight::testing
