#pragma once

#include <optional>
#include <string>
#include <vector>

#include "three_mf.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::command {

/// Whether a file of that name is read by way of another program or library: 3MF, STEP, IFC, and what Assimp reads.
[[nodiscard]] bool is_converted(const std::string& path);

/// Whether it takes another program, one of those that `read_converted` names.
[[nodiscard]] bool is_read_by_program(const std::string& path);

/// Files that are named, or also those that lie in a folder that is. What Assimp reads is of very many kinds, and much
/// of it no part: such files are named themselves.
enum class FormatsOf { commands, folders };

/// The extensions of these files, without the dot.
[[nodiscard]] std::vector<std::string> converted_formats(FormatsOf which);

/// Whether a file of that name says itself in which unit its numbers are, and --unit is about others: these, and scene
/// files.
[[nodiscard]] bool states_its_unit(const std::string& path);

/// Whether a file of that name may have curved faces, which --tessellation is about.
[[nodiscard]] bool may_be_curved(const std::string& path);

/// How it is read.
struct Conversion {
  double scale = 1;
  std::string tessellation;                 ///< a length with its unit; empty: the converter's own
  std::optional<double> metres_per_unit{};  ///< of a file that does not state its unit
};

/// What the file holds. All but 3MF files are read by `toccata-read-step`, `toccata-read-ifc` and
/// `toccata-read-assimp`, programs beside this one or on the path: a file by which they break down breaks nothing else.
/// Throws Error naming the file and what its reader said, or that it is not installed and how it is.
[[nodiscard]] ConvertedScene read_converted(const std::string& path, const Conversion& conversion);

}  // namespace toccata::command
