#include "render/flatten/flatten.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/coincidence/coincident.h"
#include "render/core/error.h"
#include "render/flatten/instances.h"

namespace ropelight {
namespace {

Vec3d apply(const Mat4d& m, Vec3d p) { return Vec3d(m * glm::dvec4(p, 1.0)); }

double area(const FlatQuad& q) { return glm::length(glm::cross(q.corner[1] - q.corner[0], q.corner[3] - q.corner[0])); }

double area(const FlatTriangle& t) { return 0.5 * glm::length(glm::cross(t.b - t.a, t.c - t.a)); }

/// What a first pass found that the next one must respect.
struct Exceptions {
  std::vector<std::uint32_t> copied;  ///< shapes whose meshes are copied, whatever the rule says; ascending
  std::vector<std::uint32_t> hidden;  ///< primitives of the pass before that are left out; ascending
};

/// Shapes of one kind at a time, so that primitive numbers come out grouped.
class Flattener {
 public:
  Flattener(const Scene& scene, Instancing instancing, const Exceptions& except)
      : scene_(scene), instancing_(instancing), except_(except) {}

  FlatScene run(CoincidentPairs& found) {
    chooseKept();
    for (const NamedMaterial& m : scene_.materials) out_.materials.push_back(m.desc);
    for (const ShapeDesc& s : scene_.shapes) {
      if (s.kind == ShapeKind::quad) addQuad(s);
      if (s.kind == ShapeKind::box) addBox(s);
    }
    for (const ShapeDesc& s : scene_.shapes)
      if (s.kind == ShapeKind::sphere) addSphere(s);
    for (const ShapeDesc& s : scene_.shapes)
      if (s.kind == ShapeKind::mesh && !kept(s)) addMesh(s);
    addInstances();
    finish();
    found = findCoincident(scene_, out_, shapeOf_);
    if (found.placed.empty()) out_.layers = makeLayers(scene_, out_, shapeOf_, found);
    return std::move(out_);
  }

 private:
  bool diffuse(int material) const {
    return std::holds_alternative<DiffuseParams>(out_.materials[std::size_t(material)]);
  }

  void add(const ShapeDesc& shape, double area) {
    out_.material.push_back(std::uint32_t(shape.material));
    shapeOf_.push_back(std::uint32_t(&shape - scene_.shapes.data()));
    if (diffuse(shape.material)) out_.diffuseArea += area;
    if (shape.kind == ShapeKind::mesh) return;
    bool const emits = shape.emission && !isBlack(shape.emission->radiance);
    out_.light.push_back(emits ? std::int32_t(out_.lights.size()) : -1);
    if (!emits) return;
    FlatLight light;
    light.primitive = std::uint32_t(out_.material.size() - 1);
    light.radiance = shape.emission->radiance;
    light.side = shape.emission->side;
    light.area = area;
    light.power = M_PI * double(mean(light.radiance)) * area * (light.side == Side::both ? 2 : 1);
    out_.lights.push_back(light);
  }

  bool leftOut() { return std::binary_search(except_.hidden.begin(), except_.hidden.end(), number_++); }

  void addFace(const ShapeDesc& shape, Vec3d a, Vec3d b, Vec3d c, Vec3d d) {
    FlatQuad const quad{{a, b, c, d}};
    if (leftOut()) {
      out_.hiddenFaces.push_back(quad);
      return;
    }
    out_.quads.push_back(quad);
    add(shape, area(quad));
  }

  /// A mirroring transform reverses the winding; the normal follows the inverse transpose.
  void addQuad(const ShapeDesc& s) {
    Vec3d const a = apply(s.toWorld, {0, 0, 0}), b = apply(s.toWorld, {1, 0, 0});
    Vec3d const c = apply(s.toWorld, {1, 1, 0}), d = apply(s.toWorld, {0, 1, 0});
    if (glm::determinant(Mat3d(s.toWorld)) < 0)
      addFace(s, a, d, c, b);
    else
      addFace(s, a, b, c, d);
  }

