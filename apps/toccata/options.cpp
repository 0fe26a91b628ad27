#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "option_kinds.hpp"
#include "question_options.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/generate/crowds.hpp"
#include "toccata/io/crowd_report.hpp"
#include "whole_number.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

void add_cost(CLI::App& app, Options& options) {
  CLI::App* cost =
      app.add_subcommand("cost", "which bounding volume and hierarchy is cheapest for two meshes, measured");
  add_input(*cost, options.cost.input, "two files of one mesh each");
  add_poses(*cost, options, options.cost.poses);
  CostWords& words = options.cost_words;
  const auto list = [&](const char* name, std::vector<std::string>& values, const char* what) {
    cost->add_option(name, values, what)->delimiter(',')->allow_extra_args(false)->type_name("WORD,…");
  };
  cost->add_option("--task", words.task, "what is asked at each pose: overlap, contacts or distance")
      ->capture_default_str();
  list("--workloads", words.workloads, "rigid, refit, rebuild (default: all)");
  list("--volumes", words.volumes, "aabb, obb, 26-dop, … (default: all)");
  list("--builders", words.builders, "heuristic, mean, median, morton, agglomeration, insertion (default: all)");
  cost->add_option("--arities", words.arities, "children a node (default: 2,4,8)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check([](const std::string& number) { return number.empty() ? "a number must be given" : std::string(); })
      ->type_name("NUMBER,…");
  cost->add_option("--leaf-size", words.leaf_size, "triangles in a leaf, at most")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  CLI::Option* quick = cost->add_flag("--quick", words.quick, "two builders and two arities, and only what is fast");
  cost->add_flag("--all", words.all, "also what takes long: of large meshes some is left out")->excludes(quick);
  cost->add_option("--rows", options.cost.rows, "how many rows of each table to show; 0: all")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  add_file(*cost, "--svg", options.cost.svg,
           "also draw the cheapest hierarchy of each volume as bars (docs/reference/plots.md)", "FILE.svg");
  add_formats(*cost, options, "docs/reference/cost-report.md");
  add_pages(*cost, options.cost);
  add_glb(*cost, options.cost);
  add_save_case(*cost, options.cost.save_case);
  cost->footer(
      with_name("F = N_u·C_u + N_bv·C_bv + N_p·C_p: volumes updated, volumes compared and triangles compared, by what "
                "one of each costs (docs/methods/cost-function.md).\n\nExit code: 0, or 2 for trouble.\n\nExample:\n"
                "  {0} cost part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0 --quick\n"
                "  {0} cost robot.stl table.obj --poses path.txt --task distance"));
}

void add_minkowski(CLI::App& app, Options& options) {
  MinkowskiArguments& arguments = options.minkowski;
  CLI::App* minkowski = app.add_subcommand("minkowski", "the Minkowski sum or difference of two convex shapes, exact");
  add_input(*minkowski, arguments.input, "two convex shapes: files of one object each, or a scene file of two");
  add_pose_pair(*minkowski, options);
  minkowski->add_flag("--difference", arguments.question.difference, "A − B, all a − b, instead of A + B, all a + b");
  minkowski->add_flag("--hull", arguments.question.hulls, "of meshes that are not convex take the convex hulls");
  add_point(*minkowski, "--point", options.point, "tell whether this point lies in it, exactly");
  add_file(*minkowski, "-o,--output", arguments.mesh,
           "write the boundary as a mesh (OBJ, OFF, STL, PLY), or for Blender as GLB", "FILE");
  minkowski->add_flag("--json", options.json, "write JSON (docs/reference/minkowski-report.md)");
  add_pages(*minkowski, arguments);
  add_glb(*minkowski, arguments);
  add_save_case(*minkowski, arguments.save_case);
  minkowski->footer(
      with_name("B moved by a vector meets A exactly when the vector lies in A − B (docs/methods/minkowski.md).\n\n"
                "Exit code: 0; with --point 1 where it lies outside; 2 for trouble.\n\nExample:\n"
                "  {0} minkowski part.stl tool.obj -o sum.obj\n"
                "  {0} minkowski part.stl tool.obj --difference --point 0 0 0.5"));
}

void add_plot(CLI::App& app, Options& options) {
  CLI::App* plot = app.add_subcommand("plot", "draw a report of `cost` or of a benchmark");
  plot->add_option("file", options.plot.file, "the report in JSON")->required()->type_name("FILE.json");
  add_file(*plot, "-o,--output", options.plot.svg, "the picture to write", "FILE.svg")->required();
  plot->footer(
      with_name("Exit code: 0 written, 2 trouble.\n\nExample:\n"
                "  {0} cost a.stl b.stl --json > cost.json\n  {0} plot cost.json -o cost.svg"));
}

void add_replay(CLI::App& app, Options& options) {
  ReplayArguments& arguments = options.replay;
  CLI::App* replay = app.add_subcommand("replay", "ask what a case file asks again, and compare the answer");
  replay->add_option("file", arguments.file, "a file that --save-case wrote")->required();
  add_formats(*replay, options, "that of the question");
  add_threads(*replay, arguments.threads, "answer");
  add_save_case(*replay, arguments.save_case, "write the case with the answer of now");
  replay->footer(with_name(
      "Exit code: 0 the answer is the recorded one to the bit, or none is recorded; 1 it is another; 2 trouble.\n\n"
      "Example:\n"
      "  {0} distance a.stl b.obj --save-case case.json\n"
      "  {0} replay case.json"));
}

void add_pairs(CLI::App& app, Options& options) {
  CLI::App* pairs = app.add_subcommand("pairs", "which questions are answered about which shapes, and why not");
  pairs->add_flag("--json", options.json, "write JSON (docs/reference/pairs.md)");
  pairs->footer(with_name("Example:\n  {0} pairs"));
}

void add_inspect(CLI::App& app, Options& options) {
  CLI::App* inspect = app.add_subcommand("inspect", "what meshes and shapes are: watertight? degenerate? how large?");
  add_input(*inspect, options.inspect.input, "mesh or scene files");
  CLI::Option* volumes =
      inspect->add_flag("--volumes", options.inspect.volumes,
                        "every bounding volume and hierarchy of each mesh: size, tightness, memory, time to build");
  CLI::Option* partitions = inspect->add_flag(
      "--partitions", options.inspect.partitions,
      "every partition of space over each mesh: cells, copies, overlap, memory, time to build and ask");
  inspect
      ->add_flag("--hierarchy", options.inspect.hierarchy,
                 "how good the tree of nodes is as a hierarchy, and what rebalancing it gains")
      ->excludes(volumes)
      ->excludes(partitions);
  inspect->add_flag("--faults", options.inspect.faults,
                    "where the edges, triangles and vertices are that are out of order");
  inspect->add_flag("--json", options.json, "write JSON (docs/reference/inspect-report.md)");
  add_threads(*inspect, options.inspect.threads, "answer");
  add_pages(*inspect, options.inspect);
  add_glb(*inspect, options.inspect);
  add_save_case(*inspect, options.inspect.save_case);
  inspect->footer(
      with_name("Nothing is repaired; everything is counted exactly. Where a mesh intersects itself is told "
                "by `{0} check FILE --self`.\n\nExample:\n  {0} inspect part.stl\n"
                "  {0} inspect machine.glb --hierarchy"));
}

void add_tree(CLI::App& app, Options& options) {
  CLI::App* tree = app.add_subcommand("tree", "save the tree over a mesh, or look whether one belongs to it");
  tree->add_option("file", options.tree.file, "a file with one mesh")->required();
  CLI::Option* save = add_file(*tree, "--save", options.tree.save, "write the tree here");
  add_file(*tree, "--check", options.tree.check, "look through this tree")->excludes(save);
  add_threads(*tree, options.tree.threads, "tree");
  tree->footer(
      with_name("Programs read it with load_model (docs/reference/tree-file.md).\n\n"
                "Exit code: 0 saved, or right; 2 trouble: damaged, or of another mesh.\n\n"
                "Example:\n  {0} tree part.stl --save part.tree\n  {0} tree part.stl --check part.tree"));
}

void add_decompose(CLI::App& app, Options& options) {
  DecomposeArguments& arguments = options.decompose;
  CLI::App* decompose = app.add_subcommand("decompose", "cut a closed mesh into convex parts that contain it");
  add_input(*decompose, arguments.input, "a file with one closed mesh");
  decompose->add_option("--parts", arguments.question.max_parts, "at most so many")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  add_length(*decompose, "--concavity", arguments.concavity,
             "cut no further where no point of a part is farther than this from the solid: a length in units of the "
             "scene or with its own (0.5, 2mm, 0.1in)");
  add_glb(*decompose, arguments, "-o,--output,--glb");
  add_pages(*decompose, arguments);
  add_save_case(*decompose, arguments.save_case);
  add_threads(*decompose, arguments.threads, "parts");
  decompose->add_flag("--json", options.json, "write JSON (docs/reference/decompose-report.md)");
  decompose->footer(with_name(
      "Each part is convex, and together they contain the whole solid; how much more they are is told "
      "(docs/methods/convex-decomposition.md).\n\nExit code: 0, or 2 for trouble.\n\n"
      "Example:\n  {0} decompose part.stl -o parts.glb\n  {0} decompose gen:torus --parts 16 --html parts.html"));
}

/// What a case of a crowd says itself.
std::vector<CLI::Option*> add_flight(CLI::App& app, CrowdArguments& crowd) {
  std::vector<std::string> methods;
  for (const BroadPhaseMethod method : broad_phase_methods()) methods.emplace_back(name_of(method));
  const auto positive = CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000});
  return {
      app.add_option("--count", crowd.count, "boxes or bodies")->check(positive)->capture_default_str(),
      app.add_option("--frames", crowd.frames, "the median of their times is told")
          ->check(positive)
          ->capture_default_str(),
      app.add_option("--seed", crowd.seed, "another seed, another crowd")->check(whole_number())->capture_default_str(),
      add_threads(app, crowd.threads, "pairs")->capture_default_str(),
      app.add_option("--method", crowd.method, "how pairs are found")
          ->check(CLI::IsMember(methods))
          ->capture_default_str()};
}

