// Polygons of every outline become triangles that cover them once.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/polygon/polygon.h"
#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

using Outline = std::vector<Vec3d>;

struct Cut {
  PolygonFacts facts;
  std::vector<glm::uvec3> triangles;
};

Cut cutPolygon(const Outline& outline) {
  std::vector<std::uint32_t> corners(outline.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Cut result;
  result.facts = PolygonCutter().cut(corners, outline, result.triangles);
  return result;
}

Vec3d areaVector(const Outline& outline) {
  Vec3d sum(0.0);
  for (std::size_t i = 2; i < outline.size(); ++i)
    sum += glm::cross(outline[i - 1] - outline[0], outline[i] - outline[0]);
  return sum / 2.0;
}

constexpr std::size_t anyCount = 0;

/// Triangles whose edges add up to the outline and that all turn as it does cover it exactly once, and nothing else.
/// The edges add up by construction, so the areas tell: their sizes add up to the polygon's, none turns the other way.
void checkCovers(const Outline& outline, double area, std::size_t count, double accuracy = 1e-12) {
  Cut const cut = cutPolygon(outline);
  CHECK_FALSE(cut.facts.crossing);
  CHECK((count == anyCount || cut.triangles.size() == count));
  Vec3d const normal = glm::normalize(areaVector(outline));
  double sum = 0, backwards = 0;
  for (const glm::uvec3& t : cut.triangles) {
    double const signedArea = glm::dot(normal, areaVector({outline[t.x], outline[t.y], outline[t.z]}));
    sum += std::abs(signedArea);
    backwards = std::min(backwards, signedArea);
  }
  CHECK(std::abs(sum - area) <= accuracy * area);
  CHECK(backwards >= -accuracy * area);
}

/// From every start corner, both ways round.
void checkEveryStart(Outline outline, double area, std::size_t count, double accuracy = 1e-12) {
  for (int way = 0; way < 2; ++way) {
    for (std::size_t start = 0; start < outline.size(); ++start) {
      CAPTURE(start);
      CAPTURE(way);
      checkCovers(outline, area, count, accuracy);
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
    std::reverse(outline.begin(), outline.end());
  }
}

Outline flat(std::initializer_list<std::pair<double, double>> points) {
  Outline outline;
  for (auto [x, y] : points) outline.emplace_back(x, y, 0);
  return outline;
}

/// Rotates the plane z = 0 at random, and moves it.
struct Placement {
  explicit Placement(TestRandom& random, double away) {
    x = random.direction();
    y = glm::normalize(glm::cross(x, random.direction()));
    origin = random.direction() * away;
  }
  Vec3d operator()(Vec3d p) const { return origin + p.x * x + p.y * y + p.z * glm::cross(x, y); }
  Vec3d x, y, origin;
};

/// `sides` corners at random distances from the middle, at equal angles.
Outline star(TestRandom& random, int sides) {
  Outline outline;
  for (int i = 0; i < sides; ++i) {
    double const angle = 2 * M_PI * i / sides, r = 0.1 + 0.9 * random.unit();
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return outline;
}

Outline comb(int teeth) {
  Outline outline = {{2.0 * teeth, -1, 0}, {2.0 * teeth, 0, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    outline.emplace_back(2.0 * i + 1, 5, 0);
    outline.emplace_back(2.0 * i, 0, 0);
  }
  outline.emplace_back(0, -1, 0);
  return outline;
}

/// A band that winds inwards around its start and back outwards.
Outline spiral(int corners) {
  Outline outline;
  int const half = corners / 2;
  auto add = [&](int i, double offset) {
    double const turns = 4.0 * i / half, angle = 2 * M_PI * turns, r = 6 - turns - offset;
    outline.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  };
  for (int i = 0; i < half; ++i) add(i, 0);
  for (int i = half - 1; i >= 0; --i) add(i, 0.5);
  return outline;
}

/// Unit squares that hang together as a tree, drawn by one outline; it runs along itself where squares are neighbours
/// but not in the tree, and touches itself at corners.
class SquareTree {
 public:
  SquareTree(TestRandom& random, std::size_t squares) {
    cells_.push_back({0, 0, {-1, -1, -1, -1}});
    while (cells_.size() < squares) {
      auto const parent = random.below(cells_.size()), side = random.below(4);
      int const x = cells_[parent].x + steps[side][0], y = cells_[parent].y + steps[side][1];
      if (std::any_of(cells_.begin(), cells_.end(), [&](const Cell& c) { return c.x == x && c.y == y; })) continue;
      cells_[parent].child[side] = int(cells_.size());
      cells_.push_back({x, y, {-1, -1, -1, -1}});
    }
    walk(0, 0, 4);
  }
  Outline outline;

 private:
  static constexpr int steps[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};  // below, right, above, left
  static constexpr int corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};  // where each side starts
  struct Cell {
    int x, y;
    int child[4];
  };

  void walk(std::size_t cell, int side, int sides) {
    for (; sides > 0; --sides, side = (side + 1) % 4) {
      Cell const c = cells_[cell];
      if (c.child[side] >= 0)
        walk(std::size_t(c.child[side]), (side + 3) % 4, 3);
      else
        outline.emplace_back(c.x + corners[side][0], c.y + corners[side][1], 0);
    }
  }

  std::vector<Cell> cells_;
};

double areaOf(const Outline& outline) { return glm::length(areaVector(outline)); }

}  // namespace

TEST_CASE("a convex polygon is a fan around its first corner, from wherever it starts") {
  Cut const cut = cutPolygon(flat({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {0, 2}}));
  CHECK(cut.triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
  CHECK(cutPolygon({{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0}, {0, 1, 0.2}}).triangles ==
        std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});  // a quad that is not planar
}

TEST_CASE("a concave quad is cut through its reflex corner") {
  Outline const arrow = flat({{0, 0}, {2, -2}, {1, 0}, {2, 2}});
  CHECK(cutPolygon(arrow).triangles == std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}});
  checkEveryStart(arrow, 2, 2);
}

