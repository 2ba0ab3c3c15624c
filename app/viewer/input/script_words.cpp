#include "app/viewer/input/script_words.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

namespace ropelight::view {
namespace {

std::optional<double> parsed(const std::string& word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  auto const [stop, status] = std::from_chars(word.data(), end, value);
  bool const good = status == std::errc{} && stop == end && std::isfinite(value);
  return good ? std::optional(value) : std::nullopt;
}

bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The word that starts at i, which moves to its end.
std::string wordAt(const std::string& line, std::size_t& i) {
  std::string word;
  bool quoted = false;
  for (; i < line.size() && (quoted || !blank(line[i])); ++i) {
    bool const escape = quoted && line[i] == '\\' && i + 1 < line.size() && (line[i + 1] == '"' || line[i + 1] == '\\');
    if (escape)
      word += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else
      word += line[i];
  }
  if (quoted) throw Refusal{"a quotation mark is not closed"};
  return word;
}

}  // namespace

std::vector<std::string> splitLine(const std::string& line) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < line.size();) {
    if (blank(line[i]))
      ++i;
    else if (line[i] == '#')
      break;
    else
      words.push_back(wordAt(line, i));
  }
  return words;
}

void Words::refuse() const {
  if (empty()) throw Refusal{fmt::format("the line ends early; expected {}", usage_)};
  throw Refusal{fmt::format("unexpected \"{}\"; expected {}", words_[next_], usage_)};
}

std::string Words::word() {
  if (empty() || words_[next_].empty()) refuse();
  return words_[next_++];
}

bool Words::take(const char* word) {
  if (empty() || words_[next_] != word) return false;
  ++next_;
  return true;
}

bool Words::isNumber(std::size_t ahead) const {
  return next_ + ahead < words_.size() && parsed(words_[next_ + ahead]).has_value();
}

double Words::number(double min, double max) {
  if (!isNumber()) refuse();
  double const value = *parsed(words_[next_]);
  if (!(value >= min && value <= max))
    throw Refusal{fmt::format("{} is not in [{:g}, {:g}]; expected {}", words_[next_], min, max, usage_)};
  ++next_;
  return value;
}

int Words::whole(double min, double max) {
  if (isNumber() && *parsed(words_[next_]) != std::floor(*parsed(words_[next_]))) refuse();
  return int(number(min, max));
}

}  // namespace ropelight::view
