#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toccata {

/// Where a mesh is that a URDF file names. Throws Error saying where it was looked for.
[[nodiscard]] std::filesystem::path mesh_place(const std::string& name, const std::filesystem::path& urdf_folder,
                                               const std::vector<std::string>& package_folders);

}  // namespace toccata
