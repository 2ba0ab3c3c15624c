#pragma once
// Error against time of one estimate: pictures kept at geometric times, measured against the best reference so far.

#include <vector>

#include "app/run/sample_schedule.h"
#include "app/viewer/session/renderer.h"

namespace ropelight::view {

class ErrorCurve {
 public:
  void clear();
  /// Whether a picture is due after so many seconds of the estimate's own time.
  bool due(double seconds) const { return schedule_.due(seconds); }
  /// Pictures beyond 256 MiB, and beyond eight, are thinned out, the oldest first.
  void add(double seconds, double iterations, Image picture);
  /// Measures what was not yet measured against this version of the reference. Pictures of another size are left out.
  void measure(const Image& truth, std::uint64_t version);

  /// Against the latest reference.
  std::vector<ErrorPoint> points() const;
  /// Of log relMSE over log seconds; NaN below three points.
  double slope() const;

 private:
  struct Entry {
    ErrorPoint point;
    Image picture;
    std::uint64_t measured = 0;  ///< version of the reference; 0: never
  };
  void thin();

  std::vector<Entry> entries_;
  std::uint64_t version_ = 0;  ///< of the latest reference
  SampleSchedule schedule_{1.2};
};

}  // namespace ropelight::view
