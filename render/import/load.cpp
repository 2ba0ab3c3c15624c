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

void addNotes(Scene& scene) {
  for (const Mesh& mesh : scene.meshes) {
    std::string const note = describe(mesh.file, mesh.report);
    bool const isNew = std::find(scene.notes.begin(), scene.notes.end(), note) == scene.notes.end();
    if (!note.empty() && isNew) scene.notes.push_back(note);
  }
  for (std::string& note : windingNotes(scene)) scene.notes.push_back(std::move(note));
}

char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool has(const Importer& format, const std::string& extension) {
  return std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end();
}

}  // namespace

std::span<const Importer> importers() {
  static const Importer table[] = {
      {{".json"}, "ropelight's scene", loadJsonScene},
      {{".obj"}, "Wavefront OBJ mesh", loadObjScene},
  };
  return table;
}

std::vector<std::string> sceneExtensions(std::span<const Importer> formats) {
  std::vector<std::string> extensions;
  for (const Importer& format : formats)
    extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
  return extensions;
}

Scene loadScene(const std::filesystem::path& path, std::span<const Importer> formats) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), lowerCase);
  for (const Importer& format : formats) {
    if (!has(format, extension)) continue;
    Scene scene = format.load(path);
    validateScene(scene);
    addNotes(scene);
    return scene;
  }
  throw Error(fmt::format("{}: \"{}\" is no known scene format; expected one of {}", path.string(), extension,
                          joinNames(sceneExtensions(formats))));
}

}  // namespace ropelight
