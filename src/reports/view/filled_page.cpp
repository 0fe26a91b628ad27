#include "reports/view/filled_page.hpp"

#include <zlib.h>

#include <new>

#include "io/formats/base64.hpp"
#include "reports/view/view_template.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

/// Where the data goes in the template.
constexpr std::string_view data_place = "<!--toccata-data-->";

/// Level 3 takes half the time of zlib's own, 6, and leaves a tenth more.
constexpr int deflate_level = 3;

std::string deflated(std::string_view bytes) {
  std::string text(compressBound(bytes.size()), '\0');
  uLongf size = text.size();
  if (compress2(reinterpret_cast<Bytef*>(text.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), deflate_level) != Z_OK)
    throw std::bad_alloc();  // there is room, so nothing else fails
  text.resize(size);
  return text;
}

/// An element whose text no HTML parser takes for markup.
std::string element(const std::string& id, std::string_view content) {
  return "<script id=\"" + id + "\" type=\"application/octet-stream\">" + base64_of(deflated(content)) + "</script>\n";
}

}  // namespace

std::string filled_page(const Json& header, const std::string& report, const ViewData& data) {
  std::string page;
  for (const std::string_view piece : view_template()) page += piece;
  const std::size_t place = page.find(data_place);
  if (place == std::string::npos) throw Error("the template of the page is damaged: build apps/viewer again");
  const std::string elements = element("toccata-header", header.dump(-1, ' ', false, Json::error_handler_t::replace)) +
                               element("toccata-report", report) + element("toccata-data", data.bytes());
  return page.replace(place, data_place.size(), elements);
}

}  // namespace toccata::io
