#include "render/prepare/first_radius.h"

#include <algorithm>
#include <cmath>

#include "render/backend/cpu_backend.h"
#include "render/kernels/gather.h"
#include "render/kernels/trace_photons.h"
#include "render/launch/launch.h"
#include "render/upload/upload.h"

namespace ropelight {
namespace {

using namespace cpu;  // the pilot runs on the CPU alone

/// Expected photons in the first disc, from radius sweeps over the assets (docs/benchmarks/first-radius.md).
constexpr double photonsPerDisc = 24;
constexpr int pilotWidth = 48;
constexpr int neighbours = 8;
constexpr std::uint32_t pathBatch = 16384, mostBatches = 16, enoughPhotons = 16384;

struct PilotPhoton {
  Vec3 p;
  float flux;
};

/// Photons of one batch, kept by path so that their order does not depend on threads.
struct CollectPhotons {
  static constexpr const char* name = "CollectPhotons";
  static constexpr std::uint32_t grain = 512;

  FrameView frame;
  std::uint64_t first;
  std::vector<std::vector<PilotPhoton>>* byPath;

  void operator()(std::uint32_t path, Tally& tally) const {
    auto& photons = (*byPath)[path];
    photons.clear();
    tracePhotonPath<feature::all>(
        frame, first + path, 1,
        [&](std::uint32_t, const PhotonPosition& at, const PhotonPower& power, Vec3) {
          photons.push_back({at.p, mean(power.flux)});
        },
        tally);
  }
};

/// Squared distance to the last of the nearest photons of a gather point, and the radiance they bring.
struct PointDensity {
  double distance2 = 0, radiance = 0;
};

struct FindDensity {
  static constexpr const char* name = "FindDensity";
  static constexpr std::uint32_t grain = 8;

  const std::vector<GatherPoint>* points;
  const std::vector<PilotPhoton>* photons;
  std::vector<PointDensity>* out;

  void operator()(std::uint32_t i, Tally&) const {
    const GatherPoint& g = (*points)[i];
    if (isBlack(g.weight)) return;
    std::pair<float, float> nearest[neighbours];  // distance², flux; ascending
    std::fill(nearest, nearest + neighbours, std::pair(INFINITY, 0.0f));
    for (const PilotPhoton& photon : *photons) {
      float const d2 = lengthSquared(photon.p - g.p);
      if (d2 >= nearest[neighbours - 1].first) continue;
      int k = neighbours - 1;
      for (; k > 0 && nearest[k - 1].first > d2; --k) nearest[k] = nearest[k - 1];
      nearest[k] = {d2, photon.flux};
    }
    double flux = 0;
    for (auto const& n : nearest) flux += double(n.second);
    PointDensity& density = (*out)[i];
    density.distance2 = double(nearest[neighbours - 1].first);
    density.radiance = double(mean(g.weight)) * flux / density.distance2;
  }
};

class Pilot {
 public:
  Pilot(const Prepared& p, PhotonClass photons) : prepared_(p), backend_(p.backend), scene_(backend_, p) {
    const Settings& s = p.settings;
    frame_.photonClass = photons;
    frame_.scene = scene_.view;
    frame_.width = pilotWidth;
    frame_.height = std::clamp(pilotWidth * s.height / s.width, 1, 4 * pilotWidth);
    frame_.camera = makeCamera(p.camera, frame_.width, frame_.height);
    frame_.maxDepth = s.maxDepth;
    frame_.seed = s.seed;
    frame_.shadowRays = s.direct == DirectLight::shadow;
  }

  /// 0 where the camera sees no photons.
  double radius() {
    std::vector<GatherPoint> const points = tracePoints();
    std::uint64_t const paths = collect();
    if (photons_.size() < neighbours) return 0;
    std::vector<PointDensity> densities(points.size());
    backend_.forEach(std::uint32_t(points.size()), FindDensity{&points, &photons_, &densities});
    double const distance2 = weightedMedian(densities);
    double const perPath = (neighbours - 1) / (M_PI * distance2 * double(paths));  // photons per area and path
    return distance2 > 0 ? std::sqrt(photonsPerDisc / (M_PI * perPath * pathsPerIteration())) : 0;
  }

 private:
  double pathsPerIteration() const {
    const Settings& s = prepared_.settings;
    return double(frame_.photonClass == PhotonClass::caustic ? s.causticPhotons : s.photons);
  }

  std::vector<GatherPoint> tracePoints() {
    std::vector<Rgb> radiance(frame_.slots());
    std::vector<GatherPoint> points(frame_.slots());
    FrameView frame = frame_;
    frame.indirectOnly = true;  // no shadow rays: only the places matter
    launch(backend_, rowFor(prepared_.features), frame.slots(),
           TraceCameraArgs{frame, {radiance.data(), frame.slots()}, {points.data(), frame.slots()}, {}});
    return points;
  }

  std::uint64_t collect() {
    std::vector<std::vector<PilotPhoton>> byPath(pathBatch);
    std::uint64_t paths = 0;
    for (std::uint32_t batch = 0; batch < mostBatches && photons_.size() < enoughPhotons; ++batch) {
      backend_.forEach(pathBatch, CollectPhotons{frame_, paths, &byPath});
      for (auto const& p : byPath) {
        if (photons_.size() >= enoughPhotons) break;
        photons_.insert(photons_.end(), p.begin(), p.end());
        ++paths;
      }
    }
    return paths;
  }

  static double weightedMedian(std::vector<PointDensity>& densities) {
    std::erase_if(densities, [](const PointDensity& d) { return !(d.radiance > 0) || !std::isfinite(d.radiance); });
    std::sort(densities.begin(), densities.end(),
              [](const PointDensity& a, const PointDensity& b) { return a.distance2 < b.distance2; });
    double total = 0, sum = 0;
    for (const PointDensity& d : densities) total += d.radiance;
    for (const PointDensity& d : densities)
      if ((sum += d.radiance) >= total / 2) return d.distance2;
    return 0;
  }

  const Prepared& prepared_;
  Backend backend_;
  DeviceScene<Backend> scene_;
  FrameView frame_;
  std::vector<PilotPhoton> photons_;
};

}  // namespace

double pixelFootprint(const Prepared& p, double distance) {
  return 2 * distance * std::tan(glm::radians(p.camera.verticalFov) / 2) / p.settings.height;
}

double automaticRadius(const Prepared& p, PhotonClass photons) {
  const FlatScene& flat = *p.flat;
  Vec3d const center = 0.5 * (flat.bounds.min + flat.bounds.max);
  double const footprint = pixelFootprint(p, glm::length(center - p.camera.position));
  double const size = glm::length(flat.bounds.extent());
  double const radius = std::max(Pilot(p, photons).radius(), 0.5 * footprint);
  return std::clamp(radius, 1e-6 * size, 0.25 * size);
}

}  // namespace ropelight
