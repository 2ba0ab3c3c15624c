#pragma once
// `ropelight bench`: speed, measured the same way every time.

#include <string>
#include <vector>

#include "app/arguments/scene_options.h"

namespace ropelight {

struct BenchResult;

struct BenchOptions {
  std::vector<std::string> names;  ///< of benchNames(); empty: all that need no window
  SceneOptions scene;              ///< an empty scene: the benchmark's own
  int repeat = 15;                 ///< timed repetitions
  bool full = false;               ///< a GPU's sizes on the CPU too
  std::string mesh;                ///< OBJ file for `traversal`, empty: a generated one
  std::string json;                ///< file, "-" for standard output instead of the tables, empty for none
  std::string csv;                 ///< file, empty for none
  std::string out;                 ///< folder for NAME.csv and NAME.svg, empty for none
};

/// Whether the sizes are a GPU's: on a GPU, or where asked for.
bool fullSizes(const BenchOptions& options);

/// Its heading: the device, and what was asked for.
BenchResult startResult(const char* bench, const std::string& device, const BenchOptions& options,
                        const std::string& settings);

/// Times single iterations, by default of box-spheres-diffuse at 512 x 512 with 262,144 photons at three first radii.
BenchResult benchIteration(const BenchOptions& options);

/// Gathering 10³ to 10⁷ photons by brute force, grid and k nearest (paper, Figure 7), and building the grid.
BenchResult benchGather(const BenchOptions& options);

/// Rays against 10 to 10⁶ triangles by brute force and through trees (paper, Figure 8).
BenchResult benchKdTree(const BenchOptions& options);

/// Midpoint splits against the surface-area heuristic, binned and swept: build and trace (paper, Figure 9).
BenchResult benchSplit(const BenchOptions& options);

/// An iteration of each mode and its parts against the triangle count (paper, Figure 10).
BenchResult benchModes(const BenchOptions& options);

/// Every traversal on primary, diffuse, shadow and photon rays.
BenchResult benchTraversal(const BenchOptions& options);

/// Times what a window's frame costs beyond the iteration, by every way that the pixels can go, by default at
/// 1920 x 1080: pixels into GL, the display pass, and waiting for the GPU; no panel and no buffer swap. Opens a window.
BenchResult benchDisplay(const BenchOptions& options);

std::vector<std::string> benchNames();

/// Returns the exit code: checkFailed where a benchmark's own results were wrong. Throws Error (usage) for an unknown
/// name.
int runBench(const BenchOptions& options);

}  // namespace ropelight
