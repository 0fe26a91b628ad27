#include "motion/stretch_view.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "math/vec3_measures.hpp"
#include "math/world_vertex.hpp"
#include "motion/convex_gap.hpp"
#include "query/meshes/cull_bounds.hpp"
#include "query/meshes/pair_cull.hpp"

// The names and the bounds are those of docs/design/culling.md.
namespace toccata {
namespace {

template <PosedConvexSet S>
HeightRange range_of_set(const S& set, const Vec3& direction) {
  const PlacedSet<S> placed([&] { return set; });
  return {lowest(placed, direction), -lowest(placed, -direction)};
}
HeightRange range_of_set(const PosedHalfSpace& set, const Vec3& direction) {
  return {-infinity, dot(direction, set.point) + 8 * unit_roundoff * sum_of_magnitudes(set.point)};
}
/// What has a tree is seen by its boxes.
HeightRange range_of_set(const PosedTriangles&, const Vec3&) { return {-infinity, infinity}; }

HeightRange range_along(const PosedShape& shape, const Vec3& direction) {
  return std::visit([&](const auto& set) { return range_of_set(set, direction); }, shape);
}

double size_of(const HeightRange& range) {
  const auto finite = [](double height) { return std::isfinite(height) ? std::fabs(height) : 0; };
  return std::max(finite(range.low), finite(range.high));
}

}  // namespace

SweptThing::SweptThing(const MovingPart& moving, const TimeStretch& stretch)
    : part(&moving),
      tree(moving.shape().has_mesh() ? &moving.shape().wide_bvh() : nullptr),
      motion(moving.motion(stretch)) {
  if (tree == nullptr) return;
  for (int i = 0; i < 3; ++i) linear_[i] = tree->unit * motion.pose.linear[i];
  origin_ = transform(motion.pose, tree->origin);
}

bool SweptThing::is_item(std::uint32_t at) const {
  return tree == nullptr || (at != whole && tree->blocks[at >> 3].is_item(at & 7U));
}

Index SweptThing::item(std::uint32_t at) const {
  if (tree == nullptr) return 0;
  return tree->items[tree->blocks[at >> 3].item_place(at & 7U)];
}

std::uint32_t SweptThing::block_below(std::uint32_t at) const {
  return at == whole ? 0 : static_cast<std::uint32_t>(tree->blocks[at >> 3].child[at & 7U]);
}

/// A box's points are within its radius of its centre.
SweptThing::Extent SweptThing::extent(std::uint32_t at) const {
  if (tree == nullptr || at == whole) return {motion.reach + part->core().radius, motion.reach};
  const WideBlock& block = tree->blocks[at >> 3];
  const std::size_t lane = at & 7U;
  const Vec3 centre{block.centre[0][lane], block.centre[1][lane], block.centre[2][lane]};
  const Vec3 half{block.extent[0][lane], block.extent[1][lane], block.extent[2][lane]};
  const Vec3 spread{dot(magnitudes(linear_[0]), half), dot(magnitudes(linear_[1]), half),
                    dot(magnitudes(linear_[2]), half)};
  const double radius = length(spread);
  return {radius, (motion.reach_of(linear_ * centre + origin_) + radius) * (1 + 0x1p-40) + motion.rounding};
}

struct StretchView::Posed {
  Posed(const SweptThing& thing_a, const SweptThing& thing_b, const TimeStretch& stretch)
      : pose{pose_of(thing_a, stretch), pose_of(thing_b, stretch)} {
    for (std::size_t end = 0; end < 2; ++end) {
      const double time = end == 0 ? stretch.begin : stretch.end;
      if (thing_a.tree == nullptr) shape[0][end].emplace(thing_a.part->at(time));
      if (thing_b.tree == nullptr) shape[1][end].emplace(thing_b.part->at(time));
    }
  }

  static std::array<Pose, 2> pose_of(const SweptThing& thing, const TimeStretch& stretch) {
    return {thing.part->pose_at(stretch.begin), thing.part->pose_at(stretch.end)};
  }

  [[nodiscard]] std::array<const PosedShape*, 2> shapes(std::size_t side) const {
    const auto pointer = [&](std::size_t end) { return shape[side][end] ? &*shape[side][end] : nullptr; };
    return {pointer(0), pointer(1)};
  }

