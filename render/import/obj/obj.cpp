#include "render/import/obj/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "render/core/error.h"
#include "render/import/obj/obj_text.h"
#include "render/polygon/polygon.h"
#include "render/scene/bounds.h"
#include "render/text/decimal.h"
#include "render/text/text_file.h"

namespace ropelight {
namespace {

using Words = std::vector<std::string_view>;

constexpr double planarity = 1e-3;  // of a polygon's size

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Reads an index that may be absent, and removes it from the word.
std::optional<std::int64_t> takeIndex(std::string_view& word) {
  std::int64_t index = 0;
  auto const [end, problem] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (problem != std::errc()) return std::nullopt;
  word.remove_prefix(static_cast<std::size_t>(end - word.data()));
  return index;
}

/// The vertex of i, i/j, i//k or i/j/k.
std::optional<std::int64_t> vertexOf(std::string_view corner) {
  auto const vertex = takeIndex(corner);
  for (int more = 0; more < 2 && corner.starts_with('/'); ++more) {
    corner.remove_prefix(1);
    takeIndex(corner);
  }
  return corner.empty() ? vertex : std::nullopt;
}

/// Fit for a message: without what a terminal would act upon, and no longer than a line.
std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 60;
  std::string text(word.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  return fmt::format("\"{}{}\"", text, word.size() > longest ? "..." : "");
}

class MeshReader {
 public:
  MeshReader(const std::string& file, std::string_view text) : statements_(text) { mesh_.file = file; }

  Mesh read() {
    while (statements_.next()) {
      std::string_view const keyword = statements_.words().front();
      if (keyword == "v") addVertex(statements_.words());
      if (isOneOf(keyword, {"f", "fo"})) addFace(statements_.words());
      if (isOneOf(keyword, {"p", "l", "curv", "curv2", "surf"})) ++mesh_.report.leftOut;
    }
    finish();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::string_view place, const std::string& problem) const {
    throw Error(fmt::format("{}: line {}: {}", mesh_.file, statements_.lineOf(place), problem));
  }

  double coordinate(std::string_view word) const {
    double const value = parseDecimal(word);
    if (!std::isfinite(value)) fail(word, "expected a finite coordinate, found " + quoted(word));
    if (std::abs(value) > maxCoordinate)
      fail(word, fmt::format("expected a coordinate in [-1e14, 1e14], found {}; scale the mesh down", quoted(word)));
    return value;
  }

  /// What follows x, y and z (a weight or a colour) does not matter for polygons.
  void addVertex(const Words& words) {
    if (words.size() < 4) fail(words[0], "a vertex needs three coordinates");
    mesh_.positions.emplace_back(coordinate(words[1]), coordinate(words[2]), coordinate(words[3]));
  }

  /// Indices count from 1, or backwards from −1, the vertex read last.
  std::uint32_t resolve(std::string_view word) const {
    auto const index = vertexOf(word);
    if (!index) fail(word, "expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found " + quoted(word));
    auto const count = static_cast<std::int64_t>(mesh_.positions.size());
    std::int64_t const resolved = *index < 0 ? count + *index : *index - 1;
    if (resolved < 0 || resolved >= count)
      fail(word, fmt::format("a face names vertex {}, but {} were read so far", *index, count));
    return static_cast<std::uint32_t>(resolved);
  }

  void addFace(const Words& words) {
    corners_.clear();
    for (std::size_t i = 1; i < words.size(); ++i) corners_.push_back(resolve(words[i]));
    if (corners_.size() < 3)
      fail(words[0], fmt::format("a face needs at least three vertices, this has {}", corners_.size()));
    used_.resize(mesh_.positions.size());
    for (std::uint32_t const corner : corners_) used_[corner] = true;
    std::size_t const before = mesh_.triangles.size();
    PolygonFacts const facts = cutter_.cut(corners_, mesh_.positions, mesh_.triangles);
    MeshReport& report = mesh_.report;
    if (corners_.size() > 3) ++report.polygons;
    if (facts.departure > planarity) ++report.notPlanar;
    report.departure = std::max(report.departure, facts.departure);
    if (facts.crossing) ++report.crossing;
    if (mesh_.triangles.size() == before) ++report.degenerate;
  }

  void finish() {
    MeshReport& report = mesh_.report;
    if (mesh_.triangles.empty() && report.degenerate > 0)
      throw Error(fmt::format("{}: none of its faces has an area ({} {}); check how the file was written", mesh_.file,
                              report.degenerate, report.degenerate == 1 ? "face" : "faces"));
    if (mesh_.triangles.empty()) throw Error(mesh_.file + ": the file holds no faces; expected a Wavefront OBJ mesh");
    used_.resize(mesh_.positions.size());
    report.unused = static_cast<std::uint64_t>(std::count(used_.begin(), used_.end(), false));
    countMerged();
  }

  void countMerged() {
    Bounds bounds;
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (used_[i]) bounds.grow(mesh_.positions[i]);
    Vec3d const center = 0.5 * (bounds.min + bounds.max);
    auto rounded = [&](std::uint32_t i) { return glm::vec3(mesh_.positions[i] - center); };
    for (const glm::uvec3& t : mesh_.triangles) {
      glm::vec3 const a = rounded(t.x), b = rounded(t.y), c = rounded(t.z);
      if (a == b || b == c || c == a || isLine(Vec3d(a), Vec3d(b), Vec3d(c))) ++mesh_.report.merged;
    }
  }

  /// Whether the triangle is thinner than floats there are apart, so that rays may hit it or not.
  static bool isLine(Vec3d a, Vec3d b, Vec3d c) {
    Vec3d const ab = b - a, bc = c - b, ca = a - c;
    double const longest = std::sqrt(std::max({glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca)}));
    double farthest = 0;
    for (Vec3d p : {a, b, c}) farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return glm::length(glm::cross(ab, bc)) <= longest * farthest * std::numeric_limits<float>::epsilon();
  }

  ObjStatements statements_;
  PolygonCutter cutter_;
  Mesh mesh_;
  std::vector<std::uint32_t> corners_;
  std::vector<bool> used_;  ///< by vertex, as far as faces have used it
};

}  // namespace

Mesh loadObj(const std::filesystem::path& path, const std::string& remedy) {
  std::string const text = readTextFile(path, remedy);
  return MeshReader(path.string(), text).read();
}

}  // namespace ropelight
