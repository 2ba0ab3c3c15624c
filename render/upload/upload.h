#pragma once
// A flat scene on a backend, rounded to its scalar. What the scene lacks is not allocated.

#include "accel/bvh/build.h"
#include "render/light/lights.h"
#include "render/upload/structures.h"
#include "render/upload/upload_instances.h"

namespace ropelight::RL_TARGET {

inline Quad toTarget(const FlatQuad& q) {
  Vec3d const n = glm::normalize(glm::cross(q.corner[1] - q.corner[0], q.corner[3] - q.corner[0]));
  return Quad{Vec3(q.corner[0]), Vec3(q.corner[1]), Vec3(q.corner[2]), Vec3(q.corner[3]), Vec3(n)};
}

inline Sphere toTarget(const FlatSphere& s) {
  return Sphere{Mat3(glm::inverse(s.toWorld)), Mat3(s.toWorld), Vec3(s.center)};
}

inline PlanePiece toTarget(const PlanePart& p) {
  PlanePiece piece;
  const Vec3d* const c = p.quad.corner;
  Vec3d const center = 0.25 * (c[0] + c[1] + c[2] + c[3]);
  Vec3d const n = glm::normalize(glm::cross(c[1] - c[0], c[2] - c[0]));
  for (int k = 0; k < 4; ++k) {
    piece.corner[k] = Vec3(c[k]);
    piece.reach = maxOf(piece.reach, Real(glm::length(c[k] - center)) * Real(1.0001));
  }
  piece.normal = Vec3(n);
  if (p.covers) piece.covers = Vec3(-n);
  piece.center = Vec3(center);
  return piece;
}

inline Target toTarget(const SpecularTarget& t) { return Target{Vec3(t.center), Real(t.radius)}; }

template <class Kinds = Bsdfs, class... Descs>
Material toTarget(const std::variant<Descs...>& desc) {
  Material m;
  Kinds::forEach([&](auto type, int index) {
    using T = typename decltype(type)::type;
    if constexpr (requires { typename T::Params; }) {  // else a test's, which no scene holds
      if (index != int(desc.index())) return;
      T bsdf;
      static_cast<typename T::Params&>(bsdf) = std::get<typename T::Params>(desc);
      m = materialOf<Kinds>(bsdf);
    }
  });
  return m;
}

inline Light toTarget(const FlatScene& flat, const FlatLight& l, double totalPower) {
  return Light{std::uint16_t(emitterOf(flat, l)), std::uint16_t(l.side), l.primitive, l.radiance, Real(l.area),
               Real(l.power / totalPower)};
}

template <class Backend>
class DeviceScene {
 public:
  template <class T>
  using Buffer = typename Backend::template Buffer<T>;

  DeviceScene(Backend& backend, const SceneStructures& p) : backend_(backend) {
    const FlatScene& flat = *p.flat;
    view.quads = convert(quads_, "quads", flat.quads);
    view.spheres = convert(spheres_, "spheres", flat.spheres);
    view.material = copy(material_, "materials", flat.material);
    if (!flat.lights.empty()) view.lightOf = copy(lightOf_, "lights", flat.light);
    if (!flat.layers.empty()) view.layers = copy(layers_, "materials", flat.layers);
    view.materials = convert(materials_, "materials", flat.materials);
    view.primitiveCount = flat.primitiveCount();
    uploadLights(flat);
    if (p.planes) {
      view.planePieces = convert(planePieces_, "quads", p.planes->parts);
      view.planeFirst = copy(planeFirst_, "quads", p.planes->first);
    }
    if (p.targets) view.targets = convert(targets_, "lights", *p.targets);
    instances_.upload(backend, p, view);
    if (p.features & feature::tree) uploadTree(*p.tree);
    if (p.features & feature::bvh)
      uploadBvh(flat, *p.bvh);
    else
      view.triangles.triangles = convert(triangles_, "triangles", flat.triangles);
    view.triangles.size = std::uint32_t(flat.triangles.size());
    view.shortStack = (p.features & feature::shortStack) != 0;
  }

  SceneView view;

 private:
  template <class T>
  Span<const T> copy(Buffer<T>& to, const char* purpose, const std::vector<T>& from) {
    to.allocate(backend_, purpose, from.size());
    backend_.upload(to, from.data(), from.size());
    return to.view();
  }

  template <class T, class From>
  Span<const T> convert(Buffer<T>& to, const char* purpose, const std::vector<From>& from) {
    std::vector<T> converted;
    converted.reserve(from.size());
    for (const From& f : from) converted.push_back(toTarget(f));
    return copy(to, purpose, converted);
  }

  void uploadLights(const FlatScene& flat) {
    if (flat.lights.empty()) return;
    double total = 0, sum = 0;
    for (const FlatLight& l : flat.lights) total += l.power;
    std::vector<Light> lights;
    std::vector<Real> cdf;
    for (const FlatLight& l : flat.lights) {
      lights.push_back(toTarget(flat, l, total));
      sum += l.power / total;
      cdf.push_back(Real(sum));
    }
    cdf.back() = 1;
    view.power = Real(total);
    view.lights = copy(lights_, "lights", lights);
    view.lightCdf = copy(lightCdf_, "lights", cdf);
    view.lightGuide = copy(lightGuide_, "lights", makeGuideTable(cdf));
  }

  void uploadTree(const KdTree& tree) {
    view.tree.nodes = copy(nodes_, "tree", tree.nodes);
    view.tree.leaves = copy(leaves_, "tree", tree.leaves);
    view.tree.references = copy(references_, "tree", tree.references);
    std::memcpy(view.tree.bounds, tree.bounds, sizeof(tree.bounds));
  }

  void uploadBvh(const FlatScene& flat, const Bvh<2>& bvh) {
    if constexpr (bvhWidth == 2)
      view.bvh.nodes = copy(bvhNodes_, "tree", bvh.nodes);
    else
      view.bvh.nodes = copy(bvhNodes_, "tree", widen(bvh).nodes);
    view.bvh.items = copy(bvhItems_, "tree", bvh.items);
    view.bvhTriangles = copy(triangles_, "triangles", itemTriangles(flat, bvh.items));
    if (flat.triangles.empty()) return;
    std::size_t const first = flat.quads.size() + flat.spheres.size();
    view.triangles.triangles = view.bvhTriangles;
    view.triangles.places = copy(places_, "triangles", placesOf(bvh.items, first, flat.triangles.size()));
  }

  Backend& backend_;
  Buffer<Quad> quads_;
  Buffer<Sphere> spheres_;
  Buffer<Triangle> triangles_;
  Buffer<std::uint32_t> material_;
  Buffer<std::int32_t> lightOf_;
  Buffer<Layer> layers_;
  Buffer<Material> materials_;
  Buffer<Light> lights_;
  Buffer<PlanePiece> planePieces_;
  Buffer<std::uint32_t> planeFirst_;
  Buffer<Target> targets_;
  Buffer<Real> lightCdf_;
  Buffer<std::uint32_t> lightGuide_;
  Buffer<KdNode> nodes_;
  Buffer<KdLeaf> leaves_;
  Buffer<std::uint32_t> references_;
  Buffer<BvhNode<bvhWidth>> bvhNodes_;
  Buffer<std::uint32_t> bvhItems_;
  Buffer<std::uint32_t> places_;
  DeviceInstances<Backend> instances_;
};

}  // namespace ropelight::RL_TARGET
