#include "io/formats/gltf_uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "io/formats/base64.hpp"
#include "io/formats/file_error.hpp"

namespace toccata::io {
namespace {

namespace fs = std::filesystem;

int hexadecimal_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// RFC 3986, section 2.1.
std::string decode_percents(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded =
        uri[i] == '%' && i + 2 < uri.size() && hexadecimal_digit(uri[i + 1]) >= 0 && hexadecimal_digit(uri[i + 2]) >= 0;
    result += coded ? static_cast<char>(16 * hexadecimal_digit(uri[i + 1]) + hexadecimal_digit(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return result;
}

bool leads_out(const fs::path& relative) {
  return relative.empty() || relative.is_absolute() || *relative.lexically_normal().begin() == "..";
}

}  // namespace

std::vector<char> decode_data_uri(const JsonValue& place, std::string_view uri) {
  constexpr std::string_view marker = ";base64,";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || comma + 1 < marker.size() ||
      uri.substr(comma + 1 - marker.size(), marker.size()) != marker)
    place.fail("the data is not in base64", "export the file again");
  return decode_base64(place, uri.substr(comma + 1));
}

fs::path file_of_uri(const JsonValue& place, std::string_view uri, const fs::path& folder) {
  const std::string name = decode_percents(uri);
  const bool strange = name.find('\0') != std::string::npos || name.find(':') != std::string::npos ||
                       name.find('\\') != std::string::npos;
  std::error_code code;
  const fs::path start = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, code);
  fs::path file = strange ? fs::path() : fs::weakly_canonical(start / name, code);
  if (strange || code || leads_out(name) || leads_out(file.lexically_relative(start)))
    place.fail(fmt::format("{} is not a file within the folder of this one", in_quotes(uri)),
               "put the buffer beside it and name it without a folder");
  return file;
}

}  // namespace toccata::io
