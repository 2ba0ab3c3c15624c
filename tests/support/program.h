#pragma once
// The program itself as a child process.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace ropelight {

/// One run of a program in a folder, where its output goes to the files stdout.txt and stderr.txt.
class Program {
 public:
  Program(const std::string& path, std::vector<std::string> arguments, const std::filesystem::path& folder)
      : out_(folder / "stdout.txt"), err_(folder / "stderr.txt") {
    arguments.insert(arguments.begin(), path);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    int const flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), flags, 0666);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), flags, 0666);
    posix_spawnattr_t attributes;  // a job in the background ignores some signals, and the program would too
    posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigemptyset(&signals);
    for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    int const failed = posix_spawn(&process_, path.c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failed) throw std::runtime_error("cannot start " + path);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { finish(0); }

  void send(int signal) const { kill(process_, signal); }

  /// Its exit code; minus the signal that ended it. One that hangs for so many seconds is killed, and shows as -9.
  int exitCode(int patience = 120) {
    finish(patience);
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
  }

  std::string out() const { return fileBytes(out_); }
  std::string err() const { return fileBytes(err_); }

  /// Waits until standard error holds `text`; false where the program ends, or a minute passes, without it.
  bool waitForError(const std::string& text) {
    for (int i = 0; i < 6000 && !ended(); ++i) {
      if (err().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

 private:
  bool ended() {
    if (!ended_) ended_ = waitpid(process_, &status_, WNOHANG) == process_;
    return ended_;
  }

  void finish(int patience) {
    auto const deadline = std::chrono::steady_clock::now() + std::chrono::seconds(patience);
    while (!ended() && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (ended_) return;
    kill(process_, SIGKILL);
    waitpid(process_, &status_, 0);
    ended_ = true;
  }

  std::filesystem::path out_, err_;
  pid_t process_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace ropelight
