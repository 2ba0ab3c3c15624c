#include "tests/oracle/oracle.h"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "tests/oracle/world.h"

namespace oracle {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int rouletteStart = 5;  // edges

Rgb operator*(Rgb const& a, Rgb const& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
Rgb operator*(double s, Rgb const& a) { return {s * a[0], s * a[1], s * a[2]}; }
void operator+=(Rgb& a, Rgb const& b) { a = {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
double largest(Rgb const& a) { return std::max({a[0], a[1], a[2]}); }

Vec cosineAround(Vec n, Random& random) {
  double const r = std::sqrt(random.next());
  double const phi = 2 * pi * random.next();
  Vec const tangent = normalize(cross(std::abs(n.x) < 0.5 ? Vec{1, 0, 0} : Vec{0, 1, 0}, n));
  Vec const bitangent = cross(n, tangent);
  return normalize(r * std::cos(phi) * tangent + r * std::sin(phi) * bitangent + std::sqrt(1 - r * r) * n);
}

/// Reflectance of unpolarised light (Fresnel's equations) from a medium of index 1 to one of index `eta`.
double fresnel(double cosI, double cosT, double eta) {
  double const s = (cosI - eta * cosT) / (cosI + eta * cosT);
  double const p = (eta * cosI - cosT) / (eta * cosI + cosT);
  return (s * s + p * p) / 2;
}

class Path {
 public:
  Path(World const& world, int maxEdges, Options const& options, Random& random)
      : world_(world), maxEdges_(maxEdges), options_(options), random_(random) {}

  /// One estimate of the radiance that arrives along the ray, against its direction.
  Rgb trace(Ray ray) {
    ray_ = ray;
    for (int edges = 1; maxEdges_ == 0 || edges <= maxEdges_; ++edges) {
      Hit const hit = world_.search.nearest(ray_);
      if (hit.shape < 0) break;
      addEmission(hit);
      bool const mayConnect = edges != maxEdges_;
      auto const& material = world_.shapes[static_cast<std::size_t>(hit.shape)].material;
      std::visit([&](auto const& m) { scatter(m, hit, mayConnect); }, material);
      if (options_.directOnly && !nextLightIsDirect()) break;
      if (!survives(edges)) break;
    }
    return radiance_;
  }

 private:
  bool nextLightIsDirect() const { return diffuseVertices_ == 0 || (diffuseVertices_ == 1 && !lastSpecular_); }
  bool wanted(bool direct) const { return direct ? !options_.indirectOnly : !options_.directOnly; }

  /// Emission met by the ray; behind a diffuse vertex it shares its weight with light sampling by the balance
  /// heuristic.
  void addEmission(Hit const& hit) {
    if (!wanted(nextLightIsDirect())) return;
    double const cosine = -dot(ray_.direction, hit.normal);
    double weight = 1;
    if (!lastSpecular_) {
      double const lightPdf = world_.areaPdf[static_cast<std::size_t>(hit.shape)] * hit.t * hit.t / std::abs(cosine);
      weight = directionPdf_ / (directionPdf_ + lightPdf);
    }
    radiance_ += weight * throughput_ * world_.emitted(hit.shape, cosine);
  }

  /// Light from one point on a light: ∫ (ρ/π) Le cos cos'/d² dA over its area, divided by the density of the point and
  /// weighted by the balance heuristic.
  Rgb lightFrom(LightPoint const& light, Rgb const& albedo, Vec point, Vec normal) const {
    Vec const away = light.point - point;
    double const distance = length(away);
    if (distance <= 2 * world_.search.epsilon) return {};
    Vec const direction = (1 / distance) * away;
    double const cosine = dot(normal, direction);
    double const cosineLight = -dot(light.normal, direction);
    if (cosine <= 0 || cosineLight == 0) return {};
    Rgb const emitted = world_.emitted(light.shape, cosineLight);
    if (largest(emitted) == 0 || world_.search.blocked({point, direction}, distance)) return {};
    double const areaPdf = world_.areaPdf[static_cast<std::size_t>(light.shape)];
    double const lightPdf = areaPdf * distance * distance / std::abs(cosineLight);
    return (cosine / pi / (lightPdf + cosine / pi)) * albedo * emitted;
  }

  void scatter(Diffuse const& m, Hit const& hit, bool mayConnect) {
    Vec const normal = dot(ray_.direction, hit.normal) < 0 ? hit.normal : -1 * hit.normal;
    ++diffuseVertices_;
    lastSpecular_ = false;
    if (!world_.lights.empty()) {
      LightPoint const light = world_.sampleLight(random_);
      if (mayConnect && wanted(diffuseVertices_ == 1))
        radiance_ += throughput_ * lightFrom(light, m.albedo, hit.point, normal);
    }
    ray_ = {hit.point, cosineAround(normal, random_)};
    directionPdf_ = dot(normal, ray_.direction) / pi;
    throughput_ = throughput_ * m.albedo;
  }

  void scatter(Mirror const& m, Hit const& hit, bool) {
    lastSpecular_ = true;
    ray_ = {hit.point, normalize(ray_.direction - 2 * dot(ray_.direction, hit.normal) * hit.normal)};
    throughput_ = throughput_ * m.reflectance;
  }

  /// Radiance over the index squared is what refraction conserves: seen from medium i, light of medium t carries
  /// (n_i/n_t)².
  void scatter(Dielectric const& m, Hit const& hit, bool) {
    lastSpecular_ = true;
    bool const fromFront = dot(ray_.direction, hit.normal) < 0;
    Vec const normal = fromFront ? hit.normal : -1 * hit.normal;
    double const eta = fromFront ? m.ior : 1 / m.ior;
    double const cosI = -dot(ray_.direction, normal);
    double const cosTSquared = 1 - (1 - cosI * cosI) / (eta * eta);
    double const cosT = std::sqrt(std::max(0.0, cosTSquared));
    double const reflected = cosTSquared <= 0 ? 1 : fresnel(cosI, cosT, eta);
    if (random_.next() < reflected) {
      ray_ = {hit.point, normalize(ray_.direction + 2 * cosI * normal)};
      throughput_ = throughput_ * m.reflectance;
    } else {
      ray_ = {hit.point, normalize((1 / eta) * ray_.direction + (cosI / eta - cosT) * normal)};
      throughput_ = (1 / (eta * eta)) * throughput_ * m.transmittance;
      indexSquared_ *= eta * eta;
    }
  }

  /// Russian roulette on the throughput without the factor of refraction, which a later refraction takes back.
  bool survives(int edges) {
    if (largest(throughput_) == 0) return false;
    if (edges < rouletteStart) return true;
    double const chance = std::min(0.95, largest(throughput_) * indexSquared_);
    if (random_.next() >= chance) return false;
    throughput_ = (1 / chance) * throughput_;
    return true;
  }

  World const& world_;
  int maxEdges_;
  Options const& options_;
  Random& random_;
  Ray ray_;
  Rgb radiance_{};
  Rgb throughput_{1, 1, 1};
  double indexSquared_ = 1;  // of the medium now, relative to the camera's
  double directionPdf_ = 0;  // of ray_ per solid angle, after a diffuse vertex
  bool lastSpecular_ = true;
  int diffuseVertices_ = 0;
};

class Lens {
 public:
  explicit Lens(Camera const& camera)
      : camera_(camera),
        forward_(normalize(camera.target - camera.position)),
        right_(normalize(cross(forward_, camera.up))),
        up_(cross(right_, forward_)),
        focus_(camera.focus > 0 ? camera.focus : length(camera.target - camera.position)),
        halfHeight_(std::tan(camera.verticalFov * pi / 360)) {
    if (!(camera.width > 0 && camera.height > 0) || !std::isfinite(dot(up_, up_)) || !(halfHeight_ > 0))
      throw std::invalid_argument("oracle: a camera without a frame");
  }

  Ray ray(int column, int row, Random& random) const {
    double const x = 2 * (column + random.next()) - camera_.width;
    double const y = camera_.height - 2 * (row + random.next());
    double const scale = halfHeight_ / camera_.height;
    Vec const through = forward_ + scale * x * right_ + scale * y * up_;
    if (camera_.aperture == 0) return {camera_.position, normalize(through)};
    double const r = camera_.aperture * std::sqrt(random.next());
    double const phi = 2 * pi * random.next();
    Vec const onLens = r * std::cos(phi) * right_ + r * std::sin(phi) * up_;
    return {camera_.position + onLens, normalize(focus_ * through - onLens)};
  }

 private:
  Camera camera_;
  Vec forward_, right_, up_;
  double focus_, halfHeight_;
};

/// Running mean and sum of squared deviations (Welford 1962).
struct Mean {
  Rgb mean{}, squares{};
  int count = 0;

  void add(Rgb const& sample) {
    ++count;
    for (std::size_t c = 0; c < 3; ++c) {
      double const before = sample[c] - mean[c];
      mean[c] += before / count;
      squares[c] += before * (sample[c] - mean[c]);
    }
  }
  double variance() const { return largest(squares) / count / (count - 1.0); }
};

/// A stream of its own for every sample, so that neither threads nor options shift the numbers of another.
Random streamOf(unsigned long long seed, std::size_t pixel, int sample) {
  Random mix{seed};
  mix.state = mix.bits() ^ pixel;
  mix.state = mix.bits() ^ static_cast<std::uint64_t>(sample);
  return {mix.bits()};
}

void onAllThreads(int threads, auto const& work) {
  unsigned const wanted = threads > 0 ? static_cast<unsigned>(threads) : std::thread::hardware_concurrency();
  std::vector<std::thread> pool(std::max(1u, wanted));
  for (std::thread& thread : pool) thread = std::thread(work);
  for (std::thread& thread : pool) thread.join();
}

}  // namespace

std::vector<Rgb> render(Scene const& scene, int samplesPerPixel, unsigned long long seed, int maxEdges, Options options,
                        std::vector<double>* variance) {
  if (samplesPerPixel < 2) throw std::invalid_argument("oracle: a variance needs at least 2 samples");
  if (options.directOnly && options.indirectOnly) throw std::invalid_argument("oracle: directOnly and indirectOnly");
  World const world(scene);
  Lens const lens(scene.camera);
  std::size_t const width = static_cast<std::size_t>(scene.camera.width);
  std::vector<Rgb> image(width * static_cast<std::size_t>(scene.camera.height));
  if (variance) variance->assign(image.size(), 0);

  std::atomic<std::size_t> next = 0;
  onAllThreads(options.threads, [&] {
    for (std::size_t pixel = next++; pixel < image.size(); pixel = next++) {
      Mean mean;
      for (int sample = 0; sample < samplesPerPixel; ++sample) {
        Random random = streamOf(seed, pixel, sample);
        Ray const ray = lens.ray(static_cast<int>(pixel % width), static_cast<int>(pixel / width), random);
        mean.add(Path(world, maxEdges, options, random).trace(ray));
      }
      image[pixel] = mean.mean;
      if (variance) (*variance)[pixel] = mean.variance();
    }
  });
  return image;
}

std::vector<TileMean> tileMeans(std::vector<Rgb> const& image, std::vector<double> const& variance, int width,
                                int tileSize) {
  std::size_t const columns = static_cast<std::size_t>(width);
  std::size_t const tile = static_cast<std::size_t>(tileSize);
  std::size_t const across = (columns + tile - 1) / tile;
  std::size_t const down = (image.size() / columns + tile - 1) / tile;
  std::vector<TileMean> tiles(across * down);
  std::vector<double> counts(tiles.size(), 0);
  for (std::size_t i = 0; i < image.size(); ++i) {
    std::size_t const t = i / columns / tile * across + i % columns / tile;
    tiles[t].mean += image[i];
    tiles[t].variance += variance[i];
    ++counts[t];
  }
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    tiles[t].mean = (1 / counts[t]) * tiles[t].mean;
    tiles[t].variance /= counts[t] * counts[t];
  }
  return tiles;
}

}  // namespace oracle
