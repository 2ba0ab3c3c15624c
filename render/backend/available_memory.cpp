#include "render/backend/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>

namespace ropelight {
namespace {

namespace fs = std::filesystem;

/// The number after `key` in a file of lines "key number"; nothing where there is no such line.
std::optional<std::uint64_t> numberOf(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string name;
    std::uint64_t value = 0;
    if (words >> name >> value && name == key) return value;
  }
  return {};
}

/// A file of one number; nothing for "max" and where there is no such file.
std::optional<std::uint64_t> onlyNumber(const fs::path& file) {
  std::ifstream in(file);
  std::uint64_t value = 0;
  return in >> value ? std::optional(value) : std::nullopt;
}

std::uint64_t less(std::uint64_t all, std::uint64_t taken) { return all > taken ? all - taken : 0; }

std::uint64_t machineMemory(const fs::path& root) {
  constexpr std::uint64_t kib = 1024;
  auto const free = numberOf(root / "proc/meminfo", "MemAvailable:");
  if (!free) return unknownMemory;
  return (*free + numberOf(root / "proc/meminfo", "SwapFree:").value_or(0)) * kib;
}

/// A control group of version 1 or 2 by the names of its files.
struct GroupFiles {
  const char *limit, *used, *reclaimable;
};
constexpr GroupFiles version2{"memory.max", "memory.current", "inactive_file"};
constexpr GroupFiles version1{"memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file"};

/// Calls visit(folder, files) for every memory group that this process is in, up to the outermost. Inside a container
/// the groups' paths may not be there; the mount itself is the container's group then, and is always looked at.
void forEachGroup(const fs::path& root, const std::function<void(const fs::path&, const GroupFiles&)>& visit) {
  std::ifstream in(root / "proc/self/cgroup");
  for (std::string line; std::getline(in, line);) {
    std::size_t const first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    std::string const controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    bool const unified = controllers == ",,";
    if (!unified && controllers.find(",memory,") == std::string::npos) continue;
    fs::path const mount = root / (unified ? "sys/fs/cgroup" : "sys/fs/cgroup/memory");
    fs::path group = fs::path(line.substr(second + 1)).relative_path();
    for (;; group = group.parent_path()) {
      visit(group.empty() ? mount : mount / group, unified ? version2 : version1);
      if (group.empty()) break;
    }
  }
}

std::uint64_t groupMemory(const fs::path& root) {
  std::uint64_t least = unknownMemory;
  forEachGroup(root, [&](const fs::path& folder, const GroupFiles& files) {
    auto const limit = onlyNumber(folder / files.limit), used = onlyNumber(folder / files.used);
    if (!limit || !used) return;
    std::uint64_t const cache = numberOf(folder / "memory.stat", files.reclaimable).value_or(0);
    least = std::min(least, less(*limit, less(*used, cache)));
  });
  return least;
}

/// What a resource limit leaves beside the pages in use; `column` is that of statm.
std::uint64_t limitLeaves(int resource, int column, const fs::path& root) {
  rlimit limit{};
  if (getrlimit(decltype(RLIMIT_AS)(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknownMemory;
  std::ifstream in(root / "proc/self/statm");
  std::uint64_t pages = 0;
  for (int i = 0; i <= column; ++i) in >> pages;
  return less(limit.rlim_cur, in ? pages * std::uint64_t(sysconf(_SC_PAGESIZE)) : 0);
}

}  // namespace

std::uint64_t groupMemoryLimit(const fs::path& root) {
  std::uint64_t least = unknownMemory;
  forEachGroup(root, [&](const fs::path& folder, const GroupFiles& files) {
    least = std::min(least, onlyNumber(folder / files.limit).value_or(unknownMemory));
  });
  return least;
}

std::uint64_t availableMemory(const fs::path& root) {
  constexpr int sizeColumn = 0, dataColumn = 5;
  return std::min({machineMemory(root), groupMemory(root), limitLeaves(RLIMIT_AS, sizeColumn, root),
                   limitLeaves(RLIMIT_DATA, dataColumn, root)});
}

}  // namespace ropelight
