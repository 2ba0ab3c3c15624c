// Writing OpenEXR files, in blocks of lines on all cores.

#include <ImfChannelList.h>
#include <ImfChromaticities.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <cassert>
#include <exception>
#include <memory>

#include "render/core/error.h"
#include "render/image_files/atomic_file.h"
#include "render/image_files/exr.h"
#include "render/image_files/exr_names.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

constexpr int linesOfBlock = 16;  // of ZIP

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
    header.insert(isStandardKey(key) ? key : std::string(exrPrefix) + key, *makeAttribute(value));
  return header;
}

/// Writes to an OutputFile. OpenEXR swallows what its last writes throw, so the first failure is kept.
class Stream final : public Imf::OStream {
 public:
  Stream(const fs::path& path, OutputFile& file) : OStream(path.c_str()), file_(file) {}

  void write(const char bytes[], int count) override {
    attempt([&] { file_.write({bytes, std::size_t(count)}); });
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override {
    attempt([&] { file_.seek(position); });
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  template <class Action>
  void attempt(Action action) {
    rethrow();
    try {
      action();
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }

  OutputFile& file_;
  std::exception_ptr failure_;
};

Imf::FrameBuffer framebufferOf(const Image& image, const Imath::Box2i& window) {
  Imf::FrameBuffer frame;
  for (int channel = 0; const char* name : {"R", "G", "B"})
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &image.pixels.front()[channel++], window, sizeof(Rgb),
                                        sizeof(Rgb) * std::size_t(image.width)));
  return frame;
}

void writeLines(Imf::OutputFile& file, int height, const WriteProgress& progress) {
  const int lines = 4 * linesOfBlock * exrThreads();
  for (int y = 0; y < height; y += lines) {
    file.writePixels(std::min(lines, height - y));
    if (progress) progress(std::min(1.0, double(y + lines) / height));
  }
}

}  // namespace

int exrThreads() {
  static const int threads = [] {
    const int count = std::max(Imf::globalThreadCount(), oneapi::tbb::info::default_concurrency());
    Imf::setGlobalThreadCount(count);
    return count;
  }();
  return threads;
}

void writeExr(const fs::path& path, const Image& image, const Metadata& metadata, const WriteProgress& progress) {
  assert(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height));
  if (image.pixels.empty()) throw Error(fmt::format("{}: the image has no pixels; render at least one", path.string()));
  OutputFile target(path);
  Stream stream(path, target);
  {
    const Imf::Header header = makeHeader(image, metadata);
    Imf::OutputFile file(stream, header, exrThreads());
    file.setFrameBuffer(framebufferOf(image, header.dataWindow()));
    writeLines(file, image.height, progress);
  }
  stream.rethrow();
  target.commit();
}

}  // namespace ropelight
