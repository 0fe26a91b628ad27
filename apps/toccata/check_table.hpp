#pragma once

#include <string>
#include <vector>

#include "toccata/reports/report.hpp"

namespace toccata::command {

std::size_t triangle_count(const Scene& scene);

/// The first few pairs of faces and where they meet, a line each and further in.
std::string face_lines(const std::vector<ReportedFacePair>& pairs);

/// What was found, for people.
std::string check_table(const Scene& scene, const CheckReport& report);

}  // namespace toccata::command
