#pragma once
// The closed sets among the settings. A new value is an enumerator and a row of its table.

#include <cstdint>

#include "render/choices/choice.h"

namespace ropelight {

/// How light is found.
enum class Mode : std::uint8_t { ray, path, sppm };

template <>
struct ChoicesOf<Mode> {
  static constexpr Choice<Mode> table[] = {
      {Mode::ray, "ray", "direct light and perfect reflection alone"},
      {Mode::path, "path", "path tracing"},
      {Mode::sppm, "sppm", "stochastic progressive photon mapping"},
  };
};

/// What the film holds.
enum class Aov : std::uint8_t { radiance, normal, depth, albedo, traversal, tests, photonCount, gatherRadius };

/// What can tell an AOV: every mode, the first hit whatever the mode, or the gather of sppm.
enum class AovSource : std::uint8_t { light, firstHit, gather };

struct AovChoice : Choice<Aov> {
  AovSource source;
};

template <>
struct ChoicesOf<Aov> {
  static constexpr AovChoice table[] = {
      {{Aov::radiance, "radiance", "linear radiance"}, AovSource::light},
      {{Aov::normal, "normal", "of the first hit"}, AovSource::firstHit},
      {{Aov::depth, "depth", "distance to the first hit"}, AovSource::firstHit},
      {{Aov::albedo, "albedo", "of the first hit"}, AovSource::firstHit},
      {{Aov::traversal, "traversal", "tree cells or nodes visited and primitives tested at the first hit"},
       AovSource::firstHit},
      {{Aov::tests, "tests", "primitives tested at the first hit, an instance as one"}, AovSource::firstHit},
      {{Aov::photonCount, "photon-count", "photons that a gather of sppm finds"}, AovSource::gather},
      {{Aov::gatherRadius, "gather-radius", "radius of the gather of sppm"}, AovSource::gather},
  };
};

constexpr AovSource sourceOf(Aov aov) { return choiceOf(aov).source; }

/// What brings direct light in sppm.
enum class DirectLight : std::uint8_t { shadow, photons };

template <>
struct ChoicesOf<DirectLight> {
  static constexpr Choice<DirectLight> table[] = {
      {DirectLight::shadow, "shadow", "shadow rays"},
      {DirectLight::photons, "photons", "the photons carry direct light too"},
  };
};

/// Which photons a gather takes.
enum class GatherBy : std::uint8_t { radius, nearest };

template <>
struct ChoicesOf<GatherBy> {
  static constexpr Choice<GatherBy> table[] = {
      {GatherBy::radius, "radius", "all within the radius"},
      {GatherBy::nearest, "nearest", "the k nearest"},
  };
};

/// Which photons a map stores: all, or those of caustics (specular bounces alone between light and surface) and the
/// others apart.
enum class PhotonClass : std::uint8_t { every, global, caustic };

/// Where photons of caustics come from.
enum class Caustics : std::uint8_t { aimed, mixed };

template <>
struct ChoicesOf<Caustics> {
  static constexpr Choice<Caustics> table[] = {
      {Caustics::aimed, "aimed", "photons of their own, aimed at mirrors and glass"},
      {Caustics::mixed, "mixed", "all photons leave their lights alike"},
  };
};

/// What rays go through.
enum class Accel : std::uint8_t { automatic, bvh, tree, shortStack, brute };

template <>
struct ChoicesOf<Accel> {
  static constexpr Choice<Accel> table[] = {
      {Accel::automatic, "auto", "by the number of primitives"},
      {Accel::bvh, "bvh", "binary bounding-volume hierarchy"},
      {Accel::tree, "tree", "kd-tree with ropes"},
      {Accel::shortStack, "short-stack", "kd-tree with a short stack"},
      {Accel::brute, "brute", "every primitive is tested"},
  };
};

/// Where the kd-tree's builder splits a node.
enum class SplitBy : std::uint8_t { sah, sweep, midpoint };

template <>
struct ChoicesOf<SplitBy> {
  static constexpr Choice<SplitBy> table[] = {
      {SplitBy::sah, "sah", "surface-area heuristic over bins"},
      {SplitBy::sweep, "sweep", "exact surface-area heuristic"},
      {SplitBy::midpoint, "midpoint", "the middle of the longest axis"},
  };
};

/// Where the numbers of a path come from.
enum class SamplerKind : std::uint8_t { sobol, independent };

template <>
struct ChoicesOf<SamplerKind> {
  static constexpr Choice<SamplerKind> table[] = {
      {SamplerKind::sobol, "sobol", "scrambled Sobol points"},
      {SamplerKind::independent, "independent", "independent random numbers"},
  };
};

}  // namespace ropelight
