#include "render/film/exr.h"

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>

#include "render/core/error.h"
#include "render/film/atomic_file.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = "ropelight.";
constexpr std::int64_t maxPixels = std::int64_t(1) << 28;

bool isStandardKey(std::string_view key) { return key == "capDate" || key == "comments"; }

std::unique_ptr<Imf::Attribute> makeAttribute(const MetadataValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return std::make_unique<Imf::StringAttribute>(*text);
  if (const auto* number = std::get_if<double>(&value)) return std::make_unique<Imf::DoubleAttribute>(*number);
  const std::int64_t integer = std::get<std::int64_t>(value);
  if (integer != std::int64_t(std::int32_t(integer)))
    return std::make_unique<Imf::StringAttribute>(std::to_string(integer));
  return std::make_unique<Imf::IntAttribute>(int(integer));
}

Imf::Header makeHeader(const Image& image, const Metadata& metadata) {
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709 with D65
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : metadata)
    header.insert(isStandardKey(key) ? key : std::string(prefix) + key, *makeAttribute(value));
  return header;
}

/// One channel of the image as OpenEXR addresses it; the data window may lie anywhere.
Imf::Slice sliceOf(const Image& image, const Imath::Box2i& window, int channel) {
  const float* first = &image.pixels.front()[channel];
  return Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(Rgb), sizeof(Rgb) * std::size_t(image.width));
}

std::string channelNames(const Imf::Header& header) {
  std::string names;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    names += (names.empty() ? "" : ", ") + std::string(c.name());
  return names;
}

/// The file's channels for red, green and blue. Y with chroma beside it is no grey image, and is refused.
std::array<const char*, 3> sourceChannels(const fs::path& path, const Imf::Header& header) {
  const auto has = [&](const char* name) { return header.channels().findChannel(name) != nullptr; };
  if (has("R") && has("G") && has("B")) return {"R", "G", "B"};
  if (has("Y") && !has("RY") && !has("BY")) return {"Y", "Y", "Y"};
  throw Error(fmt::format("{}: channels: expected R, G and B, or Y alone, found {}; write the image with these names",
                          path.string(), channelNames(header)));
}

Imath::V2i imageSize(const fs::path& path, const Imath::Box2i& window) {
  const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
  const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
  if (width < 1 || height < 1 || width > maxPixels / height)
    throw Error(fmt::format("{}: dataWindow: {} x {} pixels, expected 1 to {} in all; crop or shrink the image",
                            path.string(), width, height, maxPixels));
  return Imath::V2i(int(width), int(height));
}

Image readPixels(const fs::path& path, Imf::InputFile& file) {
  const Imath::Box2i window = file.header().dataWindow();
  const Imath::V2i size = imageSize(path, window);
  const auto sources = sourceChannels(path, file.header());
  if (!file.isComplete())
    throw Error(fmt::format("{}: the file ends before its last pixel; write or copy it again", path.string()));
  Image image(size.x, size.y);
  const bool grey = sources[0] == sources[1];
  Imf::FrameBuffer frame;
  for (int channel = 0; channel < (grey ? 1 : 3); ++channel)
    frame.insert(sources[std::size_t(channel)], sliceOf(image, window, channel));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (grey)
    for (Rgb& pixel : image.pixels) pixel = Rgb(pixel.x);
  return image;
}

Metadata collectMetadata(const Imf::Header& header) {
  Metadata metadata;
  for (auto a = header.begin(); a != header.end(); ++a) {
    std::string key = a.name();
    if (key.starts_with(prefix)) key.erase(0, prefix.size());
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

/// Opens the file and hands it to `use`; what the library throws becomes an Error that names the file.
template <class Use>
auto withFile(const fs::path& path, Use use) {
  if (access(path.c_str(), R_OK) != 0)
    throw Error(
        fmt::format("{}: cannot be opened: {}; give a readable .exr file", path.string(), std::strerror(errno)));
  if (!Imf::isOpenExrFile(path.c_str()))
    throw Error(fmt::format("{}: is not an OpenEXR file; give one", path.string()));
  try {
    Imf::InputFile file(path.c_str());
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

void writeExr(const fs::path& path, const Image& image, const Metadata& metadata) {
  assert(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  if (image.pixels.empty()) throw Error(fmt::format("{}: the image has no pixels; render at least one", path.string()));
  Imf::StdOSStream stream;
  {
    const Imf::Header header = makeHeader(image, metadata);
    Imf::FrameBuffer frame;
    for (int channel = 0; const char* name : {"R", "G", "B"})
      frame.insert(name, sliceOf(image, header.dataWindow(), channel++));
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
  }
  writeFile(path, stream.str());
}

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
