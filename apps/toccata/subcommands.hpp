#pragma once

#include <array>
#include <functional>
#include <string>

#include "check_input.hpp"
#include "toccata/reports/scene_question.hpp"

namespace CLI {
class App;
}

// Each subcommand is in a file of its own: its options, what it does, and what people read of its answer.
namespace toccata::command {

/// One that was added to the program.
struct Subcommand {
  CLI::App* app;
  std::function<int()> run;  ///< the exit code: 0 nothing to report, 1 something. Trouble is an exception
};

Subcommand add_check(CLI::App& app);
Subcommand add_view(CLI::App& app);
Subcommand add_distance(CLI::App& app);
Subcommand add_ray(CLI::App& app);
Subcommand add_sweep(CLI::App& app);
Subcommand add_walk(CLI::App& app);
Subcommand add_faces(CLI::App& app);
Subcommand add_cost(CLI::App& app);
Subcommand add_plot(CLI::App& app);
Subcommand add_nearest(CLI::App& app);
Subcommand add_locate(CLI::App& app);
Subcommand add_minkowski(CLI::App& app);
Subcommand add_subdivide(CLI::App& app);
Subcommand add_replay(CLI::App& app);
Subcommand add_pairs(CLI::App& app);
Subcommand add_inspect(CLI::App& app);
Subcommand add_tree(CLI::App& app);
Subcommand add_decompose(CLI::App& app);
Subcommand add_crowd(CLI::App& app);
Subcommand add_demo(CLI::App& app);
Subcommand add_robot(CLI::App& app);

/// As --help lists them.
inline constexpr std::array all_subcommands = {
    add_check, add_view,    add_distance, add_ray,       add_sweep,     add_walk,      add_faces,
    add_cost,  add_plot,    add_nearest,  add_locate,    add_minkowski, add_subdivide, add_replay,
    add_pairs, add_inspect, add_tree,     add_decompose, add_crowd,     add_demo,      add_robot};

/// What people read of an answer.
std::string table_of(const CheckInput& input, const CheckReport& report);
std::string table_of(const CheckInput& input, const PosesReport& report);
std::string table_of(const CheckInput& input, const SelfReport& report);
std::string table_of(const CheckInput& input, const DistanceReport& report);
std::string table_of(const CheckInput& input, const DistancePosesReport& report);
std::string table_of(const CheckInput& input, const RayReport& report);
std::string table_of(const CheckInput& input, const SweepReport& report);
std::string table_of(const CheckInput& input, const WalkReport& report);
std::string table_of(const CheckInput& input, const FacesReport& report);
std::string table_of(const CheckInput& input, const NearestReport& report);
std::string table_of(const CheckInput& input, const InspectReport& report);
std::string table_of(const CheckInput& input, const RebalanceReport& report);
std::string table_of(const CheckInput& input, const CostReport& report);
std::string table_of(const CheckInput& input, const CrowdReport& report);
std::string table_of(const CheckInput& input, const CrowdWorldReport& report);
std::string table_of(const CheckInput& input, const DecomposeReport& report);
std::string table_of(const CheckInput& input, const MinkowskiReport& report);
std::string table_of(const CheckInput& input, const SubdivideReport& report);

/// An answer in a word.
struct Summary {
  std::string findings;   ///< how many of which kind: "2 pairs"
  bool is_found = false;  ///< something that the subcommand looks for: exit code 1
};

Summary summary_of(const CheckReport& report);
Summary summary_of(const PosesReport& report);
Summary summary_of(const SelfReport& report);
Summary summary_of(const DistanceReport& report);
Summary summary_of(const DistancePosesReport& report);
Summary summary_of(const RayReport& report);
Summary summary_of(const SweepReport& report);
Summary summary_of(const WalkReport& report);
Summary summary_of(const FacesReport& report);
Summary summary_of(const NearestReport& report);
Summary summary_of(const InspectReport& report);
Summary summary_of(const RebalanceReport& report);
Summary summary_of(const CostReport& report);
Summary summary_of(const CrowdReport& report);
Summary summary_of(const CrowdWorldReport& report);
Summary summary_of(const DecomposeReport& report);
Summary summary_of(const MinkowskiReport& report);
Summary summary_of(const SubdivideReport& report);

}  // namespace toccata::command
