#include "app/stress/cases/case.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/stress/cases/run.h"
#include "render/core/error.h"

namespace ropelight {

double Measurement::error() const { return std::abs(value - expected); }

bool Measurement::holds() const {
  return std::isfinite(value) && std::isfinite(noise) && error() <= bound + 4 * noise && noise <= bound;
}

const char* Measurement::verdict() const {
  if (!std::isfinite(value) || !std::isfinite(noise)) return "not finite";
  if (error() > bound + 4 * noise) return "FAILS";
  return noise <= bound ? "holds" : "too noisy";
}

Holds CaseResult::verdict() const {
  if (!leftOut.empty()) return Holds::leftOut;
  bool const all =
      std::all_of(measurements.begin(), measurements.end(), [](const Measurement& m) { return m.holds(); });
  return all && !measurements.empty() && nonFinite == 0 ? Holds::yes : Holds::no;
}

const Measurement* CaseResult::worst() const {
  auto const badness = [](const Measurement& m) {
    if (!std::isfinite(m.value) || !std::isfinite(m.noise)) return std::numeric_limits<double>::infinity();
    double const allowed = m.bound + 4 * m.noise;
    return std::max(allowed > 0 ? m.error() / allowed : (m.error() > 0 ? 1e300 : 0),
                    m.bound > 0 ? m.noise / m.bound : 0);
  };
  auto const it = std::max_element(measurements.begin(), measurements.end(),
                                   [&](const auto& a, const auto& b) { return badness(a) < badness(b); });
  return it == measurements.end() ? nullptr : &*it;
}

bool StressRun::failed() const {
  return interrupted ||
         std::any_of(results.begin(), results.end(), [](const CaseResult& r) { return r.verdict() == Holds::no; });
}

const StressCase& StressRun::caseOf(const CaseResult& result) const {
  for (const StressFamily& family : families)
    for (const StressCase& c : family.cases)
      if (result.name == c.name && result.family == family.name) return c;
  throw Error("stress: the result of no case", ExitCode::internal);
}

}  // namespace ropelight
