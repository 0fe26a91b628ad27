#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "toccata/query/check_all.hpp"
#include "toccata/reports/scene_question.hpp"
#include "toccata/shapes/scene.hpp"

// A scene with what was asked about it, in one file that needs no other: for a bug report, or a test. It is a scene
// file (docs/reference/scene-file.md) that holds its meshes, a "query", and the "answer" that was given.
namespace toccata {

struct Case {
  Scene scene;
  std::optional<SceneQuestion> question{};  ///< none in a plain scene file
  /// The report that answered it, as JSON (`report_json`), or what `error_json` makes of an Error. Empty: not known.
  std::string answer{};
};

/// Posed models as a scene. A name that is empty or taken becomes "a", "b", …, or gets a number; what is no UTF-8 is
/// written as \xff.
[[nodiscard]] Scene scene_of(std::span<const SceneInstance> models, const std::string& unit = "unit");

/// Reads a case, or any scene file. Throws Error naming the file and the place in it, as `read_scene` does.
[[nodiscard]] Case read_case(const std::filesystem::path& path);

/// Writes the case so that reading it gives the same shapes, poses and question, to the bit; the objects lose the tree
/// of nodes, not their places. Meshes that objects share are written once. The file is complete or not there. Throws
/// Error naming the file when there is something else than a case in its place, or it cannot be written; naming the
/// object for names that are not UTF-8, empty or taken; and for an answer that is no JSON.
void write_case(const Case& content, const std::filesystem::path& path);

/// Where two answers differ, and both: "/pairs/0/upper: recorded 1.5, now 1.25". Empty when every bit is the same;
/// warnings and the version of the program are not compared. Throws Error for what is no JSON.
[[nodiscard]] std::string answer_difference(const std::string& recorded, const std::string& now);

/// What asking again gave.
struct Replay {
  std::string answer;      ///< as in Case: the report, or the error
  std::string difference;  ///< from the recorded one (`answer_difference`); empty also where none is recorded
};

/// Asks the question of the case again. Throws Error when it holds none.
[[nodiscard]] Replay replay(const Case& content, const AskOptions& options = {});

/// What a case has for an answer where there was an Error with that message.
[[nodiscard]] std::string error_json(const std::string& message);

}  // namespace toccata
