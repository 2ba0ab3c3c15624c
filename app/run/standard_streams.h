#pragma once
// Standard output that cannot be written is a failure, standard error that cannot be written is nobody's concern, and
// neither costs a picture.

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
/// reader has gone away, the program ends by SIGPIPE without a word, as others do.
int finishStandardOutput(int code);

/// For a failure that was met elsewhere: what errno was.
void rememberOutputError(int error);

/// Whether something could not be written to standard output.
bool standardOutputFailed();

/// A line on standard error.
void printError(const std::string& line);

template <class... T>
void printError(fmt::format_string<T...> format, T&&... values) {
  printError(fmt::format(format, std::forward<T>(values)...));
}

/// Text that may be lost without costing more than itself; finishStandardOutput tells.
template <class... T>
void printTo(std::FILE* stream, fmt::format_string<T...> format, T&&... values) {
  std::fputs(fmt::format(format, std::forward<T>(values)...).c_str(), stream);
}

}  // namespace ropelight
