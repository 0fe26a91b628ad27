#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "arguments.hpp"
#include "ask.hpp"
#include "case_asked.hpp"
#include "check_input.hpp"
#include "clearance.hpp"
#include "mesh_output.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

struct SubdivideArguments : PosedArguments {
  std::string scheme;   ///< as it is written; empty: by what the question has
  std::string within;   ///< a length; empty: by the size of the cage
  std::string creases;  ///< a file; empty: none
  bool sharp_corners = false;
  std::string mesh;  ///< a file for the mesh; empty: none
  SubdivideQuestion question;
};

/// What would be of no use is refused.
void require_use(const SubdivideArguments& arguments, std::size_t objects) {
  if (arguments.question.both && objects != 2) throw Error("--both is about two cages: name two files");
  if (arguments.solid && objects == 1)
    throw Error(
        "--solid tells what is taken for a solid where two objects are asked how far apart they are: name another "
        "file, or leave it out");
  if (objects == 1) return;
  if (!arguments.mesh.empty())
    throw Error("-o writes the mesh of one cage, and two objects are asked how far apart they are: name one file");
  if (arguments.question.levels > 0)
    throw Error(
        "--levels is about the mesh of one cage, and two objects are asked how far apart they are: name one file, or "
        "leave it out; --within tells how near");
}

/// What the options ask of what was read.
SubdivideQuestion question_of(const SubdivideArguments& arguments, const Scene& scene) {
  require_use(arguments, scene.objects.size());
  SubdivideQuestion question = arguments.question;
  if (arguments.scheme == "loop") question.scheme = SubdivisionScheme::loop;
  if (!arguments.creases.empty()) question.features = read_creases(arguments.creases);
  if (arguments.sharp_corners) question.features.border = CageBorder::sharp_corner;
  if (!arguments.within.empty()) {
    question.within = read_length("--within", arguments.within, length_units(scene, arguments.input), Longest::finite);
    if (question.within == 0) throw Error("--within 0: no mesh is nearer to a curved surface than that; write more");
  }
  return question;
}

std::string limit_text(const SubdividedMesh& mesh) {
  return fmt::format("{} and {}, proved to be nowhere farther than {:.3g} from the limit surface, nor it from them",
                     counted(mesh.mesh.triangle_count(), "triangle"),
                     counted(mesh.mesh.vertices().size(), "vertex", "vertices"), mesh.distance_to_limit);
}

std::string gap_text(const SubdivideReport& report) {
  const LimitDistance& gap = *report.gap;
  if (gap.upper == 0) return "they meet, proved";
  if (gap.lower == 0)
    return fmt::format("no farther apart than {:.3g}; whether they meet is undecided, which counts as contact",
                       gap.upper);
  return fmt::format("{:.12g} to {:.12g} apart, proved of the limit: from {} (within {:.2g} of it) to {}", gap.lower,
                     gap.upper, point_text(gap.on_mesh), gap.distance_to_limit, point_text(gap.on_model));
}

int run_subdivide(const SubdivideArguments& arguments, const std::vector<std::string>& asking) {
  require_mesh_output(arguments, arguments.mesh);
  const AlsoWritten mesh = [&](const CheckInput& input, const SceneAnswer& answer) {
    const auto* report = std::get_if<SubdivideReport>(&answer);
    if (arguments.mesh.empty() || report == nullptr) return std::string();
    if (!report->mesh)
      throw Error(
          "-o writes the mesh of one cage, and what is asked here is how far two objects are apart: leave it out");
    write_mesh_output({[&] { return report->mesh->mesh; }, [&] { return limit_object(*report); }},
                      input.loaded.scene.unit, arguments.mesh);
    return fmt::format("{}: {}.\n", printable(arguments.mesh),
                       counted(report->mesh->mesh.triangle_count(), "triangle"));
  };
  if (const auto code = answered_case(arguments, {.asks = "subdivide", .asking = asking}, mesh)) return *code;
  const CheckInput input = read_check_input(arguments);
  const SubdivideQuestion question = question_of(arguments, input.loaded.scene);
  return exit_code_of(answer_to(question, input, arguments, "refining", mesh));
}

}  // namespace

