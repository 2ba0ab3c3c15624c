#pragma once
// How far a run is: a bar on a terminal, a line now and then elsewhere. All of it goes to standard error.

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

class Progress {
 public:
  Progress(const Goal& goal, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows `iterations` done in `seconds` of wall clock, unless something was shown just before.
  void update(std::uint64_t iterations, double seconds);

 private:
  enum class Style { none, lines, bar };

  void show(std::uint64_t iterations, double seconds);

  Goal goal_;
  Style style_;
  double nextShown_;
  bool barOpen_ = false;
};

}  // namespace ropelight
