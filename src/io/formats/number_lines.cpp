#include "io/formats/number_lines.hpp"

#include <algorithm>
#include <string>

#include "io/formats/file_bytes.hpp"

namespace toccata::io {

void for_each_line_of_numbers(const std::filesystem::path& path, const std::function<void(TextCursor&)>& read,
                              std::string_view blanks) {
  const FileBytes bytes = read_file(path);
  const std::string name = path.string();
  std::string text(bytes.span().begin(), bytes.span().end());
  const auto is_blank = [&](char c) { return blanks.find(c) != std::string_view::npos; };
  std::replace_if(text.begin(), text.end(), is_blank, ' ');
  TextCursor cursor(text, name, {.hash_comments = true});
  while (cursor.next_line_with_words()) {
    read(cursor);
    cursor.next_line();
  }
}

}  // namespace toccata::io
