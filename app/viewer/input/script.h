#pragma once
// A script of input: what a person would do with mouse, keys and files, one command per line. It sets ImGui's input
// before a frame, so that everything after it is the same code that a person's input drives.

#include <deque>
#include <string>
#include <vector>

#include "app/viewer/input/script_input.h"
#include "app/viewer/input/script_parse.h"

struct ImGuiIO;

namespace ropelight::view {

/// What a script asks of the main loop for this frame, apart from input.
struct ScriptRequests {
  std::vector<std::string> drop;        ///< files dropped on the window
  std::vector<std::string> stateFiles;  ///< write the state as JSON here, after the frame
  std::vector<std::string> screenshots;
  int resizeWidth = 0, resizeHeight = 0;  ///< 0: no resize
  bool quit = false;
};

class Script {
 public:
  /// Throws Error (badInput) with file, line and what was expected.
  static Script load(const std::string& file);

  /// False after the last command's last frame, and after a problem.
  bool running() const { return !commands_.empty() || !frames_.empty(); }
  /// The program's progress, for the wait commands: iterations of A (0 where not ready) and seconds since the start.
  /// Called once a frame, after the backend's and before ImGui's NewFrame. Leaves io alone where nothing is running.
  ScriptRequests apply(ImGuiIO& io, double seconds, double iterations, bool busy);
  /// The files that its commands write, in their order.
  std::vector<std::string> outputs() const;
  /// Why the script could not go on, such as a widget that is not there; empty: none.
  const std::string& problem() const { return problem_; }

 private:
  /// What the program reports in a frame.
  struct Now {
    double seconds, iterations;
    bool busy;
    float windowHeight;
  };
  void advance(const Now& now, ScriptRequests& requests);
  void wait(const Now& now);
  bool waitOver(const Now& now);
  void point(const Now& now);
  void ask(ScriptRequests& requests);
  void finish(std::deque<ScriptInput> frames);
  void fail(const std::string& why);

  std::string file_, problem_;
  std::deque<ScriptCommand> commands_;  ///< the first is at work
  std::deque<ScriptInput> frames_;      ///< of the command before it, still to come
  ScriptInput held_;                    ///< as the latest command leaves mouse and buttons
  ScriptInput lastPress_;               ///< the latest frame with a button down
  double pressedAt_ = -1e300;           ///< seconds at it
  double notBefore_ = 0;                ///< seconds; until then the first of frames_ is repeated
  int framesHere_ = 0;                  ///< that the first command has waited
  double startedAt_ = 0;                ///< seconds at the first of them
};

}  // namespace ropelight::view
