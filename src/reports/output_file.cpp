#include "toccata/reports/output_file.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"

namespace toccata {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n"sv;
/// Behind the signature and the chunk IHDR, which is always of this size.
constexpr std::size_t png_mark_place = 8 + 25;
/// The type of a chunk of text, and that of ours.
constexpr std::string_view png_mark = "tEXtSoftware\0Toccata"sv;

/// What stands in a file of Toccata's, and where.
struct Mark {
  std::string_view name;
  std::size_t place;
  std::string_view text;
};

Mark mark_of(OutputKind kind) {
  switch (kind) {
    case OutputKind::page:
      return {"a page", 0, "<!doctype html>\n<!--\nPage of Toccata"sv};
    case OutputKind::glb:
      return {"a GLB file", 20, R"({"asset":{"version":"2.0","generator":"Toccata)"sv};
    case OutputKind::picture:
      return {"a picture", png_mark_place + 4, png_mark};
    case OutputKind::case_file:
      return {"a case", 0, "{\n \"comment\": \"Case of Toccata"sv};
    case OutputKind::junit:
      return {"a JUnit report", 0, "<?xml version=\"1.0\"?>\n<!-- JUnit XML of Toccata"sv};
    case OutputKind::sarif:
      return {
          "a SARIF report", 0,
          "{\n \"$schema\": \"https://json.schemastore.org/sarif-2.1.0.json\",\n \"version\": \"2.1.0\",\n \"runs\": "
          "[\n  {\n   \"tool\": {\n    \"driver\": {\n     \"name\": \"Toccata"sv};
    case OutputKind::bcf:  // the first entry of the zip, which is not compressed, behind its name
      return {"a BCF file", 41, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- BCF of Toccata"sv};
    case OutputKind::plot:
      break;
  }
  return {"a plot", 0, "<!-- Plot of Toccata -->"sv};
}

bool is_marked(std::string_view bytes, const Mark& mark) {
  return bytes.size() >= mark.place && bytes.substr(mark.place).starts_with(mark.text);
}

std::string beginning_of(const fs::path& path, std::size_t size) {
  std::string bytes(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

void require_own_or_nothing(const fs::path& path, OutputKind kind) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found) return;
  if (fs::is_directory(status)) io::fail_in_file(path.string(), {"this is a directory", "name a file in it"});
  if (!fs::is_regular_file(status))
    io::fail_in_file(path.string(), {"this exists and is no regular file", "choose another name"});
  const Mark mark = mark_of(kind);
  const std::string start = beginning_of(path, mark.place + mark.text.size());
  if (!start.empty() && !is_marked(start, mark))
    io::fail_in_file(path.string(), {"the file exists and is not " + std::string(mark.name) + " of Toccata",
                                     "choose another name, or delete it"});
}

/// A page or GLB in a file of that name could be read by nothing.
void require_no_name_of_another_format(const fs::path& path, OutputKind kind) {
  const bool is_page = kind == OutputKind::page;
  if (!is_page && kind != OutputKind::glb) return;
  const fs::path extension = path.extension();
  for (const char* other : {".obj", ".off", ".ply", ".stl", ".gltf", ".png", ".json", is_page ? ".glb" : ".html"})
    if (extension == other)
      io::fail_in_file(
          path.string(),
          {is_page ? "what is written here is a page (HTML)" : "what is written here is GLB",
           is_page ? "give the file a name that ends in .html" : "give the file a name that ends in .glb"});
}

/// ISO 3309, as PNG uses it.
std::uint32_t cyclic_redundancy_check(std::string_view bytes) {
  std::uint32_t check = 0xffffffffU;
  for (const char c : bytes) {
    check ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) check = (check & 1U) != 0 ? check >> 1U ^ 0xedb88320U : check >> 1U;
  }
  return ~check;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(number >> shift & 255U);
  return bytes;
}

std::string marked_picture(std::string_view png) {
  if (is_marked(png, mark_of(OutputKind::picture))) return std::string(png);
  constexpr std::size_t type = 4;
  return std::string(png.substr(0, png_mark_place)) + big_endian(static_cast<std::uint32_t>(png_mark.size() - type)) +
         std::string(png_mark) + big_endian(cyclic_redundancy_check(png_mark)) +
         std::string(png.substr(png_mark_place));
}

}  // namespace

void require_output(const fs::path& path, OutputKind kind) {
  require_no_name_of_another_format(path, kind);
  require_own_or_nothing(path, kind);
  io::require_writable(path);
}

void write_output(std::string_view bytes, const fs::path& path, OutputKind kind) {
  require_own_or_nothing(path, kind);
  if (kind != OutputKind::picture) return io::write_file(path, bytes);
  if (!bytes.starts_with(png_signature) || bytes.size() < png_mark_place)
    io::fail_in_file(path.string(), {"what is to be written is no PNG", "draw the picture again"});
  io::write_file(path, marked_picture(bytes));
}

}  // namespace toccata
