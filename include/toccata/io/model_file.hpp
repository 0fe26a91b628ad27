#pragma once

#include <filesystem>

#include "toccata/query/model.hpp"

namespace toccata {

/// A mesh file (OBJ, STL, PLY, OFF), or "gen:<name>?<parameter>=<number>&…", made ready for questions. Files that hold
/// several posed objects are read with `read_scene` and made ready with `scene_models`. Throws Error like `read_mesh`.
[[nodiscard]] Model load_model(const std::filesystem::path& path);

}  // namespace toccata
