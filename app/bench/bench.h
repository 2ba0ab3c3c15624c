#pragma once
// `ropelight bench`: speed, measured the same way every time.

#include <span>
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

/// A benchmark. A new one is its own file and a word of RL_BENCHES; its doc is at its function.
struct Bench {
  const char* name;
  BenchResult (*run)(const BenchOptions&);
  bool needsWindow;
};

// X(function, name, needs a window)
#define RL_BENCHES(X)                   \
  X(benchIteration, "iteration", false) \
  X(benchGather, "gather", false)       \
  X(benchKdTree, "kdtree", false)       \
  X(benchSplit, "split", false)         \
  X(benchModes, "modes", false)         \
  X(benchTraversal, "traversal", false) \
  X(benchDisplay, "display", true)

#define RL_BENCH(function, name, needsWindow) BenchResult function(const BenchOptions& options);
RL_BENCHES(RL_BENCH)
#undef RL_BENCH

/// Those there are, in the order in which they run.
std::span<const Bench> benches();

std::vector<std::string> benchNames(std::span<const Bench> table = benches());

/// Returns the exit code: checkFailed where a benchmark's own results were wrong. Throws Error (usage) for an unknown
/// name.
int runBench(const BenchOptions& options, std::span<const Bench> table = benches());

}  // namespace ropelight
