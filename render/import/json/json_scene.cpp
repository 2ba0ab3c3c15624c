#include "render/import/json/json_scene.h"

#include "render/import/json/json_material.h"
#include "render/import/json/json_node.h"
#include "render/import/json/json_shape.h"
#include "render/import/json/json_text.h"
#include "render/text/text_file.h"

namespace ropelight {
namespace {

constexpr ParamInfo lengthLimits{"", 0, maxCoordinate, "scene units"};

CameraDesc readCamera(const JsonNode& node) {
  node.allowKeys({"position", "target", "up", "fov", "aperture", "focus"});
  CameraDesc camera;
  camera.position = node.at("position").vector(coordinateLimits);
  camera.target = node.at("target").vector(coordinateLimits);
  if (auto up = node.find("up")) camera.up = up->vector(coordinateLimits);
  if (auto fov = node.find("fov")) camera.verticalFov = fov->number({"", minFov, maxFov, "degrees"});
  if (auto aperture = node.find("aperture")) camera.apertureRadius = aperture->number(lengthLimits);
  if (auto focus = node.find("focus")) camera.focusDistance = focus->number(lengthLimits);
  return camera;
}

FilmDesc readFilm(const JsonNode& node) {
  node.allowKeys({"width", "height"});
  constexpr ParamInfo limits{"", 1, maxFilmEdge, "pixels"};
  FilmDesc film;
  if (auto width = node.find("width")) film.width = width->integer(limits);
  if (auto height = node.find("height")) film.height = height->integer(limits);
  return film;
}

std::vector<NamedMaterial> readMaterials(const JsonNode& node) {
  std::vector<NamedMaterial> materials;
  for (const std::string& name : node.keys()) materials.push_back({name, readMaterial(node.at(name))});
  return materials;
}

}  // namespace

Scene loadJsonScene(const std::filesystem::path& path) {
  Scene scene;
  scene.file = path.string();
  nlohmann::json const document = parseJson(scene.file, readTextFile(path, "check the path"));
  JsonNode const root(scene.file, document);
  root.allowKeys({"name", "description", "camera", "film", "materials", "shapes"});
  auto const name = root.find("name");
  scene.name = name ? name->string() : path.stem().string();
  if (auto description = root.find("description")) description->string();
  scene.camera = readCamera(root.at("camera"));
  if (auto film = root.find("film")) scene.film = readFilm(*film);
  scene.materials = readMaterials(root.at("materials"));
  readShapes(root.at("shapes"), scene);
  return scene;
}

}  // namespace ropelight
