#pragma once

#include <memory>
#include <string>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata::bench {

/// The mesh of a file, or of gen:NAME?…. Throws Error when it holds several objects.
std::shared_ptr<const TriangleMesh> single_mesh(const std::string& file);

}  // namespace toccata::bench
