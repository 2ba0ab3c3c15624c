#pragma once
// What a study of error against run time holds: scenes × modes × seeds, each run sampled as it goes.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "render/film/metrics.h"
#include "render/integrators/integrator.h"

namespace ropelight {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One look at a run.
struct ErrorSample {
  double seconds = 0;  ///< wall clock of its iterations so far; start-up, tree build and measuring are left out
  std::uint64_t iterations = 0;
  Metrics metrics;  ///< against the scene's reference
};

/// One mode with one seed.
struct StudyRun {
  std::uint64_t seed = 0;
  std::vector<ErrorSample> samples;  ///< by ascending time, the last at the end of the run
};

/// The mean square error at the end of the runs, split by S seeds (all in squared radiance, means over pixels and
/// channels): bias² = mean((mean of the runs − reference)²) − variance/S − the reference's own variance.
struct ErrorSplit {
  double mse = unknown;
  double bias2 = unknown;     ///< may be negative: then it is smaller than S seeds can show
  double variance = unknown;  ///< of one run; unknown with one seed
  double referenceVariance = unknown;
};

/// The pixels within the first gather radius of an edge of the scene, where discs are cut.
struct EdgeShare {
  double pixels = unknown;  ///< share of the image
  double error = unknown;   ///< share of the sum of (a − b)²/(b² + ε)
};

/// One mode with its settings on one scene.
struct StudyMode {
  std::string label;                 ///< as it was asked for: "sppm:alpha=0.5"
  Settings settings;                 ///< resolved
  std::string accel;                 ///< what rays go through
  std::string kernels;               ///< the row of kernels in use
  double setupSeconds = 0;           ///< making the integrator: flattening, tree, buffers
  double treeSeconds = 0;            ///< the tree's share of it; 0 where none is built or the modes share one
  double firstIterationSeconds = 0;  ///< of an iteration before the runs, which the curves leave out
  std::vector<StudyRun> runs;        ///< one per seed
  ErrorSplit split;
  Image picture;              ///< of the first seed at equal time
  double pictureSeconds = 0;  ///< when that was
  std::uint64_t pictureIterations = 0;
  EdgeShare pictureEdges;        ///< of the picture's error
  double pictureFlip = unknown;  ///< mean FLIP of the picture
  std::string referenceWarning;  ///< where the reference may be too noisy to judge this mode; else empty
};

struct StudyReference {
  Image image;
  std::string origin;         ///< the file, or what made it with which settings for how long
  double noise = unknown;     ///< relMSE of its own noise, by the study's ε; unknown of a file that does not say
  double variance = unknown;  ///< the same as a mean square, squared radiance
  double epsilon = 0;         ///< ε of relMSE that all figures of the scene use, squared radiance
  std::optional<Mode> mode;   ///< that made it; empty where a file does not say
  Stats stats;                ///< of a made one
};

struct StudyScene {
  std::string name;
  std::string file;
  std::string device;
  double loadSeconds = 0;
  double edgeRadius = 0;  ///< the largest first gather radius of the modes, scene units; 0 without one
  StudyReference reference;
  std::vector<StudyMode> modes;
};

struct Study {
  std::string command;  ///< the command line that made it
  std::string version;
  std::string device;
  int threads = 0;               ///< CPU threads asked for; 0: all cores
  double startSeconds = 0;       ///< from the process's start to the first scene's load
  double seconds = 0;            ///< limit of every run; 0: none
  std::uint64_t iterations = 0;  ///< limit of every run; 0: none
  int seeds = 1;
  bool trimmed = false;  ///< the headline figure leaves out the worst 0.1% of pixels
  bool complete = true;  ///< false where Ctrl-C ended it
  std::vector<StudyScene> scenes;
};

}  // namespace ropelight
