#include "toccata/motion/swept_volume.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "math/constants.hpp"
#include "motion/refined_cells.hpp"
#include "motion/swept_cell.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

constexpr std::string_view name_of_volume = "a swept volume";
constexpr double default_excess = 0x1p-5;  ///< of the diagonal of the body's box

void require(const SweptVolumeOptions& options) {
  if (!(options.excess >= 0 && std::isfinite(options.excess)))
    throw Error(fmt::format("{}: the excess {} is not a length of 0 or more", name_of_volume, options.excess));
  if (options.max_parts < 1) throw Error(fmt::format("{}: at least 1 part has to be allowed", name_of_volume));
}

bool rests(const RigidMotion& motion) {
  const auto stays = [](const RigidMove& move) { return move.turns == 0 && move.translation == Vec3{}; };
  return motion.pieces().size() == 1 && stays(motion.pieces().front().move);
}

Model model_of(std::vector<CompoundPart> parts) {
  if (parts.size() == 1 && parts.front().pose == Pose{}) return Model(parts.front().shape);
  return Model(Compound(parts));
}

/// Every shape of the body, where it is.
SweptVolume volume_at_rest(const std::vector<MovingPart>& parts, Solid solid) {
  std::vector<CompoundPart> placed;
  for (const MovingPart& part : parts) {
    placed.push_back({part.shape().shape(), part.pose_at(0)});
  }
  return {model_of(std::move(placed)), 0, true, solid};
}

double diagonal_at_start(const std::vector<MovingPart>& parts) {
  Aabb box;
  for (const MovingPart& part : parts) box = merge(box, world_box(part.at(0)));
  return length(box.upper - box.lower);
}

/// Adds the inside, at the start, of every mesh that is a solid.
void add_insides(const std::vector<MovingPart>& parts, std::vector<CompoundPart>& volume) {
  for (const MovingPart& part : parts)
    if (part.shape().has_mesh() && is_solid(part.at(0))) volume.push_back({part.shape().shape(), part.pose_at(0)});
}

}  // namespace

SweptVolume swept_volume(const Model& body, const RigidMotion& motion, const SweptVolumeOptions& options) {
  require(options);
  const std::vector<MovingPart> parts = moving_parts(body, motion, options.solid, name_of_volume);
  for (const MovingPart& part : parts) (void)part.at(0);  // may it be posed so?
  if (rests(motion)) return volume_at_rest(parts, options.solid);
  for (const MovingPart& part : parts)
    if (part.is_half_space())
      throw Error(
          fmt::format("{}: a half-space has no end, nor has what it passes; ask `sweep` about it", name_of_volume));
  const double wanted = options.excess > 0 ? options.excess : default_excess * diagonal_at_start(parts);
  std::vector<CompoundPart> volume;
  double excess = 0;
  for (const SweptCell& cell : refined_cells(parts, motion, {wanted, options.max_parts})) {
    const SweptHull hull = hull_of(cell);
    if (!(hull.excess < infinity))
      throw Error(fmt::format("{}: it reaches beyond the doubles; use a larger unit", name_of_volume));
    volume.push_back({hull.shape, Pose{}});
    excess = std::max(excess, hull.excess);
  }
  add_insides(parts, volume);
  return {model_of(std::move(volume)), excess, false, options.solid};
}

SweptOverlap may_meet(const SweptVolume& a, const SweptVolume& b) {
  const PairQuery query{.solid_a = a.solid, .solid_b = b.solid};
  if (!overlap(a.model, b.model, query)) return SweptOverlap::never;
  const bool is_told = a.is_exact() && b.is_exact() && (a.rests || b.rests);
  return is_told && relation(a.model, b.model, query).status == Status::exact ? SweptOverlap::certain
                                                                              : SweptOverlap::maybe;
}

}  // namespace toccata
