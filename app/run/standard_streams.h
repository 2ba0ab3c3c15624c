#pragma once
// Standard output that cannot be written is a failure; standard error that cannot be written is ignored. In neither
// case is a picture lost.

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace ropelight {

/// Once, at the start: no file that is opened later may take the place of a standard stream that is closed, and a
/// reader that goes away does not end the program at once.
void prepareStandardStreams();

/// Flushes standard output now, remembering why that failed.
void flushStandardOutput();

/// At the end. The code to exit with: `code`, or 1 with a message where standard output could not be written. Where its
/// reader has gone away, the program ends by SIGPIPE without a message, as others do.
int finishStandardOutput(int code);

/// For a failure that was noticed elsewhere: its errno.
void rememberOutputError(int error);

/// Whether something could not be written to standard output.
bool standardOutputFailed();

/// A line on standard error.
void printError(const std::string& line);

template <class... T>
void printError(fmt::format_string<T...> format, T&&... values) {
  printError(fmt::format(format, std::forward<T>(values)...));
}

/// Text whose loss does not end the run; finishStandardOutput reports it.
template <class... T>
void printTo(std::FILE* stream, fmt::format_string<T...> format, T&&... values) {
  std::fputs(fmt::format(format, std::forward<T>(values)...).c_str(), stream);
}

}  // namespace ropelight
