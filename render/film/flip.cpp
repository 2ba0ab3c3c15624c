#include "render/film/flip.h"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "render/core/error.h"
#include "render/film/plane.h"

namespace ropelight {
namespace {

using std::numbers::pi;

/// Linear Rec. 709 to XYZ: its primaries (ITU-R BT.709) and D65 at x = 0.31271, y = 0.32902 with Y = 1.
Mat3d makeRgbToXyz() {
  const auto xyz = [](double x, double y) { return Vec3d(x / y, 1.0, (1.0 - x - y) / y); };
  const Mat3d primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
  const Vec3d amounts = glm::inverse(primaries) * xyz(0.31271, 0.32902);
  return Mat3d(primaries[0] * amounts.x, primaries[1] * amounts.y, primaries[2] * amounts.z);
}

struct ColourSpaces {
  Mat3d toXyz = makeRgbToXyz();
  Mat3d toRgb = glm::inverse(toXyz);
  Vec3d white = toXyz * Vec3d(1.0);

  static Vec3d opponents(Vec3d w) { return {116.0 * w.y - 16.0, 500.0 * (w.x - w.y), 200.0 * (w.y - w.z)}; }

  /// YyCxCz: L*a*b* without its cube root, so that a filter may add values up.
  Vec3d rgbToYcxcz(Vec3d rgb) const { return opponents(toXyz * rgb / white); }

  Vec3d ycxczToRgb(Vec3d c) const {
    const double y = (c.x + 16.0) / 116.0;
    return toRgb * (Vec3d(y + c.y / 500.0, y, y - c.z / 200.0) * white);
  }

  /// CIE L*a*b* with a* and b* times L*/100, since colours look the more colourful the lighter they are (Hunt).
  Vec3d rgbToHuntLab(Vec3d rgb) const {
    constexpr double d = 6.0 / 29.0;
    const auto f = [](double t) { return t > d * d * d ? std::cbrt(t) : t / (3.0 * d * d) + 4.0 / 29.0; };
    const Vec3d w = toXyz * rgb / white;
    const Vec3d lab = opponents(Vec3d(f(w.x), f(w.y), f(w.z)));
    return lab * Vec3d(1.0, 0.01 * lab.x, 0.01 * lab.x);
  }
};

/// Three numbers per pixel.
struct Planes {
  Plane x, y, z;

  Planes(int width, int height) : x(width, height), y(width, height), z(width, height) {}
  Planes(Plane first, Plane second, Plane third) : x(std::move(first)), y(std::move(second)), z(std::move(third)) {}

  Vec3d get(std::size_t i) const { return {x.values[i], y.values[i], z.values[i]}; }
  void set(std::size_t i, Vec3d c) { x.values[i] = c.x, y.values[i] = c.y, z.values[i] = c.z; }
};

/// body(i) for every index of a width × height plane, in parallel over rows.
template <class Body>
void forPixels(int width, int height, const Body& body) {
  oneapi::tbb::parallel_for(0, height, [&](int y) {
    const std::size_t first = std::size_t(y) * std::size_t(width);
    for (std::size_t i = first; i < first + std::size_t(width); ++i) body(i);
  });
}

/// A term a·√(π/b)·exp(−π²d²/b) of a contrast sensitivity, d in degrees.
struct Term {
  double a, b;
};

/// The eye's contrast sensitivities as the paper fitted them, by sums of Gaussians.
const std::vector<Term> achromatic = {{1.0, 0.0047}}, redGreen = {{1.0, 0.0053}},
                        blueYellow = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double widestB = 0.04;

template <class Weight>
Kernel makeKernel(int radius, const Weight& weight) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(weight(double(i)));
  return kernel;
}

/// The plane as the eye resolves it. Each Gaussian separates, but not their sum.
Plane resolve(const Plane& plane, const std::vector<Term>& sensitivity, double pixelsPerDegree) {
  const int radius = int(std::ceil(3.0 * std::sqrt(widestB / (2.0 * pi * pi)) * pixelsPerDegree));
  Plane out(plane.width, plane.height);
  double total = 0;
  for (const auto [a, b] : sensitivity) {
    const double scale = pi * pi / (b * pixelsPerDegree * pixelsPerDegree), height = a * std::sqrt(pi / b);
    const Kernel kernel = makeKernel(radius, [&](double x) { return std::exp(-scale * x * x); });
    const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
    const Plane term = filterPlane(plane, kernel, kernel);
    forPixels(out.width, out.height, [&](std::size_t i) { out.values[i] += height * term.values[i]; });
    total += height * sum * sum;
  }
  forPixels(out.width, out.height, [&](std::size_t i) { out.values[i] /= total; });
  return out;
}

/// Positive weights sum to 1, negative ones to −1.
Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (double weight : kernel) (weight > 0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
  return kernel;
}

/// The filters that find edges and points: two derivatives of a Gaussian 0.082 degrees wide.
struct FeatureKernels {
  Kernel smooth, edge, point;

