#pragma once
// Settings that are valid and make no sense for the scene.

#include <string>
#include <vector>

#include "render/prepare/prepare.h"

namespace ropelight {

/// First gather radii between which pictures come out; scene units. least: a hundredth of a pixel's footprint at the
/// camera's target or the scene's centre, whichever is nearer, and no less than positions are exact to. most: the
/// scene's diagonal.
struct RadiusRange {
  double least = 0, most = 0;
};
RadiusRange sensibleRadius(const Prepared& prepared);

/// No disc is smaller, whatever the settings: positions carry errors of some 8 units in the last place of the scene's
/// extent, and a disc must be thicker than that. epsilon: half a step of the scalar at 1.
double smallestDisc(const FlatScene& flat, double epsilon);

/// One sentence for each setting that was asked for and makes no sense: its name, what will come of it, and what would
/// do. Nothing is changed.
std::vector<std::string> adviceOn(const Prepared& prepared);

}  // namespace ropelight
