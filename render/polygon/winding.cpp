#include "render/polygon/winding.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "render/scene/bounds.h"

namespace ropelight {
namespace {

/// By vertex, the first of those in the same place.
std::vector<std::uint32_t> weld(const std::vector<Vec3d>& positions) {
  std::vector<std::uint32_t> order(positions.size()), first(positions.size());
  std::iota(order.begin(), order.end(), 0u);
  auto key = [&](std::uint32_t i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) { return key(i) < key(k); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

bool isClosed(const Mesh& mesh) {
  std::vector<std::uint32_t> const vertex = weld(mesh.positions);
  std::vector<std::uint64_t> up, down;  // edges, from their lower vertex and towards it
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      std::uint64_t const a = vertex[t[i]], b = vertex[t[(i + 1) % 3]];
      (a < b ? up : down).push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  std::sort(up.begin(), up.end());
  std::sort(down.begin(), down.end());
  return up == down;
}

Bounds boundsOf(const Mesh& mesh) {
  Bounds bounds;
  for (const glm::uvec3& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) bounds.grow(mesh.positions[t[i]]);
  return bounds;
}

std::string note(const Scene& scene, std::size_t i, double volume) {
  const ShapeDesc& shape = scene.shapes[i];
  const Mesh& mesh = scene.meshes[std::size_t(shape.mesh)];
  std::string const name = shape.name.empty() ? "" : fmt::format(" (\"{}\")", shape.name);
  return fmt::format(
      "{}: /shapes/{}{}: the triangles of {} face inwards (its volume is {:.4g}), so that its inside is "
      "taken for its outside; {} turns them",
      scene.file, i, name, mesh.file, volume, mesh.flipped ? "no \"flip\"" : "\"flip\": true");
}

}  // namespace

void flip(Mesh& mesh) {
  for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
  mesh.flipped = !mesh.flipped;
}

std::optional<double> enclosedVolume(const Mesh& mesh) {
  if (!isClosed(mesh)) return std::nullopt;
  Bounds const bounds = boundsOf(mesh);
  Vec3d const center = 0.5 * (bounds.min + bounds.max);
  double volume = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    Vec3d const a = mesh.positions[t.x] - center, b = mesh.positions[t.y] - center, c = mesh.positions[t.z] - center;
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

std::vector<std::string> windingNotes(const Scene& scene) {
  constexpr double rounding = 1e-12;  // of the bounds' volume: two sheets back to back enclose nothing
  std::vector<std::string> notes;
  std::vector<std::optional<double>> inwards(scene.meshes.size());
  std::vector<bool> known(scene.meshes.size());
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const ShapeDesc& shape = scene.shapes[i];
    if (shape.kind != ShapeKind::mesh) continue;
    if (!std::holds_alternative<DielectricParams>(scene.materials[std::size_t(shape.material)].desc)) continue;
    auto const m = std::size_t(shape.mesh);
    if (!known[m]) {
      Vec3d const extent = boundsOf(scene.meshes[m]).extent();
      auto const volume = enclosedVolume(scene.meshes[m]);
      if (volume && *volume < -rounding * extent.x * extent.y * extent.z) inwards[m] = volume;
      known[m] = true;
    }
    if (inwards[m]) notes.push_back(note(scene, i, *inwards[m]));
  }
  return notes;
}

}  // namespace ropelight
