#include "words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace toccata::command {
namespace {

/// Characters, not bytes: UTF-8 continuation bytes take no column.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Six, or as many as leave three behind the point where coordinates are large.
int digits_of(const Vec3& point) {
  const double largest = std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)});
  return largest >= 1000 && largest < 1e13 ? 4 + static_cast<int>(std::log10(largest)) : 6;
}

}  // namespace

std::string point_text(const Vec3& point) {
  // Adding 0 takes the sign from a zero, which means nothing to people.
  return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", point.x + 0.0, digits_of(point), point.y + 0.0, digits_of(point),
                     point.z + 0.0, digits_of(point));
}

std::string distance_text(const Distance& distance) {
  if (distance.status == Status::undecided) return "meet, or nearly: undecided";
  if (distance.upper == 0) return "meet";
  const std::string upper = fmt::format("{:.12g}", distance.upper), lower = fmt::format("{:.12g}", distance.lower);
  // Rounding to twelve digits may still tell two ends of an interval that is as narrow as is promised.
  return (distance.status == Status::exact || lower == upper ? upper : lower + " to " + upper) + " apart";
}

std::string nearest_text(const Distance& distance) {
  return fmt::format("{} to {}", point_text(distance.on_a), point_text(distance.on_b));
}

std::string depth_text(const Penetration& penetration) {
  const std::string depth = depth_text(penetration.lower, penetration.upper);
  return penetration.upper == 0 ? depth : depth + " along " + point_text(penetration.direction);
}

std::string depth_text(double lower, double upper) { return bracket_text(lower, upper) + " deep"; }

std::string depth_text(const Penetration& penetration, DepthEnd end, const std::string& moved) {
  std::string text = depth_text(penetration) + (penetration.upper == 0 ? "" : ", moving " + moved);
  switch (end) {
    case DepthEnd::precise:
      break;
    case DepthEnd::exhausted:
      return text + ", as narrow as could be proved";
    case DepthEnd::out_of_time:
      return text + ", when the time was over";
  }
  return text;
}

std::string local_depth_text(const ReportedPair& pair) {
  return pair.tolerance == ToleranceVerdict::within
             ? fmt::format("nowhere more than {} deep", upper_bound_text(pair.local_depth->upper))
             : fmt::format("{} deep or more in one place", lower_bound_text(pair.local_depth->lower));
}

std::string volume_text(const OverlapVolume& volume) {
  return volume.status == Status::exact ? fmt::format("{:.6g}", volume.upper)
                                        : bracket_text(volume.lower, volume.upper);
}

std::string verb_of(const ReportedPair& pair) {
  if (pair.piercing == ClashPiercing::a_through_b) return "pierces";
  if (pair.piercing == ClashPiercing::b_through_a) return "is pierced by";
  if (pair.kind == ClashKind::pierce) return "pierces or is pierced by";
  if (pair.kind == ClashKind::protrude) return "protrudes into";
  return verb_of(pair.relation);
}

std::string winding_text(const WindingNumber& winding) {
  return fmt::format("(the mesh around it is open: by its generalised winding number, {:.3g})", winding.value);
}

std::string since_text(const ReportedPair& pair) {
  const Since since = since_baseline(pair);
  return since == Since::moved ? fmt::format("moved by {:.6g}", *pair.moved_by) : name_of(since);
}

std::string length_text(double length, const std::string& unit) {
  if (std::isinf(length)) return "all";
  if (unit == "unit") return fmt::format("{:.12g}", length);
  if (unit.ends_with(" m")) return fmt::format("{:.12g} times {}", length, unit);
  if (unit == "m" && length > 0 && length < 1) return fmt::format("{:.12g} mm", 1000 * length);
  return fmt::format("{:.12g} {}", length, unit);
}

std::string called_as() {
  const char* name = std::getenv("TOCCATA_CALLED_AS");
  return name == nullptr || *name == '\0' ? "toccata" : printable(name);
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
  return digits;
}

std::string decided_text(std::size_t undecided) {
  return undecided == 0 ? "decided exactly" : fmt::format("{} undecided and counted", grouped(undecided));
}

std::string only_winding_text(const MeshHealth& health) {
  if (health.closed || health.boundary_edges > 0 || health.non_manifold_edges > 0) return {};
  return fmt::format(
      "no face is missing, but {} {} between triangles that are wound against each other: turn these round",
      counted(health.flipped_edges, "edge"), health.flipped_edges == 1 ? "lies" : "lie");
}

std::string counted(std::size_t number, const std::string& noun) { return counted(number, noun, noun + "s"); }

std::string counted(std::size_t number, const std::string& noun, const std::string& plural) {
  return fmt::format("{} {}", grouped(number), number == 1 ? noun : plural);
}

namespace {

/// The signs of Unicode in UTF-8 that turn the direction of what follows, end lines, or control terminals.
std::optional<std::string_view> unseen_sign(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const bool controls = byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) <= 0x9F;
  const bool arabic_mark = byte(0) == 0xD8 && byte(1) == 0x9C;
  if (controls || arabic_mark) return text.substr(0, 2);
  const unsigned last = byte(2);
  const bool turns =
      byte(0) == 0xE2 && byte(1) == 0x80 && ((last >= 0x8E && last <= 0x8F) || (last >= 0xA8 && last <= 0xAE));
  const bool isolates = byte(0) == 0xE2 && byte(1) == 0x81 && last >= 0xA6 && last <= 0xA9;
  return turns || isolates ? std::optional(text.substr(0, 3)) : std::nullopt;
}

unsigned number_of(std::string_view sign) {
  const auto bits = [&](std::size_t i, unsigned mask) { return static_cast<unsigned char>(sign[i]) & mask; };
  return sign.size() == 2 ? bits(0, 0x1F) << 6U | bits(1, 0x3F)
                          : bits(0, 0x0F) << 12U | bits(1, 0x3F) << 6U | bits(2, 0x3F);
}

}  // namespace

std::string printable(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (const auto sign = unseen_sign(std::string_view(text).substr(i))) {
      result += fmt::format("\\u{:04x}", number_of(*sign));
      i += sign->size() - 1;
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\x{:02x}", byte);
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string columns(const std::vector<std::vector<std::string>>& rows, std::size_t indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line(indent, ' ');
    for (std::size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] - width_of(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace toccata::command
