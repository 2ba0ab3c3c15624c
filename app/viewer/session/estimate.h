#pragma once
// One estimate as the render thread drives it: its integrator, what it was last asked for, and its measurements.

#include <mutex>

#include "app/viewer/session/error_curve.h"

namespace ropelight::view {

/// What an integrator is to render.
struct Target {
  std::uint64_t scene = 0;  ///< version
  CameraDesc camera;
  Settings settings;

  bool operator==(const Target&) const = default;
};

/// What an integrator found for the photons; 0 where it is not known.
struct FirstRadii {
  double radius = 0, caustic = 0;
  double causticShare = 0;
};

/// A coarser and cheaper version of the settings: every `scale`-th pixel and photon, with discs as much larger.
Settings draftOf(const Settings& settings, const FilmDesc& film, int scale, FirstRadii resolved);

class Estimate {
 public:
  /// Takes a new integrator, or releases the old one (null).
  void install(std::unique_ptr<Integrator> integrator, const Target& target);
  /// Restarts for the target, coarser by `scale`; `still`: the automatic radius may be searched again. False where
  /// another integrator is needed; throws as Integrator::restart.
  bool restart(const Target& target, const FilmDesc& film, int scale, bool still);
  /// The same settings again, from an empty film.
  void reset();
  /// Adds iterations. False where it was interrupted.
  bool advance(int count);
  /// Brings pixels and photons up to date for the window.
  void present(std::uint32_t photons);

  /// Iterations that take about `seconds`; at least 1.
  int batchFor(double seconds) const;
  /// Whether there are pixels of the present film to copy.
  bool presented() const { return shown_.ready; }
  /// Whether the time of an iteration is not known yet.
  bool unmeasured() const { return fullSeconds_ == 0; }
  /// The coarsening at which one iteration takes at most `seconds`: 1, 2, 4 or 8.
  int scaleFor(double seconds) const;
  /// Measures the error where a picture is due.
  void measure(const Image* truth, std::uint64_t version);
  /// What the window may know; the flags `enabled` and `building` are the renderer's.
  void fill(EstimateStatus& status) const;

  bool copyPixels(void* to, std::size_t capacity, int& width, int& height, std::uint64_t& iterations);
  std::uint32_t copyPhotons(PhotonPoint* to, std::uint32_t capacity);

  std::unique_ptr<Integrator> integrator;  ///< changed under `pixels`
  Target applied;
  int scale = 1;
  bool settled = true;  ///< restarted since the last change, at full size
  double clock = 0;     ///< time used so far, for sharing the machine fairly
  std::string problem;
  std::uint32_t shownPhotons = 0;     ///< that the latest present() was asked for
  std::uint64_t measuredVersion = 0;  ///< of the reference, at the latest measure()
  bool failed = false;                ///< the integrator threw: nothing more is expected of it

 private:
  void clearMeasurements();
  void recordStages(const Stats& before);

  mutable std::mutex pixels_;
  EstimateStatus shown_;
  ErrorCurve curve_;
  Stats stats_;
  double fullSeconds_ = 0;  ///< of one iteration at full size; 0: not known
  FirstRadii resolved_;
  Target radiusFor_;  ///< that resolved_ was found for
};

}  // namespace ropelight::view
