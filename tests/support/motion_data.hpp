#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "toccata/motion/first_contact.hpp"

namespace toccata::test {

/// A question of the public data set, with what is true of it.
template <class Pair>
struct MotionQuery {
  std::string name;  ///< scene and number
  Pair pair;
  bool is_hit = false;
};

/// All questions in data_folder()/ccd, in the order of scenes and rows (shared data, `ccd`). Throws
/// std::runtime_error where a row is not as described, or a coordinate no double.
std::vector<MotionQuery<VertexFace>> vertex_face_queries(const std::filesystem::path& data);
std::vector<MotionQuery<EdgeEdge>> edge_edge_queries(const std::filesystem::path& data);

}  // namespace toccata::test
