#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check_input.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/reports/report.hpp"

// How a pair that a check tells is told in the files of other programs.
namespace toccata::command {

/// "overlapping", "crossing", "touching", "clearance" or "undecided": what kind of finding it is.
[[nodiscard]] std::string kind_of_finding(const ReportedPair& pair);

/// What kind of clash it is: as above, and, of a report with volumes where that says more, "pierce", "protrude" and so
/// on.
[[nodiscard]] std::vector<std::string> labels_of(const ReportedPair& pair, bool has_volume);

/// "left overlaps right, 0.5 deep along (1, 0, 0), beyond the tolerance (both solids)". Control characters in names are
/// written out. Where the kind of clash is known, it "pierces" or "protrudes into" the other.
[[nodiscard]] std::string sentence_of(const Scene& scene, const ReportedPair& pair);

/// What is told of a pair besides, a line each: where it is, as "the surfaces meet within the box from … to …" or "the
/// deepest points are … and …", the volume that both have in common and a point of it, and how it stands against a
/// baseline.
[[nodiscard]] std::vector<std::string> details_of(const Scene& scene, const ReportedPair& pair, bool has_baseline);

/// A box in the world to look at: around the points in which the two meet or are near, or the object that lies inside
/// the other; where the answer tells none, around what both may hold. For what has no end, it is a box about the
/// origin.
[[nodiscard]] Aabb place_of(const Scene& scene, const ReportedPair& pair);

/// 32 hexadecimal digits that are the same for the same words, in runs of every day and machine.
[[nodiscard]] std::string digits_of(const std::string& words);

/// A path or a generator as the reference of an address: what means something there, and what is no letter, by its
/// number.
[[nodiscard]] std::string in_address(const std::string& path);

}  // namespace toccata::command
