#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/generate/crowds.hpp"
#include "whole_number.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

constexpr const char* any_files = "mesh files (OBJ, STL, PLY, OFF, glTF, GLB) or scene files (JSON)";

void add_input(CLI::App& app, InputArguments& input, const std::string& what) {
  input.wanted = what;
  app.add_option("files", input.files, what);
  app.add_option(
      "--unit", input.unit,
      "unit of the numbers in mesh files: mm, cm, m, km, in, ft, or metres per unit; the world, with it the t of "
      "given poses and all printed points, is then in metres");
  app.add_option("--scale", input.scale, "multiply all coordinates of the files by this");
}

/// An option that must say something where it is given; `missing` is told where it does not.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& text, const std::string& help,
                      const std::string& missing) {
  return app.add_option(name, text, help)->check([missing](const std::string& word) {
    return word.empty() ? missing : std::string();
  });
}

CLI::Option* add_file(CLI::App& app, const std::string& name, std::string& file, const std::string& help,
                      const std::string& type = "FILE") {
  return add_text(app, name, file, help, "a file must be named")->type_name(type);
}

CLI::Option* add_length(CLI::App& app, const std::string& name, std::string& length, const std::string& help) {
  return add_text(app, name, length, help, "a length must be given")->type_name("LENGTH");
}

/// So many numbers, by commas or spaces.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                         const std::string& help, int count, const std::string& type) {
  return app.add_option(name, numbers, help)->expected(count)->delimiter(',')->allow_extra_args(false)->type_name(type);
}

CLI::Option* add_point(CLI::App& app, const std::string& name, std::vector<std::string>& numbers,
                       const std::string& help) {
  return add_numbers(app, name, numbers, help, 3, "X Y Z");
}

/// Where the objects of two files are: --pose-a and --pose-b.
std::array<CLI::Option*, 2> add_pose_pair(CLI::App& app, Options& options) {
  const auto pose = [&](const char* name, std::vector<std::string>& numbers, const char* what) {
    return app.add_option(name, numbers, what)->expected(12)->allow_extra_args(false)->type_name("12 NUMBERS");
  };
  return {pose("--pose-a", options.pose_a, "places the first of two files: R row by row, then t"),
          pose("--pose-b", options.pose_b, "places the second of two files: R row by row, then t")};
}

/// Where the objects of two files are, once or at many poses. Returns --poses.
CLI::Option* add_poses(CLI::App& app, Options& options, std::string& poses) {
  const auto [pose_a, pose_b] = add_pose_pair(app, options);
  return add_file(app, "--poses", poses,
                  "answers for two objects at many poses: a file with 12 or 24 numbers a line "
                  "(docs/reference/poses-file.md)")
      ->excludes(pose_a)
      ->excludes(pose_b);
}

/// How the answer is written. `report` names the page about its JSON.
void add_formats(CLI::App& app, Options& options, const std::string& report) {
  CLI::Option* json = app.add_flag("--json", options.json, "write JSON (" + report + ")");
  app.add_flag("--csv", options.csv, "write comma-separated values")->excludes(json);
}

/// `made` is what does not depend on the threads.
void add_threads(CLI::App& app, int& threads, const std::string& made) {
  app.add_option("--threads", threads, "threads to use; 0: as many as there are; same " + made + " for any")
      ->check(CLI::Range(0, 1024));
}

void add_save_case(CLI::App& app, std::string& file, const char* what) {
  app.add_option("--save-case", file, what)
      ->check([](const std::string& name) { return name.empty() ? "a file must be named" : std::string(); })
      ->type_name("FILE.json");
}

/// What shows the answer besides telling it.
void add_pages(CLI::App& app, PosedArguments& arguments) {
  add_file(app, "--html", arguments.html, "also write a page that shows the objects and what was found", "FILE.html");
  add_file(app, "--png", arguments.png, "also draw a picture of that page, where Chromium is installed", "FILE.png");
}

void add_writing(CLI::App& app, Options& options, PosedArguments& arguments, const std::string& report) {
  add_formats(app, options, report);
  add_threads(app, arguments.threads, "answer");
  add_pages(app, arguments);
  add_save_case(app, arguments.save_case,
                "write the shapes, the question and the answer into one file, for a bug report or a test; `replay` "
                "asks it again (docs/reference/case-file.md)");
}

CLI::Option* add_solid(CLI::App& app, Options& options) {
  return app
      .add_option("--solid", options.solid,
                  "auto: closed meshes are solids; all: an open mesh is an error; none: all are surfaces "
                  "(default: as the scene says, else auto)")
      ->check(CLI::IsMember({"auto", "all", "none"}));
}

