// From pairs of surfaces at the same place to stacks, and the order in each.

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "render/coincidence/coincident.h"

namespace ropelight {
namespace {

/// Disjoint sets with path halving (Tarjan & van Leeuwen 1984).
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// The lower number stays the set's own.
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// What distinguishes a shape from others, independently of its place in the file; compared only to break ties.
std::vector<double> signature(const Scene& scene, const ShapeDesc& shape) {
  std::vector<double> s;
  MaterialDesc material = scene.materials[std::size_t(shape.material)].desc;
  s.push_back(-double(material.index()));
  auto const put = [&s](const auto&, const auto& value, const ParamInfo&) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Rgb>)
      for (int c = 0; c < 3; ++c) s.push_back(double(value[c]));
    else
      s.push_back(double(value));
  };
  std::visit([&](auto& params) { params.params(put); }, material);
  for (int c = 0; c < 3; ++c) s.push_back(shape.emission ? double(shape.emission->radiance[c]) : 0);
  s.push_back(shape.emission ? double(shape.emission->side) : 0);
  s.push_back(double(shape.kind));
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) s.push_back(shape.toWorld[c][r]);
  return s;
}

/// One side of a shape in a stack: its primitives there that face the same way.
struct Sheet {
  std::uint32_t shape;
  bool flipped;
  auto operator<=>(const Sheet&) const = default;
};

enum class Kind : std::uint8_t { leaving, opaque, entering };  ///< as a ray from one side hits it

class Layers {
 public:
  Layers(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf,
         const CoincidentPairs& found)
      : scene_(scene), found_(found), sets_(found.facets.size()), size2_(scene.shapes.size()) {
    std::vector<Bounds> bounds(scene.shapes.size());
    for (std::uint32_t i = 0; i < flat.primitiveCount(); ++i) bounds[shapeOf[i]].grow(flat.primitiveBounds(i));
    for (std::size_t i = 0; i < bounds.size(); ++i)
      size2_[i] = bounds[i].empty() ? 0 : glm::dot(bounds[i].extent(), bounds[i].extent());
    layers_.resize(flat.primitiveCount());
  }

  std::vector<Layer> run() {
    std::vector<bool> paired(found_.facets.size(), false);
    for (auto const& [a, b] : found_.pairs) {
      sets_.unite(a, b);
      paired[a] = paired[b] = true;
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> stacks;
    for (std::uint32_t i = 0; i < paired.size(); ++i)
      if (paired[i]) stacks[sets_.find(i)].push_back(i);
    std::uint32_t number = 0;
    for (const auto& [first, members] : stacks) makeStack(++number, members);
    return std::move(layers_);
  }

 private:
  bool flipped(std::uint32_t facet, const Facet& front) const {
    const Facet& f = found_.facets[facet];
    return !f.curved() && glm::dot(f.normal, front.normal) < 0;
  }

  bool transmits(const Sheet& s) const {
    const ShapeDesc& shape = scene_.shapes[s.shape];
    return std::visit([](const auto& params) { return params.transmits; },
                      scene_.materials[std::size_t(shape.material)].desc);
  }

  /// 0: emits towards the side; 1: emits; 2: does not. A normal that is not flipped points to the front.
  int darkness(const Sheet& s, bool front) const {
    const ShapeDesc& shape = scene_.shapes[s.shape];
    if (!shape.emission || isBlack(shape.emission->radiance)) return 2;
    Side const side = front != s.flipped ? Side::out : Side::in;
    return (std::uint8_t(shape.emission->side) & std::uint8_t(side)) != 0 ? 0 : 1;
  }

  /// A solid lies behind its normal: a ray from the front leaves a solid whose normal points to the back.
  Kind kindOf(const Sheet& s, bool front) const {
    if (!transmits(s)) return Kind::opaque;
    return front == s.flipped ? Kind::leaving : Kind::entering;
  }

  /// Whether a ray from that side hits a before b.
  bool metBefore(const Sheet& a, const Sheet& b, bool front) const {
    Kind const ka = kindOf(a, front), kb = kindOf(b, front);
    if (ka != kb) return ka < kb;
    if (ka == Kind::opaque) {
      int const da = darkness(a, front), db = darkness(b, front);
      if (da != db) return da < db;
      return smaller(a.shape, b.shape);
    }
    return ka == Kind::leaving ? smaller(a.shape, b.shape) : smaller(b.shape, a.shape);
  }

  bool smaller(std::uint32_t a, std::uint32_t b) const {
    double const sa = size2_[a], sb = size2_[b];
    if (std::abs(sa - sb) > 1e-9 * (sa + sb)) return sa < sb;
    auto const ta = signature(scene_, scene_.shapes[a]), tb = signature(scene_, scene_.shapes[b]);
    return ta != tb ? ta < tb : a < b;
  }

  void makeStack(std::uint32_t number, const std::vector<std::uint32_t>& members) {
    const Facet& front = found_.facets[members.front()];
    std::vector<Sheet> sheets;
    double bound = 0, size = front.size;
    for (std::uint32_t m : members) {
      sheets.push_back({found_.facets[m].shape, flipped(m, front)});
      bound = std::max(bound, found_.facets[m].bound);
      size = std::min(size, found_.facets[m].size);
    }
    std::sort(sheets.begin(), sheets.end());
    sheets.erase(std::unique(sheets.begin(), sheets.end()), sheets.end());
    std::map<Sheet, std::uint32_t> const fromFront = numbered(sheets, true), fromBack = numbered(sheets, false);
    for (std::uint32_t m : members) {
      Sheet const sheet{found_.facets[m].shape, flipped(m, front)};
      Layer& layer = layers_[found_.facets[m].primitive];
      layer.stack = number << 2 | (sheet.flipped ? Layer::flippedBit : 0) | (transmits(sheet) ? 0 : Layer::opaqueBit);
      layer.fromFront = fromFront.at(sheet);
      layer.fromBack = fromBack.at(sheet);
      layer.depth = float(8 * bound + 0x1p-21 * size);  // twice the largest tolerance
    }
  }

  std::map<Sheet, std::uint32_t> numbered(std::vector<Sheet> sheets, bool front) const {
    std::sort(sheets.begin(), sheets.end(), [&](const Sheet& a, const Sheet& b) { return metBefore(a, b, front); });
    std::map<Sheet, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < sheets.size(); ++i) numbers[sheets[i]] = i + 1;
    return numbers;
  }

  const Scene& scene_;
  const CoincidentPairs& found_;
  DisjointSets sets_;
  std::vector<double> size2_;  ///< by shape: squared diagonal of its bounds
  std::vector<Layer> layers_;
};

}  // namespace

std::vector<Layer> makeLayers(const Scene& scene, const FlatScene& flat, const std::vector<std::uint32_t>& shapeOf,
                              const CoincidentPairs& found) {
  if (found.pairs.empty()) return {};
  return Layers(scene, flat, shapeOf, found).run();
}

}  // namespace ropelight
