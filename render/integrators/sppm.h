#pragma once
// `sppm`: stochastic progressive photon mapping (Hachisuka & Jensen 2009) with Knaus & Zwicker's independent iterations
// (2011): each one estimates the image with its own photons and its own radius, and the film is their mean.

#include <bit>

#include "render/integrators/photon_map.h"
#include "render/kernels/gather_adaptive.h"
#include "render/kernels/gather_glossy.h"

namespace ropelight::RL_TARGET {

template <class Backend>
class SppmIntegrator final : public IntegratorBase<Backend> {
  using Base = IntegratorBase<Backend>;
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

 public:
  explicit SppmIntegrator(const Prepared& p) : Base(p) {
    settingsChanged();
    reset();
  }

  std::uint32_t presentPhotons(std::uint32_t most) override {
    bool const any = hasPhotons() && this->state_.committed > 0;
    std::uint32_t const others = any ? this->state_.otherPhotons : 0;
    std::uint32_t const caustics = any && hasCaustics() ? this->state_.chunkPhotons : 0;
    std::uint64_t const photons = std::uint64_t(others) + caustics;
    this->backend_.activate();
    std::uint32_t const count = std::uint32_t(std::min<std::uint64_t>(photons, most));
    points3d_.allocate(this->backend_, "display", count);
    std::uint32_t const first = photons > 0 ? std::uint32_t(std::uint64_t(count) * caustics / photons) : 0;
    presentFrom(caustics_, caustics, {points3d_.span().data, first});
    presentFrom(map_, others, {points3d_.span().data + first, count - first});
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
    std::uint64_t const latest = std::max<std::uint64_t>(s.iterations, 1);
    s.radius = radiusOf(latest, s.firstRadius);
    if (!hasCaustics()) return s;
    s.firstCausticRadius = this->prepared_.settings.causticRadius;
    s.causticRadius = radiusOf(latest, s.firstCausticRadius);
    return s;
  }

  void reset() override {
    Base::reset();
    if (discs_.size() > 0) this->backend_.clear(discs_);
  }

