#pragma once
// What a user gave us and cannot be used: file, place in it, what was expected and what to do about it.

#include <stdexcept>
#include <string>

namespace ropelight {

/// Exit codes of the command line (docs/command-line.md).
enum class ExitCode { done = 0, internal = 1, usage = 2, badInput = 3, noDevice = 4, outOfMemory = 5, checkFailed = 6 };

/// Thrown for bad input. what() is one message fit for a terminal: "FILE: PLACE: PROBLEM; REMEDY".
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message, ExitCode code = ExitCode::badInput)
      : std::runtime_error(message), code_(code) {}

  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace ropelight