/// What bodies in a World do not have.
std::vector<CLI::Option*> add_boxes(CLI::App& app, CrowdArguments& crowd) {
  std::vector<std::string> scenes, bounds;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  for (const CrowdBounds one : all_crowd_bounds) bounds.emplace_back(name_of(one));
  return {app.add_option("--scene", crowd.scene, "how they lie and move")
              ->check(CLI::IsMember(scenes))
              ->capture_default_str(),
          app.add_option("--bounds", crowd.bounds,
                         "what bounds each: its box, the ball around that, or the box turned (oriented)")
              ->check(CLI::IsMember(bounds))
              ->capture_default_str(),
          app.add_option("--cells", crowd.cells,
                         "which cells the page shows: those of the method, or of a grid those that boxes enter, keep "
                         "and leave")
              ->check(CLI::IsMember({"method", "tracked"}))
              ->capture_default_str()};
}

void add_crowd(CLI::App& app, Options& options) {
  CLI::App* crowd = app.add_subcommand("crowd", "many moving boxes: which overlap, frame by frame, and how fast");
  CLI::Option* files =
      crowd->add_option("case", options.crowd.input.files, "a case of a crowd, to be answered again")->expected(0, 1);
  const std::vector<CLI::Option*> flight = add_flight(*crowd, options.crowd), boxes = add_boxes(*crowd, options.crowd);
  CLI::Option* compare =
      crowd->add_flag("--compare", options.crowd.compare, "all methods that can bear so many, one after the other");
  compare->excludes(flight.back());
  CLI::Option* world = crowd->add_flag(
      "--world", options.crowd.world,
      "instead of boxes, spheres, boxes, capsules and hulls that fly in a World: which are in contact, exactly");
  world->excludes(compare);
  for (CLI::Option* option : boxes) world->excludes(option->excludes(files));
  for (CLI::Option* option : flight) option->excludes(files);
  compare->excludes(files);
  world->excludes(files);
  add_file(*crowd, "--html", options.crowd.html,
           "also write a page of the boxes, their pairs and the method's cells, frame by frame", "FILE.html");
  add_picture(*crowd, options.crowd);
  add_glb(*crowd, options.crowd);
  add_save_case(
      *crowd, options.crowd.save_case,
      "write the question and the answer into one file; `replay` asks it again (docs/reference/case-file.md)");
  crowd->add_flag("--json", options.json, "write JSON (docs/reference/crowd.md)");
  crowd->footer(
      with_name("Exit code: 0, or 2 for trouble; of a case also 1, where its answer is another.\n\n"
                "Example:\n  {0} crowd --count 100000 --scene clustered\n  {0} crowd --count 5000 --compare\n"
                "  {0} crowd --count 2000 --frames 100 --html crowd.html\n"
                "  {0} crowd --world --count 500 --frames 60 --html world.html --save-case world.json\n"
                "  {0} crowd world.json --glb world.glb"));
}

void add_demo(CLI::App& app, Options& options) {
  CLI::App* demo = app.add_subcommand("demo", "the main job on generated scenes, no file needed");
  add_text(*demo, "--write", options.demo.write_folder, "write the scenes as files to play with, into this folder",
           "a folder must be named");
  add_threads(*demo, options.demo.threads, "answer");
  demo->add_flag("--json", options.json, "write the answers as JSON");
  demo->footer(with_name("Example:\n  {0} demo\n  {0} demo --write scenes"));
}

}  // namespace

void add_subcommands(CLI::App& app, Options& options) {
  add_check(app, options);
  add_view(app, options);
  add_distance(app, options);
  add_ray(app, options);
  add_faces(app, options);
  add_cost(app, options);
  add_plot(app, options);
  add_nearest(app, options);
  add_minkowski(app, options);
  add_replay(app, options);
  add_pairs(app, options);
  add_inspect(app, options);
  add_tree(app, options);
  add_decompose(app, options);
  add_crowd(app, options);
  add_demo(app, options);
}

std::string with_name(const char* text) { return fmt::format(fmt::runtime(text), called_as()); }

}  // namespace toccata::command
