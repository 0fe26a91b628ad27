#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/query/contacts.hpp>

#include "described.hpp"

// Answers of which one question has any number, as rows of one array.
namespace toccata::python {

/// What the number before a row counts.
struct OfQuery {
  static constexpr const char* name = "query";
  static constexpr const char* doc = "Of which question.";
};
struct OfObject {
  static constexpr const char* name = "object";
  static constexpr const char* doc = "Of which object.";
};
struct OfPair {
  static constexpr const char* name = "pair";
  static constexpr const char* doc = "Of which pair.";
};

template <class Answer, class Of>
struct Numbered {
  Index number = 0;
  Answer answer{};
};

template <class Answer, class Of>
struct Described<Numbered<Answer, Of>> {
  using Row = Numbered<Answer, Of>;
  static constexpr const char* name = Described<Answer>::name;
  static constexpr const char* doc = Described<Answer>::doc;
  static constexpr auto fields = std::tuple_cat(std::tuple{field<Row, &Row::number>(Of::name, Of::doc)},
                                                fields_within<Row, &Row::answer>(Described<Answer>::fields));
};

template <class Of, class Answer>
std::vector<Numbered<Answer, Of>> numbered(const std::vector<std::vector<Answer>>& lists) {
  std::vector<Numbered<Answer, Of>> rows;
  std::size_t count = 0;
  for (const auto& list : lists) count += list.size();
  rows.reserve(count);
  for (std::size_t i = 0; i < lists.size(); ++i)
    for (const Answer& answer : lists[i]) rows.push_back({static_cast<Index>(i), answer});
  return rows;
}

/// Calls `take(number, answer)` for each row that an array tells. Throws Error, beginning with `what`, for another
/// array and where the number of a row is not below `count`.
template <class Answer, class Of, class Take>
void for_rows(nb::handle rows, std::size_t count, const char* what, const Take& take) {
  for (const Numbered<Answer, Of>& row : answers_of<Numbered<Answer, Of>>(rows, what)) {
    if (row.number >= count) throw Error(fmt::format("{}: there is no {} {}", what, Of::name, row.number));
    take(row.number, row.answer);
  }
}

/// A ContactRegion, of which every member is a number.
struct Region {
  std::size_t triangle_pairs = 0, face_pairs = 0;
  Vec3 lower{}, upper{};
  std::size_t point_count = 0;
  bool closed = false;
  std::size_t curve_count = 0;
  double area = 0;
  Vec3 normal{};
  double depth_lower = 0, depth_upper = 0;
  Vec3 deepest{};
};

template <>
struct Described<Region> {
  static constexpr const char* name = "ContactRegion";
  static constexpr const char* doc = "One place at which two meshes meet.";
  static constexpr std::tuple fields{field<Region, &Region::triangle_pairs>("triangle_pairs", ""),
                                     field<Region, &Region::face_pairs>("face_pairs", ""),
                                     field<Region, &Region::lower>("lower", ""),
                                     field<Region, &Region::upper>("upper", ""),
                                     field<Region, &Region::point_count>("point_count", ""),
                                     field<Region, &Region::closed>("closed", ""),
                                     field<Region, &Region::curve_count>("curve_count", ""),
                                     field<Region, &Region::area>("area", ""),
                                     field<Region, &Region::normal>("normal", ""),
                                     field<Region, &Region::depth_lower>("depth_lower", ""),
                                     field<Region, &Region::depth_upper>("depth_upper", ""),
                                     field<Region, &Region::deepest>("deepest", "")};
};

inline std::vector<Region> flat(const std::vector<ContactRegion>& regions) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Region> rows;
  for (const ContactRegion& region : regions) {
    const auto depth = region.depth.value_or(ContactRegion::Depth{none, none});
    rows.push_back({region.triangle_pairs, region.face_pairs, region.box.lower, region.box.upper, region.point_count,
                    region.closed, region.curve_count, region.area, region.normal, depth.lower, depth.upper,
                    region.deepest});
  }
  return rows;
}

inline ContactRegion region_of(const Region& row) {
  ContactRegion region;
  region.triangle_pairs = row.triangle_pairs;
  region.face_pairs = row.face_pairs;
  region.box = {row.lower, row.upper};
  region.point_count = row.point_count;
  region.closed = row.closed;
  region.curve_count = row.curve_count;
  region.area = row.area;
  region.normal = row.normal;
  region.deepest = row.deepest;
  if (!std::isnan(row.depth_lower)) region.depth = ContactRegion::Depth{row.depth_lower, row.depth_upper};
  return region;
}

}  // namespace toccata::python
