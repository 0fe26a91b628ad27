#pragma once

#include <vector>

#include "toccata/reports/report.hpp"

namespace toccata::io {

/// The contacts by faces of the files, ascending.
[[nodiscard]] std::vector<ReportedFacePair> reported_face_pairs(const SceneInstance& a, const SceneInstance& b,
                                                                const std::vector<Contact>& contacts);

}  // namespace toccata::io
