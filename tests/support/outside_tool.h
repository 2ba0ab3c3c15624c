#pragma once
// Programs of others that judge our files, where they are installed.

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ropelight {

inline bool toolOnPath(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

/// What the shell command printed, on either stream.
inline std::string toolOutput(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("no shell for " + command);
  std::string output;
  char buffer[4096];
  while (std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
  pclose(pipe);
  return output;
}

}  // namespace ropelight
