#include "io/formats/text_cursor.hpp"

#include <algorithm>
#include <charconv>

#include "io/formats/file_error.hpp"
#include "io/formats/number.hpp"

namespace toccata::io {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_break(char c) { return c == '\n' || c == '\r'; }

bool starts_with(std::span<const char> text, std::string_view prefix) {
  return std::string_view(text.data(), text.size()).starts_with(prefix);
}

void require_text(std::span<const char> text, std::string_view name) {
  if (starts_with(text, "\xFF\xFE") || starts_with(text, "\xFE\xFF"))
    fail_in_file(name, {"this is UTF-16 text", "save it as UTF-8 or ASCII"});
  constexpr std::size_t looked_at = 1024;
  const auto head = text.first(std::min(text.size(), looked_at));
  if (std::ranges::find(head, '\0') != head.end())
    fail_in_file(
        name, {"this is binary data where text was expected", "check that the file's extension is that of its format"});
}

}  // namespace

TextCursor::TextCursor(std::span<const char> text, std::string_view name, TextSyntax syntax, std::size_t first_line)
    : position_(text.data()), end_(text.data() + text.size()), name_(name), syntax_(syntax), line_(first_line) {
  require_text(text, name);
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (starts_with(text, byte_order_mark)) position_ += byte_order_mark.size();
}

void TextCursor::consume_line_break() {
  if (position_ == end_) return;
  const bool two_characters = *position_ == '\r' && end_ - position_ > 1 && position_[1] == '\n';
  position_ += two_characters ? 2 : 1;
  ++line_;
}

void TextCursor::skip_blanks() {
  while (position_ != end_) {
    if (is_blank(*position_)) {
      ++position_;
    } else if (*position_ == '\\' && syntax_.backslash_joins && end_ - position_ > 1 && is_line_break(position_[1])) {
      ++position_;
      consume_line_break();
    } else {
      return;
    }
  }
}

bool TextCursor::at_line_end() {
  skip_blanks();
  return position_ == end_ || is_line_break(*position_) || (*position_ == '#' && syntax_.hash_comments);
}

void TextCursor::next_line() {
  while (position_ != end_ && !is_line_break(*position_)) ++position_;
  consume_line_break();
}

bool TextCursor::next_line_with_words() {
  while (position_ != end_ && at_line_end()) next_line();
  return position_ != end_;
}

const char* TextCursor::word_end() const {
  const char* last = position_;
  while (last != end_ && !is_blank(*last) && !is_line_break(*last)) ++last;
  // A backslash that joins lines is no part of the word before it.
  if (syntax_.backslash_joins && last != end_ && is_line_break(*last) && last - position_ > 1 && last[-1] == '\\')
    --last;
  return last;
}

std::string_view TextCursor::peek_word() {
  if (at_line_end()) return {};
  return {position_, word_end()};
}

std::string_view TextCursor::word() {
  const std::string_view result = peek_word();
  position_ += result.size();
  return result;
}

double TextCursor::number(std::string_view what) {
  if (at_line_end()) fail(std::string(what) + " is missing", "write a number there");
  const ParsedNumber parsed = parse_number(position_, end_);
  const char* last = word_end();
  const auto text = [&] { return in_quotes({position_, last}); };
  if (parsed.fault == NumberFault::not_a_number || parsed.end != last)
    fail(std::string(what) + " " + text() + " is not a finite decimal number", "write it like -1.5 or 2e-3");
  if (parsed.fault == NumberFault::too_large)
    fail(std::string(what) + " " + text() + " is larger than any double", "use a unit in which it fits");
  position_ = last;
  return parsed.value;
}

std::int64_t TextCursor::integer(std::string_view what) {
  const std::string_view text = word();
  if (text.empty()) fail(std::string(what) + " is missing", "write an integer there");
  const ParsedInteger parsed = parse_integer(text);
  if (!parsed.valid) fail(std::string(what) + " " + in_quotes(text) + " is not an integer", "write digits only");
  return parsed.value;
}

void TextCursor::expect_line_end(std::string_view after_what) {
  if (!at_line_end())
    fail(in_quotes(peek_word()) + " does not belong after " + std::string(after_what),
         "start a new line there or delete it");
  next_line();
}

void TextCursor::fail(const std::string& what, const std::string& advice) const {
  fail_at_line(name_, line_, {what, advice});
}

ParsedInteger parse_integer(std::string_view word) {
  if (word.starts_with('+') && word.size() > 1 && word[1] != '-') word.remove_prefix(1);
  ParsedInteger result;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), result.value);
  result.valid = code == std::errc() && end == word.data() + word.size();
  return result;
}

}  // namespace toccata::io
