#pragma once

#include <string>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::io {

// A mesh as the text of a file. Numbers are the shortest that are read as the same double.

[[nodiscard]] std::string obj_text(const TriangleMesh& mesh);
[[nodiscard]] std::string off_text(const TriangleMesh& mesh);
[[nodiscard]] std::string ply_text(const TriangleMesh& mesh);
[[nodiscard]] std::string stl_text(const TriangleMesh& mesh);

}  // namespace toccata::io
