#pragma once
// Modes compared at equal time: nothing is called best that the seeds do not set apart.

#include <optional>
#include <vector>

#include "app/converge/analysis/curves.h"

namespace ropelight {

struct EqualTime {
  double seconds = unknown;                     ///< the last that all modes with samples reach; unknown without any
  std::vector<std::optional<BandPoint>> bands;  ///< one per mode; empty where it has no error at that time
};
EqualTime atEqualTime(const StudyScene& scene, bool trimmed);

/// Index of the mode whose 95% interval lies below all others' at equal time; nothing where intervals overlap, where a
/// mode has one seed alone, where one has samples but none so early, or where there are no two modes to compare.
std::optional<std::size_t> bestAtEqualTime(const StudyScene& scene, bool trimmed);

/// Index of the mode that reaches `error` first with all seeds, the 95% interval of its times below all others'. A mode
/// that ran longer and did not get there with any seed is beaten; with one that some seeds brought there nothing can be
/// said.
std::optional<std::size_t> firstToReach(const StudyScene& scene, double error, bool trimmed);

}  // namespace ropelight
