#include "render/image_files/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <new>
#include <string_view>

#include "render/core/error.h"
#include "render/image_files/exr_names.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t maxPixels = std::int64_t(1) << 28;

int channelCount(const Imf::Header& header) {
  int count = 0;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) ++count;
  return count;
}

/// The channels' names; those in layers include the layer's name ("beauty.R").
std::string channelNames(const Imf::Header& header) {
  constexpr int most = 24;
  std::string names;
  int shown = 0;
  for (auto c = header.channels().begin(); c != header.channels().end() && shown < most; ++c, ++shown)
    names += (names.empty() ? "" : ", ") + std::string(c.name());
  if (channelCount(header) > most) names += fmt::format(" and {} more", channelCount(header) - most);
  return names;
}

/// The file's channels for red, green and blue. Y beside others (chroma, X and Z) is no grey image, and is refused.
std::array<const char*, 3> sourceChannels(const fs::path& path, const Imf::Header& header) {
  const auto has = [&](const char* name) { return header.channels().findChannel(name) != nullptr; };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y") && channelCount(header) == (has("A") ? 2 : 1)) return {"Y", "Y", "Y"};
  throw Error(fmt::format("{}: channels: expected R, G and B, or Y alone, found {}; write the image with these names",
                          path.string(), channelNames(header)));
}

Imath::V2i sizeOf(const fs::path& path, const char* what, const Imath::Box2i& window) {
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > maxPixels / height)
    throw Error(fmt::format("{}: {}: {} x {} pixels, expected 1 to {} in all; crop or shrink the image", path.string(),
                            what, width, height, maxPixels));
  return Imath::V2i(int(width), int(height));
}

/// One channel of the image as OpenEXR addresses it; the window may lie anywhere.
Imf::Slice sliceOf(Image& image, const Imath::Box2i& window, int channel) {
  return Imf::Slice::Make(Imf::FLOAT, &image.pixels.front()[channel], window, sizeof(Rgb),
                          sizeof(Rgb) * std::size_t(image.width));
}

/// The image over `from`, cut or extended with black to the window `to`.
Image place(const Image& image, const Imath::Box2i& from, const Imath::Box2i& to, Imath::V2i size) {
  Image placed(size.x, size.y);
  const Imath::V2i low(std::max(from.min.x, to.min.x), std::max(from.min.y, to.min.y));
  const Imath::V2i high(std::min(from.max.x, to.max.x), std::min(from.max.y, to.max.y));
  if (low.x > high.x) return placed;
  for (int y = low.y; y <= high.y; ++y)
    std::copy_n(&image.at(low.x - from.min.x, y - from.min.y), high.x - low.x + 1,
                &placed.at(low.x - to.min.x, y - to.min.y));
  return placed;
}

Image readPixels(const fs::path& path, Imf::InputFile& file) {
  const Imath::Box2i data = file.header().dataWindow(), display = file.header().displayWindow();
  const Imath::V2i size = sizeOf(path, "dataWindow", data), shown = sizeOf(path, "displayWindow", display);
  const auto sources = sourceChannels(path, file.header());
  if (!file.isComplete())
    throw Error(fmt::format("{}: the file ends before its last pixel; write or copy it again", path.string()));
  Image image(size.x, size.y);
  const bool grey = sources[0] == sources[1];
  Imf::FrameBuffer frame;
  for (int channel = 0; channel < (grey ? 1 : 3); ++channel)
    frame.insert(sources[std::size_t(channel)], sliceOf(image, data, channel));
  file.setFrameBuffer(frame);
  file.readPixels(data.min.y, data.max.y);
  if (grey)
    for (Rgb& pixel : image.pixels) pixel = Rgb(pixel.x);
  return data == display ? image : place(image, data, display, shown);
}

Metadata collectMetadata(const Imf::Header& header) {
  Metadata metadata;
  for (auto a = header.begin(); a != header.end(); ++a) {
    std::string key = a.name();
    if (key.starts_with(exrPrefix)) key.erase(0, exrPrefix.size());
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&a.attribute()))
      metadata.emplace_back(key, text->value());
    else if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&a.attribute()))
      metadata.emplace_back(key, number->value());
    else if (const auto* single = dynamic_cast<const Imf::FloatAttribute*>(&a.attribute()))
      metadata.emplace_back(key, double(single->value()));
    else if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&a.attribute()))
      metadata.emplace_back(key, std::int64_t(integer->value()));
  }
  return metadata;
}

std::array<Imath::V2f, 4> pointsOf(const Imf::Chromaticities& c) { return {c.red, c.green, c.blue, c.white}; }

/// Written so that a NaN is far from everything.
bool isNear(Imath::V2f a, Imath::V2f b) { return std::abs(a.x - b.x) <= 1e-3f && std::abs(a.y - b.y) <= 1e-3f; }

std::string describeForeign(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const auto found = pointsOf(Imf::chromaticities(header)), ours = pointsOf(Imf::Chromaticities());
  if (std::equal(found.begin(), found.end(), ours.begin(), isNear)) return {};
  const auto text = [](Imath::V2f point) { return fmt::format("({:.5g} {:.5g})", point.x, point.y); };
  return fmt::format("primaries {} {} {}, white {}", text(found[0]), text(found[1]), text(found[2]), text(found[3]));
}

/// Opens the file and calls `use` with it; what the library throws becomes an Error that names the file.
template <class Use>
auto withFile(const fs::path& path, Use use) {
  if (access(path.c_str(), R_OK) != 0)
    throw Error(
        fmt::format("{}: cannot be opened: {}; give a readable .exr file", path.string(), std::strerror(errno)));
  if (!Imf::isOpenExrFile(path.c_str()))
    throw Error(fmt::format("{}: is not an OpenEXR file; give one", path.string()));
  try {
    Imf::InputFile file(path.c_str(), exrThreads());
    return use(file);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    throw Error(fmt::format("{}: cannot be read as OpenEXR: {}; write or copy it again", path.string(), e.what()));
  }
}

}  // namespace

Image readExr(const fs::path& path) {
  return withFile(path, [&](Imf::InputFile& file) { return readPixels(path, file); });
}

Metadata readExrMetadata(const fs::path& path) {
  return withFile(path, [](Imf::InputFile& file) { return collectMetadata(file.header()); });
}

std::string foreignColours(const fs::path& path) {
  return withFile(path, [](Imf::InputFile& file) { return describeForeign(file.header()); });
}

}  // namespace ropelight
