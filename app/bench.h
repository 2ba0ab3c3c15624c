#pragma once
// `ropelight bench`: speed, measured the same way every time.

#include <string>
#include <vector>

#include "app/scene_options.h"

namespace ropelight {

struct BenchOptions {
  std::vector<std::string> names;  ///< of benchNames(); empty: all that need no window
  SceneOptions scene;              ///< an empty scene: the benchmark's own
  int repeat = 15;                 ///< timed repetitions
  std::string json;                ///< file, "-" for standard output instead of the tables, empty for none
  std::string csv;                 ///< file, empty for none
};

/// One measured configuration. Times are seconds of wall clock for one repetition.
struct BenchRow {
  std::string bench;
  std::string timed = "iteration";  ///< what `seconds` are of
  std::string scene;
  Settings settings;  ///< resolved
  Stats stats;        ///< of the timed repetitions alone
  int threads = 0;    ///< CPU threads asked for; 0: all cores
  std::vector<double> seconds;
};

/// Times single iterations, by default of box-spheres-diffuse at 512 x 512 with 262,144 photons at three first radii.
std::vector<BenchRow> benchIteration(const BenchOptions& options);

/// Times what a window's frame costs beyond the iteration, by every way that the pixels can go, by default at
/// 1920 x 1080: pixels into GL, the display pass, and waiting for the GPU; no panel and no buffer swap. Opens a window.
std::vector<BenchRow> benchDisplay(const BenchOptions& options);

std::vector<std::string> benchNames();

/// Returns the exit code. Throws Error (usage) for an unknown name.
int runBench(const BenchOptions& options);

}  // namespace ropelight
