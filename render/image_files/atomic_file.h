#pragma once
// Output files that appear whole or not at all.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace ropelight {

/// A file that is written piece by piece to a temporary name beside its place, and takes its place with commit().
/// Without that, also where writing failed, it leaves nothing behind, and what was at `path` stays as it was. A
/// symbolic link keeps pointing where it did. Throws Error: badInput for a path that cannot be written (a folder, a
/// device, a folder that is missing or that we may not use), internal where writing fails half-way (a full disk).
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view bytes);
  std::uint64_t position() const;
  void seek(std::uint64_t position);
  /// Flushes to the disk and renames.
  void commit();

 private:
  class Temporary;
  std::unique_ptr<Temporary> file_;
};

/// Replaces the file `path` by `bytes`, as OutputFile does.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Throws what writeFile would throw for a path that cannot be written; for use before hours of rendering.
void checkWritable(const std::filesystem::path& path);

}  // namespace ropelight
