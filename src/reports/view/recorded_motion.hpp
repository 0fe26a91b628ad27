#pragma once

#include "io/formats/json.hpp"
#include "reports/view/display_frame.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata::io {

/// The member "motion" of the header (docs/reference/view-page.md): where the objects are at each moment. Throws Error
/// naming an object whose pose has changed by more than a turn and a move.
[[nodiscard]] Json motion_of(const WorldRecording& recording, const DisplayFrame& frame, ViewData& data);

}  // namespace toccata::io
