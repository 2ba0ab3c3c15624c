#pragma once
// PNG files: 8-bit sRGB out, 8 or 16 bits in.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "render/film/image.h"
#include "render/film/tonemap.h"

namespace ropelight {

/// Writes the image tone-mapped, 8 bits a channel, marked as sRGB. Returns the count of non-finite pixels, shown black.
/// Throws Error as writeFile does, and for images of more than 1 GiB of bytes.
std::uint64_t writePng(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap = {});

/// Writes bytes that are screen values already: width·height·3, row 0 at the top. Throws Error as writePng does.
void writeScreenPng(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> bytes);

/// The bytes of the file that writePng would write. Throws Error for an image without pixels, or of more than 1 GiB of
/// bytes.
std::vector<std::uint8_t> encodePng(const Image& image, const Tonemap& tonemap = {});

/// Reads a PNG as linear Rec. 709, its values in [0, 1] taken as sRGB, a grey image spread over the three channels and
/// opacity ignored. Throws Error (badInput) for a file that is missing, damaged or of another format.
Image readPng(const std::filesystem::path& path);

}  // namespace ropelight
