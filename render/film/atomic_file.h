#pragma once
// Output files that appear whole or not at all.

#include <filesystem>
#include <string_view>

namespace ropelight {

/// Replaces the file `path` by `bytes`: written to a temporary name beside it, flushed to the disk, renamed. On failure
/// the temporary file is removed and what was at `path` stays as it was. A symbolic link keeps pointing where it did.
/// Throws Error: badInput for a path that cannot be written (a folder, a device, a folder that is missing or closed to
/// us), internal where writing fails half-way (a full disk).
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws what writeFile would throw for a path that cannot be written; for use before hours of rendering.
void checkWritable(const std::filesystem::path& path);

}  // namespace ropelight
