#pragma once
// Surfaces at the same place: which they are, and in what order rays meet them (docs/scene-format.md).

#include "render/coincidence/facet.h"

namespace ropelight {

/// Pairs of facets at the same place whose order matters: not two opaque surfaces of one material that do not emit, and
/// not two of one shape with the same side out.
struct CoincidentPairs {
  std::vector<Facet> facets;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< into facets, ascending
  std::vector<std::uint32_t> placed;                           ///< shapes with a placed mesh in some pair, ascending
  std::vector<std::uint32_t> hidden;                           ///< primitives that are left out, ascending; in no pair
};

/// Takes the pairs out in which an opaque surface covers a face of an opaque solid (a box or a closed mesh) with
/// neither the camera nor a lamp inside, such as the bottom of a block that stands on a floor: nobody sees the face,
/// which need not be there. Lists those faces as hidden, but for placed meshes'.
void takeHidden(const Scene& scene, const FlatScene& flat, CoincidentPairs& found);

/// shapeOf: index into scene.shapes, by primitive. Placed meshes are looked at up to 2²⁶ triangles in all.
CoincidentPairs findCoincident(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf);

/// The layers of all primitives; empty where there are no pairs. The result, but for the numbers of the stacks, does
/// not depend on the order of the scene's shapes.
std::vector<Layer> makeLayers(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf,
                              const CoincidentPairs& found);

}  // namespace ropelight
