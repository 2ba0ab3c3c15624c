#pragma once
// What the program sees of a rendering: advance it, look at its film, ask what it cost.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/backend/devices.h"
#include "render/backend/kernel_use.h"
#include "render/film/image.h"
#include "render/kernels/photon_point.h"
#include "render/prepare/shared_scene.h"
#include "render/scene/scene.h"
#include "render/settings/settings.h"

namespace ropelight {

/// Counts since reset, and what the automatic settings came to.
struct Stats {
  std::uint64_t iterations = 0;   ///< committed to the film
  double seconds = 0;             ///< spent in advance()
  std::uint64_t rays = 0;         ///< closest-hit rays, camera and photon
  std::uint64_t shadowRays = 0;   ///< any-hit rays
  std::uint64_t photonPaths = 0;  ///< emitted
  std::uint64_t photonsStored = 0;
  std::uint64_t nonFinite = 0;                       ///< samples and photons that were NaN or infinite and left out
  std::map<std::string, std::uint64_t> nonFiniteBy;  ///< the same by the stage that brought them
  std::uint64_t truncatedPaths = 0;                  ///< cut at the hard depth limit
  std::uint64_t regrown = 0;                         ///< iterations traced again after the photon storage had grown
  std::uint64_t chunks = 1;                          ///< parts that one iteration's photons are traced in
  double firstRadius = 0;                            ///< scene units; 0 without photons
  double radius = 0;                                 ///< of the latest iteration
  double firstCausticRadius = 0, causticRadius = 0;  ///< likewise of caustics; 0 where they are not apart
  Settings settings;                                 ///< resolved: no automatic value is left
  std::vector<std::string> advice;                   ///< settings that make no sense for the scene, a sentence each
  std::string accel;                                 ///< what rays go through
  std::uint64_t treeNodes = 0;                       ///< of the kd-tree or the BVHs; 0 without one
  std::uint64_t treeLeaves = 0;
  int treeDepth = 0;
  double treeSeconds = 0;  ///< to build it
  double treeCost = 0;     ///< SAH cost in primitive tests
  std::string kernelRow;   ///< the row of rows.h in use
  std::string device;
  FeatureBits features = 0;
  std::map<std::string, std::uint64_t> bytes;     ///< device memory by purpose
  std::map<std::string, std::uint64_t> launches;  ///< stage name → times launched since reset
  std::map<std::string, double> stageSeconds;     ///< stage name → seconds, where measured
};

/// "3 of TracePhotons, 1 of gather": where samples and photons came from that were not finite.
std::string nonFiniteStages(const Stats& stats);

struct KdTree;

/// One thread at a time may call it; interrupt() alone may come from any other.
class Integrator {
 public:
  virtual ~Integrator() = default;
  /// Adds `count` iterations to the film and returns true when they are committed. False after interrupt(): only
  /// reset() and restart() may follow.
  virtual bool advance(int count) = 0;
  /// Makes an advance() that is running, or the next one, return early.
  virtual void interrupt() = 0;
  /// Starts again with an empty film and the same settings.
  virtual void reset() = 0;
  /// Starts again with another camera and other settings, keeping the scene and its tree. False, with nothing changed,
  /// where they need another integrator. Throws Error (usage) for settings that contradict each other.
  virtual bool restart(const CameraDesc& camera, const Settings& settings) = 0;
  /// Measures every stage on a GPU too, at the cost of a synchronisation each.
  virtual void timeStages(bool on) = 0;
  /// The mean of all iterations, linear radiance.
  virtual Image film() const = 0;
  virtual Stats stats() const = 0;
  /// Of the frame that the tree and the photons are in, in the scene file's coordinates.
  virtual Vec3d frameOrigin() const = 0;
  /// The tree that rays go through, in the frame; empty where every primitive is tested.
  virtual std::shared_ptr<const KdTree> tree() const = 0;

  /// Makes the mean of all iterations ready for copyPixels. False after interrupt().
  virtual bool present() = 0;
  /// Copies what present() made: width·height RGBA in 32-bit floats (A: 1), row by row from the top. `to` is host
  /// memory, or memory of the integrator's GPU.
  virtual void copyPixels(void* to) const = 0;
  /// Makes at most `most` photons of the latest iteration ready for copyPhotons, evenly chosen; how many there are.
  virtual std::uint32_t presentPhotons(std::uint32_t most) = 0;
  /// Copies the first `count` of what presentPhotons made; `to` as above.
  virtual void copyPhotons(PhotonPoint* to, std::uint32_t count) const = 0;
  /// Index of the GPU whose memory it uses; −1: host memory.
  virtual int gpu() const = 0;
};

/// Flattens the scene, builds the acceleration structure and allocates the buffers that its features ask for.
/// `auto` takes the first usable GPU, else the CPU; `why` (if given) says which and why.
/// Throws Error: noDevice where the backend asked for cannot be used, outOfMemory where buffers do not fit, usage for
/// settings that contradict each other. `cache`, of the same scene, saves the work that it already holds.
std::unique_ptr<Integrator> makeIntegrator(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                           std::string* why = nullptr, std::shared_ptr<SceneCache> cache = nullptr);

/// What the kernels of every row take of the GPU; empty on the CPU. Throws as makeIntegrator does.
std::vector<KernelUse> kernelUses(const BackendChoice& choice);

}  // namespace ropelight
