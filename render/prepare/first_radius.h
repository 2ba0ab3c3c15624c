#pragma once
// The default first gather radius, from a few thousand photons and camera rays traced on the CPU, whatever the backend.

#include "render/prepare/prepare.h"

namespace ropelight {

/// The radius whose disc holds `photonsPerDisc` photons of one iteration at the typical gather point: the median over
/// points seen by the camera, weighted by the radiance that photons bring there, so that a small bright caustic counts
/// and a floor without photons does not. At least half a pixel's footprint, at most a quarter of the scene's diagonal.
/// Scene units; > 0. The same for every backend and number of threads.
double automaticRadius(const Prepared& prepared, PhotonClass photons);

/// What a pixel covers at that distance along the view; scene units.
double pixelFootprint(const Prepared& prepared, double distance);

}  // namespace ropelight
