#pragma once
// Times of the latest frames on the GPU and on the CPU, without waiting for either.

#include <array>
#include <chrono>
#include <cstddef>
#include <deque>

#include "app/viewer/gl/gl.h"

namespace ropelight::view {

/// Cost of showing a frame, milliseconds, medians over the latest frames.
struct DisplayTimes {
  double upload = 0;  ///< pixels into the texture, GPU time where it can be measured
  double draw = 0;    ///< the picture, GPU time
  double cpu = 0;     ///< both, as the CPU saw them
};

void releaseQuery(GLuint name);

/// The median of the latest 120 values.
class LatestMedian {
 public:
  void add(double value);
  double median() const;  ///< 0 without values

 private:
  std::deque<double> values_;
};

/// GPU time between begin() and end(), which may not enclose those of another GpuTimer. While results are outstanding
/// for all its queries, a frame goes unmeasured.
class GpuTimer {
 public:
  GpuTimer();
  void begin();
  void end();
  double milliseconds() const { return times_.median(); }

 private:
  struct Query {
    GlName<releaseQuery> name;
    bool pending = false;
  };
  void collect();

  std::array<Query, 3> queries_;
  std::size_t next_ = 0;
  bool running_ = false;
  LatestMedian times_;
};

class CpuTimer {
 public:
  using Clock = std::chrono::steady_clock;
  void begin() { start_ = Clock::now(); }
  void end() { frame_ += std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
  /// Makes one value of all that was measured since the last frame.
  void endFrame();
  double milliseconds() const { return times_.median(); }

 private:
  Clock::time_point start_{};
  double frame_ = 0;
  LatestMedian times_;
};

}  // namespace ropelight::view
