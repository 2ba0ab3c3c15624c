#pragma once
// Default settings of the photon maps, from a few thousand photons and camera rays traced on the CPU, whatever the
// backend.

#include "render/prepare/prepare.h"

namespace ropelight {

/// Fills in the first radii and the share of caustics that are 0. The same for every backend and number of threads.
///
/// The first radius is that whose disc holds `photonsPerDisc` photons of one iteration at the
/// typical gather point: the median over points seen by the camera, weighted by the radiance that photons bring there,
/// so that a small bright caustic counts and a floor without photons does not. At least half a pixel's footprint, at
/// most a twentieth of the scene's diagonal. That of caustics is weighted by the part that they have in relMSE, since
/// their discs shrink where they are bright. The share of caustics is that which makes the variance in relMSE the least
/// for the number of photons, were all discs to hold as many of either kind.
void resolvePhotons(Prepared& prepared);

/// What a pixel covers at that distance along the view; scene units.
double pixelFootprint(const Prepared& prepared, double distance);

}  // namespace ropelight
