#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "picture.hpp"
#include "toccata/reports/pages.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::command {

/// A page to be written, a GLB file, a picture: any of them.
struct ViewTarget {
  std::string path{};  ///< of the page; empty: it is not kept
  std::string glb{};   ///< of the GLB file; empty: none
  ViewOptions options{};
  std::optional<PictureTarget> picture{};
};

/// What a subcommand writes besides its answer. Throws Error for what is said of a picture where there is none, or no
/// picture can be.
ViewTarget target_of(const PosedArguments& arguments);

/// Whether there is anything to be written.
bool draws_something(const ViewTarget& target);

/// Throws Error, before long work, when one cannot be written, two are one file, or one is among the files that are
/// read.
void require_view(const ViewTarget& target, const PosedArguments& arguments);
void require_view(const PosedArguments& arguments);

/// Its name ends with ".json", however that is spelled.
bool is_json(const std::string& file);

/// As the option says, else as the files do.
UpAxis up_of(const PosedArguments& arguments);

/// Y for glTF and GLB, whose standard says so, when all files are such; else Z.
UpAxis up_of(const std::vector<std::string>& files);

/// The names of the files, as short as they tell something.
std::string title_of(const std::vector<std::string>& files);

/// `answer` has faces, where the page shall show them. Throws Error for a GLB file of what none can show.
void write_view(const ViewTarget& target, const CheckInput& input, const SceneAnswer& answer);

/// Writes what was made of each that the target names.
void write_files(const ViewTarget& target, const std::string& page, const std::string& glb);

/// A line for each file that was written, with what it `holds`.
std::string written_lines(const ViewTarget& target, const std::string& holds);

}  // namespace toccata::command
