#include "render/image_files/png.h"

#include <fmt/format.h>

// Static, so that it does not clash with another copy in the program (libstb, a user interface).
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <string>

#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/image_files/png_colour.h"
#include "render/image_files/png_encode.h"

namespace ropelight {
namespace {

void checkSize(const std::string& what, int width, int height) {
  if (width < 1 || height < 1) throw Error(fmt::format("{}: the image has no pixels; render at least one", what));
}

/// Tone-maps rows on the threads that encode them, so that no second image is needed.
class ScreenRows {
 public:
  ScreenRows(const Image& image, const Tonemap& tonemap) : image_(image), tonemap_(tonemap) {}

  void operator()(int first, int count, std::uint8_t* out) const {
    std::size_t const width = std::size_t(image_.width);
    std::span const pixels(image_.pixels.data() + std::size_t(first) * width, std::size_t(count) * width);
    toScreen(pixels, tonemap_, out);
  }

 private:
  const Image& image_;
  const Tonemap& tonemap_;
};

std::uint64_t countNonFinite(const Image& image) {
  return std::uint64_t(
      std::count_if(image.pixels.begin(), image.pixels.end(), [](Rgb p) { return !isFinitePixel(p); }));
}

/// Linear values of all 16-bit samples; eight-bit files arrive scaled by 257.
std::vector<float> decodingTable(double gamma) {
  std::vector<float> table(65536);
  for (std::size_t i = 0; i < table.size(); ++i) {
    double const sample = double(i) / 65535.0;
    table[i] = float(gamma > 0 ? std::pow(sample, 1 / gamma) : decodeSrgb(sample));
  }
  return table;
}

}  // namespace

std::uint64_t writePng(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap,
                       const WriteProgress& progress) {
  assert(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  checkSize(path.string(), image.width, image.height);
  checkTonemap(tonemap);
  OutputFile file(path);
  encodePngRows(
      image.width, image.height, ScreenRows(image, tonemap), [&](std::string_view bytes) { file.write(bytes); },
      progress);
  file.commit();
  return countNonFinite(image);
}

void writeScreenPng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> bytes) {
  checkSize(path.string(), width, height);
  assert(bytes.size() == std::size_t(width) * std::size_t(height) * 3);
  std::size_t const row = std::size_t(width) * 3;
  OutputFile file(path);
  encodePngRows(
      width, height,
      [&](int first, int count, std::uint8_t* out) {
        std::copy_n(bytes.data() + std::size_t(first) * row, std::size_t(count) * row, out);
      },
      [&](std::string_view piece) { file.write(piece); });
  file.commit();
}

std::vector<std::uint8_t> encodePng(const Image& image, const Tonemap& tonemap) {
  checkSize("a picture", image.width, image.height);
  checkTonemap(tonemap);
  std::vector<std::uint8_t> file;
  encodePngRows(image.width, image.height, ScreenRows(image, tonemap),
                [&](std::string_view bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); });
  return file;
}

Image readPng(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> data(
      stbi_load_16(path.c_str(), &width, &height, &channels, 3), stbi_image_free);
  if (!data)
    throw Error(
        fmt::format("{}: cannot be read as PNG: {}; give an existing .png file", path.string(), stbi_failure_reason()));
  Image image(width, height);
  const std::vector<float> linear = decodingTable(readPngColour(path).gamma);
  const stbi_us* value = data.get();
  for (Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = linear[*value++];
  return image;
}

}  // namespace ropelight
