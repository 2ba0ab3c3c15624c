#pragma once
// GatherStream on one backend, which the including unit has included before.

#include <algorithm>
#include <bit>

#include "measure/streams/gather_stream.h"
#include "render/core/error.h"
#include "render/integrators/photon_bins.h"
#include "render/kernels/gather.h"
#include "render/photons/photon_plan.h"

namespace ropelight::RL_TARGET {

struct KeyPhotons {
  static constexpr const char* name = "KeyPhotons";
  static constexpr std::uint32_t grain = 4096;

  Span<const Photon> photons;
  PhotonGrid grid;
  Span<std::uint32_t> keys, slots;

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    keys[i] = grid.key(photons[i].position.p);
    slots[i] = i;
  }
};

/// One query by the renderer's own gathers, or by testing every photon.
template <GatherKind kind>
struct StreamQueries {
  static constexpr const char* name = kind == GatherKind::brute  ? "StreamBrute"
                                      : kind == GatherKind::grid ? "StreamRadius"
                                                                 : "StreamNearest";
  static constexpr std::uint32_t grain = 128;

  GatherView view;
  int k;
  Span<const Photon> photons;
  Span<const GatherPoint> points;
  Span<StreamGather> results;

  RL_HD void operator()(std::uint32_t i, Tally&) const {
    GatherPoint const g = points[i];
    Gathering sum;
    if constexpr (kind == GatherKind::brute)
      sum = testAll(g);
    else if constexpr (kind == GatherKind::grid)
      sum = gatherDisc(view, g);
    else
      sum = gatherNearest(view, g, k);
    results[i] = StreamGather{sum.flux, sum.count, float(sum.radius2)};
  }

 private:
  RL_HD Gathering testAll(const GatherPoint& g) const {
    Gathering sum;
    sum.radius2 = square(view.radius);
    for (const Photon& photon : photons) {
      Real distance2;
      if (!view.onDisc(g, photon.position, distance2) || !view.counts(g, photon.position, photon.power)) continue;
      sum.flux += photon.power.flux;
      ++sum.count;
    }
    return sum;
  }
};

template <class Backend>
class GatherStreamOn final : public GatherStream {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  explicit GatherStreamOn(const BackendChoice& choice) : backend_(choice) {}

  void setPhotons(std::span<const StreamPhoton> photons, const Bounds& bounds) override {
    bounds_ = bounds;
    built_ = false;
    std::vector<Photon> list;
    list.reserve(photons.size());
    for (const StreamPhoton& p : photons)
      list.push_back({{vector(p.position), packDirection(vector(p.normal))}, {p.flux, 0}});
    photons_.allocate(backend_, "photons", list.size());
    backend_.upload(photons_, list.data(), list.size());
    IterationState state;
    state.chunkPhotons = std::uint32_t(list.size());
    state_.allocate(backend_, "photons", 1);
    backend_.upload(state_, &state, 1);
  }

  void setQueries(std::span<const StreamQuery> queries) override {
    std::vector<GatherPoint> list;
    list.reserve(queries.size());
    for (const StreamQuery& q : queries) {
      Vec3 const n = vector(q.normal);
      list.push_back({vector(q.position), 0, n, packDirection(n), Rgb(1.0f)});
    }
    points_.allocate(backend_, "queries", list.size());
    results_.allocate(backend_, "queries", list.size());
    backend_.upload(points_, list.data(), list.size());
  }

  double build(float cell, std::uint32_t table) override {
    std::uint32_t const n = std::uint32_t(photons_.size());
    if (table == 0) table = tableFor(n);
    bins_.allocate(backend_, n, table);
    built_ = true;
    backend_.synchronize();
    return backend_.timed([&] {
      bins_.layOut(bounds_, double(cell), table);
      backend_.forEach(n, KeyPhotons{photons_.view(), bins_.grid(), bins_.keys(), bins_.slots()});
      bins_.sort(backend_, photons_.view(), state_.view());
    });
  }

  double gather(GatherKind kind, float radius, int k) override {
    if (kind != GatherKind::brute && !built_) throw Error("gather: there is no grid; build one", ExitCode::internal);
    switch (kind) {
      case GatherKind::brute:
        return run<GatherKind::brute>(radius, k);
      case GatherKind::grid:
        return run<GatherKind::grid>(radius, k);
      case GatherKind::nearest:
        return run<GatherKind::nearest>(radius, std::clamp(k, 1, nearestLimit));
    }
    return 0;
  }

  std::vector<StreamGather> results() override {
    std::vector<StreamGather> list(results_.size());
    backend_.download(list.data(), results_, list.size());
    return list;
  }

  DeviceInfo device() const override { return backend_.device(); }

 private:
  static Vec3 vector(const float (&v)[3]) { return Vec3(v[0], v[1], v[2]); }

  template <GatherKind kind>
  double run(float radius, int k) {
    GatherView const view{bins_.grid(), Real(radius), hardDepthLimit};
    return backend_.timed([&] {
      backend_.forEach(std::uint32_t(points_.size()),
                       StreamQueries<kind>{view, k, photons_.view(), points_.view(), results_.span()});
    });
  }

  Backend backend_;
  Bounds bounds_;
  bool built_ = false;
  Buffer<Photon> photons_;
  Buffer<GatherPoint> points_;
  Buffer<StreamGather> results_;
  Buffer<IterationState> state_;
  PhotonBins<Backend> bins_;
};

}  // namespace ropelight::RL_TARGET
