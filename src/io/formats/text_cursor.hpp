#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace toccata::io {

/// What a text format has beyond words, blanks and lines.
struct TextSyntax {
  bool hash_comments = false;    ///< a word that starts with '#' begins a comment, to the end of the line
  bool backslash_joins = false;  ///< a backslash at the end of a line joins it with the next
};

/// Walks once over a text that lies in memory, knows the line it is in, and throws Errors that name it. Lines end with
/// LF, CR LF or CR; a byte order mark of UTF-8 is skipped, UTF-16 and binary data are refused.
class TextCursor {
 public:
  /// Both arguments must outlive the cursor. `first_line` is the number of the text's first line.
  TextCursor(std::span<const char> text, std::string_view name, TextSyntax syntax, std::size_t first_line = 1);

  /// Nothing but the end of the text lies ahead on this line, or of the whole text.
  [[nodiscard]] bool at_line_end();
  [[nodiscard]] bool at_end() const { return position_ == end_; }
  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - position_); }

  /// Moves to the start of the next line, over whatever is left of this one.
  void next_line();
  /// Moves to the next line that has a word in it; false when there is none.
  [[nodiscard]] bool next_line_with_words();

  /// The next word of this line, empty at its end.
  [[nodiscard]] std::string_view word();
  [[nodiscard]] std::string_view peek_word();
  /// Moves over so many characters of the word ahead.
  void skip(std::size_t characters) { position_ += characters; }

  /// The next word as a number; `what` is what the message calls it, "the x coordinate" say.
  [[nodiscard]] double number(std::string_view what);
  [[nodiscard]] std::int64_t integer(std::string_view what);

  /// Throws if a word is left on this line, or skips the rest of it.
  void expect_line_end(std::string_view after_what);

  [[noreturn]] void fail(const std::string& what, const std::string& advice) const;

 private:
  void skip_blanks();
  void consume_line_break();
  [[nodiscard]] const char* word_end() const;

  const char* position_;
  const char* end_;
  std::string_view name_;
  TextSyntax syntax_;
  std::size_t line_;
};

/// The whole of `word` as an integer, for words that hold several.
struct ParsedInteger {
  std::int64_t value = 0;
  bool valid = false;
};
[[nodiscard]] ParsedInteger parse_integer(std::string_view word);

}  // namespace toccata::io
