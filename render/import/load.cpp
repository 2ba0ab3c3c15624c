#include "render/import/load.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/core/error.h"
#include "render/import/json/json_scene.h"
#include "render/import/obj/obj_scene.h"
#include "render/polygon/winding.h"
#include "render/text/suggest.h"

namespace ropelight {
namespace {

struct Format {
  const char* extension;
  Scene (*load)(const std::filesystem::path&);
};

constexpr Format formats[] = {{".json", loadJsonScene}, {".obj", loadObjScene}};

void addNotes(Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    std::string const note = describe(mesh.file, mesh.report);
    bool const isNew = std::find(scene.notes.begin(), scene.notes.end(), note) == scene.notes.end();
    if (!note.empty() && isNew) scene.notes.push_back(note);
  }
  for (std::string& note : windingNotes(scene)) scene.notes.push_back(std::move(note));
}

char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::vector<std::string> sceneExtensions() {
  std::vector<std::string> extensions;
  for (const Format& format : formats) extensions.push_back(format.extension);
  return extensions;
}

Scene loadScene(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), lowerCase);
  for (const Format& format : formats) {
    if (extension != format.extension) continue;
    Scene scene = format.load(path);
    validateScene(scene);
    addNotes(scene);
    return scene;
  }
  throw Error(fmt::format("{}: \"{}\" is no known scene format; expected one of {}", path.string(), extension,
                          joinNames(sceneExtensions())));
}

}  // namespace ropelight
