#pragma once
// EXR files as other programs write them, and pictures to put in them.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledRgbaFile.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "render/film/image.h"

namespace ropelight {

/// Every pixel and channel different, all exact in half precision: x + y/16, and its negative, and 64 more.
inline Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float value = float(x) + float(y) / 16.0f;
      image.at(x, y) = Rgb(value, -value, value + 64.0f);
    }
  return image;
}

inline std::vector<Imf::Rgba> toRgba(const Image& image) {
  std::vector<Imf::Rgba> result;
  for (Rgb p : image.pixels) result.emplace_back(p.x, p.y, p.z);
  return result;
}

inline bool sameBits(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height &&
         std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(Rgb)) == 0;
}

/// The image as another program would write it: half floats, with the data window's corner at `origin`.
inline void writeHalf(const std::filesystem::path& path, const Image& image, Imf::RgbaChannels channels,
                      Imath::V2i origin, Imath::Box2i display) {
  const Imath::Box2i window(origin, origin + Imath::V2i(image.width - 1, image.height - 1));
  const std::vector<Imf::Rgba> pixels = toRgba(image);
  Imf::RgbaOutputFile file(path.c_str(), display, window, channels);
  file.setFrameBuffer(pixels.data() - origin.x - std::ptrdiff_t(origin.y) * image.width, 1, std::size_t(image.width));
  file.writePixels(image.height);
}

/// The same with both windows where the image is.
inline void writeHalf(const std::filesystem::path& path, const Image& image, Imf::RgbaChannels channels) {
  writeHalf(path, image, channels, {0, 0}, {{0, 0}, {image.width - 1, image.height - 1}});
}

/// Channels of these names, each pixel 1.
inline void writeNamed(const std::filesystem::path& path, const std::vector<std::string>& names) {
  const std::vector<float> ones(4, 1.0f);
  Imf::Header header(2, 2);
  Imf::FrameBuffer frame;
  for (const std::string& name : names) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, ones.data(), header.dataWindow()));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(2);
}

inline void writeTiled(const std::filesystem::path& path, const Image& image) {
  const std::vector<Imf::Rgba> pixels = toRgba(image);
  Imf::TiledRgbaOutputFile file(path.c_str(), image.width, image.height, 8, 8, Imf::ONE_LEVEL);
  file.setFrameBuffer(pixels.data(), 1, std::size_t(image.width));
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

/// A pixel whose header states these colours.
inline void writeWithColours(const std::filesystem::path& path, const Imf::Chromaticities& colours) {
  const Imf::Rgba pixel(1.0f, 1.0f, 1.0f);
  Imf::Header header(1, 1);
  Imf::addChromaticities(header, colours);
  Imf::RgbaOutputFile file(path.c_str(), header, Imf::WRITE_RGB);
  file.setFrameBuffer(&pixel, 1, 1);
  file.writePixels(1);
}

}  // namespace ropelight
