#pragma once
// `sppm`: stochastic progressive photon mapping (Hachisuka & Jensen 2009) with Knaus & Zwicker's independent iterations
// (2011): each one estimates the image with its own photons and its own radius, and the film is their mean.

#include "render/integrators/photon_map.h"
#include "render/kernels/gather_glossy.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class SppmIntegrator final : public IntegratorBase<Backend> {
  using Base = IntegratorBase<Backend>;
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

 public:
  explicit SppmIntegrator(const Prepared& p) : Base(p) { settingsChanged(); }

  std::uint32_t presentPhotons(std::uint32_t most) override {
    std::uint32_t const photons = hasPhotons() && this->state_.committed > 0 ? this->state_.chunkPhotons : 0;
    std::uint32_t const count = std::min(photons, most);
    this->backend_.activate();
    points3d_.allocate(this->backend_, "display", count);
    if (count > 0)
      this->backend_.forEach(
          count, ResolvePhotons{map_.grid().positions, map_.grid().powers, photons, count, points3d_.span()});
    this->backend_.synchronize();
    return this->backend_.interrupted() ? 0 : count;
  }
  void copyPhotons(PhotonPoint* to, std::uint32_t count) const override {
    this->backend_.copyOut(to, points3d_, std::min<std::size_t>(count, points3d_.size()));
  }

  Stats stats() const override {
    Stats s = Base::stats();
    if (!hasPhotons()) return s;
    s.photonPaths = s.iterations * this->prepared_.settings.photons;
    s.chunks = map_.plan().chunks;
    s.settings.photonMemory = budget_ >> 20;
    s.firstRadius = this->prepared_.settings.radius;
    s.radius = radiusOf(std::max<std::uint64_t>(s.iterations, 1));
    return s;
  }

 protected:
  void settingsChanged() override {
    const Settings& s = this->prepared_.settings;
    points_.allocate(this->backend_, "gather points", hasPhotons() ? this->frame_.slots() : 0);
    glossy_.allocate(this->backend_, "gather points", hasPhotons() && isGlossy() ? this->frame_.slots() : 0);
    if (!hasPhotons()) return map_.release();
    if (s.photons == plannedPhotons_ && s.photonMemory == plannedMemory_ && s.gather == plannedGather_) return;
    budget_ = s.photonMemory > 0 ? s.photonMemory << 20 : this->backend_.device().memory / 4;
    makeRoom(perPath_ > 0 ? perPath_ : expectedPerPath, perPath_ > 0 ? tailPerPath_ : expectedTail);
  }

  void iterate(std::uint64_t i) override {
    this->run(this->frame_.slots(),
              TraceCameraArgs{this->frame_, this->radiance_.span(), points_.span(), glossy_.span()});
    if (hasPhotons()) gatherPhotons(i);
    this->commit();
  }

  void recover() override {
    double const paths = double(map_.plan().paths);
    makeRoom(std::max(perPath_, double(this->state_.photonsNeeded) / paths),
             std::max(tailPerPath_, double(this->state_.tailNeeded) / paths));
    this->clearHalt();
  }

 private:
  bool isGlossy() const { return (this->prepared_.features & feature::glossy) != 0; }
  bool hasPhotons() const { return (this->prepared_.features & feature::photons) != 0; }

  double radiusOf(std::uint64_t iteration) const {
    return gatherRadius(this->prepared_.settings.radius, this->prepared_.settings.alpha, iteration,
                        smallestDisc(*this->prepared_.flat, double(machineEpsilon)));
  }

  /// Room for what was seen, in more and smaller chunks as long as memory does not suffice.
  void makeRoom(double perPath, double tailPerPath) {
    const Settings& s = this->prepared_.settings;
    perPath_ = perPath;
    tailPerPath_ = tailPerPath;
    plannedPhotons_ = 0;  // until it stands
    map_.release();
    for (;; budget_ /= 2) {
      PhotonPlan const plan = planPhotons(s.photons, budget_, perPath, tailPerPath);
      if (plan.chunks > 1 && (this->prepared_.features & feature::nearest))
        throw Error("k-nearest gathering needs all photons of an iteration at once, and they do not fit into " +
                        std::to_string(budget_ >> 20) + " MiB; use fewer --photons or -D gather=radius",
                    ExitCode::outOfMemory);
      try {
        map_.allocate(this->backend_, plan, isGlossy());
        break;
      } catch (const std::bad_alloc&) {
        map_.release();
        if (plan.paths <= 1024) throw;
      }
    }
    plannedPhotons_ = s.photons;
    plannedMemory_ = s.photonMemory;
    plannedGather_ = s.gather;
  }

  void gatherPhotons(std::uint64_t i) {
    const Settings& s = this->prepared_.settings;
    Real const radius = Real(radiusOf(i + 1));
    const PhotonPlan& plan = map_.plan();
    for (std::uint32_t chunk = 0; chunk < plan.chunks; ++chunk) {
      std::uint64_t const first = std::uint64_t(chunk) * plan.paths;
      std::uint32_t const count = std::uint32_t(std::min<std::uint64_t>(plan.paths, s.photons - first));
      map_.build(this->backend_, this->row_, this->frame_, this->stateBuffer_,
                 i * s.photons + (faulty(Fault::chunkNumbers) ? 0 : first), count, Real(s.photons),
                 *this->prepared_.flat, radius * Real(s.cellSize));
      gather(radius);
    }
  }

  void gather(Real radius) {
    const Settings& s = this->prepared_.settings;
    Gathered const output = s.aov == Aov::photonCount    ? Gathered::photonCount
                            : s.aov == Aov::gatherRadius ? Gathered::radius
                                                         : Gathered::radiance;
    GatherView const view{map_.grid(), radius, s.maxDepth};
    std::uint32_t const n = this->frame_.slots();
    if (this->prepared_.features & feature::nearest)
      this->backend_.forEach(n, GatherNearest{view, s.nearest, points_.view(), this->radiance_.span(), output});
    else if (isGlossy() && output == Gathered::radiance)
      this->run(n, GatherGlossyArgs{view, this->frame_.scene.materials, points_.view(), glossy_.view(),
                                    this->radiance_.span()});
    else
      this->backend_.forEach(n, GatherRadius{view, points_.view(), this->radiance_.span(), output});
  }

  PhotonMap<Backend> map_;
  Buffer<GatherPoint> points_;
  Buffer<GlossyPoint> glossy_;
  Buffer<PhotonPoint> points3d_;  ///< for a window
  std::uint64_t budget_ = 0;
  std::uint64_t plannedPhotons_ = 0, plannedMemory_ = 0;
  GatherBy plannedGather_ = GatherBy::radius;  ///< read only where plannedPhotons_ is not 0
  double perPath_ = 0, tailPerPath_ = 0;
};

}  // namespace ropelight::RL_TARGET
