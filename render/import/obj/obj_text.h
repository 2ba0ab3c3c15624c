#pragma once
// A Wavefront OBJ's text, statement by statement.

#include <string_view>
#include <vector>

namespace ropelight {

/// Lines end in LF, CR or both; a # starts a comment up to the line's end; a backslash at the end of a line, before
/// blanks and a comment, continues the statement on the next one.
class ObjStatements {
 public:
  /// The text must outlive this and all words.
  explicit ObjStatements(std::string_view text) : text_(text) {}

  /// Reads the next statement that has words; false at the end of the text.
  bool next();

  /// Of the statement read last, its keyword first.
  const std::vector<std::string_view>& words() const { return words_; }

  /// The line of the text, from 1, that a word stands on.
  std::size_t lineOf(std::string_view word) const;

 private:
  bool readLine();
  void skipLineEnd();

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::string_view> words_;
};

}  // namespace ropelight
