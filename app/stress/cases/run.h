#pragma once
// What one run of the catalogue found.

#include "app/stress/cases/case.h"

namespace ropelight {

struct StressRun {
  std::string device, backend;
  std::uint64_t seed = 1;
  bool isShort = false;
  bool interrupted = false;
  double seconds = 0;
  std::vector<StressFamily> families;
  std::vector<CaseResult> results;  ///< of the families' cases, in order; fewer where it was interrupted

  /// A case does not hold, or was never reached.
  bool failed() const;
  const StressCase& caseOf(const CaseResult& result) const;
};

}  // namespace ropelight
