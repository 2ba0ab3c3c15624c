#pragma once
// Settings and statistics as data: for --json and for the metadata of an image.

#include <nlohmann/json.hpp>
#include <string>

#include "render/core/bytes.h"
#include "render/image_files/exr.h"
#include "render/integrators/integrator.h"
#include "render/scene/scene.h"

namespace ropelight {

nlohmann::ordered_json toJson(Settings settings);
nlohmann::ordered_json toJson(const Stats& stats);

/// Iterations per second.
double iterationRate(const Stats& stats);

/// Millions per second of rays (closest-hit and shadow), and of photon paths. 0 where no time was spent.
double megaRays(const Stats& stats);
double megaPhotons(const Stats& stats);

/// The metadata of an image: every setting, and iterations, seconds, device, version and scene.
Metadata imageMetadata(Settings resolvedSettings, const Scene& scene, const Stats& stats);

}  // namespace ropelight
