#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "load.hpp"
#include "mesh_output.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct MinkowskiArguments : PosedArguments {
  std::string mesh;  ///< a file for the boundary; empty: none
  MinkowskiQuestion question;
  std::vector<std::string> point;  ///< as it is written
};

std::string faces_text(const MinkowskiSum& sum) {
  std::array<std::size_t, 4> kinds{};
  for (Index f = 0; f < sum.topology().face_count(); ++f) ++kinds[static_cast<std::size_t>(sum.face_kind(f))];
  return fmt::format(" and {}: {} of A, {} of B, {} of both, {} of edges", counted(sum.topology().face_count(), "face"),
                     kinds[0], kinds[1], kinds[2], kinds[3]);
}

/// What the sum is; with a radius, what a ball grows it to.
std::string shape_text_of(const MinkowskiSum& sum) {
  const double radius = sum.radius();
  const bool has_radius = radius > 0;
  if (sum.dimension() == 0)
    return has_radius ? fmt::format("a ball of radius {:.12g} around {}", radius, point_text(sum.vertex(0)))
                      : fmt::format("the point {}", point_text(sum.vertex(0)));
  if (sum.dimension() == 1) {
    const std::string ends = fmt::format("from {} to {}", point_text(sum.vertex(0)), point_text(sum.vertex(1)));
    return has_radius ? fmt::format("a capsule of radius {:.12g} {}", radius, ends) : "a segment " + ends;
  }
  const std::string text = fmt::format("{} of {}{}", sum.dimension() == 2 ? "a flat polygon" : "a solid",
                                       counted(sum.vertex_count(), "vertex", "vertices"), faces_text(sum));
  return has_radius ? fmt::format("{}; grown by a ball of radius {:.12g}", text, radius) : text;
}

std::string point_line(const MinkowskiSum& sum, const Vec3& point) {
  const Sign side = sum.side_of(point);
  return fmt::format("{} {}\n", point_text(point),
                     side == Sign::zero ? "lies on the boundary" : fmt::format("lies {}", name_of_side(side)));
}

std::string written_sum(const MinkowskiReport& report, const std::string& unit, const std::string& file) {
  write_mesh_output({[&] { return report.sum.as_mesh(); }, [&] { return sum_object(report); }}, unit, file);
  const double radius = is_glb(file) ? 0 : report.sum.radius();
  return fmt::format("{}: {} with {}{}.\n", printable(file), name_of(report.question),
                     counted(report.sum.topology().face_count(), "face"),
                     radius > 0 ? fmt::format(", without the ball of radius {:.12g} that grows it", radius) : "");
}

int run_minkowski(const MinkowskiArguments& arguments) {
  require_mesh_output(arguments, arguments.mesh);
  const AlsoWritten mesh = [&](const CheckInput& input, const SceneAnswer& answer) {
    const auto* report = std::get_if<MinkowskiReport>(&answer);
    if (arguments.mesh.empty() || report == nullptr) return std::string();
    return written_sum(*report, input.loaded.scene.unit, arguments.mesh);
  };
  const bool asks_itself = changes_objects(arguments) || arguments.question != MinkowskiQuestion{};
  if (const auto code = answered_case(arguments, {"minkowski", asks_itself}, mesh)) return *code;
  const CheckInput input = read_check_input(arguments);
  return exit_code_of(answer_to(arguments.question, input, arguments, "adding", mesh));
}

}  // namespace

std::string table_of(const CheckInput&, const MinkowskiReport& report) {
  const MinkowskiSum& sum = report.sum;
  std::string text = fmt::format("{} of A = {} and B = {}: {}\n", name_of(report.question), printable(report.a),
                                 printable(report.b), shape_text_of(sum));
  return report.question.point ? text + point_line(sum, *report.question.point) : text;
}

Summary summary_of(const MinkowskiReport& report) {
  const auto& point = report.question.point;
  return {"their " + name_of(report.question), point && !report.sum.contains(*point)};
}

Subcommand add_minkowski(CLI::App& app) {
  const auto arguments = std::make_shared<MinkowskiArguments>();
  CLI::App* minkowski = app.add_subcommand("minkowski", "the Minkowski sum or difference of two convex shapes, exact");
  add_input(*minkowski, arguments->input, "two convex shapes: files of one object each, or a scene file of two");
  add_pose_pair(*minkowski, *arguments);
  minkowski->add_flag("--difference", arguments->question.difference, "A − B, all a − b, instead of A + B, all a + b");
  minkowski->add_flag("--hull", arguments->question.hulls, "of meshes that are not convex take the convex hulls");
  add_point(*minkowski, "--point", arguments->point, "tell whether this point lies in it, exactly");
  add_file(*minkowski, "-o,--output", arguments->mesh,
           "write the boundary as a mesh (OBJ, OFF, STL, PLY), or for Blender as GLB", "FILE");
  add_json(*minkowski, arguments->format, "write JSON (docs/reference/minkowski-report.md)");
  add_pages(*minkowski, *arguments);
  add_glb(*minkowski, *arguments);
  add_save_case(*minkowski, arguments->save_case);
  minkowski->footer(
      with_name("B moved by a vector meets A exactly when the vector lies in A − B (docs/methods/minkowski.md).\n\n"
                "Exit code: 0; with --point 1 where it lies outside; 2 for trouble.\n\nExample:\n"
                "  {0} minkowski part.stl tool.obj -o sum.obj\n"
                "  {0} minkowski part.stl tool.obj --difference --point 0 0 0.5"));
  return {minkowski, [arguments] {
            take_words(*arguments);
            if (!arguments->point.empty()) arguments->question.point = parse_point(arguments->point, "--point");
            return run_minkowski(*arguments);
          }};
}

}  // namespace toccata::command
