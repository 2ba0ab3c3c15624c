#pragma once
// The estimates of a scene, advanced by a thread of their own: the window asks what there is to show and says what is
// wanted, and never waits for an iteration.

#include <array>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "app/viewer/state/pixel_source.h"
#include "app/viewer/state/view_state.h"
#include "render/integrators/integrator.h"

namespace ropelight::view {

/// Error of an estimate against the reference, after so much time of its own.
struct ErrorPoint {
  double seconds = 0;
  double iterations = 0;
  double relMse = 0;
};

/// Seconds of one iteration by stage, from the latest batch.
using StageSample = std::vector<std::pair<std::string, double>>;

/// What the window knows of one estimate.
struct EstimateStatus {
  bool enabled = false;
  bool ready = false;     ///< there are pixels to copy
  bool building = false;  ///< another integrator is on its way
  bool draft = false;     ///< coarser while the camera moves
  std::string problem;    ///< why the latest settings could not be used; empty: none
  Stats stats;
  int width = 0, height = 0;           ///< of the pixels
  CameraDesc camera;                   ///< that they were seen from, in the scene file's coordinates
  Vec3d frameOrigin{0.0};              ///< of the frame that photons and tree are in
  std::uint64_t pixelIterations = 0;   ///< that the pixels hold
  std::uint64_t pixelVersion = 0;      ///< changes with the pixels
  std::uint64_t photonVersion = 0;     ///< changes with the photons
  std::uint32_t photonCount = 0;       ///< that copyPhotons has
  double iterationSeconds = 0;         ///< of the latest batch
  double presentSeconds = 0;           ///< to make the latest pixels ready for copying
  std::deque<StageSample> stages;      ///< latest last; at most stageHistory
  std::vector<ErrorPoint> errors;      ///< by ascending seconds
  double slope = 0;                    ///< fitted to log relMSE over log seconds; NaN below three points
  std::shared_ptr<const KdTree> tree;  ///< null without one
};

inline constexpr std::size_t stageHistory = 240;

/// The image that errors are measured against.
struct ReferenceStatus {
  bool present = false;
  bool accumulating = false;
  std::string name;                    ///< file, or the mode that accumulates it
  std::string problem;                 ///< why it cannot be compared with, such as another size
  std::uint64_t iterations = 0;        ///< of an accumulated one
  std::shared_ptr<const Image> image;  ///< null where there is none yet
  std::uint64_t version = 0;
};

class RenderThread;

/// Every function returns at once unless it says otherwise.
class Renderer final : public PixelSource {
 public:
  /// lockStep: iterations are made by step() alone, nothing is drafted, so that what is shown can be repeated.
  explicit Renderer(const BackendChoice& choice, bool lockStep = false);
  ~Renderer() override;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Makes integrators for the new scene in the background and swaps when they are ready. What was shown stays until
  /// then, and stays where that fails: problem() then says why.
  void setScene(std::shared_ptr<const Scene> scene, const CameraDesc& camera);
  /// Ignored where another scene than that version's has taken over since.
  void setCamera(const CameraDesc& camera, std::uint64_t sceneVersion);
  void setSettings(int which, const Settings& settings);
  void setEnabled(int which, bool enabled);
  void setPaused(bool paused);
  void setStageTimes(bool on);
  /// At most this many photons for copyPhotons; 0: none are wanted.
  void wantPhotons(std::uint32_t most);
  void reset();
  /// Adds n iterations to every enabled estimate although paused.
  void step(int n);
  /// Waits until every enabled estimate is built and has made the steps asked for, and its pixels are ready.
  void finishSteps();

  void setReference(std::shared_ptr<const Image> image, const std::string& name);
  void clearReference();

  EstimateStatus status(int which) const;
  ReferenceStatus referenceStatus() const;
  /// The scene that is rendered (not one on its way).
  std::shared_ptr<const Scene> scene() const;
  /// Rises when a new scene takes over.
  std::uint64_t sceneVersion() const;
  /// Why the latest scene could not be taken; empty: it was, or is on its way.
  std::string problem() const;
  /// Whether anything that was asked for is still to come: a scene, an integrator, a restart, the full size.
  bool busy() const;
  /// Which backend was taken and why.
  std::string backendText() const;
  /// Index of the GPU; −1: the CPU.
  int gpu() const;

  bool copyPixels(int which, void* to, std::size_t capacity, int& width, int& height,
                  std::uint64_t& iterations) override;
  std::uint32_t copyPhotons(int which, PhotonPoint* to, std::uint32_t capacity) override;
  /// The film and its statistics; waits for the running iteration. Empty image where there is none.
  std::pair<Image, Stats> film(int which);

 private:
  std::unique_ptr<RenderThread> thread_;
};

}  // namespace ropelight::view
