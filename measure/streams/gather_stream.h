#pragma once
// Photons and gather points without a rendering around them: what the gather benchmark times and what its checks ask.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "render/backend/devices.h"
#include "render/integrators/integrator.h"
#include "render/scene/bounds.h"

namespace ropelight {

struct StreamPhoton {
  float position[3];
  float normal[3];  ///< unit, towards where the photon came from
  Rgb flux{1.0f};
};

struct StreamQuery {
  float position[3];
  float normal[3];
};

/// Which photons a query adds up: all within the radius, or the k nearest of them.
enum class GatherKind : std::uint8_t { brute, grid, nearest };

/// flux: sum over the photons taken; count: how many were found; radius2: squared radius of the disc they lie on. Where
/// `nearest` finds all k, the k-th gives radius2 and is counted, and flux is that of the others.
struct StreamGather {
  Rgb flux{0.0f};
  std::uint32_t count = 0;
  float radius2 = 0;
};

class GatherStream {
 public:
  virtual ~GatherStream() = default;

  virtual void setPhotons(std::span<const StreamPhoton> photons, const Bounds& bounds) = 0;
  virtual void setQueries(std::span<const StreamQuery> queries) = 0;
  /// Sorts the photons into cells of that edge (scene units; finer along x where the table has room); `table`: most
  /// cells, a power of two, 0: twice the photons as the renderer has it. Seconds on the device, or of wall clock on the
  /// CPU.
  virtual double build(float cell, std::uint32_t table = 0) = 0;
  /// One gather of all queries; seconds as above. k, from 1 to 128, counts for `nearest` alone. `brute` needs no build.
  virtual double gather(GatherKind kind, float radius, int k) = 0;
  /// Of the last gather, by query.
  virtual std::vector<StreamGather> results() = 0;
  virtual DeviceInfo device() const = 0;
};

std::unique_ptr<GatherStream> makeGatherStream(const BackendChoice& choice);

}  // namespace ropelight
