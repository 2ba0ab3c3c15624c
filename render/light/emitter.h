#pragma once
// What every kind of light answers: where a photon starts, what light arrives at a point, how likely a direction
// towards it was, what a ray brings that leaves the scene.

#include "render/core/frame.h"
#include "render/core/warp.h"
#include "render/flat/flat_scene.h"
#include "render/intersection/flight.h"
#include "render/light/receiver.h"

namespace ropelight::RL_TARGET {

/// The start of a photon path. flux: watts of one path out of `paths`, the same for every light before colour.
struct Emitted {
  Surface surface;
  Vec3 direction{0};
  Rgb flux{0.0f};
};

/// One sample of the light that reaches a point: towards it, at what density per solid angle, how much if unoccluded.
struct DirectSample {
  Surface surface;        ///< on the light, where it is at a distance
  Vec3 toward{0};         ///< from the point to it, scene units
  Vec3 wi{0};             ///< the same with unit length
  Real pdf = 0;           ///< 0: nothing to be had here
  bool infinite = false;  ///< it has no place: wi alone is known
  Rgb radiance{0.0f};
};

/// The three random numbers of an emission: uLight is what picking the light has left of its own.
struct EmissionSample {
  Real uLight;
  Vec2 uPoint, uDirection;
};

/// A diffuse emitter that is a surface, on its outer side, its inner side or both. Shape: samples it (quad_light.h).
template <class Shape>
struct SurfaceEmitter {
  static constexpr FeatureBits bit = Shape::bit;

  /// Whether a light of the flat scene is of this kind.
  static bool holds(const FlatScene& flat, const FlatLight& light) { return Shape::holds(flat, light.primitive); }

  /// The point of a photon; returns the normal of the side that it leaves.
  RL_HD static Vec3 start(const SceneView& scene, const Light& light, const EmissionSample& u, Emitted& e) {
    Shape::samplePoint(Shape::shape(scene, light), u.uPoint, e.surface);
    e.surface.primitive = light.primitive;
    bool const inward =
        light.side == std::uint32_t(Side::in) || (light.side == std::uint32_t(Side::both) && u.uLight < 0.5f);
    return inward ? -e.surface.n : e.surface.n;
  }

  /// The point and the direction of a photon; its flux is for the caller.
  RL_HD static void emit(const SceneView& scene, const Light& light, const EmissionSample& u, Emitted& e) {
    Vec3 const n = start(scene, light, u, e);
    e.direction = normalize(Frame(n).toWorld(cosineHemisphere(u.uDirection)));
  }

  /// Fills surface, toward and pdf.
  template <FeatureBits F>
  RL_HD static void sampleToward(const SceneView& scene, const Light& light, const Surface& from, Vec2 u,
                                 DirectSample& s) {
    Receiver const receiver{from.p, samePlace<F>(scene, from.primitive, light.primitive)};
    s.pdf = Shape::sampleToward(Shape::shape(scene, light), light.area, receiver, u, s.surface, s.toward);
    s.surface.primitive = light.primitive;
  }

  /// Density per solid angle of sampleToward for the point `on`, at `toward` from the receiver.
  RL_HD static Real pdfToward(const SceneView& scene, const Light& light, Vec3 from, const Surface& on, Vec3 toward) {
    return Shape::pdfToward(Shape::shape(scene, light), light.area, from, on, toward);
  }

  /// Radiance that a ray brings which leaves the scene along w (unit).
  RL_HD static Rgb beyond(const SceneView&, const Light&, Vec3 /*w*/) { return Rgb(0.0f); }
};

}  // namespace ropelight::RL_TARGET
