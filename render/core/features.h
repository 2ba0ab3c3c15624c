#pragma once
// What a scene and its settings need. What no bit asks for is not allocated, built, launched or compiled in.

#include "render/core/hd.h"

namespace ropelight {

using FeatureBits = std::uint32_t;

namespace feature {
inline constexpr FeatureBits quads = 1u << 0;
inline constexpr FeatureBits spheres = 1u << 1;
inline constexpr FeatureBits triangles = 1u << 2;
inline constexpr FeatureBits tree = 1u << 3;     ///< kd-tree
inline constexpr FeatureBits diffuse = 1u << 4;  ///< a surface that photons can be stored on
inline constexpr FeatureBits mirror = 1u << 5;
inline constexpr FeatureBits dielectric = 1u << 6;
inline constexpr FeatureBits lens = 1u << 7;  ///< thin lens: two more sample dimensions
inline constexpr FeatureBits lights = 1u << 8;
inline constexpr FeatureBits photons = 1u << 9;      ///< photon pass, grid and gather
inline constexpr FeatureBits nearest = 1u << 10;     ///< k-nearest gather
inline constexpr FeatureBits bvh = 1u << 11;         ///< bounding-volume hierarchy
inline constexpr FeatureBits shortStack = 1u << 12;  ///< the kd-tree is traversed with a short stack, not by ropes
inline constexpr FeatureBits instances = 1u << 13;   ///< instanced meshes
inline constexpr FeatureBits coincident = 1u << 14;  ///< surfaces at the same place, hit in a defined order
inline constexpr FeatureBits caustics = 1u << 15;    ///< photons of caustics apart, aimed at what makes them
inline constexpr FeatureBits all = (1u << 16) - 1;
// What kernels are ready for and no scene can ask for yet, so that no row has it; tests compile it in.
inline constexpr FeatureBits glossy = 1u << 16;       ///< photons with directions, weighted one by one
inline constexpr FeatureBits shading = 1u << 17;      ///< uv, tangent and shading normal at surfaces
inline constexpr FeatureBits environment = 1u << 18;  ///< light from infinitely far
}  // namespace feature

struct FeatureName {
  FeatureBits bit;
  const char* name;
  const char* what;
};

/// In the order that `ropelight info` prints.
inline constexpr FeatureName featureNames[] = {
    {feature::quads, "quads", "quads and box faces"},
    {feature::spheres, "spheres", "spheres and ellipsoids"},
    {feature::triangles, "triangles", "triangle meshes"},
    {feature::instances, "instances", "meshes kept once and placed more often"},
    {feature::tree, "tree", "kd-tree"},
    {feature::shortStack, "short-stack", "short stack for the kd-tree"},
    {feature::bvh, "bvh", "bounding-volume hierarchy"},
    {feature::diffuse, "diffuse", "diffuse surfaces"},
    {feature::mirror, "mirror", "mirrors"},
    {feature::dielectric, "dielectric", "smooth dielectrics"},
    {feature::coincident, "coincident", "surfaces at the same place"},
    {feature::lens, "lens", "thin-lens samples"},
    {feature::lights, "lights", "emitters and shadow rays"},
    {feature::photons, "photons", "photon pass, hash grid and gather"},
    {feature::nearest, "nearest", "k-nearest gather"},
    {feature::caustics, "caustics", "photons aimed at what makes caustics"},
};

}  // namespace ropelight
