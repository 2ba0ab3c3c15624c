#pragma once
// `ropelight converge`: error against run time.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments/scene_options.h"

namespace ropelight {

struct ConvergeOptions {
  SceneOptions scene;               ///< its name is not used
  std::vector<std::string> scenes;  ///< as given; findScene() turns them into paths
  std::string sceneList;            ///< more of them, comma-separated
  std::string modes = "ray,path,sppm";
  double time = 0;               ///< seconds of every run; 0: see iterations, or 10 where neither is given
  std::uint64_t iterations = 0;  ///< of every run; 0: no limit
  int seeds = 3;
  std::string reference;      ///< .exr, {scene} for the scene's name; empty: made
  double referenceTime = 0;   ///< seconds; 0: eight times the run's
  std::string referenceMode;  ///< empty: path or sppm, whichever trials say will be nearer
  std::optional<double> referenceNoise;
  std::string saveReference;  ///< .exr; empty: not kept
  std::optional<double> epsilon;
  bool trimmed = false;
  std::string out = "converge";  ///< folder
  std::string json;              ///< file for the figures, "-" for standard output; empty: none
  std::string commandLine;       ///< as typed, for the report
  bool quiet = false;
};

/// Writes report.html, samples.csv and SCENE-seconds.svg, SCENE-iterations.svg into the folder, and prints a table.
/// Returns the exit code. Throws Error.
int runConverge(const ConvergeOptions& options);

}  // namespace ropelight
