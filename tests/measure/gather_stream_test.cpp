// The gather stream on the CPU against sums in double precision over every photon.

#include "measure/streams/gather_stream.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/test_random.h"

using namespace ropelight;

namespace {

constexpr double thickness = 0.2;  // of a disc over its radius

struct Stream {
  std::string name;
  std::vector<StreamPhoton> photons;
  std::vector<StreamQuery> queries;
};

template <class T>
T placed(Vec3d p, Vec3d n) {
  T t;
  for (int a = 0; a < 3; ++a) {
    t.position[a] = float(p[a]);
    t.normal[a] = float(n[a]);
  }
  return t;
}

Vec3d vector(const float (&v)[3]) { return {double(v[0]), double(v[1]), double(v[2])}; }

/// A place on the faces of the unit cube, whose normals face inwards.
template <class T>
T onCube(TestRandom& random) {
  Vec3d p = random.inBox(0.5) + 0.5, n(0);
  int const axis = int(random.below(3));
  p[axis] = random.below(2);
  n[axis] = p[axis] > 0 ? -1 : 1;
  return placed<T>(p, n);
}

/// A place on the unit sphere about (0.5, 0.5, 0.5), thicker where `spread` is larger.
template <class T>
T onSphere(TestRandom& random, double spread) {
  Vec3d const n = random.direction();
  return placed<T>(Vec3d(0.5) + 0.5 * (1 + random.between(-spread, spread)) * n, n);
}

std::vector<Stream> streams() {
  TestRandom random(1);
  std::vector<Stream> list(4);
  list[0].name = "the faces of a cube";
  list[1].name = "a sphere";
  list[2].name = "a cluster on a face, and few elsewhere";
  list[3].name = "half of them beyond the bounds";
  for (int i = 0; i < 3000; ++i) {
    list[0].photons.push_back(onCube<StreamPhoton>(random));
    list[1].photons.push_back(onSphere<StreamPhoton>(random, 0.005));
    Vec3d const p(random.between(0.5, 0.52), random.between(0.5, 0.52), 0);
    list[2].photons.push_back(i % 10 == 0 ? onCube<StreamPhoton>(random) : placed<StreamPhoton>(p, {0, 0, 1}));
    list[3].photons.push_back(placed<StreamPhoton>({random.between(-1, 2), random.between(0, 1), 0}, {0, 0, 1}));
  }
  for (int i = 0; i < 200; ++i) {
    list[0].queries.push_back(onCube<StreamQuery>(random));
    list[1].queries.push_back(onSphere<StreamQuery>(random, 0));
    Vec3d const p(random.between(0.49, 0.53), random.between(0.49, 0.53), 0);
    list[2].queries.push_back(placed<StreamQuery>(p, {0, 0, 1}));
    list[3].queries.push_back(placed<StreamQuery>({random.between(-1.1, 2.1), random.between(0, 1), 0}, {0, 0, 1}));
  }
  for (Stream& s : list)
    for (StreamPhoton& p : s.photons)
      p.flux = Rgb(float(random.below(4096)), float(random.below(4096)), float(random.below(4096)));
  return list;
}

/// Squared distances in the disc's plane with the flux, nearest first, and whether one is too near to a rim to tell.
struct Expected {
  std::vector<std::pair<double, Rgb>> photons;
  bool doubtful = false;
};

Expected expectedAt(const Stream& s, const StreamQuery& q, double radius) {
  Expected e;
  auto const near = [](double a, double b) { return std::abs(a - b) < 1e-4 * b; };
  for (const StreamPhoton& photon : s.photons) {
    Vec3d const d = vector(photon.position) - vector(q.position), n = vector(q.normal);
    double const height = glm::dot(d, n), distance = glm::length(d - height * n);
    double const cosine = glm::dot(vector(photon.normal), n);
    bool const counts = distance <= radius && std::abs(height) <= thickness * radius && cosine > 0.1;
    e.doubtful |= near(distance, radius) || near(std::abs(height), thickness * radius) || near(cosine, 0.1);
    if (counts) e.photons.push_back({distance * distance, photon.flux});
  }
  std::sort(e.photons.begin(), e.photons.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return e;
}

Rgb fluxOf(const Expected& e, std::size_t count) {
  Rgb flux(0.0f);
  for (std::size_t i = 0; i < count; ++i) flux += e.photons[i].second;
  return flux;
}

std::vector<Expected> expectedOf(const Stream& s, double radius) {
  std::vector<Expected> list;
  for (const StreamQuery& q : s.queries) list.push_back(expectedAt(s, q, radius));
  return list;
}

std::unique_ptr<GatherStream> streamOf(const Stream& s) {
  BackendChoice choice;
  choice.backend = BackendKind::cpu;
  std::unique_ptr<GatherStream> stream = makeGatherStream(choice);
  stream->setPhotons(s.photons, Bounds{Vec3d(0), Vec3d(1)});
  stream->setQueries(s.queries);
  return stream;
}

constexpr float radius = 0.06f;

}  // namespace

TEST_CASE("a gather stream takes the photons that double precision takes, with and without a grid") {
  for (const Stream& s : streams()) {
    CAPTURE(s.name);
    auto const stream = streamOf(s);
    std::vector<Expected> const expected = expectedOf(s, double(radius));
    for (float cell : {0.5f, 1.0f, 3.0f})
      for (std::uint32_t table : {0u, 16u}) {
        CHECK(stream->build(cell * radius, table) > 0);
        for (GatherKind kind : {GatherKind::brute, GatherKind::grid}) {
          CHECK(stream->gather(kind, radius, 0) > 0);
          std::vector<StreamGather> const results = stream->results();
          REQUIRE(results.size() == s.queries.size());
          int wrong = 0, sure = 0, photons = 0;
          for (std::size_t i = 0; i < results.size(); ++i) {
            const Expected& e = expected[i];
            if (e.doubtful) continue;
            ++sure;
            photons += int(results[i].count);
            wrong += results[i].count != e.photons.size() || results[i].flux != fluxOf(e, e.photons.size());
          }
          CHECK(wrong == 0);
          CHECK(sure > 100);
          CHECK(photons > 500);
        }
      }
  }
}

TEST_CASE("the k nearest of a gather stream are those of double precision") {
  for (const Stream& s : streams()) {
    CAPTURE(s.name);
    auto const stream = streamOf(s);
    std::vector<Expected> const expected = expectedOf(s, double(radius));
    stream->build(radius);
    for (int k : {2, 5, 20, 128}) {
      CAPTURE(k);
      stream->gather(GatherKind::nearest, radius, k);
      std::vector<StreamGather> const results = stream->results();
      int wrong = 0, sure = 0;
      for (std::size_t i = 0; i < results.size(); ++i) {
        const Expected& e = expected[i];
        bool const full = e.photons.size() >= std::size_t(k);
        std::size_t const last = std::size_t(k) - 1;
        auto const tied = [&](std::size_t a, std::size_t b) {
          return b < e.photons.size() && e.photons[b].first - e.photons[a].first < 1e-5 * e.photons[b].first;
        };
        if (e.doubtful || (full && (tied(last - 1, last) || tied(last, last + 1)))) continue;
        ++sure;
        double const radius2 = full ? e.photons[last].first : double(radius) * double(radius);
        wrong += results[i].count != (full ? std::size_t(k) : e.photons.size());
        wrong += results[i].flux != fluxOf(e, full ? last : e.photons.size());
        wrong += std::abs(double(results[i].radius2) - radius2) > 1e-4 * radius2;
      }
      CHECK(wrong == 0);
      CHECK(sure > 80);
    }
  }
}

TEST_CASE("a gather stream of nothing answers nothing") {
  Stream s;
  auto const stream = streamOf(s);
  stream->build(0.1f);
  stream->gather(GatherKind::grid, radius, 0);
  CHECK(stream->results().empty());
  TestRandom random(2);
  s.queries.push_back(onCube<StreamQuery>(random));
  stream->setQueries(s.queries);
  for (GatherKind kind : {GatherKind::brute, GatherKind::grid, GatherKind::nearest}) {
    stream->gather(kind, radius, 5);
    REQUIRE(stream->results().size() == 1);
    CHECK(stream->results()[0].count == 0);
    CHECK(stream->results()[0].flux == Rgb(0.0f));
  }
}
