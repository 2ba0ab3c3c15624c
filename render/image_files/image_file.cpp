#include "render/image_files/image_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/core/error.h"
#include "render/image_files/png.h"
#include "render/image_files/png_colour.h"

namespace ropelight {

ImageFormat imageFormatOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  if (ending == ".exr") return ImageFormat::exr;
  if (ending == ".png") return ImageFormat::png;
  throw Error(
      fmt::format("{}: unknown image format '{}'; expected a name that ends in .exr or .png", path.string(), ending));
}

Image readImage(const std::filesystem::path& path) {
  return imageFormatOf(path) == ImageFormat::exr ? readExr(path) : readPng(path);
}

std::string ignoredColours(const std::filesystem::path& path) {
  return imageFormatOf(path) == ImageFormat::exr ? foreignColours(path) : readPngColour(path).ignored;
}

std::uint64_t writeImage(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap,
                         const Metadata& metadata, const WriteProgress& progress) {
  if (imageFormatOf(path) == ImageFormat::png) return writePng(path, image, tonemap, progress);
  writeExr(path, image, metadata, progress);
  return 0;
}

}  // namespace ropelight
