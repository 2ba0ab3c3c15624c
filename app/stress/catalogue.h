#pragma once
// The catalogue of hostile cases.

#include <string>
#include <vector>

#include "app/stress/cases/case.h"
#include "app/stress/families/families.h"

namespace ropelight {

/// All families in order.
std::vector<StressFamily> stressCatalogue(const families::RayOptions& rays = {});

/// The families with the cases that the names ask for, of cases or of whole families; all where there is no name.
/// `isShort` leaves out what is not in the short catalogue. Throws Error (usage) for a name that there is not.
std::vector<StressFamily> chooseCases(std::vector<StressFamily> all, const std::vector<std::string>& names,
                                      bool isShort);

}  // namespace ropelight
