#pragma once
// Exact signs on whole coordinates, and a search by place.

#include <algorithm>
#include <cmath>

#include "render/polygon/ear_clipping.h"

namespace ropelight {

__extension__ typedef __int128 WideInt;

/// Twice the signed area of abc, positive where it turns counter-clockwise. The sign is exact.
inline double turn(GridPoint a, GridPoint b, GridPoint c) {
  return double(WideInt(b.x - a.x) * (c.y - a.y) - WideInt(b.y - a.y) * (c.x - a.x));
}

inline double distance(GridPoint a, GridPoint b) { return std::hypot(double(b.x - a.x), double(b.y - a.y)); }

inline double longestEdge(GridPoint a, GridPoint b, GridPoint c) {
  return std::max({distance(a, b), distance(b, c), distance(c, a)});
}

/// Points by cells of a uniform grid, some four to a cell.
class PointCells {
 public:
  explicit PointCells(const std::vector<GridPoint>& points) {
    edge_ = std::max(1, int(std::sqrt(double(points.size()) / 4)));
    low_ = high_ = points[0];
    for (const GridPoint& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    start_.assign(std::size_t(edge_) * std::size_t(edge_) + 1, 0);
    for (const GridPoint& p : points) ++start_[cellOf(p) + 1];
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    end_.assign(start_.begin(), start_.end() - 1);
    index_.resize(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) index_[end_[cellOf(points[i])]++] = i;
  }

  void remove(std::uint32_t i, GridPoint p) {
    std::size_t const cell = cellOf(p);
    auto const first = index_.begin() + start_[cell], last = index_.begin() + end_[cell];
    *std::find(first, last, i) = *(last - 1);
    --end_[cell];
  }

  /// Whether the test holds for any of the points that may lie within `margin` of a triangle.
  template <class Test>
  bool any(const GridPoint (&triangle)[3], double margin, Test&& test) const {
    auto const [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    int const last = rowOf(double(high) + margin);
    for (int row = rowOf(double(low) - margin); row <= last; ++row) {
      auto const [left, right] = span(triangle, row, margin);
      int const end = columnOf(right);
      for (int column = columnOf(left); column <= end; ++column) {
        std::size_t const cell = std::size_t(row) * std::size_t(edge_) + std::size_t(column);
        for (std::uint32_t k = start_[cell]; k < end_[cell]; ++k)
          if (test(index_[k])) return true;
      }
    }
    return false;
  }

 private:
  /// Between which x a triangle passes through a row of cells, or within `margin` of it.
  std::pair<double, double> span(const GridPoint (&triangle)[3], int row, double margin) const {
    double const height = (double(high_.y - low_.y) + 1) / edge_, slack = margin + 1e-6 * height;
    double const bottom = double(low_.y) + row * height - slack, top = bottom + height + 2 * slack;
    double left = INFINITY, right = -INFINITY;
    for (int i = 0; i < 3; ++i) {
      GridPoint const p = triangle[i], q = triangle[(i + 1) % 3];
      double const rise = double(q.y - p.y);
      double enter = rise == 0 ? 0 : (bottom - double(p.y)) / rise, leave = rise == 0 ? 1 : (top - double(p.y)) / rise;
      if (enter > leave) std::swap(enter, leave);
      if (enter > 1 || leave < 0) continue;
      for (double const t : {std::max(enter, 0.0), std::min(leave, 1.0)}) {
        double const x = double(p.x) + t * double(q.x - p.x);
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    return {left - slack, right + slack};
  }

  int slot(double x, std::int64_t low, std::int64_t high) const {
    double const share = (x - double(low)) / (double(high - low) + 1);
    return int(std::clamp(share * edge_, 0.0, edge_ - 1.0));
  }
  int columnOf(double x) const { return slot(x, low_.x, high_.x); }
  int rowOf(double y) const { return slot(y, low_.y, high_.y); }
  std::size_t cellOf(GridPoint p) const {
    return std::size_t(rowOf(double(p.y))) * std::size_t(edge_) + std::size_t(columnOf(double(p.x)));
  }

  int edge_ = 1;
  GridPoint low_, high_;
  std::vector<std::uint32_t> start_, end_;  ///< by cell, into index_
  std::vector<std::uint32_t> index_;
};

}  // namespace ropelight
