#pragma once

#include <filesystem>
#include <string>

#include "toccata/io/query_files.hpp"

namespace toccata::io {

/// How the animation of a glTF or GLB file moves a node (`read_motion`).
[[nodiscard]] FileMotion read_gltf_motion(const std::filesystem::path& path, const std::string& node);

}  // namespace toccata::io
