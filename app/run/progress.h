#pragma once
// How far a run is: a bar on a terminal, a line now and then elsewhere. All of it goes to standard error.

#include <chrono>
#include <cstdint>
#include <string>

namespace ropelight {

/// Where a run ends, whichever comes first. Zero: no such limit.
struct Goal {
  std::uint64_t iterations = 0;
  double seconds = 0;
};

/// "1:02:03", "2:03" or "0:03".
std::string formatDuration(double seconds);

enum class ProgressStyle { none, lines, bar };

/// How much of something is done. Nothing is shown before a second has passed.
class ShareProgress {
 public:
  /// what: "writing out.exr".
  ShareProgress(std::string what, bool quiet);
  ~ShareProgress();
  ShareProgress(const ShareProgress&) = delete;
  ShareProgress& operator=(const ShareProgress&) = delete;

  void update(double share);

 private:
  std::string what_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double nextShown_ = 1;  ///< seconds
  bool barOpen_ = false;
};

class Progress {
 public:
  Progress(const Goal& goal, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `iterations` done in `seconds` of wall clock, unless something was shown just before.
  void update(std::uint64_t iterations, double seconds);

 private:
  void show(std::uint64_t iterations, double seconds);

  Goal goal_;
  ProgressStyle style_;
  double nextShown_;
  bool barOpen_ = false;
};

}  // namespace ropelight
