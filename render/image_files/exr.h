#pragma once
// OpenEXR files: linear Rec. 709 in 32-bit floats, with the settings of the rendering as metadata.

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "render/film/image.h"
#include "render/image_files/write_progress.h"

namespace ropelight {

using MetadataValue = std::variant<std::string, double, std::int64_t>;
using Metadata = std::vector<std::pair<std::string, MetadataValue>>;

/// Writes channels R, G, B as they are (FLOAT, ZIP), bit for bit. A key of the metadata becomes the attribute
/// `ropelight.<key>`, or the standard attribute of that name if it is `capDate` ("YYYY:MM:DD hh:mm:ss") or `comments`.
/// Integers beyond 32 bits are stored as text, since the format has no attribute for them.
/// On all cores; the same bytes for any number of them. Throws Error as writeFile does.
void writeExr(const std::filesystem::path& path, const Image& image, const Metadata& metadata = {},
              const WriteProgress& progress = {});

/// Reads channels R, G, B (or Y alone, as grey), half, float or integer, scan lines or tiles, taken as linear Rec. 709;
/// opacity, and what there is beside R, G and B, is left out. The image is the file's display window, black where its
/// data window does not reach, without what lies outside. Throws Error (badInput) for a file that is missing, damaged,
/// of another format, of more than 2^28 pixels, or without these channels; it then lists those there are.
Image readExr(const std::filesystem::path& path);

/// The text and number attributes of the file: those that writeExr wrote under their keys, others under their full
/// names, in alphabetical order of the attributes. Throws Error as readExr does.
Metadata readExrMetadata(const std::filesystem::path& path);

/// The colour space, where it is not the one that readExr assumes: "primaries (0.68 0.32) (0.265 0.69) (0.15 0.06),
/// white (0.3127 0.329)", the CIE x and y that the file states for red, green, blue and white. Empty where it states
/// none, or those of Rec. 709 with D65 within 10⁻³. Throws Error as readExr does for files that cannot be opened.
std::string foreignColours(const std::filesystem::path& path);

}  // namespace ropelight
