#pragma once
// PNG files: 8-bit sRGB out, 8 or 16 bits in.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "render/film/image.h"
#include "render/film/tonemap.h"
#include "render/image_files/write_progress.h"

namespace ropelight {

/// Writes the image tone-mapped, 8 bits per channel, marked as sRGB. Returns the count of non-finite pixels, shown
/// black. On all cores; the same bytes for any number of them. Throws Error as writeFile does, and for an image without
/// pixels.
std::uint64_t writePng(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap = {},
                       const WriteProgress& progress = {});

/// Writes bytes that are screen values already: width·height·3, row 0 at the top. Throws Error as writePng does.
void writeScreenPng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> bytes);

/// The bytes of the file that writePng would write. Throws Error for an image without pixels.
std::vector<std::uint8_t> encodePng(const Image& image, const Tonemap& tonemap = {});

/// Reads a PNG as linear Rec. 709: samples in [0, 1], of 8 or 16 bits, by the file's gAMA chunk where it has one and no
/// sRGB chunk, else as sRGB; a grey image spread over the three channels, opacity and the rest of what the file says
/// about its colours ignored (readPngColour names it). Throws Error (badInput) for a file that is missing, damaged or
/// of another format.
Image readPng(const std::filesystem::path& path);

}  // namespace ropelight
