#pragma once
// An X server without a screen, for the tests that open a window: one for all of them.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace ropelight {

class VirtualDisplay {
 public:
  /// Empty where there is no Xvfb, or it does not start. ROPELIGHT_TEST_DISPLAY names another one, such as a GPU's.
  static const std::string& name() {
    static std::string const given = givenName();
    if (!given.empty()) return given;
    static VirtualDisplay const display;
    return display.name_;
  }

  static std::string givenName() {
    const char* const name = std::getenv("ROPELIGHT_TEST_DISPLAY");
    return name ? name : "";
  }

 private:
  VirtualDisplay() {
    int fds[2];
    if (pipe(fds) != 0) return;
    std::string const number = std::to_string(fds[1]);
    const char* const argv[] = {"Xvfb",         "-displayfd", number.c_str(), "-screen", "0",
                                "1600x1000x24", "-nolisten",  "tcp",          nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclose(&actions, fds[0]);
    bool const started = posix_spawnp(&server_, "Xvfb", &actions, nullptr, const_cast<char**>(argv), environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    close(fds[1]);
    if (started) readNumber(fds[0]);
    close(fds[0]);
    if (!started) server_ = 0;
  }

  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }

  /// The server writes its number and a new line once it takes connections; its end closes the pipe.
  void readNumber(int fd) {
    char c;
    std::string digits;
    while (read(fd, &c, 1) == 1 && c != '\n') digits += c;
    if (!digits.empty()) name_ = ":" + digits;
  }

  pid_t server_ = 0;
  std::string name_;
};

}  // namespace ropelight
