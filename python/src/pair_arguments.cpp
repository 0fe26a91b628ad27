#include "pair_arguments.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <toccata/core/error.hpp>

namespace toccata::python {
namespace {

/// How many there are of four things, of each of which one stands for all.
std::size_t common_count(const Models& a, const Models& b, const Poses& poses_a, const Poses& poses_b) {
  struct Part {
    const char* name;
    std::size_t count;
    bool single;
  };
  const Part parts[] = {{"shapes a", a.each.size(), a.single},
                        {"shapes b", b.each.size(), b.single},
                        {"poses of a", poses_a.size(), poses_a.is_single()},
                        {"poses of b", poses_b.size(), poses_b.is_single()}};
  const Part* counted = nullptr;
  for (const Part& part : parts) {
    if (part.single) continue;
    if (counted != nullptr && counted->count != part.count)
      throw Error(fmt::format("there are {} {} and {} {}; give as many, or one of one of them", counted->count,
                              counted->name, part.count, part.name));
    if (counted == nullptr) counted = &part;
  }
  return counted == nullptr ? 1 : counted->count;
}

}  // namespace

PairQuery query_of(const PoseLike& pose_a, const PoseLike& pose_b, Solid solid_a, Solid solid_b) {
  return {
      .pose_a = pose_of(pose_a, "pose_a"), .pose_b = pose_of(pose_b, "pose_b"), .solid_a = solid_a, .solid_b = solid_b};
}

PairsAsked::PairsAsked(const ShapesLike& a, const ShapesLike& b, const PosesLike& poses_a, const PosesLike& poses_b,
                       Solid solid_a, Solid solid_b)
    : a_(models_of(a, "a")),
      b_(models_of(b, "b")),
      poses_a_(poses_of(poses_a, "poses_a")),
      poses_b_(poses_of(poses_b, "poses_b")),
      solid_a_(solid_a),
      solid_b_(solid_b),
      count_(common_count(a_, b_, poses_a_, poses_b_)) {
  if (a_.single && b_.single) return;
  pairs_.reserve(count_);
  for (std::size_t i = 0; i < count_; ++i) pairs_.push_back({a_[i], b_[i], query(i)});
}

Batch<PairQuery> PairsAsked::batch() const {
  if (a_.single && b_.single) return {a_.each.front(), b_.each.front(), count_, *this};
  return Batch<PairQuery>(pairs_);
}

}  // namespace toccata::python
