#include "render/targets/specular_targets.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace ropelight {
namespace {

/// What a target costs besides its cross-section, as a share of that of the ball around everything.
constexpr double costOfOne = 0.005;
/// A ball is larger than what it holds by more than floats round.
constexpr double margin = 1 + 1e-5;
/// Triangles of instances above which an instance is taken by its box.
constexpr std::size_t manyTriangles = 1u << 20;

/// A surface: the ball around `center`, or corners.
struct Item {
  Vec3d corner[4];
  int corners = 0;
  double radius = 0;  ///< about the first corner, where that is all there is

  void add(Vec3d p) { corner[corners++] = p; }
  Vec3d center() const {
    Vec3d sum(0);
    for (int i = 0; i < corners; ++i) sum += corner[i];
    return sum / double(corners);
  }
  void grow(Bounds& bounds) const {
    for (int i = 0; i < corners; ++i) {
      bounds.grow(corner[i] - Vec3d(radius));
      bounds.grow(corner[i] + Vec3d(radius));
    }
  }
  double reach(Vec3d from) const {
    double most = 0;
    for (int i = 0; i < corners; ++i) most = std::max(most, glm::length(corner[i] - from));
    return most + radius;
  }
};

/// Upper bound on the longest radius of an ellipsoid, exact for spheres: √ of the largest row sum of the Gram matrix.
double longestRadius(const FlatSphere& s) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += std::abs(glm::dot(s.toWorld[i], s.toWorld[j]));
    most = std::max(most, sum);
  }
  return std::sqrt(most);
}

Item itemOf(const FlatTriangle& t) {
  Item item;
  for (Vec3d p : {t.a, t.b, t.c}) item.add(p);
  return item;
}

void addInstance(const FlatScene& flat, const FlatInstance& instance, std::vector<Item>& items) {
  const FlatScene& mesh = *flat.meshes[instance.mesh];
  if (mesh.triangles.size() + items.size() > manyTriangles) {
    Item item;
    item.add(0.5 * (instance.bounds.min + instance.bounds.max));
    item.radius = 0.5 * glm::length(instance.bounds.extent());
    items.push_back(item);
    return;
  }
  auto const place = [&](Vec3d p) { return Vec3d(instance.toWorld * glm::dvec4(p, 1)); };
  for (const FlatTriangle& t : mesh.triangles) items.push_back(itemOf({place(t.a), place(t.b), place(t.c)}));
}

std::vector<Item> specularItems(const FlatScene& flat) {
  std::vector<Item> items;
  auto const isSpecular = [&](std::size_t primitive) {
    FeatureBits const bit =
        std::visit([](const auto& params) { return params.bit; }, flat.materials[flat.material[primitive]]);
    return (bit & (feature::mirror | feature::dielectric)) != 0;
  };
  std::size_t primitive = 0;
  for (const FlatQuad& q : flat.quads) {
    if (!isSpecular(primitive++)) continue;
    Item item;
    for (Vec3d p : q.corner) item.add(p);
    items.push_back(item);
  }
  for (const FlatSphere& s : flat.spheres) {
    if (!isSpecular(primitive++)) continue;
    Item item;
    item.add(s.center);
    item.radius = longestRadius(s);
    items.push_back(item);
  }
  for (const FlatTriangle& t : flat.triangles)
    if (isSpecular(primitive++)) items.push_back(itemOf(t));
  for (const FlatInstance& i : flat.instances)
    if (isSpecular(primitive++)) addInstance(flat, i, items);
  return items;
}

/// The cheapest set of balls for some items, and what it costs.
struct Cut {
  std::vector<SpecularTarget> targets;
  double cost = 0;
};

class Cutter {
 public:
  Cut cut(std::span<Item> items, int most) {
    SpecularTarget const one = ballAround(items);
    if (whole_ == 0) whole_ = one.radius * one.radius;
    Cut best{{one}, one.radius * one.radius + costOfOne * whole_};
    if (items.size() < 2 || most < 2) return best;
    std::size_t const middle = halve(items);
    Cut a = cut(items.first(middle), most / 2), b = cut(items.subspan(middle), most / 2);
    if (a.cost + b.cost >= best.cost) return best;
    a.targets.insert(a.targets.end(), b.targets.begin(), b.targets.end());
    a.cost += b.cost;
    return a;
  }

 private:
  static SpecularTarget ballAround(std::span<const Item> items) {
    Bounds bounds;
    for (const Item& i : items) i.grow(bounds);
    SpecularTarget ball{0.5 * (bounds.min + bounds.max), 0};
    for (const Item& i : items) ball.radius = std::max(ball.radius, i.reach(ball.center));
    ball.radius *= margin;
    return ball;
  }

  /// In the middle of the longest axis of the centres, or of their number where one side would be empty.
  static std::size_t halve(std::span<Item> items) {
    Bounds centers;
    for (const Item& i : items) centers.grow(i.center());
    Vec3d const extent = centers.extent(), middle = 0.5 * (centers.min + centers.max);
    int const axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    auto const border =
        std::partition(items.begin(), items.end(), [&](const Item& i) { return i.center()[axis] < middle[axis]; });
    std::size_t const below = std::size_t(border - items.begin());
    return below == 0 || below == items.size() ? items.size() / 2 : below;
  }

  double whole_ = 0;
};

}  // namespace

std::vector<SpecularTarget> specularTargets(const FlatScene& flat) {
  std::vector<Item> items = specularItems(flat);
  return items.empty() ? std::vector<SpecularTarget>{} : Cutter().cut(items, mostTargets).targets;
}

}  // namespace ropelight