/// --clearance and --clearance-of; returns both.
std::array<CLI::Option*, 2> add_clearances(CLI::App& app, CheckArguments& arguments) {
  CLI::Option* clearance =
      add_length(app, "--clearance", arguments.clearance,
                 "also tell pairs that are at most so far apart, and how far: a length in units of the scene or with "
                 "its own (0.5, 2mm, 0.1in); all: every pair");
  CLI::Option* clearance_of =
      app.add_option("--clearance-of", arguments.clearances_of, "another clearance for two objects; may be repeated")
          ->type_name("NAME,NAME=LENGTH")
          ->expected(1)
          ->allow_extra_args(false)
          ->take_all();
  return {clearance, clearance_of};
}

CLI::Option* add_glb(CLI::App& app, CheckArguments& arguments) {
  return add_file(app, "--glb", arguments.glb,
                  "write the objects and what was found as a GLB file, for Blender (docs/reference/glb-file.md)",
                  "FILE.glb");
}

void add_check(CLI::App& app, Options& options) {
  CLI::App* check = app.add_subcommand("check", "which objects touch, decided exactly");
  add_input(*check, options.check.input, any_files);
  CLI::Option* poses = add_poses(*check, options, options.check.poses);
  CLI::Option* solid = add_solid(*check, options);
  CLI::Option* touching = check->add_option("--touching", options.touching, "whether merely touching counts")
                              ->check(CLI::IsMember({"count", "ignore"}))
                              ->capture_default_str();
  CLI::Option* penetration = check->add_flag("--penetration", options.check.penetration,
                                             "how deep solids overlap, a way to part them, their regions of contact "
                                             "and (without --poses) their points of contact");
  const auto [clearance, clearance_of] = add_clearances(*check, options.check);
  clearance->excludes(poses);
  clearance_of->excludes(poses);
  CLI::Option* glb = add_glb(*check, options.check)->excludes(poses);
  check
      ->add_flag("--self", options.check.self,
                 "each object against itself, instead of against the others: where its own faces meet")
      ->excludes(poses)
      ->excludes(penetration)
      ->excludes(clearance)
      ->excludes(clearance_of)
      ->excludes(glb)
      ->excludes(solid)
      ->excludes(touching);
  check->add_flag("--faces", options.check.faces,
                  "list the faces that meet, by the files' own numbers from 0; with --poses, count them");
  add_writing(*check, options, options.check, "docs/reference/check-report.md");
  check->footer(
      with_name("Exit code: 0 nothing touches or is nearer than its clearance, 1 something is, 2 trouble.\n\n"
                "Example:\n"
                "  {0} demo --write scenes\n"
                "  {0} check scenes/a.obj scenes/b.stl --faces\n"
                "  {0} check part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0\n"
                "  {0} check robot.stl table.obj --poses path.txt --csv\n"
                "  {0} check part.stl --self --faces\n"
                "  {0} check shapes.json --penetration\n"
                "  {0} check cell.json --clearance 2mm --clearance-of robot,table=5cm\n"
                "  {0} check a.stl b.stl --html report.html\n"
                "  {0} check scenes/shelf/scene.json --json"));
}

/// Of `look` and `size` where there is a picture.
void add_picture(CLI::App& app, std::string& png, std::string& size, std::string& look) {
  add_file(app, "--png", png, "draw a picture of the page, where Chromium is installed", "FILE.png");
  add_text(app, "--size", size, "of the picture (default: 1200x800)", "a size must be given")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--look", look, "what the picture shows: the end of a link to the page, 'finding=0&theme=dark'")
      ->type_name("TEXT");
}

