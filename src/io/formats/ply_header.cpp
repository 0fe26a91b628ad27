#include "io/formats/ply_header.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "io/formats/file_error.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/text_cursor.hpp"

namespace toccata::io {
namespace {

struct PlyTypeName {
  std::string_view name, older_name;
  PlyType type;
};
constexpr std::array<PlyTypeName, 8> type_names = {{{"int8", "char", PlyType::int8},
                                                    {"uint8", "uchar", PlyType::uint8},
                                                    {"int16", "short", PlyType::int16},
                                                    {"uint16", "ushort", PlyType::uint16},
                                                    {"int32", "int", PlyType::int32},
                                                    {"uint32", "uint", PlyType::uint32},
                                                    {"float32", "float", PlyType::float32},
                                                    {"float64", "double", PlyType::float64}}};

/// The text of the header, up to and with the line break behind "end_header". How the first line ends tells how all
/// do: after a lone CR, a line feed may be the first byte of the values.
std::span<const char> header_text(std::span<const char> bytes, std::string_view name) {
  const std::string_view text(bytes.data(), bytes.size());
  const std::size_t first_end = text.find_first_of("\r\n");
  if (!looks_like_ply(bytes))
    fail_at_line(name, 1,
                 {"a PLY file begins with a line that says ply", "check that the extension is that of the format"});
  const std::string line_break = text.substr(first_end).starts_with("\r\n") ? "\r\n" : std::string(1, text[first_end]);
  constexpr std::string_view last_word = "end_header";
  for (std::size_t at = text.find(last_word); at != std::string_view::npos; at = text.find(last_word, at + 1)) {
    const bool starts_line = line_break.ends_with(text[at - 1]);
    std::size_t end = at + last_word.size();
    end = std::min(text.find_first_not_of(" \t", end), text.size());
    if (starts_line && text.substr(end).starts_with(line_break)) return bytes.first(end + line_break.size());
  }
  fail_in_file(name, {"the line end_header is missing", "export the mesh again"});
}

class PlyHeaderReader {
 public:
  PlyHeaderReader(std::span<const char> text, std::string_view name) : cursor_(text, name, {}) {
    header_.body_offset = text.size();
  }

  PlyHeader read() {
    cursor_.next_line();
    while (cursor_.next_line_with_words()) {
      read_line(cursor_.word());
      cursor_.next_line();
    }
    if (!has_format_) cursor_.fail("the header has no format line", "export the mesh again");
    header_.body_line = cursor_.line();
    return std::move(header_);
  }

 private:
  void read_line(std::string_view keyword) {
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      read_property();
    } else if (!is_remark(keyword) && keyword != "end_header") {
      cursor_.fail(in_quotes(keyword) + " is no word of a PLY header", "export the mesh again");
    }
  }

  /// Blender 2.4x wrote its remark "Created by Blender3D" without the word comment.
  static bool is_remark(std::string_view keyword) {
    return keyword == "comment" || keyword == "obj_info" || keyword == "Created";
  }

  void read_format() {
    const std::string_view encoding = cursor_.word();
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::binary_little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::binary_big_endian;
    } else {
      cursor_.fail("the format " + in_quotes(encoding) + " is not known",
                   "use ascii, binary_little_endian or binary_big_endian");
    }
    if (const std::string_view version = cursor_.word(); version != "1.0")
      cursor_.fail("version " + in_quotes(version) + " of PLY is not known", "export the mesh as version 1.0");
    has_format_ = true;
  }

  void read_element() {
    PlyElement element;
    element.line = cursor_.line();
    element.name = cursor_.word();
    const std::int64_t count = cursor_.integer("the number of elements");
    if (count < 0 || count > std::numeric_limits<std::uint32_t>::max())
      cursor_.fail("the number of " + in_quotes(element.name) + " is " + std::to_string(count),
                   "correct the count or split the file");
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    if (header_.elements.empty()) cursor_.fail("a property stands before the first element", "export the mesh again");
    PlyProperty property;
    if (cursor_.peek_word() == "list") {
      static_cast<void>(cursor_.word());
      property.count_type = read_type();
      if (!is_integer(*property.count_type)) cursor_.fail("a list is counted by floats", "use an integer type");
    }
    property.type = read_type();
    property.name = cursor_.word();
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType read_type() {
    const std::string_view word = cursor_.word();
    const auto* const known = std::ranges::find_if(
        type_names, [&](const PlyTypeName& type) { return word == type.name || word == type.older_name; });
    if (known == type_names.end())
      cursor_.fail("the type " + in_quotes(word) + " is not known",
                   "use char, uchar, short, ushort, int, uint, float or double");
    return known->type;
  }

  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

bool looks_like_ply(std::span<const char> bytes) {
  const std::string_view text(bytes.data(), bytes.size());
  return text.starts_with("ply\n") || text.starts_with("ply\r");
}

PlyHeader parse_ply_header(std::span<const char> bytes, std::string_view name) {
  return PlyHeaderReader(header_text(bytes, name), name).read();
}

}  // namespace toccata::io