std::string table_of(const CheckInput&, const SubdivideReport& report) {
  std::string text = fmt::format("{}, {} cage of {}", printable(report.cage), report.closed ? "a closed" : "an open",
                                 counted(report.faces, "face"));
  text += report.mesh ? ": " + limit_text(*report.mesh) : ", and the other object: " + gap_text(report);
  const Status status = report.mesh ? report.mesh->status : report.gap->status;
  if (status == Status::not_converged && report.mesh && report.mesh->distance_to_limit <= report.within)
    text += ".\nSo many levels as --levels asks for were not reached: raise --triangles";
  else if (status == Status::not_converged)
    text += fmt::format(
        ".\n{:.3g} was asked for, and not reached: {}", report.within,
        report.mesh ? "raise --triangles or --within"
                    : "rounding, or --triangles, ended it: where surfaces coincide or are parallel, more seldom help");
  return text + ".\n";
}

Summary summary_of(const SubdivideReport& report) {
  if (report.mesh)
    return {counted(report.mesh->mesh.triangle_count(), "triangle"), report.mesh->status == Status::not_converged};
  return {report.gap->lower > 0 ? "apart" : "in contact", report.gap->lower == 0};
}

Subcommand add_subdivide(CLI::App& app) {
  const auto arguments = std::make_shared<SubdivideArguments>();
  CLI::App* subdivide =
      app.add_subcommand("subdivide", "the limit surface of a cage as a mesh, or how far it is from another object");
  add_input(*subdivide, arguments->input, "a cage: a mesh file with its faces; or a cage and another object");
  subdivide->add_option("--scheme", arguments->scheme, "how the cage is refined (catmull-clark)")
      ->check(CLI::IsMember({"loop", "catmull-clark"}));
  add_length(*subdivide, "--within", arguments->within,
             "how far mesh and limit may be apart, or how wide the interval of a distance: a length in units of "
             "--unit or the scene, or with its own (0.5, 2mm, 0.1in)");
  subdivide->add_option("--levels", arguments->question.levels, "refine every face of one cage at least so often")
      ->check(whole_number(0, 30));
  subdivide
      ->add_option("--triangles", arguments->question.max_triangles,
                   "at most so many; of two objects so many faces are looked at")
      ->check(whole_number(1, std::uint64_t{1} << 40))
      ->capture_default_str();
  add_file(*subdivide, "--creases", arguments->creases,
           "a file of sharp edges and corners: lines of crease A B [SHARPNESS] or corner V [SHARPNESS]");
  subdivide
      ->add_option("--crease-angle", arguments->question.crease_angle,
                   "edges whose faces turn by more than so many degrees are creases")
      ->check(number_between(0, 180));
  subdivide->add_flag("--sharp-corners", arguments->sharp_corners,
                      "vertices of one face on a border stay where they are");
  subdivide->add_flag("--both", arguments->question.both, "the second object is a cage, too");
  add_pose_pair(*subdivide, *arguments);
  add_solid(*subdivide, *arguments);
  add_file(*subdivide, "-o,--output", arguments->mesh, "write the mesh (OBJ, OFF, STL, PLY), or for Blender as GLB",
           "FILE");
  add_json(*subdivide, arguments->format, "write JSON (docs/reference/subdivide-report.md)");
  add_pages(*subdivide, *arguments);
  add_glb(*subdivide, *arguments);
  add_save_case(*subdivide, arguments->save_case);
  subdivide->footer(with_name(
      "What is told is proved of the limit surface (docs/methods/subdivision-surfaces.md). Of two objects the "
      "first is a cage.\n\n"
      "Exit code: 0; 1 where two objects meet or it is undecided, or the mesh is farther off than asked; 2 for "
      "trouble.\n\nExample:\n"
      "  {0} subdivide cage.obj --within 0.1mm --unit mm -o surface.obj\n"
      "  {0} subdivide cage.obj part.stl --within 1e-6\n"
      "  {0} subdivide cage.obj --crease-angle 60 -o surface.glb"));
  return {subdivide, [arguments, subdivide] {
            take_words(*arguments);
            return run_subdivide(*arguments, asking_options(*subdivide));
          }};
}

}  // namespace toccata::command
