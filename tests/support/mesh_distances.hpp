#pragma once

#include <string>

#include "toccata/query/distance.hpp"

namespace toccata::test {

/// What is wrong with the distance of two meshes taken as surfaces, compared with that of every pair of triangles: the
/// interval, the points, another order, a warm workspace; empty when nothing is.
std::string fault_of_surface_distance(const Model& a, const Model& b, const PairQuery& query);

/// The greatest magnitude of a coordinate of the posed mesh.
double largest_coordinate(const Model& mesh, const Pose& pose);

}  // namespace toccata::test
