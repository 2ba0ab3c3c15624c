#include "render/image_files/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "render/core/error.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw Error(fmt::format("{}: {}", path.string(), why));
}

[[noreturn]] void failWriting(const fs::path& path, int error) {
  throw Error(fmt::format("{}: cannot write: {}; the file is as it was before; free some space or name another file",
                          path.string(), std::strerror(error)),
              ExitCode::internal);
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Names that are too long, links that go in circles, folders that may not be searched.
void requireUsableName(const fs::path& path, std::error_code failed) {
  const bool absent = failed == std::errc::no_such_file_or_directory || failed == std::errc::not_a_directory;
  if (failed && !absent) refuse(path, fmt::format("cannot be used: {}; name another file", failed.message()));
}

/// The file that `path` stands for, links followed, after every check that can be made without writing.
fs::path resolveTarget(const fs::path& path) {
  if (path.empty()) throw Error("the name of an output file is empty; name a file");
  std::error_code failed, ignored;
  const fs::file_status status = fs::status(path, failed);
  const bool present = fs::exists(status);
  requireUsableName(path, failed);
  if (fs::is_directory(status)) refuse(path, "is a folder; name a file in it");
  if (present && !fs::is_regular_file(status)) refuse(path, "is not a regular file; name one, or a new file");
  if (present && access(path.c_str(), W_OK) != 0)
    refuse(path, "is write-protected; allow writing (chmod u+w) or name another file");

  const fs::path target = present ? fs::canonical(path) : path;
  const fs::path folder = folderOf(target);
  if (!fs::is_directory(folder, ignored))
    refuse(path, fmt::format("there is no folder {}; create it or name another", folder.string()));
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    refuse(path, fmt::format("no file can be made in the folder {}: {}; allow it (chmod u+wx) or name another folder",
                             folder.string(), std::strerror(errno)));
  return target;
}

}  // namespace

/// A new file beside the target; gone with the object, unless it has taken the target's place. Small writes are
/// collected.
class OutputFile::Temporary {
 public:
  explicit Temporary(const fs::path& target) : target_(target) {
    static std::atomic<unsigned> counter = 0;
    do {
      path_ = folderOf(target) / fmt::format(".ropelight-{}-{}.tmp", getpid(), counter++);
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) failWriting(target_, errno);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!renamed_) unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    if (pending_.size() + bytes.size() > mostPending) flush();
    if (bytes.size() > mostPending) return put(bytes);
    pending_ += bytes;
  }

  std::uint64_t position() const { return written_ + pending_.size(); }

  void seek(std::uint64_t position) {
    flush();
    if (lseek(descriptor_, off_t(position), SEEK_SET) < 0) failWriting(target_, errno);
    written_ = position;
  }

  void replaceTarget() {
    flush();
    struct stat before;
    if (stat(target_.c_str(), &before) == 0) fchmod(descriptor_, before.st_mode & 07777);
    if (fsync(descriptor_) != 0) failWriting(target_, errno);
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || rename(path_.c_str(), target_.c_str()) != 0) failWriting(target_, errno);
    renamed_ = true;
  }

 private:
  static constexpr std::size_t mostPending = 1 << 20;

  void flush() {
    put(pending_);
    pending_.clear();
  }

  void put(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) failWriting(target_, errno);
      bytes.remove_prefix(std::size_t(written));
      written_ += std::uint64_t(written);
    }
  }

  fs::path target_;
  fs::path path_;
  std::string pending_;
  std::uint64_t written_ = 0;  ///< the place that the next byte of pending_ goes to
  int descriptor_ = -1;
  bool renamed_ = false;
};

OutputFile::OutputFile(const fs::path& path) : file_(std::make_unique<Temporary>(resolveTarget(path))) {}
OutputFile::~OutputFile() = default;
void OutputFile::write(std::string_view bytes) { file_->write(bytes); }
std::uint64_t OutputFile::position() const { return file_->position(); }
void OutputFile::seek(std::uint64_t position) { file_->seek(position); }
void OutputFile::commit() { file_->replaceTarget(); }

void writeFile(const fs::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

void checkWritable(const fs::path& path) { resolveTarget(path); }

}  // namespace ropelight