TEST_CASE("concave outlines are covered from every start and either way") {
  checkEveryStart(flat({{0, 0}, {1, 0}, {1, 2}, {3, 2}, {3, 0}, {4, 0}, {4, 3}, {0, 3}}), 8, 6);  // a doorway
  checkEveryStart(flat({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}), 5, 4);                  // an L
  checkEveryStart(comb(12), 12 * 2 + 12 * 5, 25);
  checkEveryStart(spiral(60), areaOf(spiral(60)), 58);
}

TEST_CASE("corners on a line stay corners of triangles") {
  checkEveryStart(flat({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}), 4, 3);
  checkEveryStart(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 3}, {0, 1}}), 4.5, 4);
  checkEveryStart(flat({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 3}, {0, 3}}), 5, 6);
}

TEST_CASE("repeated corners are one") {
  checkEveryStart(flat({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}}), 4, 2);
  checkEveryStart(flat({{0, 0}, {2, -2}, {1, 0}, {1, 0}, {2, 2}}), 2, 2);
}

TEST_CASE("a slit to a hole and back leaves the hole open") {
  // A square ring: round the outside, in to the hole, round it the other way, and out again.
  Outline const ring = flat({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}});
  checkEveryStart(ring, 32, 8);
  Outline const two = flat({{0, 0},
                            {9, 0},
                            {9, 3},
                            {8, 2},
                            {8, 1},
                            {7, 1},
                            {7, 2},
                            {8, 2},
                            {9, 3},
                            {0, 3},
                            {1, 2},
                            {2, 2},
                            {2, 1},
                            {1, 1},
                            {1, 2},
                            {0, 3}});
  checkEveryStart(two, 25, 14);
}

