#pragma once

#include <algorithm>
#include <vector>

#include "query/posed_shape.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {

/// The relation of two unions from those of their parts, as docs/truth.md has it: they overlap, cross or touch when
/// some parts do, and one contains the other when each part of the one lies in some part of the other.
class RelationOfUnions {
 public:
  RelationOfUnions(const PosedModel& a, const PosedModel& b)
      : a_solid_(a.solid), b_solid_(b.solid), covered_a_(a.parts.size()), covered_b_(b.parts.size()) {}

  /// Takes in the relation of two parts; those that are never told are apart.
  void add(const ItemPair& parts, const Relation& found) {
    meets_ |= found.kind != RelationKind::apart;
    deep_ |= found.kind == RelationKind::overlapping || found.kind == RelationKind::crossing;
    unresolved_ |= found.side_unresolved;
    if (found.status != Status::exact) status_ = found.status;
    // A union that is a surface is contained when all of it is in the interior; its solid parts do not tell that.
    const bool as_told = found.a_solid == a_solid_ && found.b_solid == b_solid_;
    const Containment c = as_told ? found.containment : Containment::none;
    if (c == Containment::a_in_b || c == Containment::equal) covered_a_[parts.first] = true;
    if (c == Containment::b_in_a || c == Containment::equal) covered_b_[parts.second] = true;
  }

  [[nodiscard]] Relation relation() const {
    Relation result{.a_solid = a_solid_, .b_solid = b_solid_, .status = status_};
    if (!meets_) return result;
    const bool deep_is_overlap = a_solid_ && b_solid_;
    result.kind = !deep_            ? RelationKind::touching
                  : deep_is_overlap ? RelationKind::overlapping
                                    : RelationKind::crossing;
    result.side_unresolved = !deep_ && unresolved_ && !a_solid_ && !b_solid_;
    result.containment = containment();
    return result;
  }

 private:
  [[nodiscard]] Containment containment() const {
    const auto all = [](const std::vector<bool>& covered) {
      return std::all_of(covered.begin(), covered.end(), [](bool is_covered) { return is_covered; });
    };
    const bool a_in_b = all(covered_a_), b_in_a = all(covered_b_);
    return a_in_b && b_in_a ? Containment::equal
           : a_in_b         ? Containment::a_in_b
           : b_in_a         ? Containment::b_in_a
                            : Containment::none;
  }

  bool a_solid_;
  bool b_solid_;
  std::vector<bool> covered_a_;
  std::vector<bool> covered_b_;
  bool meets_ = false;
  bool deep_ = false;
  bool unresolved_ = false;
  Status status_ = Status::exact;
};

}  // namespace toccata
