#pragma once
// Rows of 8-bit RGB → the bytes of a PNG file, on all cores.

#include <cstdint>
#include <functional>
#include <string_view>

#include "render/image_files/write_progress.h"

namespace ropelight {

/// Rows first, first + 1, … first + count − 1 as width·3 bytes each. Called by several threads at once, and more than
/// once for a row.
using PngRows = std::function<void(int first, int count, std::uint8_t* out)>;

/// Hands the file's bytes to `sink`, piece by piece and in order, marked as sRGB. The same for any number of threads.
/// Needs a few MiB per thread, however large the image. width, height ≥ 1.
void encodePngRows(int width, int height, const PngRows& rows, const std::function<void(std::string_view)>& sink,
                   const WriteProgress& progress = {});

}  // namespace ropelight