void add_view(CLI::App& app, Options& options) {
  ViewArguments& arguments = options.view;
  CLI::App* view = app.add_subcommand("view", "write a page that shows the objects, what was found, and why");
  add_input(*view, arguments.input, any_files);
  add_file(*view, "-o,--output", arguments.html, "the page to write", "FILE.html");
  add_glb(*view, arguments);
  add_pose_pair(*view, options);
  add_solid(*view, options);
  view->add_flag("--penetration", arguments.penetration,
                 "also how deep solids overlap, and their points and regions of contact");
  add_clearances(*view, arguments);
  add_text(*view, "--hierarchy", arguments.hierarchy,
           "also the levels of a hierarchy over each mesh, of these volumes: aabb, ball, cube, obb, 6-dop, …, "
           "rss, ellipsoid, hull; wide: the tree that queries use",
           "a volume must be named")
      ->type_name("VOLUME");
  add_picture(*view, arguments.png, arguments.size, arguments.look);
  view->add_option("--up", arguments.up, "which axis points up (default: y for glTF, else z)")
      ->check(CLI::IsMember({"y", "z"}));
  add_threads(*view, arguments.threads, "page");
  add_save_case(*view, arguments.save_case, "also write what is shown as a case (docs/reference/case-file.md)");
  view->footer(
      with_name("The page is one file that any browser with WebGL 2 opens from disk: no network, no server.\n\n"
                "Exit code: 0 written, 2 trouble.\n\nExample:\n"
                "  {0} view a.stl b.obj -o touch.html\n"
                "  {0} view scene.json --penetration --clearance 2mm -o scene.html\n"
                "  {0} view bunny.ply --hierarchy obb -o tree.html\n"
                "  {0} view scene.json --glb scene.glb\n"
                "  {0} ray part.stl --from 0 0 5 --to 0 0 -5 --json > report.json\n"
                "  {0} view report.json -o report.html\n"
                "  {0} view a.stl b.obj --png touch.png --look 'finding=0'"));
}

void add_distance(CLI::App& app, Options& options) {
  CLI::App* distance = app.add_subcommand("distance", "how far apart shapes are, certified");
  add_input(*distance, options.distance.input,
            "one file (all pairs of its objects) or two (pairs of one of each): meshes or scenes");
  add_poses(*distance, options, options.distance.poses);
  add_solid(*distance, options);
  add_writing(*distance, options, options.distance, "docs/reference/distance-report.md");
  distance->footer(
      with_name("Exit code: 0 nothing meets, 1 something does, 2 trouble.\n\nExample:\n  {0} distance a.stl b.obj\n"
                "  {0} distance shapes.json\n  {0} distance robot.json table.json --poses path.txt --csv"));
}

void add_ray(CLI::App& app, Options& options) {
  CLI::App* ray = app.add_subcommand("ray", "what a ray meets first, decided exactly");
  add_input(*ray, options.ray.input, any_files);
  CLI::Option* from = add_point(*ray, "--from", options.from, "where the ray starts, in the world");
  CLI::Option* to = add_point(*ray, "--to", options.to, "where it ends");
  add_file(*ray, "--rays", options.ray.rays, "many rays: a file with six numbers a line, where each starts and ends")
      ->excludes(from)
      ->excludes(to);
  add_solid(*ray, options);
  add_writing(*ray, options, options.ray, "docs/reference/ray-report.md");
  ray->footer(
      with_name("A solid is met at once by a ray that starts inside; --solid=none asks about surfaces alone.\n\n"
                "Exit code: 0 nothing is met, 1 something is, 2 trouble.\n\nExample:\n"
                "  {0} ray part.stl --from 0 0 5 --to 0 0 -5\n  {0} ray scene.json --rays rays.txt --csv"));
}

void add_faces(CLI::App& app, Options& options) {
  CLI::App* faces = app.add_subcommand("faces", "which faces lie in a box or a ball, wholly or in part");
  add_input(*faces, options.faces.input, any_files);
  CLI::Option* box = add_numbers(*faces, "--box", options.box, "the least corner and the greatest, in the world", 6,
                                 "X0 Y0 Z0 X1 Y1 Z1");
  add_numbers(*faces, "--ball", options.ball, "centre and radius", 4, "X Y Z R")->excludes(box);
  add_writing(*faces, options, options.faces, "docs/reference/faces-report.md");
  faces->footer(
      with_name("Touching counts. Faces are the files' own, from 0.\n\n"
                "Exit code: 0 there is none, 1 there is one, 2 trouble.\n\nExample:\n"
                "  {0} faces part.stl --box 0 0 0  1 1 1\n  {0} faces scene.json --ball 0 0 5 0.25 --csv"));
}

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
  cost->footer(
      with_name("F = N_u·C_u + N_bv·C_bv + N_p·C_p: volumes updated, volumes compared and triangles compared, by what "
                "one of each costs (docs/methods/cost-function.md).\n\nExit code: 0, or 2 for trouble.\n\nExample:\n"
                "  {0} cost part.stl part.stl --pose-b 1 0 0  0 1 0  0 0 1  0.5 0 0 --quick\n"
                "  {0} cost robot.stl table.obj --poses path.txt --task distance"));
}

