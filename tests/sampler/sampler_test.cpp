// The samplers: range, uniformity, stratification, independence and determinism.

#include "render/sampler/sampler.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "tests/support/chi_square.h"
#include "tests/support/test_random.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

constexpr int sobol = Samplers::indexOf<SobolSampler>();
constexpr int independent = Samplers::indexOf<IndependentSampler>();
constexpr int tests = 256;  // statistical tests in this file, at most

/// The numbers of dimension d of one path's point.
Vec2 sampleOf(int kind, std::uint64_t seed, Stream stream, std::uint32_t path, std::uint32_t index, int d) {
  Sampler s(kind, seed, stream, path, index);
  for (int i = 0; i < d; ++i) s.next2();
  return s.next2();
}

/// Whether n = 2^k points lie one in each box of every division of the square into 2^a × 2^(k−a) boxes.
bool stratified(const std::vector<Vec2>& points, int k) {
  for (int a = 0; a <= k; ++a) {
    std::set<std::pair<int, int>> boxes;
    for (Vec2 p : points) boxes.insert({int(std::ldexp(p.x, a)), int(std::ldexp(p.y, k - a))});
    if (boxes.size() != points.size()) return false;
  }
  return true;
}

/// Correlation coefficient of pairs, in units of its standard deviation for independent ones.
class Correlation {
 public:
  void add(double x, double y) {
    ++n_;
    sum_ += (x - 0.5) * (y - 0.5) * 12;
  }
  double sigmas() const { return std::abs(sum_) / std::sqrt(n_); }

 private:
  double n_ = 0, sum_ = 0;
};

/// Every kind with every stream.
template <class Visit>
void forEverySampler(Visit&& visit) {
  for (int kind : {sobol, independent})
    for (Stream stream : {Stream::camera, Stream::photon}) {
      CAPTURE(kind);
      CAPTURE(std::uint32_t(stream));
      visit(kind, stream);
    }
}

}  // namespace

TEST_CASE("Philox with seven rounds gives its authors' known answers") {  // Random123, kat_vectors
  Uint4 const zero = philox(Uint4{0, 0, 0, 0}, 0, 0);
  CHECK((zero.x == 0x5f6fb709u && zero.y == 0x0d893f64u && zero.z == 0x4f121f81u && zero.w == 0x4f730a48u));
  std::uint32_t const f = 0xffffffffu;
  Uint4 const ones = philox(Uint4{f, f, f, f}, f, f);
  CHECK((ones.x == 0x5207ddc2u && ones.y == 0x45165e59u && ones.z == 0x4d8ee751u && ones.w == 0x8c52f662u));
}

TEST_CASE("no word becomes 1") {
  CHECK(toUnit(0xffffffffu) < 1);
  CHECK(toUnit(0) == 0);
}

TEST_CASE("samples are in [0, 1) and depend on nothing but their names") {
  forEverySampler([](int kind, Stream stream) {
    int outside = 0, different = 0;
    for (std::uint32_t path : {0u, 1u, 77u, 0xffffffffu})
      for (std::uint32_t index : {0u, 1u, 1023u, 0x80000000u, 0xffffffffu}) {
        Sampler s(kind, 0x123456789abcdefull, stream, path, index);
        for (int d = 0; d < 64; ++d) {
          Vec2 const u = s.next2();
          outside += !(u.x >= 0 && u.x < 1 && u.y >= 0 && u.y < 1);
          different += sampleOf(kind, 0x123456789abcdefull, stream, path, index, d) != u;
        }
      }
    CHECK(outside == 0);
    CHECK(different == 0);
  });
}

TEST_CASE("a single number is the first of its dimension's two") {
  forEverySampler([](int kind, Stream stream) {
    Sampler pairs(kind, 3, stream, 5, 7), singles(kind, 3, stream, 5, 7);
    for (int d = 0; d < 16; ++d) CHECK(singles.next1() == pairs.next2().x);
  });
}

TEST_CASE("every part of a sample's name changes it") {
  forEverySampler([](int kind, Stream stream) {
    Vec2 const u = sampleOf(kind, 1, stream, 2, 3, 4);
    CHECK(sampleOf(kind, 2, stream, 2, 3, 4) != u);
    CHECK(sampleOf(kind, 1 + (1ull << 32), stream, 2, 3, 4) != u);
    CHECK(sampleOf(kind, 1, stream == Stream::camera ? Stream::photon : Stream::camera, 2, 3, 4) != u);
    CHECK(sampleOf(kind, 1, stream, 3, 3, 4) != u);
    CHECK(sampleOf(kind, 1, stream, 2, 4, 4) != u);
    CHECK(sampleOf(kind, 1, stream, 2, 3, 5) != u);
  });
}

TEST_CASE("samples are uniform in the square over paths, indices and seeds") {
  constexpr std::uint32_t n = 40000;
  forEverySampler([](int kind, Stream stream) {
    for (int d : {0, 1, 9}) {
      CAPTURE(d);
      Histogram2 paths(16, 16), indices(16, 16), seeds(16, 16), fine(1024, 1);
      for (std::uint32_t i = 0; i < n; ++i) {
        Vec2 const a = sampleOf(kind, 1, stream, i, 5, d);
        Vec2 const b = sampleOf(kind, 1, stream, hash32(i), i, d);
        Vec2 const c = sampleOf(kind, i, stream, 0, 0, d);
        paths.add(a.x, a.y);
        indices.add(b.x, b.y);
        seeds.add(c.x, c.y);
        fine.add(std::fmod(double(c.x) * 4096, 1), 0);  // digits 13 to 22
      }
      CHECK(paths.uniformP() > significance(tests));
      CHECK(indices.uniformP() > significance(tests));
      CHECK(seeds.uniformP() > significance(tests));
      CHECK(fine.uniformP() > significance(tests));
    }
  });
}

