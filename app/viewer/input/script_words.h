#pragma once
// The words of a line of an input script, and what may be wrong with them.

#include <string>
#include <vector>

namespace ropelight::view {

/// Why a line is refused, without its place.
struct Refusal {
  std::string why;
};

/// Words are separated by blanks; "…" keeps blanks in a word, with \" and \\ in it; # at a word's start ends the line.
/// Throws Refusal.
std::vector<std::string> splitLine(const std::string& line);

/// The words after a command's name, taken one by one. Throws Refusal, with the usage, where one is not as expected.
class Words {
 public:
  Words(std::vector<std::string> words, const char* usage) : words_(std::move(words)), usage_(usage) {}

  bool empty() const { return next_ == words_.size(); }
  [[noreturn]] void refuse() const;
  /// Any word but an empty one.
  std::string word();
  /// Whether this one is next; then it is taken.
  bool take(const char* word);
  /// Whether the word so many places ahead is a number.
  bool isNumber(std::size_t ahead = 0) const;
  double number(double min, double max);
  int whole(double min, double max);

 private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
  const char* usage_;
};

}  // namespace ropelight::view
