#include "narrow/quadrics/distance/quadric_search.hpp"

#include <algorithm>
#include <cmath>

#include "math/vec3_measures.hpp"

namespace toccata {
namespace {

constexpr std::uint64_t most_search_steps = 128;

/// A slot that no pair of the simplex names.
Index free_slot(const VertexPairs& pairs) {
  unsigned taken = 0;
  for (std::size_t i = 0; i < pairs.size; ++i) taken |= 1U << pairs.a[i];
  Index slot = 0;
  while ((taken >> slot & 1U) != 0) ++slot;
  return slot;
}

/// Weights of the corners that make the point, as far as doubles tell; of the corners of a face whose relative interior
/// contains it.
std::array<double, 4> weights_of(const std::array<Vec3, 4>& p, std::size_t size, const Vec3& at) {
  std::array<double, 4> weight{1, 0, 0, 0};
  if (size == 2) {
    const Vec3 along = p[1] - p[0];
    weight[1] = dot(at - p[0], along) / dot(along, along);
  } else if (size == 3) {
    const Vec3 u = p[1] - p[0], v = p[2] - p[0], w = at - p[0], normal = cross(u, v);
    const double squared = dot(normal, normal);
    weight[1] = dot(cross(w, v), normal) / squared;
    weight[2] = dot(cross(u, w), normal) / squared;
  } else if (size == 4) {
    const Vec3 u = p[1] - p[0], v = p[2] - p[0], t = p[3] - p[0], w = at - p[0];
    const double volume = dot(cross(u, v), t);
    weight[1] = dot(cross(w, v), t) / volume;
    weight[2] = dot(cross(u, w), t) / volume;
    weight[3] = dot(cross(u, v), w) / volume;
  }
  double total = 0;
  for (std::size_t i = 1; i < size; ++i) {
    weight[i] = weight[i] > 0 && weight[i] < 1 ? weight[i] : (weight[i] >= 1 ? 1.0 : 0.0);
    total += weight[i];
  }
  weight[0] = std::fmax(0, 1 - total);
  total += weight[0];
  for (double& w : weight) w /= total;
  return weight;
}

}  // namespace

QuadricSearch::QuadricSearch(const PlainBody& a, const PlainBody& b, const Vec3& first_direction)
    : a_(a), b_(b), direction_(first_direction == Vec3{} ? Vec3{0, 0, 1} : first_direction) {}

QuadricSearch::QuadricSearch(const PlainBody& a, const PlainBody& b, const Vec3& first_direction, const Mat3& map)
    : QuadricSearch(a, b, first_direction) {
  map_ = map;
}

bool QuadricSearch::step(double part) {
  if (inside_ || stalled_ || steps_ >= most_search_steps) return false;
  ++steps_;
  const double length = plain_length(direction_);
  if (!(length > 0)) {
    stalled_ = true;
    return false;
  }
  const Vec3 d = (1 / length) * direction_;
  const Index slot = free_slot(simplex_.pairs);
  const Vec3 along = in_pair(d);
  slot_a_[slot] = a_.support(-along);
  slot_b_[slot] = b_.support(along);
  Vec3 point = slot_a_[slot].point - slot_b_[slot].point;
  if (map_) point = {dot((*map_)[0], point), dot((*map_)[1], point), dot((*map_)[2], point)};
  size_ = std::max(size_, largest_magnitude(point));
  const double gap = dot(d, point);
  if (gap > best_gap_) {
    best_gap_ = gap;
    best_direction_ = d;
  }
  const bool first = simplex_.pairs.size == 0;
  if (!first) {
    const double gain = squared_ - dot(nearest_, point), rounding = 0x1p-48 * size_;
    if (!(gain > 0 && gain * gain > rounding * rounding * squared_)) {
      stalled_ = true;
      return false;
    }
    if (gain <= part * squared_) return false;
  }
  simplex_.append(slot, slot, point);
  const NearestFace face = nearest_face(simplex_);
  if (!first && face.kept != 15 && !(face.squared < squared_)) {
    --simplex_.pairs.size;
    stalled_ = true;
    return false;
  }
  simplex_.keep(face.kept);
  nearest_ = face.nearest;
  direction_ = face.direction;
  squared_ = face.squared;
  inside_ = face.kept == 15 || squared_ == 0;
  return !inside_;
}

void QuadricSearch::run(double part) {
  while (step(part)) {
  }
}

void QuadricSearch::run_until_apart() {
  while (step(0) && !(best_gap_ > 0x1p-44 * size_)) {
  }
}

void QuadricSearch::run_until_compared(double length) {
  while (step(0) && !(squared_ <= length * length || best_gap_ > length + 0x1p-44 * size_)) {
  }
}

QuadricSearch::Carried QuadricSearch::carried(std::span<const Corner> corners, SideOf which, const PlainBody& body) {
  Carried side;
  for (const Corner& corner : corners) {
    const QuadricSupport& support = which == SideOf::a ? corner.a : corner.b;
    if (!(corner.weight > 0)) continue;
    if (body.grown(support.generator)) {
      side.grown += corner.weight;
      side.round = side.round + corner.weight * support.round;
    }
    std::size_t i = 0;
    while (i < side.size && side.generator[i] != support.generator) ++i;
    if (i == side.size) side.generator[side.size++] = support.generator;
    side.weight[i] += corner.weight;
  }
  if (side.grown > 0) side.round = (1 / side.grown) * side.round;
  return side;
}

QuadricSearch::Simplex QuadricSearch::simplex() const {
  Simplex found;
  found.count = simplex_.pairs.size;
  const auto weight = weights_of(simplex_.point, found.count, nearest_);
  for (std::size_t i = 0; i < found.count; ++i)
    found.corner[i] = {slot_a_[simplex_.pairs.a[i]], slot_b_[simplex_.pairs.a[i]], weight[i]};
  return found;
}

}  // namespace toccata
