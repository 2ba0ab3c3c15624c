#pragma once
// Discs that fit the light they lie on: every pixel has a radius of its own, as large as the photons within still lie
// evenly over it. A test for evenness that shrinks a disc where it fails is Lin et al. 2020's (chi-squared progressive
// photon mapping); here it looks at what the bias of a disc comes from, the flux's second moment.

#include "render/kernels/gather.h"
#include "render/photons/photon_store.h"

namespace ropelight::RL_TARGET {

/// Sums over photons of a pixel: of flux φ, of φ², and of φ(ρ² − ½), ρ being the distance from the centre in radii.
struct DiscMoments {
  float flux = 0, squares = 0, radial = 0;

  RL_HD void operator+=(const DiscMoments& o) {
    flux += o.flux;
    squares += o.squares;
    radial += o.radial;
  }

  /// Whether the flux is not spread evenly: over a disc ρ² − ½ has the variance 1/12. Too few photons tell nothing.
  RL_HD bool uneven() const {
    return flux * flux >= 8 * squares && 12 * radial * radial > significance * significance * squares;
  }

  static constexpr float significance = 1;  ///< low: a disc that is too small costs less than one too large
};

/// What is kept of a pixel's disc. scale: of the iteration's radius; 0: not chosen yet.
struct DiscState {
  float scale = 0;
  DiscMoments moments;
};

struct GatherAdaptive {
  static constexpr const char* name = "GatherAdaptive";
  static constexpr std::uint32_t grain = 256;
  static constexpr std::uint32_t mostPhotons = 256;  ///< a first disc with more is made smaller at once
  static constexpr float step = 0.8f;

  GatherView view;
  Span<const GatherPoint> points;
  Span<Rgb> radiance;
  Span<DiscState> discs;
  Span<const IterationState> state;
  Gathered output = Gathered::radiance;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    GatherPoint const g = points[slot];
    if (isBlack(g.weight) || state[0].halt) return;
    DiscState disc = discs[slot];
    DiscMoments moments;
    Gathering sum;
    if (disc.scale > 0) {
      sum = gather(g, disc.scale, moments);
    } else {
      disc.scale = 1;
      sum = choose(g, disc.scale, moments);
    }
    disc.moments += moments;
    discs[slot] = disc;
    putGathering(radiance[slot], g, sum, output);
  }

 private:
  RL_HD Gathering choose(const GatherPoint& g, float& scale, DiscMoments& moments) const {
    Gathering sum;
    for (int trial = 0; trial < 16; ++trial) {
      sum = gather(g, scale, moments);
      if (sum.count > mostPhotons)
        scale *= sqrt(float(mostPhotons) / float(sum.count)) * 0.95f;
      else if (moments.uneven())
        scale *= step;
      else
        break;
    }
    return sum;
  }

  RL_HD Gathering gather(const GatherPoint& g, float scale, DiscMoments& moments) const {
    GatherView here = view;
    here.radius = view.radius * Real(scale);
    Gathering sum;
    sum.radius2 = square(here.radius);
    float const inverse = float(1 / sum.radius2);
    moments = DiscMoments{};
    here.forEachOnDisc(g, sum.radius2, [&](std::uint32_t, Real distance2, const PhotonPower& power) {
      float const flux = mean(power.flux);
      sum.flux += power.flux;
      ++sum.count;
      moments.flux += flux;
      moments.squares += flux * flux;
      moments.radial += flux * (float(distance2) * inverse - 0.5f);
    });
    sum.share = here.share(g, sum.radius2);
    return sum;
  }
};

/// The scale for the next iterations: smaller where a disc is uneven. Neighbours are not asked: their discs hold the
/// same photons, so that together they would be surer than they are, and discs would shrink as fast as photons come in.
struct AdaptDiscs {
  static constexpr const char* name = "AdaptDiscs";
  static constexpr std::uint32_t grain = 4096;
  static constexpr float step = 0.7f;

  Span<DiscState> discs;
  Span<const IterationState> state;

  RL_HD void operator()(std::uint32_t slot, Tally&) const {
    DiscState const disc = discs[slot];
    if (!state[0].halt && disc.scale > 0 && disc.moments.uneven()) discs[slot] = DiscState{disc.scale * step, {}};
  }
};

}  // namespace ropelight::RL_TARGET
