#include "render/polygon/ear_clipping.h"

#include "render/polygon/grid_plane.h"

namespace ropelight {
namespace {

/// Rules for what counts as an ear, strictest first; the next rule is tried where no corner passes. Simple outlines
/// need the first two: with the first alone corners that lie on another's edge stay corners. The last two are for
/// outlines that cross.
enum class Rule { clear, exact, flat, touching, convex, any };

class EarClipper {
 public:
  EarClipper(const std::vector<GridPoint>& outline, double tolerance, std::vector<glm::uvec3>& triangles)
      : points_(outline),
        tolerance_(tolerance),
        triangles_(triangles),
        cells_(outline),
        left_(outline.size()),
        gone_(left_) {
    auto const count = static_cast<std::uint32_t>(left_);
    for (std::uint32_t i = 0; i < count; ++i) {
      next_.push_back((i + 1) % count);
      previous_.push_back((i + count - 1) % count);
    }
    for (std::uint32_t i = 0; i < count; ++i) mayBlock_.push_back(!isConvex(i));
  }

  /// Whether no corner was cut by the last two rules.
  bool run() {
    for (std::size_t patience = 20 * left_; left_ > 3;) {
      fillQueue();
      patience -= std::min(patience, queue_.size());
      bool const found = pass(patience > 0 && rule_ != Rule::clear);
      if (!found) rule_ = Rule(int(rule_) + 1);
      if (found && patience > 0) rule_ = Rule::clear;
    }
    if (left_ == 3) emit(last_);
    return simple_;
  }

 private:
  GridPoint before(std::uint32_t i) const { return points_[previous_[i]]; }
  GridPoint after(std::uint32_t i) const { return points_[next_[i]]; }
  double area(std::uint32_t i) const { return turn(before(i), points_[i], after(i)); }
  double leastArea(std::uint32_t i) const { return tolerance_ * longestEdge(before(i), points_[i], after(i)); }
  bool isConvex(std::uint32_t i) const { return area(i) > leastArea(i); }

  /// All that are left, every other one first: that makes fewer needles.
  void fillQueue() {
    queue_.clear();
    for (std::uint32_t start : {last_, next_[last_]})
      for (std::size_t k = 0; k < left_; k += 2, start = next_[next_[start]]) queue_.push_back(start);
  }

  /// Cuts all corners that pass, or only the first, and looks at their neighbours again. Returns whether any was cut.
  bool pass(bool firstAlone) {
    bool found = false;
    for (std::size_t k = 0; k < queue_.size() && left_ > 3 && !(found && firstAlone); ++k) {
      std::uint32_t const i = queue_[k];
      if (gone_[i] || !(isSuperfluous(i) || passes(i))) continue;
      cut(i);
      queue_.push_back(previous_[i]);
      queue_.push_back(next_[i]);
      found = true;
    }
    return found;
  }

  /// A corner that repeats its neighbour, or the tip of a line that runs out and back.
  bool isSuperfluous(std::uint32_t i) const {
    return before(i) == points_[i] || points_[i] == after(i) || before(i) == after(i);
  }

  bool passes(std::uint32_t i) const {
    if (rule_ == Rule::any) return true;
    if (rule_ == Rule::flat) return std::abs(area(i)) <= leastArea(i);
    if (!(rule_ == Rule::clear ? isConvex(i) : area(i) > 0)) return false;
    return rule_ == Rule::convex || !isBlocked(i);
  }

  /// Whether another corner lies in the ear; one in the same place as a corner of the ear does not.
  bool isBlocked(std::uint32_t i) const {
    GridPoint const a = before(i), b = points_[i], c = after(i);
    double const margin = rule_ == Rule::clear ? tolerance_ : 0;
    double const ab = -margin * distance(a, b), bc = -margin * distance(b, c), ca = -margin * distance(c, a);
    return cells_.any({a, b, c}, margin, [&](std::uint32_t k) {
      if (!mayBlock_[k]) return false;
      GridPoint const p = points_[k];
      if (p == a || p == b || p == c) return false;
      double const x = turn(a, b, p), y = turn(b, c, p), z = turn(c, a, p);
      if (rule_ == Rule::touching) return x > 0 && y > 0 && z > 0;
      return x >= ab && y >= bc && z >= ca;
    });
  }

  void emit(std::uint32_t i) {
    double const signedArea = area(i);
    if (signedArea == 0) return;
    if (signedArea < 0 && -signedArea > leastArea(i)) simple_ = false;
    triangles_.emplace_back(previous_[i], i, next_[i]);
  }

  /// Takes a corner away, with its triangle if it has one.
  void cut(std::uint32_t i) {
    if (!isSuperfluous(i) && rule_ != Rule::flat) {
      if (rule_ >= Rule::convex && std::abs(area(i)) > leastArea(i)) simple_ = false;
      emit(i);
    }
    std::uint32_t const p = previous_[i], n = next_[i];
    next_[p] = n;
    previous_[n] = p;
    gone_[i] = true;
    cells_.remove(i, points_[i]);
    --left_;
    for (std::uint32_t const k : {p, n}) mayBlock_[k] = !isConvex(k);
    last_ = n;
  }

  const std::vector<GridPoint>& points_;
  double tolerance_;
  std::vector<glm::uvec3>& triangles_;
  PointCells cells_;
  std::size_t left_;
  std::vector<bool> gone_;
  std::vector<std::uint32_t> next_, previous_, queue_;
  std::vector<bool> mayBlock_;  ///< by corner; a convex one never lies in an ear alone
  Rule rule_ = Rule::clear;
  std::uint32_t last_ = 0;  ///< a corner that is left
  bool simple_ = true;
};

}  // namespace

bool clipEars(const std::vector<GridPoint>& outline, double tolerance, std::vector<glm::uvec3>& triangles) {
  return EarClipper(outline, tolerance, triangles).run();
}

}  // namespace ropelight