TEST_CASE("every aligned block of 2^k Sobol points puts one into each elementary interval") {
  for (std::uint64_t seed : {0ull, 1ull, 0xdeadbeefcafeull})
    for (std::uint32_t path : {0u, 4711u})
      for (int d : {0, 3, 20})
        for (int k = 1; k <= 9; ++k)
          for (std::uint32_t block : {0u, 1u, 5u, 0x7fffffu}) {
            std::vector<Vec2> points;
            for (std::uint32_t i = 0; i < 1u << k; ++i)
              points.push_back(sampleOf(sobol, seed, Stream::camera, path, (block << k) + i, d));
            if (!stratified(points, k)) FAIL("seed ", seed, " path ", path, " d ", d, " k ", k, " block ", block);
          }
}

TEST_CASE("independent samples are not stratified") {
  std::vector<Vec2> points;
  for (std::uint32_t i = 0; i < 256; ++i) points.push_back(sampleOf(independent, 1, Stream::camera, 0, i, 0));
  CHECK_FALSE(stratified(points, 8));
}

TEST_CASE("Owen scrambling permutes each digit by the digits before it alone") {
  TestRandom random(9);
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    std::uint32_t const x = random.word(), seed = random.word(), bit = i % 32, low = (1u << bit) - 1;
    std::uint32_t const a = SobolSampler::scrambleReversed(x, seed);
    std::uint32_t const b = SobolSampler::scrambleReversed(x ^ (1u << bit), seed);
    wrong += (a & low) != (b & low) || ((a ^ b) >> bit & 1) != 1;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the second Sobol coordinate is Pascal's triangle modulo 2") {
  int wrong = 0;
  for (std::uint32_t i = 0; i < 4096; ++i)
    for (std::uint32_t digit = 0; digit < 32; ++digit) {
      std::uint32_t parity = 0;
      for (std::uint32_t j = 0; j < 12; ++j) parity ^= (i >> j & 1) & ((j & digit) == digit);  // C(j, digit) mod 2
      wrong += (SobolSampler::pascal(i) >> digit & 1) != parity;
    }
  CHECK(wrong == 0);
}

TEST_CASE("dimensions, paths and seeds are uncorrelated") {
  constexpr std::uint32_t n = 4096;
  forEverySampler([](int kind, Stream stream) {
    double worst = 0;
    for (int d = 0; d < 24; ++d) {
      Correlation across, ahead, twoAhead, path, seed, index;
      for (std::uint32_t i = 0; i < n; ++i) {
        Sampler s(kind, 1, stream, 17, i), t(kind, 1, stream, hash32(i), 0);
        for (int skip = 0; skip < d; ++skip) s.next2(), t.next2();
        Vec2 const a = s.next2(), b = s.next2(), c = s.next2();
        across.add(a.x, a.y);
        ahead.add(a.x, b.x);
        twoAhead.add(a.y, c.y);
        path.add(a.x, sampleOf(kind, 1, stream, 18, i, d).x);
        seed.add(a.x, sampleOf(kind, 2, stream, 17, i, d).x);
        Vec2 const first = t.next2(), second = t.next2();
        index.add(first.x, second.x);
      }
      for (const Correlation* c : {&across, &ahead, &twoAhead, &path, &seed, &index})
        worst = std::max(worst, c->sigmas());
    }
    CHECK(worst <
          8);  // Sobol points come in pairs that flip together: their correlations spread wider than random ones
  });
}

TEST_CASE("successive dimensions of independent samples fill the square") {
  constexpr std::uint32_t n = 40000;
  for (int d : {0, 1, 6}) {
    Histogram2 dimensions(16, 16), indices(16, 16), paths(16, 16);
    for (std::uint32_t i = 0; i < n; ++i) {
      Vec2 const a = sampleOf(independent, 1, Stream::photon, 0, i, d);
      dimensions.add(a.x, sampleOf(independent, 1, Stream::photon, 0, i, d + 1).x);
      indices.add(a.y, sampleOf(independent, 1, Stream::photon, 0, i + 1, d).y);
      paths.add(a.x, sampleOf(independent, 1, Stream::photon, 1, i, d).y);
    }
    CHECK(dimensions.uniformP() > significance(tests));
    CHECK(indices.uniformP() > significance(tests));
    CHECK(paths.uniformP() > significance(tests));
  }
}

TEST_CASE("successive dimensions of scrambled Sobol points fill the square over paths") {
  constexpr std::uint32_t n = 40000;
  for (int d : {0, 1, 6})
    for (std::uint32_t index : {0u, 1u, 1000u}) {
      Histogram2 histogram(16, 16);
      for (std::uint32_t path = 0; path < n; ++path) {
        Vec2 const a = sampleOf(sobol, 1, Stream::camera, path, index, d);
        histogram.add(a.y, sampleOf(sobol, 1, Stream::camera, path, index, d + 1).x);
      }
      CHECK(histogram.uniformP() > significance(tests));
    }
}

TEST_CASE("a Sobol mean converges faster than a random one") {
  double error[2] = {0, 0};
  for (int kind : {sobol, independent})
    for (std::uint32_t path = 0; path < 64; ++path) {
      double mean = 0;
      for (std::uint32_t i = 0; i < 1024; ++i) {
        Vec2 const u = sampleOf(kind, 1, Stream::camera, path, i, 2);
        mean += double(u.x) * double(u.y) / 1024;
      }
      error[kind == independent] += (mean - 0.25) * (mean - 0.25);
    }
  CHECK(error[0] < error[1] / 100);
}
