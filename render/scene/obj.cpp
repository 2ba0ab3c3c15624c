#include "render/scene/obj.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <charconv>
#include <istream>
#include <streambuf>
#include <string_view>

#include "render/core/error.h"
#include "render/scene/text_file.h"

namespace ropelight {
namespace {

/// A text as a stream that knows how much of it was read, which is what names lines.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }

  /// The line read last, without its end.
  std::string_view line() const {
    std::string_view read = withoutLineEnd();
    std::size_t const before = read.find_last_of("\r\n");
    return before == std::string_view::npos ? read : read.substr(before + 1);
  }

  /// Of the line read last, from 1.
  std::size_t lineNumber() const {
    std::string_view const read = withoutLineEnd();
    std::size_t number = 1;
    for (std::size_t i = 0; i < read.size(); ++i)
      if (read[i] == '\n' || (read[i] == '\r' && (i + 1 == read.size() || read[i + 1] != '\n'))) ++number;
    return number;
  }

 private:
  std::string_view withoutLineEnd() const {
    std::string_view read(eback(), static_cast<std::size_t>(gptr() - eback()));
    if (!read.empty() && read.back() == '\n') read.remove_suffix(1);
    if (!read.empty() && read.back() == '\r') read.remove_suffix(1);
    return read;
  }
};

/// The words of a line after its keyword.
std::vector<std::string_view> words(std::string_view line) {
  constexpr const char* blanks = " \t";
  std::vector<std::string_view> found;
  for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
    std::size_t const end = std::min(line.find_first_of(blanks, at), line.size());
    found.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
  }
  if (!found.empty()) found.erase(found.begin());
  return found;
}

bool isFiniteNumber(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  auto const [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  return problem == std::errc() && end == word.data() + word.size() && std::isfinite(value);
}

/// i, i/j, i//k or i/j/k, with i within the range of int.
bool isCorner(std::string_view word) {
  int index = 0;
  auto const [end, problem] = std::from_chars(word.data(), word.data() + word.size(), index);
  return problem == std::errc() && word.find_first_not_of("0123456789-/") == std::string_view::npos;
}

/// Receives what tinyobjloader reads. It takes words that are no numbers for zero, so the line is looked at as well.
class MeshReader {
 public:
  MeshReader(const std::string& file, const TextBuffer& source) : source_(source) { mesh_.file = file; }

  void addVertex(Vec3d position) {
    std::vector<std::string_view> const coordinates = words(source_.line());
    if (coordinates.size() < 3) fail("a vertex needs three coordinates");
    for (int i = 0; i < 3; ++i)
      if (!isFiniteNumber(coordinates[i]) || !std::isfinite(position[i]))
        fail(fmt::format("expected a finite coordinate, found \"{}\"", coordinates[i]));
    mesh_.positions.push_back(position);
  }

  void addFace(const tinyobj::index_t* corners, int count) {
    for (std::string_view const word : words(source_.line()))
      if (!isCorner(word))
        fail(fmt::format("expected vertex indices such as 1, 1/2, 1//3 or 1/2/3, found \"{}\"", word));
    if (count < 3) fail(fmt::format("a face needs at least three vertices, this has {}", count));
    std::uint32_t const first = resolve(corners[0].vertex_index);
    for (int i = 2; i < count; ++i)
      mesh_.triangles.emplace_back(first, resolve(corners[i - 1].vertex_index), resolve(corners[i].vertex_index));
  }

  Mesh take() {
    if (mesh_.triangles.empty()) throw Error(mesh_.file + ": the file holds no faces; expected a Wavefront OBJ mesh");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(fmt::format("{}: line {}: {}", mesh_.file, source_.lineNumber(), problem));
  }

  /// Indices count from 1, or backwards from −1, the vertex read last.
  std::uint32_t resolve(int index) const {
    auto const count = static_cast<std::int64_t>(mesh_.positions.size());
    std::int64_t const resolved = index < 0 ? count + index : std::int64_t{index} - 1;
    if (resolved < 0 || resolved >= count)
      fail(fmt::format("a face names vertex {}, but {} were read so far", index, count));
    return static_cast<std::uint32_t>(resolved);
  }

  const TextBuffer& source_;
  Mesh mesh_;
};

void onVertex(void* reader, tinyobj::real_t x, tinyobj::real_t y, tinyobj::real_t z, tinyobj::real_t) {
  static_cast<MeshReader*>(reader)->addVertex(Vec3d(x, y, z));
}

void onFace(void* reader, tinyobj::index_t* corners, int count) {
  static_cast<MeshReader*>(reader)->addFace(corners, count);
}

}  // namespace

Mesh loadObj(const std::filesystem::path& path, const std::string& remedy) {
  std::string text = readTextFile(path, remedy);
  TextBuffer source(text);
  std::istream in(&source);
  MeshReader reader(path.string(), source);
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = onVertex;
  callbacks.index_cb = onFace;
  tinyobj::LoadObjWithCallback(in, callbacks, &reader);
  return reader.take();
}

}  // namespace ropelight
