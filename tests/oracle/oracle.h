#pragma once
// A path tracer in double precision that shares no code with the renderer it judges: plain structs in, an image out.

#include <array>
#include <variant>
#include <vector>

namespace oracle {

struct Vec {
  double x = 0, y = 0, z = 0;
};

/// Linear red, green, blue.
using Rgb = std::array<double, 3>;

/// Front is the outside.
struct Sphere {
  Vec center;
  double radius = 1;
};

/// Front is the side of edge1 × edge2.
struct Parallelogram {
  Vec corner, edge1, edge2;
};

/// Front is the side from which a, b, c run counter-clockwise.
struct Triangle {
  Vec a, b, c;
};

/// Lambertian on both sides.
struct Diffuse {
  Rgb albedo{};
};

/// Perfect mirror on both sides.
struct Mirror {
  Rgb reflectance{1, 1, 1};
};

/// Smooth interface; ior is the index behind the surface over the index in front of it.
struct Dielectric {
  double ior = 1.5;
  Rgb reflectance{1, 1, 1};
  Rgb transmittance{1, 1, 1};
};

enum class Side { front, back, both };

/// The same radiance (W·sr⁻¹·m⁻²) in all directions of a side; black means none.
struct Emission {
  Rgb radiance{};
  Side side = Side::front;
};

struct Shape {
  std::variant<Sphere, Parallelogram, Triangle> geometry;
  std::variant<Diffuse, Mirror, Dielectric> material;
  Emission emission{};
};

/// Pinhole or thin lens; right = normalize(forward × up), row 0 is the top, column 0 the left.
struct Camera {
  Vec position{0, 0, 5};
  Vec target{};
  Vec up{0, 1, 0};
  double verticalFov = 45;  ///< full angle, degrees
  int width = 64;           ///< pixels
  int height = 64;          ///< pixels
  double aperture = 0;      ///< lens radius; 0: pinhole
  double focus = 0;         ///< distance of the focal plane along forward; 0: distance to the target
};

struct Scene {
  Camera camera;
  std::vector<Shape> shapes;
};

/// Splits the image in two: `directOnly` keeps emission seen through specular chains alone (or none), and the light
/// that reaches the first diffuse vertex in a straight line; `indirectOnly` keeps the rest, caustics included. Not
/// both.
struct Options {
  bool directOnly = false;
  bool indirectOnly = false;
  int threads = 0;  ///< 0: as many as the machine has; the image does not depend on it
};

/// Mean radiance of every pixel, uniform over its box, row by row from the top left. Paths have at most `maxEdges`
/// segments from lens to light (0: no limit). `variance`, where given, becomes for every pixel the variance of its
/// mean, of the channel where it is largest: a bound for each channel and for any weighted average of them. Throws
/// std::invalid_argument for degenerate shapes or cameras, contradictory options, and fewer than 2 samples.
std::vector<Rgb> render(Scene const& scene, int samplesPerPixel, unsigned long long seed, int maxEdges = 0,
                        Options options = {}, std::vector<double>* variance = nullptr);

/// Mean of a block of pixels and the variance of that mean.
struct TileMean {
  Rgb mean{};
  double variance = 0;
};

/// Blocks of tileSize² pixels (smaller at the right and bottom), row by row, from what render() returned.
std::vector<TileMean> tileMeans(std::vector<Rgb> const& image, std::vector<double> const& variance, int width,
                                int tileSize);

}  // namespace oracle
