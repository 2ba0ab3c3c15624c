#include "render/import/json/json_shape.h"

#include <fmt/format.h>

#include <filesystem>

#include "render/import/json/json_transform.h"
#include "render/import/obj/obj.h"
#include "render/polygon/winding.h"
#include "render/scene/transform.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

Vec3d vectorOr(const JsonNode& node, const char* key, Vec3d absent) {
  auto const value = node.find(key);
  return value ? value->vector(coordinateLimits) : absent;
}

Mat4d placeSphere(const JsonNode& node) {
  auto const radius = node.find("radius");
  double const r = radius ? radius->number({"", minExtent, maxCoordinate, "scene units"}) : 1;
  return translation(vectorOr(node, "center", Vec3d(0))) * scaling(Vec3d(r));
}

Mat4d placeBox(const JsonNode& node) {
  Vec3d const low = vectorOr(node, "min", Vec3d(-1)), high = vectorOr(node, "max", Vec3d(1));
  for (int i = 0; i < 3; ++i)
    if (!(low[i] < high[i]))
      node.fail(fmt::format("expected min < max, found {:g} and {:g} on axis {}", low[i], high[i], "xyz"[i]));
  return translation((low + high) / 2.0) * scaling((high - low) / 2.0);
}

Mat4d placeQuad(const JsonNode& node) {
  return quadToWorld(vectorOr(node, "corner", Vec3d(0)), vectorOr(node, "edge1", Vec3d(1, 0, 0)),
                     vectorOr(node, "edge2", Vec3d(0, 1, 0)));
}

Mat4d placeMesh(const JsonNode&) { return Mat4d(1.0); }

/// One row per kind of shape: its own keys besides those that all kinds share.
struct ShapeType {
  const char* name;
  ShapeKind kind;
  std::vector<std::string> keys;
  Mat4d (*place)(const JsonNode&);
};

const ShapeType& shapeType(const JsonNode& node) {
  static const std::vector<ShapeType> types = {
      {"sphere", ShapeKind::sphere, {"center", "radius"}, placeSphere},
      {"box", ShapeKind::box, {"min", "max"}, placeBox},
      {"quad", ShapeKind::quad, {"corner", "edge1", "edge2"}, placeQuad},
      {"mesh", ShapeKind::mesh, {"file", "generator", "flip"}, placeMesh},
  };
  std::vector<std::string> names;
  for (const ShapeType& type : types) names.push_back(type.name);
  const ShapeType& type = types[node.at("type").choice("shape type", names)];
  std::vector<std::string> keys = {"type", "name", "material", "transform", "emission"};
  keys.insert(keys.end(), type.keys.begin(), type.keys.end());
  node.allowKeys(keys);
  return type;
}

/// A quad keeps its normal on the side of the transformed edges' cross product, also under a mirroring transform.
Mat4d transformed(const Mat4d& transform, const Mat4d& local, ShapeKind kind) {
  Mat4d const m = transform * local;
  return kind == ShapeKind::quad ? quadToWorld(Vec3d(m[3]), Vec3d(m[0]), Vec3d(m[1])) : m;
}

/// Black emission is none.
std::optional<Emission> readEmission(const JsonNode& node) {
  node.allowKeys({"radiance", "side"});
  Emission emission;
  emission.radiance = node.at("radiance").rgb({"", 0, maxRadiance, "W/(sr m^2)"});
  constexpr Side sides[] = {Side::out, Side::in, Side::both};
  if (auto side = node.find("side")) emission.side = sides[side->choice("side", {"out", "in", "both"})];
  if (isBlack(emission.radiance)) return std::nullopt;
  return emission;
}

/// The index of a mesh. A file is read once, however many shapes name it; a flipped mesh is a copy.
int readMesh(const JsonNode& node, Scene& scene) {
  auto const turned = node.find("flip");
  bool const flipped = turned && turned->boolean();
  std::optional<Mesh> mesh;
  JsonNode const file = node.at("file");
  fs::path const path = (fs::path(scene.file).parent_path() / file.string()).lexically_normal();
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    if (scene.meshes[i].file == path.string()) {
      if (scene.meshes[i].flipped == flipped) return static_cast<int>(i);
      mesh = scene.meshes[i];
    }
  auto const generator = node.find("generator");
  std::string const remedy = generator ? "run " + generator->string() + " to make it" : "check the path";
  if (!mesh)
    mesh =
        loadObj(path, fmt::format("{}: {} names it, relative to the scene; {}", file.file(), file.pointer(), remedy));
  if (mesh->flipped != flipped) flip(*mesh);
  scene.meshes.push_back(std::move(*mesh));
  return static_cast<int>(scene.meshes.size()) - 1;
}

ShapeDesc readShape(const JsonNode& node, Scene& scene, const std::vector<std::string>& materials) {
  const ShapeType& type = shapeType(node);
  ShapeDesc shape;
  shape.kind = type.kind;
  if (auto name = node.find("name")) shape.name = name->string();
  shape.material = static_cast<int>(node.at("material").choice("material", materials));
  auto const transform = node.find("transform");
  shape.toWorld = transformed(transform ? readTransform(*transform) : Mat4d(1.0), type.place(node), type.kind);
  if (auto emission = node.find("emission")) shape.emission = readEmission(*emission);
  if (type.kind == ShapeKind::mesh) shape.mesh = readMesh(node, scene);
  return shape;
}

}  // namespace

void readShapes(const JsonNode& node, Scene& scene) {
  std::vector<std::string> materials;
  for (const NamedMaterial& material : scene.materials) materials.push_back(material.name);
  for (const JsonNode& shape : node.items()) scene.shapes.push_back(readShape(shape, scene, materials));
}

}  // namespace ropelight
