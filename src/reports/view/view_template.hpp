#pragma once

#include <span>
#include <string_view>

namespace toccata::io {

/// The empty page, apps/viewer/dist/page.html, in pieces; cmake/EmbedText.cmake makes them a source.
[[nodiscard]] std::span<const std::string_view> view_template();

}  // namespace toccata::io
