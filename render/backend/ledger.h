#pragma once
// Bytes by purpose and launches by stage: what a scene did not need must show as zero here.

#include <cstdint>
#include <map>
#include <string>

namespace ropelight {

class Ledger {
 public:
  void allocated(const std::string& purpose, std::uint64_t bytes) { bytes_[purpose] += bytes; }
  void freed(const std::string& purpose, std::uint64_t bytes) {
    auto const it = bytes_.find(purpose);
    if (it != bytes_.end() && (it->second -= bytes) == 0) bytes_.erase(it);
  }
  void launched(const char* stage) { ++launches_[stage]; }
  void timed(const char* stage, double seconds) { seconds_[stage] += seconds; }
  void clearCounts() {
    launches_.clear();
    seconds_.clear();
  }

  const std::map<std::string, std::uint64_t>& bytes() const { return bytes_; }
  const std::map<std::string, std::uint64_t>& launches() const { return launches_; }
  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  std::map<std::string, std::uint64_t> bytes_, launches_;
  std::map<std::string, double> seconds_;
};

}  // namespace ropelight
