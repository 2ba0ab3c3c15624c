#pragma once
// What the host does once before any backend: flatten, decide features, resolve automatic settings, build the tree.

#include <optional>

#include "render/backend/devices.h"
#include "render/prepare/scene_cache.h"
#include "render/settings/settings.h"
#include "render/upload/structures.h"

namespace ropelight {

/// A scene made ready for a backend, with the settings resolved.
struct Prepared : SceneStructures {
  CameraDesc camera;  ///< in the flat scene's frame
  FilmDesc film;
  Settings requested;     ///< as given
  Settings settings;      ///< resolved: no zero that means 'automatic' is left
  BackendChoice backend;  ///< its gpu is the one taken
  bool onGpu = false;
};

/// The drivers that are compiled; integratorMakers of render/integrators/modes.h makes them.
enum class IntegratorKind : std::uint8_t { ray, path, sppm, aov };

/// What makes the film that the settings ask for: the mode's driver, or aov for what the first hit alone shows.
IntegratorKind integratorOf(const Settings& settings);

/// The whole table of features: the scene's, and those that the settings add or make unnecessary.
FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera, const Settings& settings);

/// onGpu: whether backend.gpu is to be used. Throws Error: usage where settings contradict each other,
/// outOfMemory where they need more memory than there is.
Prepared prepare(const Scene& scene, const Settings& settings, const BackendChoice& backend, bool onGpu,
                 SceneCache& cache);

/// The same scene and tree with another camera and other settings; empty where those need another integrator. Throws
/// as prepare does.
std::optional<Prepared> prepareAgain(const Prepared& before, const CameraDesc& camera, const Settings& settings);

/// Gather radius of iteration i = 1, 2, …: r_i² = r_1² Γ(i+α) / (Γ(1+α) Γ(i+1)), the closed form of
/// r²_{i+1} = r²_i (i+α)/(i+1) (Knaus & Zwicker 2011, eq. 20), never below `floor`.
double gatherRadius(double firstRadius, double alpha, std::uint64_t iteration, double floor);

}  // namespace ropelight
