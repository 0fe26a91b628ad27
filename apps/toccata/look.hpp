#pragma once

#include <string>
#include <string_view>

namespace toccata::command {

/// `--look` is the end of a link to a page, "finding=0&theme=dark" (docs/reference/view-page.md). Throws Error where it
/// says a key that no link has, or one twice. What else is wrong the page tells in words, also in a picture.
void require_known_keys(std::string_view look);

/// The end of the link by which a picture is drawn: bright and without panels, where `look` says nothing about these.
[[nodiscard]] std::string link_of_picture(std::string_view look);

}  // namespace toccata::command