 protected:
  void settingsChanged() override {
    const Settings& s = this->prepared_.settings;
    points_.allocate(this->backend_, "gather points", hasPhotons() ? this->frame_.slots() : 0);
    glossy_.allocate(this->backend_, "gather points", hasPhotons() && isGlossy() ? this->frame_.slots() : 0);
    std::uint32_t const discs = hasPhotons() && hasCaustics() && !isGlossy() ? this->frame_.slots() : 0;
    discs_.allocate(this->backend_, "gather points", discs);
    if (!hasPhotons()) {
      caustics_.release();
      return map_.release();
    }
    if (s.photons == plannedPhotons_ && s.causticShare == plannedShare_ && s.photonMemory == plannedMemory_ &&
        s.gather == plannedGather_)
      return;
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

  bool hasCaustics() const { return (this->prepared_.features & feature::caustics) != 0; }

  double radiusOf(std::uint64_t iteration, double first) const {
    return gatherRadius(first, this->prepared_.settings.alpha, iteration,
                        smallestDisc(*this->prepared_.flat, double(machineEpsilon)));
  }

  /// Room for what was seen, in more and smaller chunks as long as memory does not suffice.
  void makeRoom(double perPath, double tailPerPath) {
    const Settings& s = this->prepared_.settings;
    perPath_ = perPath;
    tailPerPath_ = tailPerPath;
    plannedPhotons_ = 0;  // until it stands
    map_.release();
    caustics_.release();
    for (;; budget_ /= 2) {
      std::uint64_t const forCaustics = hasCaustics() ? causticBudget(budget_) : 0;
      PhotonPlan const plan = planPhotons(others(), budget_ - forCaustics, perPath, tailPerPath);
      if (plan.chunks > 1 && (this->prepared_.features & feature::nearest))
        throw Error("k-nearest gathering needs all photons of an iteration at once, and they do not fit into " +
                        std::to_string(budget_ >> 20) + " MiB; use fewer --photons or -D gather=radius",
                    ExitCode::outOfMemory);
      try {
        map_.allocate(this->backend_, plan, isGlossy());
        if (hasCaustics()) caustics_.allocate(this->backend_, planCaustics(s.causticPaths(), forCaustics), isGlossy());
        break;
      } catch (const std::bad_alloc&) {
        map_.release();
        caustics_.release();
        if (plan.paths <= 1024) throw;
      }
    }
    plannedPhotons_ = s.photons;
    plannedShare_ = s.causticShare;
    plannedMemory_ = s.photonMemory;
    plannedGather_ = s.gather;
  }

  /// Discs of caustics fit what they lie on, where all photons of an iteration are there at once.
  bool isAdaptive() const { return hasCaustics() && !isGlossy() && caustics_.plan().chunks == 1; }

  /// Iterations after which discs are looked at: the first eight, then eight an octave.
  static bool isDue(std::uint64_t i) {
    int const octave = std::bit_width(i + 1) - 1;
    return octave < 3 || ((i + 1) & ((std::uint64_t(1) << (octave - 3)) - 1)) == 0;
  }

  /// Photon paths that are not for caustics.
  std::uint64_t others() const {
    const Settings& s = this->prepared_.settings;
    return hasCaustics() ? s.otherPaths() : s.photons;
  }

  /// Caustics last: their discs learn from an iteration only once all its photons have found room.
  void gatherPhotons(std::uint64_t i) {
    const Settings& s = this->prepared_.settings;
    gatherFrom(map_, hasCaustics() ? PhotonClass::global : PhotonClass::every, i, others(),
               Real(radiusOf(i + 1, s.radius)));
    if (!hasCaustics()) return;
    gatherFrom(caustics_, PhotonClass::caustic, i, s.causticPaths(), Real(radiusOf(i + 1, s.causticRadius)));
    if (isAdaptive() && isDue(i))
      this->backend_.forEach(this->frame_.slots(), AdaptDiscs{discs_.span(), this->stateBuffer_.view()});
  }

  void gatherFrom(PhotonMap<Backend>& map, PhotonClass photonClass, std::uint64_t i, std::uint64_t photons,
                  Real radius) {
    FrameView frame = this->frame_;
    frame.photonClass = photonClass;
    const PhotonPlan& plan = map.plan();
    for (std::uint32_t chunk = 0; chunk < plan.chunks; ++chunk) {
      std::uint64_t const first = std::uint64_t(chunk) * plan.paths;
      std::uint32_t const count = std::uint32_t(std::min<std::uint64_t>(plan.paths, photons - first));
      map.build(this->backend_, this->row_, frame, this->stateBuffer_,
                i * photons + (faulty(Fault::chunkNumbers) ? 0 : first), count, Real(photons), *this->prepared_.flat,
                radius * Real(this->prepared_.settings.cellSize));
      gather(map.grid(), radius, photonClass == PhotonClass::caustic && isAdaptive());
    }
  }

  /// Every so many-th of the map's photons, as many as there are points.
  void presentFrom(const PhotonMap<Backend>& map, std::uint32_t photons, Span<PhotonPoint> points) {
    if (points.size == 0) return;
    this->backend_.forEach(points.size,
                           ResolvePhotons{map.grid().positions, map.grid().powers, photons, points.size, points});
  }

  void gather(const PhotonGrid& grid, Real radius, bool adaptive) {
    const Settings& s = this->prepared_.settings;
    Gathered const output = s.aov == Aov::photonCount    ? Gathered::photonCount
                            : s.aov == Aov::gatherRadius ? Gathered::radius
                                                         : Gathered::radiance;
    const SceneView& scene = this->frame_.scene;
    GatherView const view{grid, radius, s.maxDepth, PlaneView{scene.planePieces, scene.planeFirst},
                          adaptive ? Real(1) : Real(s.quadScale)};
    std::uint32_t const n = this->frame_.slots();
    if (adaptive)
      this->backend_.forEach(n, GatherAdaptive{view, points_.view(), this->radiance_.span(), discs_.span(),
                                               this->stateBuffer_.view(), output});
    else if (this->prepared_.features & feature::nearest)
      this->backend_.forEach(n, GatherNearest{view, s.nearest, points_.view(), this->radiance_.span(), output});
    else if (isGlossy() && output == Gathered::radiance)
      this->run(n, GatherGlossyArgs{view, this->frame_.scene.materials, points_.view(), glossy_.view(),
                                    this->radiance_.span()});
    else
      this->backend_.forEach(n, GatherRadius{view, points_.view(), this->radiance_.span(), output});
  }

  PhotonMap<Backend> map_, caustics_;
  Buffer<GatherPoint> points_;
  Buffer<GlossyPoint> glossy_;
  Buffer<DiscState> discs_;       ///< of caustics
  Buffer<PhotonPoint> points3d_;  ///< for a window
  std::uint64_t budget_ = 0;
  std::uint64_t plannedPhotons_ = 0, plannedMemory_ = 0;
  double plannedShare_ = 0;
  GatherBy plannedGather_ = GatherBy::radius;  ///< read only where plannedPhotons_ is not 0
  double perPath_ = 0, tailPerPath_ = 0;
};

}  // namespace ropelight::RL_TARGET
