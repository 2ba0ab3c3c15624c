// Files as programs write them: what is read must be what is meant.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/stress/families/families.h"
#include "render/import/load.h"

namespace ropelight::families {
namespace {

/// A file that is removed again.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / fmt::format("ropelight-stress-{}.obj", std::uintptr_t(this))) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~ScratchFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

double areaOf(const Mesh& mesh) {
  double sum = 0;
  for (glm::uvec3 t : mesh.triangles)
    sum += 0.5 * glm::length(
                     glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]));
  return sum;
}

struct Text {
  const char* what;
  std::string text;
  double triangles, area;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::vector<Text> texts() {
  return {{"a backslash continues a line", square + "f 1 2 \\\n 3 4\n", 2, 1},
          {"a comment after a statement", square + "f 1 2 3 4 # a face\n", 2, 1},
          {"a byte order mark", "\xEF\xBB\xBF" + square + "f 1 2 3 4\n", 2, 1},
          {"numbers that underflow", "v 1E-400 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", 2, 1},
          {"carriage returns", "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n", 1, 0.5},
          {"negative indices", square + "f -4 -3 -2 -1\n", 2, 1},
          {"a concave outline", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n", 3, 10},
          {"a hole that the outline runs to",
           "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n", 8, 12},
          {"a vertex that no face uses", square + "v 1e9 0 0\nf 1 2 3 4\n", 2, 1},
          {"faces without an area", square + "f 1 1 2\nf 1 2 3 4\n", 2, 1}};
}

std::vector<Measurement> objFiles(Probe&) {
  std::vector<Measurement> out;
  for (const Text& t : texts()) {
    ScratchFile const file(t.text);
    Mesh const mesh = loadScene(file.path()).meshes.at(0);
    out.push_back({fmt::format("{}: triangles", t.what), 0, double(mesh.triangles.size()), 0, t.triangles, 0});
    out.push_back({fmt::format("{}: area", t.what), 0, areaOf(mesh), 0, t.area, 1e-9});
  }
  return out;
}

}  // namespace

StressFamily files() {
  return {"files",
          "files as programs write them",
          {{"obj", "continued lines, comments, marks, underflow, concave outlines, holes", "", "triangles, area",
            "what the text means", "0", true, objFiles}}};
}

}  // namespace ropelight::families
