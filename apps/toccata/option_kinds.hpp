#pragma once

#include <array>
#include <string>
#include <vector>

#include "arguments.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

// The options that several subcommands have.
namespace toccata::command {

inline constexpr const char* any_files =
    "mesh files (OBJ, STL, PLY, OFF, glTF, GLB, 3MF, STEP, IFC) or scene files (JSON)";

void add_input(CLI::App& app, InputArguments& input, const std::string& what);

/// An option that must say something where it is given; `missing` is told where it does not.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& text, const std::string& help,
                      const std::string& missing);

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& file, const std::string& help,
                      const std::string& type = "FILE");

CLI::Option* add_length(CLI::App& app, const std::string& name, std::string& length, const std::string& help);

/// So many numbers, by commas or spaces.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                         const std::string& help, int count, const std::string& type);

CLI::Option* add_point(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                       const std::string& help);

/// Where the objects of two files are: --pose-a and --pose-b.
std::array<CLI::Option*, 2> add_pose_pair(CLI::App& app, PosedArguments& arguments);

/// Where the objects of two files are, once or at many poses. Returns --poses.
CLI::Option* add_poses(CLI::App& app, PosedArguments& arguments);

CLI::Option* add_json(CLI::App& app, Format& format, const std::string& help);

/// How the answer is written. `report` names the page about its JSON.
void add_formats(CLI::App& app, Format& format, const std::string& report);

/// `made` is what does not depend on the threads.
CLI::Option* add_threads(CLI::App& app, int& threads, const std::string& made);

/// `what` is told in place of the usual help.
void add_save_case(CLI::App& app, std::string& file, const char* what = nullptr);

/// What shows the answer besides telling it.
void add_pages(CLI::App& app, PosedArguments& arguments);

void add_writing(CLI::App& app, PosedArguments& arguments, const std::string& report);

CLI::Option* add_solid(CLI::App& app, PosedArguments& arguments);

/// --close, for questions that it matters to whether a mesh is a solid.
CLI::Option* add_close(CLI::App& app, InputArguments& input);

/// --clearance and --clearance-of; returns both.
std::array<CLI::Option*, 2> add_clearances(CLI::App& app, CheckArguments& arguments);

CLI::Option* add_glb(CLI::App& app, PosedArguments& arguments, const char* names = "--glb");

/// Which axis points up.
CLI::Option* add_up(CLI::App& app, PosedArguments& arguments);

/// Adds `--png`, with `--size` and `--look` for the picture.
void add_picture(CLI::App& app, PosedArguments& arguments);

/// Poses and solids of what was written. Throws Error naming the option.
void take_words(PosedArguments& arguments);

/// The options that were given, but for those that say how an answer is written: what a case that is asked again would
/// not heed.
std::vector<std::string> asking_options(const CLI::App& app);

/// {0} in the text becomes what the command was called as.
std::string with_name(const char* text);

}  // namespace toccata::command
