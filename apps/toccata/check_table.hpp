#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "load.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::command {

/// The first few pairs of faces and where they meet, a line each and further in.
std::string face_lines(const std::vector<ReportedFacePair>& pairs);

/// What a table of a check tells of an object besides its name.
struct TableObject {
  ShapeKind kind = ShapeKind::mesh;
  std::size_t triangles = 0;
};

std::vector<TableObject> table_objects(const Scene& scene);
std::size_t triangle_count(std::span<const TableObject> objects);

/// What --unit and --scale did to coordinates, where these were rounded; else empty.
std::string scaling_line(const LoadedScene& loaded);

/// What was found, for people. Of the scene its unit and the names count.
std::string check_table(const Scene& scene, std::span<const TableObject> objects, const CheckReport& report);
std::string check_table(const Scene& scene, const CheckReport& report);

}  // namespace toccata::command
