#include "question_options.hpp"

#include <CLI/CLI.hpp>

#include "option_kinds.hpp"

namespace toccata::command {

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
  check
      ->add_flag("--self", options.check.self,
                 "each object against itself, instead of against the others: where its own faces meet")
      ->excludes(poses)
      ->excludes(penetration)
      ->excludes(clearance)
      ->excludes(clearance_of)
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
  add_text(*view, "--partition", arguments.partition,
           "also the cells of a partition over each mesh, depth by depth: grid, grid-2d, octree, kd-tree, r-tree, "
           "inserted-r-tree",
           "a partition must be named")
      ->type_name("PARTITION");
  view->add_flag("--voronoi", arguments.voronoi,
                 "also the Voronoi regions of objects that are convex polytopes: of faces, edges and vertices");
  view->add_flag("--voronoi-walk", arguments.voronoi_walk,
                 "also how each pair of convex polytopes is found to be nearest by walking from region to region, "
                 "feature by feature");
  add_picture(*view, arguments);
  view->add_option("--up", arguments.up, "which axis points up (default: y for glTF, else z)")
      ->check(CLI::IsMember({"y", "z"}));
  add_threads(*view, arguments.threads, "page");
  add_save_case(*view, arguments.save_case, "also write what is shown as a case (docs/reference/case-file.md)");
  view->footer(with_name(
      "The page is one file that any browser with WebGL 2 opens from disk: no network, no server.\n\n"
      "Exit code: 0 written, 1 written and the answer is another than a report or case says, 2 trouble.\n\nExample:\n"
      "  {0} view a.stl b.obj -o touch.html\n"
      "  {0} view scene.json --penetration --clearance 2mm -o scene.html\n"
      "  {0} view bunny.ply --hierarchy obb -o tree.html\n"
      "  {0} view bunny.ply --partition octree -o octree.html\n"
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

}  // namespace toccata::command