  std::array<std::array<Pose, 2>, 2> pose;                        ///< of either thing at the ends
  std::array<std::array<std::optional<PosedShape>, 2>, 2> shape;  ///< of what is no tree
};

StretchView::Along StretchView::along(const SweptThing& thing, const std::array<Pose, 2>& poses,
                                      const std::array<const PosedShape*, 2>& shapes,
                                      const std::array<Vec3, 2>& direction_at_ends) {
  Along result;
  for (std::size_t end = 0; end < 2; ++end) {
    const Vec3& direction = direction_at_ends[end];
    if (thing.tree == nullptr) {
      result.whole.at[end] = range_along(*shapes[end], direction);
      result.size = std::max(result.size, size_of(result.whole.at[end]));
      continue;
    }
    const Pose& pose = poses[end];
    const WideBvh& tree = *thing.tree;
    const Vec3 on = transpose(pose.linear) * direction;
    const double at_origin = dot(direction, pose.offset);
    const FormRange range = range_of(on, tree.box);
    const Vec3 units{sum_of_magnitudes(pose.linear[0]), sum_of_magnitudes(pose.linear[1]),
                     sum_of_magnitudes(pose.linear[2])};
    result.form[end] = tree.unit * on;
    result.offset[end] = dot(on, tree.origin) + at_origin;
    result.whole.at[end] = {range.low + at_origin, range.high + at_origin};
    result.size = std::max(result.size, sum_of_magnitudes(world_sizes(pose, tree.box) + (2 * tree.unit) * units));
  }
  return result;
}

/// The pad is that of the walk of straight casts: 64 u W covers heights that are computed from the trees' units. A
/// direction of length 1 has no coordinate above 1.
void StretchView::add(const Posed& posed, const std::array<Vec3, 2>& direction_at_ends) {
  Direction& d = directions_[count_];
  d.side = {along(a_, posed.pose[0], posed.shapes(0), direction_at_ends),
            along(b_, posed.pose[1], posed.shapes(1), direction_at_ends)};
  d.pad = 64 * unit_roundoff * (d.side[0].size + d.side[1].size) + 0x1p-960;
  if (std::isfinite(d.pad)) ++count_;
}

StretchView::StretchView(const SweptThing& a, const SweptThing& b, const TimeStretch& stretch)
    : a_(a), b_(b), stretch_(stretch) {
  const Posed posed(a, b, stretch);
  poses_ = posed.pose;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto shapes = posed.shapes(side);
    if (shapes[0] == nullptr || !std::holds_alternative<PosedHalfSpace>(*shapes[0])) continue;
    add(posed, {normalized(std::get<PosedHalfSpace>(*shapes[0]).normal),
                normalized(std::get<PosedHalfSpace>(*shapes[1]).normal)});
    return;
  }
  const double middle = stretch.begin + 0.5 * (stretch.end - stretch.begin);
  const SweptThing &first = a.tree != nullptr ? a : b, &second = b.tree != nullptr ? b : a;
  const PosedMesh mesh_a(first.part->shape(), first.part->pose_at(middle)),
      mesh_b(second.part->shape(), second.part->pose_at(middle));
  const PairCull cull(mesh_a, mesh_b);
  for (const CullDirection& d : cull.directions()) {
    const Vec3 unit = normalized(d.world);
    add(posed, {unit, unit});
  }
}

HeightsAtEnds StretchView::heights(std::size_t direction, std::size_t side, std::uint32_t at) const {
  if (at == SweptThing::whole) return directions_[direction].side[side].whole;
  const Along& along = directions_[direction].side[side];
  const WideBlock& boxes = (side == 0 ? a_ : b_).tree->blocks[at >> 3];
  const std::size_t lane = at & 7U;
  const Vec3 centre{boxes.centre[0][lane], boxes.centre[1][lane], boxes.centre[2][lane]};
  const Vec3 extent{boxes.extent[0][lane], boxes.extent[1][lane], boxes.extent[2][lane]};
  HeightsAtEnds heights;
  for (std::size_t end = 0; end < 2; ++end) {
    const double middle = dot(along.form[end], centre) + along.offset[end];
    const double half = dot(magnitudes(along.form[end]), extent);
    heights.at[end] = {middle - half, middle + half};
  }
  return heights;
}

BlockHeights StretchView::block_heights(std::size_t direction, std::size_t side, std::uint32_t block) const {
  const Along& along = directions_[direction].side[side];
  const WideBlock& boxes = (side == 0 ? a_ : b_).tree->blocks[block];
  BlockHeights heights;
  for (std::size_t end = 0; end < 2; ++end) {
    const Vec3 form = along.form[end], spread = magnitudes(form);
    const double offset = along.offset[end];
    for (std::size_t lane = 0; lane < WideBlock::width; ++lane) {
      const double middle =
          ((form.x * boxes.centre[0][lane] + form.y * boxes.centre[1][lane]) + form.z * boxes.centre[2][lane]) + offset;
      const double half =
          (spread.x * boxes.extent[0][lane] + spread.y * boxes.extent[1][lane]) + spread.z * boxes.extent[2][lane];
      heights.low[end][lane] = middle - half;
      heights.high[end][lane] = middle + half;
    }
  }
  return heights;
}

Triangle StretchView::triangle(std::size_t side, std::size_t end, Index number) const {
  const TriangleMesh& mesh = (side == 0 ? a_ : b_).part->shape().mesh();
  const auto& corner = mesh.triangles()[number];
  const Pose& pose = poses_[side][end];
  const auto world = [&](std::size_t i) { return world_vertex(pose, mesh.vertices()[corner[i]]); };
  return {{world(0), world(1), world(2)}};
}

StretchView::Heights StretchView::heights(std::size_t side, std::uint32_t at) const {
  Heights result;
  for (std::size_t i = 0; i < count_; ++i) result[i] = heights(i, side, at);
  return result;
}

}  // namespace toccata
