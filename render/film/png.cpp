#include "render/film/png.h"

#include <fmt/format.h>

// Ours alone: another copy in the program (libstb, a user interface) stays apart.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <cassert>
#include <memory>
#include <new>
#include <string>

#include "render/core/error.h"
#include "render/film/atomic_file.h"

namespace ropelight {
namespace {

// The encoder counts bytes in int; up to here, a growing buffer of incompressible rows cannot overflow it.
constexpr std::size_t maxBytes = std::size_t(1) << 30;

void appendBytes(void* file, void* data, int size) {
  static_cast<std::string*>(file)->append(static_cast<const char*>(data), std::size_t(size));
}

void checkSize(const std::string& what, int width, int height) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  if (pixels == 0 || pixels > maxBytes / 3)
    throw Error(fmt::format("{}: an image of {} x {} pixels does not fit into a PNG here; write .exr instead", what,
                            width, height));
}

/// The sRGB chunk (PNG 3rd edition, §11.3.2.5; perceptual intent), whose place is behind signature and IHDR.
void markAsSrgb(std::string& file) {
  constexpr std::size_t behindHeader = 8 + 25;
  constexpr char chunk[] = "\0\0\0\1sRGB\0\xAE\xCE\x1C\xE9";  // length, type, intent, CRC
  file.insert(behindHeader, chunk, sizeof(chunk) - 1);
}

std::string fileOf(int width, int height, std::span<const std::uint8_t> bytes) {
  assert(bytes.size() == std::size_t(width) * std::size_t(height) * 3);
  std::string file;
  if (!stbi_write_png_to_func(appendBytes, &file, width, height, 3, bytes.data(), width * 3)) throw std::bad_alloc();
  markAsSrgb(file);
  return file;
}

}  // namespace

std::uint64_t writePng(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap) {
  assert(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  checkSize(path.string(), image.width, image.height);
  const ScreenImage screen = toScreen(image, tonemap);
  writeScreenPng(path, image.width, image.height, screen.bytes);
  return screen.nonFinite;
}

void writeScreenPng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> bytes) {
  checkSize(path.string(), width, height);
  writeFile(path, fileOf(width, height, bytes));
}

std::vector<std::uint8_t> encodePng(const Image& image, const Tonemap& tonemap) {
  checkSize("a picture", image.width, image.height);
  const std::string file = fileOf(image.width, image.height, toScreen(image, tonemap).bytes);
  return {file.begin(), file.end()};
}

Image readPng(const std::filesystem::path& path) {
  // Eight-bit files arrive scaled by 257, so that one division serves both depths.
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_us, decltype(&stbi_image_free)> data(
      stbi_load_16(path.c_str(), &width, &height, &channels, 3), stbi_image_free);
  if (!data)
    throw Error(
        fmt::format("{}: cannot be read as PNG: {}; give an existing .png file", path.string(), stbi_failure_reason()));
  Image image(width, height);
  const stbi_us* value = data.get();
  for (Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) pixel[channel] = float(decodeSrgb(*value++ / 65535.0));
  return image;
}

}  // namespace ropelight