  void addBox(const ShapeDesc& s) {
    Vec3d v[8];
    for (int i = 0; i < 8; ++i) v[i] = apply(s.toWorld, {i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
    static constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    bool const mirrored = glm::determinant(Mat3d(s.toWorld)) < 0;
    for (const auto& f : faces) addFace(s, v[f[0]], v[f[mirrored ? 3 : 1]], v[f[2]], v[f[mirrored ? 1 : 3]]);
  }

  void addSphere(const ShapeDesc& s) {
    FlatSphere sphere{Mat3d(s.toWorld), Vec3d(s.toWorld[3])};
    if (glm::determinant(sphere.toWorld) < 0) sphere.toWorld[0] = -sphere.toWorld[0];  // the same surface, outside out
    ++number_;
    out_.spheres.push_back(sphere);
    add(s, ellipsoidArea(sphere.toWorld));
  }

  void addMesh(const ShapeDesc& s) {
    const Mesh& mesh = scene_.meshes[std::size_t(s.mesh)];
    bool const mirrored = glm::determinant(Mat3d(s.toWorld)) < 0;
    for (glm::uvec3 t : mesh.triangles) {
      if (mirrored) std::swap(t.y, t.z);
      FlatTriangle const triangle{apply(s.toWorld, mesh.positions[t.x]), apply(s.toWorld, mesh.positions[t.y]),
                                  apply(s.toWorld, mesh.positions[t.z])};
      if (leftOut()) {
        out_.hiddenFaces.push_back({{triangle.a, triangle.b, triangle.c, triangle.c}});
        continue;
      }
      out_.triangles.push_back(triangle);
      add(s, area(triangle));
    }
  }

  bool placeable(const ShapeDesc& s) const {
    auto const index = std::uint32_t(&s - scene_.shapes.data());
    if (std::binary_search(except_.copied.begin(), except_.copied.end(), index)) return false;
    Vec3d const growth = roundingGrowth(Mat3d(s.toWorld));
    return std::max({growth.x, growth.y, growth.z}) <= maxInstanceGrowth;
  }

  bool kept(const ShapeDesc& s) const { return keep_[std::size_t(s.mesh)] && placeable(s); }

  void chooseKept() {
    std::vector<std::uint64_t> uses(scene_.meshes.size(), 0);
    for (const ShapeDesc& s : scene_.shapes)
      if (s.kind == ShapeKind::mesh && placeable(s)) ++uses[std::size_t(s.mesh)];
    for (std::size_t m = 0; m < uses.size(); ++m) {
      std::uint64_t const triangles = scene_.meshes[m].triangles.size();
      bool const spares = uses[m] > 1 && (uses[m] - 1) * triangles >= leastSpared;
      keep_.push_back(triangles > 0 && instancing_ != Instancing::never &&
                      (spares || instancing_ == Instancing::always));
    }
  }

  void addInstances() {
    std::vector<KeptMesh> meshes(scene_.meshes.size());
    std::vector<std::uint32_t> number(meshes.size());
    std::vector<const ShapeDesc*> shapes;
    for (const ShapeDesc& s : scene_.shapes) {
      if (s.kind != ShapeKind::mesh || !kept(s)) continue;
      std::size_t const m = std::size_t(s.mesh);
      if (!meshes[m].scene) {
        meshes[m] = keepMesh(scene_.meshes[m]);
        number[m] = std::uint32_t(out_.meshes.size());
        out_.meshes.push_back(meshes[m].scene);
      }
      FlatInstance& instance = out_.instances.emplace_back();
      instance.mesh = number[m];
      instance.toWorld = s.toWorld * meshes[m].toGiven;
      shapes.push_back(&s);
    }
    std::vector<double> areas(shapes.size());
    oneapi::tbb::parallel_for(std::size_t(0), areas.size(), [&](std::size_t i) {
      areas[i] = placeInstance(*out_.meshes[out_.instances[i].mesh], out_.instances[i]);
    });
    for (std::size_t i = 0; i < areas.size(); ++i) add(*shapes[i], areas[i]);
  }

  void numberHits() {
    std::uint64_t next = out_.primitiveCount();
    for (FlatInstance& instance : out_.instances) {
      instance.firstHit = std::uint32_t(next);
      next += out_.meshes[instance.mesh]->primitiveCount();
      if (next >= (std::uint64_t(1) << 32))
        throw Error(fmt::format("{}: its instances have more than 2^32 triangles together; use fewer", scene_.file));
    }
  }

  void finish() {
    if (out_.material.size() >= (1u << 30))
      throw Error(fmt::format("{}: {} primitives; at most 2^30 fit", scene_.file, out_.material.size()));
    numberHits();
    moveToFrame(out_);
    out_.reach = reachOf(out_.bounds, out_.inFrame(scene_.camera).position);
    if (!(out_.reach < 1e15))
      throw Error(fmt::format("{}: the scene spans {:g} units; float arithmetic needs less than 1e15: scale it down",
                              scene_.file, out_.reach));
  }

  const Scene& scene_;
  Instancing instancing_;
  const Exceptions& except_;
  std::uint32_t number_ = 0;            ///< of primitives, those that are left out included
  std::vector<std::uint32_t> shapeOf_;  ///< by primitive
  std::vector<bool> keep_;              ///< by mesh of the scene
  FlatScene out_;
};

}  // namespace

FlatScene flatten(const Scene& scene, Instancing instancing) {
  Exceptions except;
  for (;;) {
    CoincidentPairs found;
    FlatScene flat = Flattener(scene, instancing, except).run(found);
    if (!found.placed.empty()) {  // layers belong to primitives, and triangles of instances are none
      except.hidden.clear();
      except.copied.insert(except.copied.end(), found.placed.begin(), found.placed.end());
      std::sort(except.copied.begin(), except.copied.end());
    } else if (!found.hidden.empty() && except.hidden.empty()) {
      except.hidden = found.hidden;
    } else {
      return flat;
    }
  }
}

FeatureBits featuresOf(const FlatScene& flat, const CameraDesc& camera) {
  FeatureBits bits = 0;
  if (!flat.quads.empty()) bits |= feature::quads;
  if (!flat.spheres.empty()) bits |= feature::spheres;
  if (!flat.triangles.empty()) bits |= feature::triangles;
  if (!flat.instances.empty()) bits |= feature::instances;
  for (std::uint32_t m : flat.material)
    bits |= std::visit([](const auto& params) { return params.bit; }, flat.materials[m]);
  if (camera.apertureRadius > 0) bits |= feature::lens;
  if (!flat.lights.empty()) bits |= feature::lights;
  if (!flat.layers.empty()) bits |= feature::coincident;
  return bits;
}

}  // namespace ropelight
