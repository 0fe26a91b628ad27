#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/signed_distance.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata::command {

/// "(0.5, 0, 1)", to six digits.
std::string point_text(const Vec3& point);

/// "0.25 apart", "meet", or that it is undecided.
std::string distance_text(const Distance& distance);

/// The nearest points: "(0, 0, 1) to (0, 0, 3)".
std::string nearest_text(const Distance& distance);

/// "0.25 deep along (0, 0, 1)"; of two that do not overlap "0 deep".
std::string depth_text(const Penetration& penetration);

/// The same, with which of the two is moved along it, and why its bracket is wider than asked, where it is.
std::string depth_text(const Penetration& penetration, DepthEnd end, const std::string& moved);

/// How much two solids have in common: "0.5", or "between 0.4 and 0.6".
std::string volume_text(const OverlapVolume& volume);

/// "pierces", "protrudes into": as the field calls the clash, where its kind is known and says more than the relation.
std::string verb_of(const ReportedPair& pair);

/// What is said of a pair that a winding number decided, in place of what both are taken for.
std::string winding_text(const WindingNumber& winding);

/// How a pair stands against the baseline: "new", or "moved by 0.5".
std::string since_text(const ReportedPair& pair);

/// A length in the world's unit, for people: "5 mm" of 0.005 m; "all" of infinity.
std::string length_text(double length, const std::string& unit);

/// "0.5 deep", "20 to 21 deep" (bracket_text).
std::string depth_text(double lower, double upper);

/// The end of `local_depth`, which has to be there, by which the verdict of a tolerance was come to.
std::string local_depth_text(const ReportedPair& pair);

/// What the user typed to call the command: "toccata", or "./toccata" through the repository's wrapper.
std::string called_as();

/// 1234567 as "1,234,567".
std::string grouped(std::size_t number);

/// "decided exactly", or how many of the answers are undecided and stand for the safe side.
std::string decided_text(std::size_t undecided);

/// "1 pair", "2 pairs".
std::string counted(std::size_t number, const std::string& noun);

/// Why a mesh without a hole is open: its triangles are wound against each other. Empty where that is not the reason.
std::string only_winding_text(const MeshHealth& health);

/// The same for a noun of another plural.
std::string counted(std::size_t number, const std::string& noun, const std::string& plural);

/// A name from a file, safe for a terminal: control characters are shown as escapes.
std::string printable(const std::string& text);

/// Rows of equally many cells as lines, columns two spaces apart, without trailing spaces. `indent` spaces in front.
std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t indent);

}  // namespace toccata::command
