#pragma once

#include <string>

#include "toccata/query/distance.hpp"

namespace toccata::test {

/// What is wrong with `within_distance` and `distance_within` of two meshes taken as surfaces, asked with tolerances at
/// and about their distance and far from it, compared with the exact rational distance, both ways round, warm and cold;
/// empty when nothing is.
std::string fault_of_closeness(const Model& a, const Model& b, const PairQuery& query);

}  // namespace toccata::test
