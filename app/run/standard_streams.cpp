#include "app/run/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "render/core/error.h"

namespace ropelight {
namespace {

bool pipeEndsUs = true;
int latestError = 0;

/// Whether standard output is a pipe that nobody reads any more.
bool readerIsGone() {
  pollfd stream{STDOUT_FILENO, POLLOUT, 0};
  return latestError == EPIPE || (poll(&stream, 1, 0) == 1 && (stream.revents & POLLERR) != 0);
}

}  // namespace

void prepareStandardStreams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) == -1) {
      // Opened against its use, so that reading or writing still fails.
      [[maybe_unused]] int const taken = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  pipeEndsUs = std::signal(SIGPIPE, SIG_IGN) != SIG_IGN;
}

void flushStandardOutput() {
  if (std::fflush(stdout) != 0) latestError = errno;
}

void rememberOutputError(int error) { latestError = error; }

bool standardOutputFailed() { return std::ferror(stdout) != 0; }

int finishStandardOutput(int code) {
  flushStandardOutput();
  if (!standardOutputFailed()) return code;
  if (pipeEndsUs && readerIsGone()) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  printError("ropelight: standard output: cannot write{}{}; write to a file that has room", latestError ? ": " : "",
             latestError ? std::strerror(latestError) : "");
  return int(ExitCode::internal);
}

void printError(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

}  // namespace ropelight
