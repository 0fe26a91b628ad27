#pragma once

#include <cstdint>

#include "toccata/bounds/kdop.hpp"
#include "toccata/narrow/posed_shapes.hpp"

// A sphere against a k-DOP, by the slabs that its centre violates: the lecture's 27 regions of a box
// (narrow/sphere.hpp), for all k. Exact.
namespace toccata {

/// The planes of a k-DOP that a point lies beyond, two bits for each slab: bit 2i: normal_i · p < lower_i, bit 2i + 1:
/// normal_i · p > upper_i. Exact for finite points and slabs. No bit: the point is inside. For k = 6 it is
/// `box_region`.
template <std::size_t k>
[[nodiscard]] std::uint32_t kdop_region(const Vec3& p, const Kdop<k>& kdop);

/// The sphere and the k-DOP have a point in common; touching counts. Exact. False for a k-DOP that is empty. The slabs
/// of one that is not have to be finite and to have a point in common, as those that are fitted or merged have.
///
/// Where the centre lies beyond one plane only, the nearest point may still lie on an edge: planes that meet at an
/// acute angle cut the foot off. So the region tells where to begin, and planes are added that the nearest point so far
/// violates, until it violates none (D. Goldfarb, A. Idnani, "A numerically stable dual method for solving strictly
/// convex quadratic programs", 1983): in doubles with a bound on the error, and where that leaves a doubt, in integers.
template <std::size_t k>
[[nodiscard]] bool overlap_by_regions(const PosedSphere& sphere, const Kdop<k>& kdop);

}  // namespace toccata
