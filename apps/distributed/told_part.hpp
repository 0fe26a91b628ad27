#pragma once

#include <span>
#include <string>
#include <vector>

#include "distributed/messages.hpp"
#include "load.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata::command {

/// What a rank that has read a file tells the others of it: everything but the shapes.
struct ToldPart {
  /// With something in the place of each shape: of a mesh one that has the box of it, so that scales are compared; a
  /// point of others.
  ConvertedScene file;
  std::vector<std::string> summaries;  ///< of its objects
  std::vector<bool> is_open;           ///< which of them are open meshes
};

void put_told_part(MessageWriter& writer, const ConvertedScene& file, std::span<const SceneInstance> models);
[[nodiscard]] ToldPart get_told_part(MessageReader& reader);

}  // namespace toccata::command
