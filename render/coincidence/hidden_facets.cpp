// Faces that cannot be seen are left out, so that furniture on a floor needs no layers.

#include <algorithm>
#include <map>

#include "render/coincidence/coincident.h"
#include "render/polygon/winding.h"

namespace ropelight {
namespace {

bool contains(const Bounds& b, Vec3d p) { return b.overlaps({p, p}); }

class Hiding {
 public:
  Hiding(const Scene& scene, const FlatScene& flat, CoincidentPairs& found)
      : scene_(scene), flat_(flat), found_(found), gone_(found.facets.size(), false) {}

  void run() {
    std::vector<bool> settled(found_.pairs.size());
    for (std::size_t i = 0; i < found_.pairs.size(); ++i) {
      auto const [a, b] = found_.pairs[i];
      settled[i] = hide(found_.facets[a].size <= found_.facets[b].size ? a : b, a, b) || hide(a, a, b) || hide(b, a, b);
    }
    std::size_t next = 0;
    std::erase_if(found_.pairs,
                  [&](const auto& pair) { return settled[next++] || gone_[pair.first] || gone_[pair.second]; });
    std::sort(found_.hidden.begin(), found_.hidden.end());
  }

 private:
  /// Whether the facet is hidden by the other of the pair (a, b), or has been before.
  bool hide(std::uint32_t facet, std::uint32_t a, std::uint32_t b) {
    const Facet &small = found_.facets[facet], &large = found_.facets[facet == a ? b : a];
    if (gone_[facet]) return true;
    if (gone_[facet == a ? b : a] || !opaque(small.shape) || !opaque(large.shape)) return false;
    if (scene_.shapes[small.shape].emission || !covers(large, small) || !dark(small.shape)) return false;
    bool const placed = small.primitive >= flat_.primitiveCount() - flat_.instances.size();
    if (placed) return true;  // its mesh is there for others too: what is seen from within or behind stays open
    gone_[facet] = true;
    found_.hidden.push_back(small.primitive);
    return true;
  }

  bool opaque(std::uint32_t shape) const {
    return !std::visit([](const auto& params) { return params.transmits; },
                       scene_.materials[std::size_t(scene_.shapes[shape].material)].desc);
  }

  /// A solid that holds neither the camera nor a light, which could see its faces from inside.
  bool dark(std::uint32_t shape) {
    auto const [known, isNew] = dark_.try_emplace(shape, false);
    if (isNew) known->second = closed(scene_.shapes[shape]) && empty(shape);
    return known->second;
  }

  bool closed(const ShapeDesc& shape) const {
    if (shape.kind == ShapeKind::mesh) return enclosedVolume(scene_.meshes[std::size_t(shape.mesh)]).has_value();
    return shape.kind == ShapeKind::box;
  }

  bool empty(std::uint32_t shape) const {
    Bounds bounds;
    for (const Facet& f : found_.facets)
      if (f.shape == shape)
        bounds.grow(f.box);  // of a mesh those of its faces that are near something: all that is known
    bounds.grow(boundsOf(shape));
    if (contains(bounds, flat_.inFrame(scene_.camera).position)) return false;
    return std::none_of(flat_.lights.begin(), flat_.lights.end(), [&](const FlatLight& l) {
      Bounds const lamp = flat_.primitiveBounds(l.primitive);
      return contains(bounds, 0.5 * (lamp.min + lamp.max));
    });
  }

  Bounds boundsOf(std::uint32_t shape) const {
    const ShapeDesc& s = scene_.shapes[shape];
    Bounds bounds;
    if (s.kind != ShapeKind::mesh) return bounds;
    for (const Vec3d& p : scene_.meshes[std::size_t(s.mesh)].positions)
      bounds.grow(Vec3d(s.toWorld * glm::dvec4(p, 1.0)) - flat_.origin);
    return bounds;
  }

  const Scene& scene_;
  const FlatScene& flat_;
  CoincidentPairs& found_;
  std::vector<bool> gone_;  ///< by facet
  std::map<std::uint32_t, bool> dark_;
};

}  // namespace

void takeHidden(const Scene& scene, const FlatScene& flat, CoincidentPairs& found) { Hiding(scene, flat, found).run(); }

}  // namespace ropelight