  explicit FeatureKernels(double pixelsPerDegree) {
    const double s = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = int(std::ceil(3.0 * s));
    const auto gauss = [s](double x) { return std::exp(-x * x / (2.0 * s * s)); };
    smooth = makeKernel(radius, gauss);
    const double sum = std::accumulate(smooth.begin(), smooth.end(), 0.0);
    for (double& weight : smooth) weight /= sum;
    edge = balanced(makeKernel(radius, [&](double x) { return -x * gauss(x); }));
    point = balanced(makeKernel(radius, [&](double x) { return (x * x / (s * s) - 1.0) * gauss(x); }));
  }
};

/// How strong a feature is: the length of what `kernel` finds along x and along y.
Plane strength(const Plane& luminance, const Kernel& kernel, const Kernel& smooth) {
  Plane out = filterPlane(luminance, kernel, smooth);
  const Plane alongY = filterPlane(luminance, smooth, kernel);
  forPixels(out.width, out.height, [&](std::size_t i) { out.values[i] = std::hypot(out.values[i], alongY.values[i]); });
  return out;
}

Planes toYcxcz(const Image& image, const ColourSpaces& spaces) {
  Planes planes(image.width, image.height);
  forPixels(image.width, image.height, [&](std::size_t i) {
    const Vec3d pixel = isFinitePixel(image.pixels[i]) ? Vec3d(image.pixels[i]) : Vec3d(0.0);
    planes.set(i, spaces.rgbToYcxcz(glm::clamp(pixel, 0.0, 1.0)));
  });
  return planes;
}

/// What one sees of an image.
struct Percept {
  Planes lab;  ///< Hunt-adjusted, at the eye's resolution
  Plane edges, points;
};

Percept perceive(const Image& image, const ColourSpaces& spaces, double pixelsPerDegree) {
  const Planes sharp = toYcxcz(image, spaces);
  Planes lab(resolve(sharp.x, achromatic, pixelsPerDegree), resolve(sharp.y, redGreen, pixelsPerDegree),
             resolve(sharp.z, blueYellow, pixelsPerDegree));
  Plane luminance(image.width, image.height);
  forPixels(image.width, image.height, [&](std::size_t i) {
    lab.set(i, spaces.rgbToHuntLab(glm::clamp(spaces.ycxczToRgb(lab.get(i)), 0.0, 1.0)));
    luminance.values[i] = (sharp.x.values[i] + 16.0) / 116.0;
  });
  const FeatureKernels kernels(pixelsPerDegree);
  return {std::move(lab), strength(luminance, kernels.edge, kernels.smooth),
          strength(luminance, kernels.point, kernels.smooth)};
}

/// HyAB, the distance that holds for large differences of colour too (Abasi et al. 2020), to the paper's power.
double colourDistance(Vec3d a, Vec3d b) {
  return std::pow(std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7);
}

/// Spreads differences below 0.4 of the largest over [0, 0.95], since larger ones look much alike.
double remap(double distance, double largest) {
  const double knee = 0.4 * largest;
  return distance < knee ? 0.95 * distance / knee : 0.95 + 0.05 * (distance - knee) / (largest - knee);
}

double featureDifference(const Percept& a, const Percept& b, std::size_t i) {
  const double edge = std::abs(a.edges.values[i] - b.edges.values[i]);
  const double point = std::abs(a.points.values[i] - b.points.values[i]);
  return std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
}

}  // namespace

FlipResult flip(const Image& image, const Image& reference, double pixelsPerDegree) {
  assert(pixelsPerDegree >= 1);
  if (image.width != reference.width || image.height != reference.height)
    throw Error(
        fmt::format("the images differ in size: {} x {} and {} x {} pixels; compare images of the same film size",
                    image.width, image.height, reference.width, reference.height));
  const ColourSpaces spaces;
  const double largest =
      colourDistance(spaces.rgbToHuntLab(Vec3d(0.0, 1.0, 0.0)), spaces.rgbToHuntLab(Vec3d(0.0, 0.0, 1.0)));
  const Percept a = perceive(image, spaces, pixelsPerDegree), b = perceive(reference, spaces, pixelsPerDegree);
  FlipResult result = {.map = Image(image.width, image.height)};
  Plane errors(image.width, image.height);
  forPixels(image.width, image.height, [&](std::size_t i) {
    const bool finite = isFinitePixel(image.pixels[i]) && isFinitePixel(reference.pixels[i]);
    const double colour = remap(colourDistance(a.lab.get(i), b.lab.get(i)), largest);
    const double error = std::min(std::pow(colour, 1.0 - featureDifference(a, b, i)), 1.0);
    errors.values[i] = finite ? error : 1.0;
    result.map.pixels[i] = Rgb(float(errors.values[i]));
  });
  result.mean = std::accumulate(errors.values.begin(), errors.values.end(), 0.0) / double(errors.values.size());
  return result;
}

}  // namespace ropelight