void add_plot(CLI::App& app, Options& options) {
  CLI::App* plot = app.add_subcommand("plot", "draw a report of `cost` or of a benchmark");
  plot->add_option("file", options.plot.file, "the report in JSON")->required()->type_name("FILE.json");
  add_file(*plot, "-o,--output", options.plot.svg, "the picture to write", "FILE.svg")->required();
  plot->footer(
      with_name("Exit code: 0 written, 2 trouble.\n\nExample:\n"
                "  {0} cost a.stl b.stl --json > cost.json\n  {0} plot cost.json -o cost.svg"));
}

void add_nearest(CLI::App& app, Options& options) {
  CLI::App* nearest = app.add_subcommand("nearest", "which point of a surface is nearest to a point, certified");
  add_input(*nearest, options.nearest.input, any_files);
  CLI::Option* point = add_point(*nearest, "--point", options.point, "the point, in the world");
  add_file(*nearest, "--points", options.nearest.points, "many points: a file with three numbers a line")
      ->excludes(point);
  nearest->add_option("--k", options.nearest.k, "so many nearest triangles, nearest first")
      ->check(CLI::Range(1, 1'000'000))
      ->type_name("NUMBER");
  add_length(*nearest, "--within", options.nearest.within,
             "leave out what is farther away: a length in units of the scene or with its own (0.5, 2mm, 0.1in); "
             "all: nothing is");
  nearest->add_flag(
      "--signed", options.nearest.sides,
      "tell on which side of the surface the point is, and inside of which object: exactly of closed meshes "
      "and other solids, by the generalised winding number of an open mesh");
  add_writing(*nearest, options, options.nearest, "docs/reference/nearest-report.md");
  nearest->footer(
      with_name("Of solids, too, it is a point of the surface.\n\nExit code: 0 answered, 2 trouble.\n\nExample:\n"
                "  {0} nearest part.stl --point 0 0 5\n"
                "  {0} nearest part.stl --points points.txt --k 3 --within 0.5 --csv"));
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
  CLI::App* inspect = app.add_subcommand("inspect", "what meshes and shapes are: closed? degenerate? how large?");
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
  inspect->add_flag("--json", options.json, "write JSON (docs/reference/inspect-report.md)");
  inspect->footer(
      with_name("Nothing is repaired; everything is counted exactly. Where a mesh meets itself is told "
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

void add_crowd(CLI::App& app, Options& options) {
  std::vector<std::string> scenes, methods;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  for (const BroadPhaseMethod method : broad_phase_methods()) methods.emplace_back(name_of(method));
  CLI::App* crowd = app.add_subcommand("crowd", "many moving boxes: which overlap, frame by frame, and how fast");
  const auto positive = CLI::Range(std::uint64_t{1}, std::uint64_t{100'000'000});
  crowd->add_option("--count", options.crowd.count, "boxes")->check(positive)->capture_default_str();
  crowd->add_option("--scene", options.crowd.scene, "how they lie and move")
      ->check(CLI::IsMember(scenes))
      ->capture_default_str();
  crowd->add_option("--frames", options.crowd.frames, "the median of their times is told")
      ->check(positive)
      ->capture_default_str();
  CLI::Option* method = crowd->add_option("--method", options.crowd.method, "how pairs are found")
                            ->check(CLI::IsMember(methods))
                            ->capture_default_str();
  crowd->add_flag("--compare", options.crowd.compare, "all methods that can bear so many, one after the other")
      ->excludes(method);
  crowd->add_option("--seed", options.crowd.seed, "another seed, another crowd")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(*crowd, options.crowd.threads, "pairs");
  add_file(*crowd, "--html", options.crowd.html,
           "also write a page of the boxes, their pairs and the method's cells, frame by frame", "FILE.html");
  add_picture(*crowd, options.crowd.png, options.crowd.size, options.crowd.look);
  crowd->add_flag("--json", options.json, "write JSON (docs/reference/crowd.md)");
  crowd->footer(
      with_name("Example:\n  {0} crowd --count 100000 --scene clustered\n  {0} crowd --count 5000 --compare\n"
                "  {0} crowd --count 2000 --frames 100 --html crowd.html"));
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
  add_replay(app, options);
  add_pairs(app, options);
  add_inspect(app, options);
  add_tree(app, options);
  add_crowd(app, options);
  add_demo(app, options);
}

std::string with_name(const char* text) { return fmt::format(fmt::runtime(text), called_as()); }

}  // namespace toccata::command
