#pragma once
// The main loop: input, panel, renderer, picture, files.

#include <array>
#include <chrono>
#include <exception>
#include <memory>
#include <new>
#include <optional>

#include "app/run/interrupt.h"
#include "app/viewer/draw/overlay.h"
#include "app/viewer/draw/picture.h"
#include "app/viewer/files.h"
#include "app/viewer/gl/window.h"
#include "app/viewer/input/controls.h"
#include "app/viewer/input/script.h"
#include "app/viewer/panel/panel.h"
#include "app/viewer/preferences/preferences.h"
#include "app/viewer/state_report.h"
#include "app/viewer/view.h"
#include "app/viewer/watch.h"
#include "app/viewer/widgets/gui.h"

namespace ropelight::view {

class Viewer {
 public:
  /// Opens the window and starts on the scene. Throws Error as runView does.
  explicit Viewer(const ViewOptions& options);
  ~Viewer();

  /// Until the window is closed or the options' end is reached; the exit code.
  int run();

 private:
  using Clock = std::chrono::steady_clock;

  /// What happens in one frame, in this order.
  bool frameWanted();
  void takeInput();
  void catchTaps();
  void takeScenes();
  void drawInterface();
  void tellRenderer();
  void drawPicture();
  void finishFrame();
  void pace();

  PanelContext context();
  void readMagnifier(PanelContext& context);
  ViewScale viewScale() const;
  Rect picturePlace() const;
  void matchWindow();

  void open(const std::string& file);
  void perform(const Actions& actions);
  void performCamera(const Actions& actions);
  void performFiles(const Actions& actions);
  void takeScene();
  void screenshot(const std::string& file);
  void writeState(const std::string& file);
  void end();
  void setTitle();
  /// Files that were read, which no output may overwrite.
  std::vector<std::string> inputs() const;
  /// Runs the action, and shows what was done or why it failed.
  template <class Action>
  void attempt(const std::string& done, Action&& action) {
    try {
      action();
      if (!done.empty()) notice_ = done;
    } catch (const std::bad_alloc&) {
      problem_ = "out of memory";
    } catch (const std::exception& error) {
      problem_ = error.what();
    }
  }

  StopOnSignal const stop_;
  ViewOptions options_;
  bool const lockStep_;
  std::string problem_, notice_;
  std::filesystem::path preferencesFile_;
  std::shared_ptr<const Scene> comingScene_;  ///< given to the renderer last
  std::optional<Script> script_;
  Preferences preferences_;
  ViewState state_;
  CameraControl camera_;
  Actions actions_;
  Window window_;
  Gui gui_;
  Renderer renderer_;
  Picture picture_;
  Overlay overlay_;
  Controls controls_;
  SceneLoader loader_;
  Watch watch_;

  std::array<EstimateStatus, 3> estimates_;
  std::shared_ptr<const Scene> scene_;  ///< the one that the renderer shows
  std::uint64_t sceneVersion_ = 0;
  CameraDesc toldCamera_;
  std::array<std::uint64_t, 6> shown_{};  ///< versions that the latest frame showed
  std::string shownProblem_;
  std::uint64_t framesBefore_ = 0;
  Rect matchedPlace_;  ///< the picture's, and since when
  Clock::time_point matchedSince_;
  bool drewBefore_ = false;
  std::vector<int> taps_;  ///< keys that count as down for this frame alone
  std::vector<std::string> screenshots_, stateFiles_;
  FrameCounts counts_;
  std::array<double, 120> frameMs_{};
  Clock::time_point started_, frameStart_, lastInput_;
  double frameSeconds_ = 0;
  bool done_ = false;
  std::string title_;
};

}  // namespace ropelight::view
