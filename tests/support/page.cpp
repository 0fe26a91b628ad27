#include "support/page.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "support/command.hpp"

namespace toccata::test {
namespace {

std::string element_text(const std::string& html, const std::string& id) {
  const std::size_t at = html.find('>', html.find("<script id=\"" + id + "\""));
  return html.substr(at + 1, html.find("</script>", at) - at - 1);
}

/// The bytes behind base64.
std::string decoded(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned held = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(letters.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& bytes) {
  std::string text(std::max<std::size_t>(64, 8 * bytes.size()), '\0');
  for (;;) {
    uLongf size = text.size();
    const int outcome = uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                                   reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (outcome == Z_BUF_ERROR && text.size() < 1100 * bytes.size() + 64) {  // deflate cannot do better than 1 : 1032
      text.resize(4 * text.size());
      continue;
    }
    if (outcome != Z_OK) throw std::runtime_error("an element of the page is not deflated");
    text.resize(size);
    return text;
  }
}

std::string content(const std::string& html, const std::string& id) {
  return inflated(decoded(element_text(html, id)));
}

}  // namespace

Page::Page(const std::string& html)
    : header(Json::parse(content(html, "toccata-header"))),
      report(Json::parse(content(html, "toccata-report"))),
      data(content(html, "toccata-data")) {}

std::string page_text(const std::filesystem::path& file) {
  const std::string html = text_of(file);
  return content(html, "toccata-header") + content(html, "toccata-report");
}

}  // namespace toccata::test
