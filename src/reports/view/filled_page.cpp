#include "reports/view/filled_page.hpp"

#include "reports/view/view_template.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

/// Where the data goes in the template.
constexpr std::string_view data_place = "<!--toccata-data-->";

/// JSON that no HTML parser takes for the end of the element it stands in.
std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

std::string script(const char* id, const char* type, const std::string& text) {
  return std::string("<script id=\"") + id + "\" type=\"" + type + "\">" + text + "</script>\n";
}

}  // namespace

std::string filled_page(const Json& header, const std::string& report, const ViewData& data) {
  std::string page;
  for (const std::string_view piece : view_template()) page += piece;
  const std::size_t place = page.find(data_place);
  if (place == std::string::npos) throw Error("the template of the page is damaged: build apps/viewer again");
  const std::string scripts = script("toccata-header", "application/json",
                                     without_tags(header.dump(-1, ' ', false, Json::error_handler_t::replace))) +
                              script("toccata-report", "application/json", without_tags(report)) +
                              script("toccata-data", "application/octet-stream", data.base64());
  return page.replace(place, data_place.size(), scripts);
}

}  // namespace toccata::io
