#include "render/import/obj/obj_text.h"

namespace ropelight {
namespace {

bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

void ObjStatements::skipLineEnd() {
  if (at_ == text_.size()) return;
  bool const pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
  at_ += pair ? 2 : 1;
}

/// Appends the words of a line; whether the statement goes on after it.
bool ObjStatements::readLine() {
  std::size_t const before = words_.size();
  auto skip = [&](auto&& wanted) {
    while (at_ < text_.size() && wanted(text_[at_])) ++at_;
  };
  for (skip(isBlank); at_ < text_.size() && !isLineEnd(text_[at_]); skip(isBlank)) {
    std::size_t const start = at_;
    skip([](char c) { return !isBlank(c) && !isLineEnd(c) && c != '#'; });
    if (at_ > start) words_.push_back(text_.substr(start, at_ - start));
    if (at_ < text_.size() && text_[at_] == '#') skip([](char c) { return !isLineEnd(c); });
  }
  skipLineEnd();
  if (words_.size() == before || !words_.back().ends_with('\\')) return false;
  words_.back().remove_suffix(1);
  if (words_.back().empty()) words_.pop_back();
  return true;
}

bool ObjStatements::next() {
  words_.clear();
  while (at_ < text_.size())
    if (!readLine() && !words_.empty()) return true;
  return !words_.empty();
}

std::size_t ObjStatements::lineOf(std::string_view word) const {
  std::string_view const before = text_.substr(0, static_cast<std::size_t>(word.data() - text_.data()));
  std::size_t line = 1;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i] == '\n' || (before[i] == '\r' && text_[i + 1] != '\n')) ++line;
  return line;
}

}  // namespace ropelight
