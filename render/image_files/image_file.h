#pragma once
// Image files by the ending of their names: .exr and .png, in any case of letters.

#include <cstdint>
#include <filesystem>
#include <string>

#include "render/film/image.h"
#include "render/film/tonemap.h"
#include "render/image_files/exr.h"

namespace ropelight {

enum class ImageFormat { exr, png };

/// Throws Error (badInput) for any other ending.
ImageFormat imageFormatOf(const std::filesystem::path& path);

/// Linear Rec. 709. Throws as readExr and readPng do.
Image readImage(const std::filesystem::path& path);

/// What the file says about its colours and readImage ignores: a sentence's end such as "primaries (…), white (…)";
/// empty: nothing. Throws as readExr does for an EXR that cannot be opened.
std::string ignoredColours(const std::filesystem::path& path);

/// EXR holds the linear image and the metadata, PNG the tone-mapped image. Returns the count of non-finite pixels that
/// a PNG shows black (0 for EXR, which keeps them). Throws as writeExr and writePng do.
std::uint64_t writeImage(const std::filesystem::path& path, const Image& image, const Tonemap& tonemap = {},
                         const Metadata& metadata = {}, const WriteProgress& progress = {});

}  // namespace ropelight
