#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/io/scene_question.hpp"
#include "toccata/shapes/scene.hpp"

// A report in JSON that says what was asked (docs/reference/asked.md), so that the question can be asked again.
namespace toccata {

/// A file that was asked about.
struct AskedFile {
  std::string name;    ///< as it was given: a path, or "gen:…"
  std::string digest;  ///< of what it held (`content_digest`)
};

/// What was asked about which files.
struct Asked {
  std::string folder;            ///< where relative names of files began; absolute
  std::vector<AskedFile> files;  ///< none of a crowd
  std::string unit{};            ///< of plain mesh files, as `metres_per_unit` takes it; empty: as the files say
  double scale = 1;              ///< of all files; positive
  std::optional<Pose> pose_a{};  ///< of everything in the first of two files; composed with what the file says
  std::optional<Pose> pose_b{};  ///< of the second
  std::optional<Solid> solid{};  ///< overrides what the files say
  SceneQuestion question{};
};

/// 16 hexadecimal digits that tell apart objects of other names, shapes, poses, groups, taken for something else, or of
/// a scene in another unit (`Scene::unit`): equal by chance for one in 2⁶⁴. Where a shape came from does not count.
[[nodiscard]] std::string content_digest(std::span<const SceneObject> objects, const std::string& unit);

/// The same of a scene with its tree of nodes, for a question about that.
[[nodiscard]] std::string content_digest(const Scene& scene);

/// The report that `report_json` made, with what was asked as its last member.
[[nodiscard]] std::string with_asked(std::string report, const Asked& asked);

/// A report from a file.
struct SavedReport {
  Asked asked;
  std::vector<std::string> sources;  ///< of its objects, in their order
  std::string answer;                ///< the whole report, as JSON
};

/// Whether the file is a JSON object with a "schema" of Toccata: a report, and neither a scene nor a case. Throws Error
/// naming the file when it cannot be read or is no JSON.
[[nodiscard]] bool is_report(const std::filesystem::path& path);

/// Throws Error naming the file and the place in it; also for a report that does not say what was asked.
[[nodiscard]] SavedReport read_report(const std::filesystem::path& path);

}  // namespace toccata