TEST_CASE("outlines that run along themselves and touch themselves are covered") {
  TestRandom random(8);
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i);
    std::size_t const squares = 2 + random.below(80);
    Outline outline = SquareTree(random, squares).outline;
    REQUIRE(areaOf(outline) == doctest::Approx(double(squares)));
    std::rotate(outline.begin(), outline.begin() + random.below(outline.size()), outline.end());
    checkCovers(outline, double(squares), anyCount);  // a cut that leads nowhere is given up
    Placement const far(random, 1e4);
    for (Vec3d& p : outline) p = far(p);
    checkCovers(outline, double(squares), anyCount, 1e-9);
  }
}

TEST_CASE("random outlines in random planes, far away and not quite planar") {
  TestRandom random(5);
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    Outline outline = star(random, 4 + i % 40);
    double const area = areaOf(outline);
    Placement const near(random, 0), far(random, 1e6);
    Outline moved, distant, bent;
    for (Vec3d p : outline) {
      moved.push_back(near(p));
      distant.push_back(far(p));
      bent.push_back(near(p + Vec3d(0, 0, 1e-4 * random.unit())));
    }
    checkCovers(moved, area, outline.size() - 2);
    checkCovers(distant, area, outline.size() - 2, 1e-8);
    checkCovers(bent, area, outline.size() - 2, 1e-6);
    CHECK(cutPolygon(bent).facts.departure < 1e-4);
  }
}

TEST_CASE("how far a polygon leaves its plane is told") {
  CHECK(cutPolygon({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}}).facts.departure < 1e-15);
  // By half the height, over the diagonal of the bounds.
  CHECK(cutPolygon({{0, 0, 0}, {3, 0, 1}, {3, 4, 0}, {0, 4, 1}}).facts.departure ==
        doctest::Approx(0.5 / std::sqrt(26.0)));
}

TEST_CASE("polygons without an area give no triangles") {
  CHECK(cutPolygon(flat({{1, 1}, {1, 1}, {1, 1}})).triangles.empty());
  CHECK(cutPolygon(flat({{1, 1}, {2, 2}, {3, 3}})).triangles.empty());
  CHECK(cutPolygon(flat({{1, 1}, {2, 2}, {3, 3}, {2, 2}})).triangles.empty());
  CHECK(cutPolygon({{0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {0.4, 0.8, 1.2}, {0.7, 1.4, 2.1}}).triangles.empty());
  CHECK(cutPolygon({{5e6, 5e6, 0}, {5e6 + 1, 5e6 + 1, 0}, {5e6, 5e6, 0}, {5e6, 5e6, 0}}).triangles.empty());
}

TEST_CASE("outlines that cross themselves are told, and cut all the same") {
  for (const Outline& outline : {
           flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),              // both halves of one size: no plane of its own
           flat({{0, 0}, {3, 3}, {3, 0}, {0, 2}}),              // halves of two sizes
           flat({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}),  // a pentagram
           flat({{0, 0}, {4, 0}, {4, 4}, {1, -2}, {0, 4}, {-1, 2}}),
       }) {
    Cut const cut = cutPolygon(outline);
    CHECK(cut.facts.crossing);
    CHECK_FALSE(cut.triangles.empty());
    CHECK(cut.triangles.size() <= outline.size() - 2);
  }
}

TEST_CASE("random outlines of any kind end, with no more triangles than there may be") {
  TestRandom random(6);
  for (int i = 0; i < 2000; ++i) {
    Outline outline(3 + std::size_t(17 * random.unit()));
    for (Vec3d& p : outline)  // on a coarse grid, so that corners repeat and edges run along each other
      p = glm::floor(Vec3d(random.unit(), random.unit(), i % 3 == 0 ? random.unit() : 0.0) * 5.0);
    CHECK(cutPolygon(outline).triangles.size() <= outline.size() - 2);
  }
}

TEST_CASE("a hundred thousand corners are cut in little time") {
  TestRandom random(7);
  for (const Outline& outline : {comb(50000), spiral(100000), star(random, 100000)})
    checkCovers(outline, areaOf(outline), outline.size() - 2, 1e-9);
}
