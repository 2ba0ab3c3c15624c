#pragma once
// Surfaces at the same place: which they are, and in what order rays hit them (docs/scene-format.md).

#include "render/coincidence/facet.h"

namespace ropelight {

/// Pairs of facets at the same place whose order matters: not two opaque surfaces of one material that do not emit, and
/// not two of one shape with the same side out.
struct CoincidentPairs {
  std::vector<Facet> facets;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< into facets, ascending
  std::vector<std::uint32_t> placed;                           ///< shapes of instances in some pair, ascending
  std::vector<std::uint32_t> hidden;                           ///< primitives that are left out, ascending; in no pair
};

/// Removes the pairs in which an opaque surface covers a face of an opaque solid (a box or a closed mesh) that holds
/// neither the camera nor a light, such as the bottom of a block on a floor: the face cannot be seen and is left out.
/// Such faces are listed as hidden, except those of instanced meshes.
void takeHidden(const Scene& scene, const FlatScene& flat, CoincidentPairs& found);

/// shapeOf: index into scene.shapes, by primitive. Instanced meshes are searched up to 2²⁶ triangles in all.
CoincidentPairs findCoincident(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf);

/// The layers of all primitives; empty where there are no pairs. The result, but for the numbers of the stacks, does
/// not depend on the order of the scene's shapes.
std::vector<Layer> makeLayers(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf,
                              const CoincidentPairs& found);

}  // namespace ropelight
