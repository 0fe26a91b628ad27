#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "check_table.hpp"
#include "distributed/messages.hpp"
#include "load.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::command {

/// What is told of an object in the place of its shape.
struct ToldObject {
  std::string summary;
  TableObject table;
  std::optional<Aabb> box;  ///< in its own frame, for baselines
  bool is_open = false;     ///< an open mesh that nobody has said is a surface
};

/// What a rank that has read a file tells the others of it: everything but the shapes.
struct ToldPart {
  /// With something in the place of each shape: of a mesh one that has the box of it, so that scales are compared; a
  /// point of others.
  ConvertedScene file;
  std::vector<ToldObject> objects;
};

void put_told_part(MessageWriter& writer, const ConvertedScene& file, std::span<const SceneInstance> models);
[[nodiscard]] ToldPart get_told_part(MessageReader& reader);

}  // namespace toccata::command
