#include "render/prepare/first_radius.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
/// The same of caustics, whose discs shrink to fit: tried from 24 to 80 on the two scenes of
/// docs/benchmarks/caustics.md.
constexpr double causticsPerDisc = 40;
constexpr int pilotWidth = 48;
constexpr int neighbours = 8;
constexpr double leastShare = 0.05;  // of either kind of photons: the pilot may have missed some
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

/// What photons of a class do at the points that the camera sees.
struct Survey {
  double paths = 0;                   ///< traced
  std::vector<PointDensity> density;  ///< by point, radiance of the whole light; empty where there are no photons

  double radiance(std::size_t point) const { return density.empty() ? 0 : density[point].radiance; }
};

class Pilot {
 public:
  explicit Pilot(const Prepared& p) : prepared_(p), backend_(p.backend), scene_(backend_, p) {
    const Settings& s = p.settings;
    frame_.scene = scene_.view;
    frame_.width = pilotWidth;
    frame_.height = std::clamp(pilotWidth * s.height / s.width, 1, 4 * pilotWidth);
    frame_.camera = makeCamera(p.camera, frame_.width, frame_.height);
    frame_.maxDepth = s.maxDepth;
    frame_.seed = s.seed;
    frame_.shadowRays = s.direct == DirectLight::shadow;
    radiance_.resize(frame_.slots());
    points_.resize(frame_.slots());
    launch(backend_, rowFor(p.features), frame_.slots(),
           TraceCameraArgs{frame_, {radiance_.data(), frame_.slots()}, {points_.data(), frame_.slots()}, {}});
  }

  Survey survey(PhotonClass photons) {
    frame_.photonClass = photons;
    Survey found;
    std::vector<PilotPhoton> const stored = collect(found.paths);
    if (stored.size() < neighbours) return found;
    found.density.resize(points_.size());
    backend_.forEach(std::uint32_t(points_.size()), FindDensity{&points_, &stored, &found.density});
    for (PointDensity& d : found.density)
      d.radiance = std::isfinite(d.radiance) ? d.radiance / (M_PI * found.paths) : 0;
    return found;
  }

  /// By point, what light of caustics weighs in relMSE: Lc²/(L² + ε), and that of the others.
  struct Weights {
    std::vector<double> caustics, others;
  };

  Weights weigh(const Survey& caustics, const Survey& others) const {
    std::size_t const n = points_.size();
    std::vector<double> total(n);
    double square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double const direct = double(mean(radiance_[i]));
      total[i] = (std::isfinite(direct) ? direct : 0) + caustics.radiance(i) + others.radiance(i);
      square += total[i] * total[i] / double(n);
    }
    Weights weights;
    for (std::size_t i = 0; i < n; ++i) {
      double const w = 1 / (total[i] * total[i] + 0.01 * square + 1e-300);
      weights.caustics.push_back(w * caustics.radiance(i) * caustics.radiance(i));
      weights.others.push_back(w * others.radiance(i) * others.radiance(i));
    }
    return weights;
  }

 private:
  std::vector<PilotPhoton> collect(double& traced) {
    std::vector<std::vector<PilotPhoton>> byPath(pathBatch);
    std::vector<PilotPhoton> photons;
    std::uint64_t paths = 0;
    for (std::uint32_t batch = 0; batch < mostBatches && photons.size() < enoughPhotons; ++batch) {
      backend_.forEach(pathBatch, CollectPhotons{frame_, paths, &byPath});
      for (auto const& p : byPath) {
        if (photons.size() >= enoughPhotons) break;
        photons.insert(photons.end(), p.begin(), p.end());
        ++paths;
      }
    }
    traced = double(paths);
    return photons;
  }

  const Prepared& prepared_;
  Backend backend_;
  DeviceScene<Backend> scene_;
  FrameView frame_;
  std::vector<Rgb> radiance_;  ///< without photons
  std::vector<GatherPoint> points_;
};

std::vector<double> radiances(const Survey& survey) {
  std::vector<double> out;
  for (const PointDensity& d : survey.density) out.push_back(d.radiance);
  return out;
}

/// Squared distance to the last of the neighbours, the median by weight; 0 where there are no photons.
double typicalDistance2(const Survey& survey, const std::vector<double>& weight) {
  std::vector<std::pair<double, double>> points;  // distance², weight
  double total = 0, sum = 0;
  for (std::size_t i = 0; i < survey.density.size(); ++i) {
    if (!(weight[i] > 0)) continue;
    points.emplace_back(survey.density[i].distance2, weight[i]);
    total += weight[i];
  }
  std::sort(points.begin(), points.end());
  for (auto const& [distance2, w] : points)
    if ((sum += w) >= total / 2) return distance2;
  return 0;
}

/// The radius whose disc holds `wanted` of the photons of `paths` paths.
double radiusFor(double wanted, const Survey& survey, double distance2, const Prepared& p, std::uint64_t paths) {
  const FlatScene& flat = *p.flat;
  Vec3d const center = 0.5 * (flat.bounds.min + flat.bounds.max);
  double const footprint = pixelFootprint(p, glm::length(center - p.camera.position));
  double const size = glm::length(flat.bounds.extent());
  double const perPath = (neighbours - 1) / (M_PI * distance2 * survey.paths);  // photons per area and path
  double const radius = distance2 > 0 ? std::sqrt(wanted / (M_PI * perPath * double(paths))) : 0;
  return std::clamp(std::max(radius, 0.5 * footprint), 1e-6 * size, 0.05 * size);
}

/// The share of caustics c by which Σ wc/c + Σ wo/(1 − c) is the least.
double causticShare(const std::vector<double>& caustics, const std::vector<double>& others) {
  double const c = std::sqrt(std::accumulate(caustics.begin(), caustics.end(), 0.0));
  double const o = std::sqrt(std::accumulate(others.begin(), others.end(), 0.0));
  return c + o > 0 ? std::clamp(c / (c + o), leastShare, 1 - leastShare) : 0.5;
}

}  // namespace

double pixelFootprint(const Prepared& p, double distance) {
  return 2 * distance * std::tan(glm::radians(p.camera.verticalFov) / 2) / p.settings.height;
}

void resolvePhotons(Prepared& p) {
  Settings& s = p.settings;
  bool const apart = (p.features & feature::caustics) != 0;
  bool const known = s.radius > 0 && (!apart || (s.causticRadius > 0 && s.causticShare > 0));
  if (known) return;
  Pilot pilot(p);
  if (!apart) {
    Survey const all = pilot.survey(PhotonClass::every);
    s.radius = radiusFor(photonsPerDisc, all, typicalDistance2(all, radiances(all)), p, s.photons);
    return;
  }
  Survey const caustics = pilot.survey(PhotonClass::caustic), others = pilot.survey(PhotonClass::global);
  Pilot::Weights const weights = pilot.weigh(caustics, others);
  if (s.causticShare == 0) s.causticShare = causticShare(weights.caustics, weights.others);
  if (s.causticRadius == 0)
    s.causticRadius =
        radiusFor(causticsPerDisc, caustics, typicalDistance2(caustics, weights.caustics), p, s.causticPaths());
  if (s.radius == 0)
    s.radius = radiusFor(photonsPerDisc, others, typicalDistance2(others, radiances(others)), p, s.otherPaths());
}

}  // namespace ropelight
