#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "arguments.hpp"
#include "casts.hpp"
#include "convex_library.hpp"
#include "feature_peer.hpp"
#include "library.hpp"
#include "movers.hpp"
#include "narrow/triangle_pairs.hpp"
#include "number_checks.hpp"
#include "subdivisions.hpp"
#include "sums.hpp"
#include "sweeps.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/crowds.hpp"

namespace toccata::bench {
namespace {

constexpr int trouble = 2;

struct Options {
  MeshArguments mesh;
  TriangleArguments triangle;
  ConvexArguments convex;
  CastsArguments casts;
  RaysArguments rays;
  SelfArguments self;
  DecomposeArguments decompose;
  RefitArguments refit;
  BuildArguments build;
  NearestArguments nearest;
  BroadArguments broad;
  WorldArguments world;
  PartsArguments parts;
  WorldQueriesArguments world_queries;
  MoverArguments mover;
  PartitionsArguments partitions;
  ProcessArguments process;
  SumsArguments sums;
  SubdivisionArguments subdivision;
  MotionArguments motion;
  DeformingArguments deforming;
  WalkerArguments walker;
  ProximityArguments proximity;
  RobotArguments robot;
};

/// CLI11's own tells the range of all doubles.
CLI::Validator positive() {
  return {[](std::string& text) {
            double number = 0;
            const bool is_less = CLI::detail::lexical_cast(text, number) && !(number > 0);
            return is_less ? fmt::format("{} is too small: at least 1 is needed", text) : std::string();
          },
          "POSITIVE"};
}

void add_peers(CLI::App& app, std::vector<std::string>& peers, const std::vector<std::string>& known) {
  app.add_option("--peer", peers, fmt::format("libraries to compare with, by commas: {}", fmt::join(known, ",")))
      ->delimiter(',')
      ->check(CLI::IsMember(known));
}

CLI::Option* add_mesh_file(CLI::App& app, const std::string& name, std::string& mesh) {
  return app.add_option(name, mesh, "a file, or gen:NAME?PARAMETER=NUMBER&…");
}

template <class Number>
void add_number(CLI::App& app, const std::string& name, Number& number, const std::string& what) {
  app.add_option(name, number, what)->check(positive())->capture_default_str();
}

void add_json(CLI::App& app, bool& json) { app.add_flag("--json", json, "write JSON (docs/guide/benchmarks.md)"); }

void add_common(CLI::App& app, QueryArguments& arguments) {
  app.add_option("--seed", arguments.seed, "another seed, other queries")->check(whole_number())->capture_default_str();
  add_number(app, "--rounds", arguments.rounds, "how often each query is asked; the fastest counts");
  app.add_flag("--verify", arguments.verify, "compare every answer with brute force in rational arithmetic: slow");
  add_json(app, arguments.json);
}

void add_mesh(CLI::App& app, MeshArguments& arguments) {
  CLI::App* mesh = app.add_subcommand("mesh", "questions about two posed meshes, taken as surfaces");
  add_mesh_file(*mesh, "--mesh-a", arguments.mesh_a)->required();
  add_mesh_file(*mesh, "--mesh-b", arguments.mesh_b)->required();
  mesh->add_option("--poses", arguments.poses,
                   "file with a line per query: 12 numbers (R by rows, t; B in A's frame) or 24 (both poses)");
  mesh->add_option("--random", arguments.random,
                   "this many random poses near contact (1000); with --poses: its poses, both objects moved together")
      ->check(positive());
  mesh->add_flag("--near", arguments.near, "random poses within 1e-6 to 1e-14 of contact instead of 2 %");
  mesh->add_option("--size-b", arguments.size_b, "B is scaled: its diagonal becomes this part of A's")
      ->check(CLI::Range(1e-6, 1e6));
  mesh->add_option("--task", arguments.task, "what to ask")
      ->check(CLI::IsMember({"overlap", "contacts", "distance", "coherent-distance", "build"}))
      ->capture_default_str();
  mesh->add_option("--motion", arguments.motion,
                   "of coherent-distance: how far a vertex moves at most in a step, as a part of the smaller diagonal")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  mesh->add_option("--gap", arguments.gap,
                   "random poses are that much away from contact, negative: into it; of coherent-distance the ways are "
                   "moved apart by it; as a part of the smaller diagonal")
      ->check(CLI::Range(-1.0, 1000.0));
  mesh->add_option("--threads", arguments.threads,
                   "use this many (docs/guide/benchmarks.md tells how); 1,2: measure both")
      ->delimiter(',')
      ->check(positive())
      ->capture_default_str();
  mesh->add_option("--simd", arguments.simd, "vector instructions that Toccata uses (default: the most there are)")
      ->check(CLI::IsMember({"scalar", "sse4", "avx2", "avx512"}));
  mesh->add_option("--clock", arguments.clock,
                   "wall, or thread: the processor's time, for one thread on a busy machine")
      ->check(CLI::IsMember({"wall", "thread"}))
      ->capture_default_str();
  mesh->add_option("--answers", arguments.answers,
                   "write Toccata's answers: a line per query, its number and the answer");
  add_peers(*mesh, arguments.peers, mesh_peers());
  add_common(*mesh, arguments);
  mesh->footer("Example:\n  ./toccata bench mesh --mesh-a a.obj --mesh-b gen:helix --random 100 --peer fcl,cgal");
}

void add_triangle(CLI::App& app, TriangleArguments& arguments) {
  CLI::App* triangle = app.add_subcommand("triangle", "do two triangles meet");
  add_number(*triangle, "--count", arguments.count, "pairs");
  triangle->add_option("--family", arguments.family, "kind of pairs")
      ->check(CLI::IsMember(test::triangle_pair_families()))
      ->capture_default_str();
  add_peers(*triangle, arguments.peers, triangle_peers());
  add_common(*triangle, arguments);
  triangle->footer("Example:\n  ./toccata bench triangle --peer cgal,fcl --family shared");
}

void add_convex(CLI::App& app, ConvexArguments& arguments) {
  CLI::App* convex = app.add_subcommand("convex", "questions about two posed convex shapes of about size 1");
  convex->add_option("--pair", arguments.pair, "which shapes")
      ->check(CLI::IsMember(convex_pairs()))
      ->capture_default_str();
  convex->add_option("--vertices", arguments.vertices, "of each hull")
      ->check(CLI::Range(4, 100000))
      ->capture_default_str();
  convex->add_option("--task", arguments.task, "what to ask")
      ->check(CLI::IsMember({"overlap", "distance", "penetration", "manifold"}))
      ->capture_default_str();
  convex
      ->add_option("--regime", arguments.regime,
                   "far; near: at --gap; deep; coherent: near by, in steps of 1 %, with a warm start")
      ->check(CLI::IsMember({"far", "near", "deep", "coherent"}))
      ->capture_default_str();
  convex
      ->add_option("--gap", arguments.gap,
                   "of near: between the shapes, as a part of the smaller one's reach; negative: so deep")
      ->check(CLI::Range(-1.0, 1.0))
      ->capture_default_str();
  add_number(*convex, "--count", arguments.count, "questions");
  add_peers(*convex, arguments.peers, convex_peers());
  add_common(*convex, arguments);
  convex->footer("Example:\n  ./toccata bench convex --pair hull --vertices 32 --task distance --peer bullet,fcl");
}

void add_casts(CLI::App& app, CastsArguments& arguments) {
  CLI::App* casts =
      app.add_subcommand("casts", "when a ray or a shape that moves first meets a shape with round sides");
  casts->add_option("--pair", arguments.pair, "what moves, and what it is moved at")
      ->check(CLI::IsMember(cast_pairs()))
      ->capture_default_str();
  casts->add_option("--regime", arguments.regime, "hit; graze: within 1 % of just missing; miss")
      ->check(CLI::IsMember({"hit", "graze", "miss"}))
      ->capture_default_str();
  add_number(*casts, "--count", arguments.count, "questions");
  add_peers(*casts, arguments.peers, cast_peers());
  add_common(*casts, arguments);
  casts->footer("Example:\n  ./toccata bench casts --pair cone-box --regime graze --peer bullet,fcl");
}

void add_rays(CLI::App& app, RaysArguments& arguments) {
  CLI::App* rays = app.add_subcommand("rays", "where rays first meet a mesh, taken as a surface");
  add_mesh_file(*rays, "--mesh", arguments.mesh)->required();
  add_number(*rays, "--count", arguments.count, "rays");
  rays->add_flag("--camera", arguments.camera,
                 "rays of one eye through a grid, row by row, instead of random ones: neighbours meet neighbours");
  add_peers(*rays, arguments.peers, {"embree"});
  add_common(*rays, arguments);
  rays->footer("Example:\n  ./toccata bench rays --mesh gen:torus-knot --peer embree");
}

void add_decompose(CLI::App& app, DecomposeArguments& arguments) {
  CLI::App* decompose = app.add_subcommand("decompose", "convex decomposition of a closed mesh, on one thread");
  add_mesh_file(*decompose, "--mesh", arguments.mesh)->required();
  add_mesh_file(*decompose, "--mesh-b", arguments.mesh_b);
  decompose
      ->add_option("--task", arguments.task,
                   "cut the mesh, or ask about two decomposed ones (--mesh-b, or the same twice) near contact")
      ->check(CLI::IsMember({"cut", "overlap", "distance", "penetration"}))
      ->capture_default_str();
  add_number(*decompose, "--random", arguments.random, "so many poses to ask at");
  decompose->add_option("--seed", arguments.seed, "another seed, other poses")
      ->check(whole_number())
      ->capture_default_str();
  add_peers(*decompose, arguments.peers, {"cgal"});
  add_number(*decompose, "--parts", arguments.parts, "at most so many");
  add_number(*decompose, "--rounds", arguments.rounds, "how often; the fastest counts");
  add_json(*decompose, arguments.json);
  decompose->footer(
      "Example:\n  ./toccata bench decompose --mesh 'gen:noise-sphere?subdivisions=6'\n"
      "  ./toccata bench decompose --mesh gen:torus --mesh-b gen:gear --task overlap");
}

void add_self(CLI::App& app, SelfArguments& arguments) {
  CLI::App* self = app.add_subcommand("self", "where a mesh intersects itself: all pairs of its triangles");
  add_mesh_file(*self, "--mesh", arguments.mesh)->required();
  add_number(*self, "--rounds", arguments.rounds, "how often it is asked; the fastest counts");
  add_peers(*self, arguments.peers, {"cgal"});
  add_json(*self, arguments.json);
  self->footer("Example:\n  ./toccata bench self --mesh gen:torus-knot --peer cgal");
}

void add_refit(CLI::App& app, RefitArguments& arguments) {
  CLI::App* refit = app.add_subcommand("refit", "putting the tree of a mesh around vertices that have moved");
  add_mesh_file(*refit, "--mesh", arguments.mesh)->required();
  refit->add_option("--seed", arguments.seed, "another seed, other questions to compare answers by")
      ->check(whole_number())
      ->capture_default_str();
  add_number(*refit, "--rounds", arguments.rounds, "how often three frames are gone through; the median counts");
  add_number(*refit, "--threads", arguments.threads, "use so many, where the library does (FCL uses one)");
  add_peers(*refit, arguments.peers, {"embree", "fcl"});
  add_json(*refit, arguments.json);
  refit->footer("Example:\n  ./toccata bench refit --mesh gen:torus-knot --peer embree,fcl");
}

void add_partitions(CLI::App& app, PartitionsArguments& arguments) {
  CLI::App* partitions =
      app.add_subcommand("partitions", "partitions of space over the boxes of a mesh's triangles: who is in a place?");
  add_mesh_file(*partitions, "--mesh", arguments.mesh)->required();
  partitions
      ->add_option(
          "--task", arguments.task,
          "the triangles whose boxes reach into a box, all pairs of boxes, the cells that boxes are in as "
          "they move; of a closed mesh a BSP tree beside the mesh's own (solid), and where points lie by these and "
          "an MSP tree (points)")
      ->check(CLI::IsMember({"box", "pairs", "cells", "solid", "points"}))
      ->capture_default_str();
  add_number(*partitions, "--queries", arguments.queries, "how many boxes are asked about; with cells, how many ways");
  partitions->add_option("--seed", arguments.seed, "another seed, other boxes")->capture_default_str();
  add_number(*partitions, "--rounds", arguments.rounds,
             "how often each is asked, of which the fastest counts; with cells, frames");
  partitions->add_option("--clock", arguments.clock, "whose time is measured: of the wall, or of the thread")
      ->check(CLI::IsMember({"wall", "thread"}))
      ->capture_default_str();
  add_peers(*partitions, arguments.peers, {"boost"});
  add_json(*partitions, arguments.json);
  partitions->footer("Example:\n  ./toccata bench partitions --mesh gen:torus-knot --peer boost");
}

void add_build(CLI::App& app, BuildArguments& arguments) {
  CLI::App* build = app.add_subcommand("build", "every builder of trees, on one thread and on several");
  add_mesh_file(*build, "--mesh", arguments.mesh)->required();
  build
      ->add_option("--threads", arguments.threads,
                   "numbers of threads, the first of which the others are compared with")
      ->delimiter(',')
      ->check(positive())
      ->capture_default_str();
  add_number(*build, "--rounds", arguments.rounds, "builds on each number of threads, in turn; the fastest counts");
  add_json(*build, arguments.json);
  build->footer("Example:\n  ./toccata bench build --mesh gen:torus-knot --threads 1,2");
}

void add_nearest(CLI::App& app, NearestArguments& arguments) {
  CLI::App* nearest = app.add_subcommand("nearest", "how far points are from a mesh, taken as a surface");
  add_mesh_file(*nearest, "--mesh", arguments.mesh)->required();
  nearest->add_option("--where", arguments.where, "far: two diagonals away; near: within 1 % of the surface")
      ->check(CLI::IsMember({"far", "near"}))
      ->capture_default_str();
  add_number(*nearest, "--count", arguments.count, "points");
  add_peers(*nearest, arguments.peers, {"cgal", "embree"});
  add_common(*nearest, arguments);
  nearest->footer("Example:\n  ./toccata bench nearest --mesh gen:torus-knot --where near --peer cgal,embree");
}

void add_broad(CLI::App& app, BroadArguments& arguments) {
  std::vector<std::string> scenes, methods;
  for (const NamedScene& scene : crowd_scenes()) scenes.push_back(scene.name);
  for (const BroadPhaseMethod method : broad_phase_methods()) methods.emplace_back(name_of(method));
  CLI::App* broad = app.add_subcommand("broad", "which boxes of a moving crowd overlap, frame by frame");
  broad
      ->add_option(
          "--task", arguments.task,
          "frames: methods and peers in one scene; table: in all scenes, with what is asked of them; cell-size: "
          "the spatial hash; swaps: what coherence saves, and how it grows with the number of boxes")
      ->check(CLI::IsMember({"frames", "table", "cell-size", "swaps"}))
      ->capture_default_str();
  broad->add_option("--scene", arguments.scene, "the crowd")->check(CLI::IsMember(scenes))->capture_default_str();
  broad->add_option("--count", arguments.count, "boxes")->check(CLI::PositiveNumber)->capture_default_str();
  broad->add_option("--frames", arguments.frames, "the median counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  broad->add_option("--method", arguments.methods, "by commas; the others are compared with the first")
      ->delimiter(',')
      ->check(CLI::IsMember(methods))
      ->capture_default_str();
  broad->add_option("--threads", arguments.threads, "that Toccata uses")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_peers(*broad, arguments.peers, {"bullet", "cgal", "fcl", "ode"});
  broad->add_option("--seconds", arguments.seconds, "after which no further frame of a method or peer is begun")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  broad->add_option("--seed", arguments.seed, "another seed, another crowd")
      ->check(whole_number())
      ->capture_default_str();
  broad->add_flag("--json", arguments.json, "write JSON (docs/guide/benchmarks.md)");
  broad->footer(
      "Example:\n  ./toccata bench broad --scene clustered --count 10000 --method auto,grid --peer bullet,fcl");
}

void add_proximity(CLI::App& app, ProximityArguments& arguments) {
  CLI::App* proximity = app.add_subcommand("proximity", "how cost grows as two meshes come near, or get larger");
  proximity
      ->add_option("--task", arguments.task,
                   "gap: helices, boxes, shells and a mould, free by less and less, for each volume and library; size: "
                   "every pair "
                   "of triangles against trees")
      ->check(CLI::IsMember({"gap", "size"}))
      ->capture_default_str();
  add_peers(*proximity, arguments.peers, mesh_peers());
  add_number(*proximity, "--rounds", arguments.rounds, "how often each library is asked; the least time counts");
  add_json(*proximity, arguments.json);
  proximity->footer("Example:\n  ./toccata bench proximity --peer fcl,cgal\n  ./toccata bench proximity --task size");
}

void add_world(CLI::App& app, WorldArguments& arguments) {
  CLI::App* world = app.add_subcommand("world", "which bodies of a moving crowd are in contact, step by step");
  world
      ->add_option("--task", arguments.task,
                   "peers: beside other libraries; space-time: with and without WorldOptions::space_time")
      ->check(CLI::IsMember({"peers", "space-time"}))
      ->capture_default_str();
  world->add_option("--scene", arguments.scene,
                    "of the task peers: fly (standard), stacks, pile, floor or terrain; of the task space-time: one of "
                    "its scenes, by "
                    "name, else all");
  add_number(*world, "--rounds", arguments.rounds, "of the task space-time; the least times count");
  add_number(*world, "--count", arguments.count, "boxes, spheres, capsules and hulls, as many of each");
  world->add_option("--contact", arguments.contact, "about the share of them that is in contact")
      ->check(CLI::Range(0.001, 1.0))
      ->capture_default_str();
  add_number(*world, "--frames", arguments.frames, "steps; the median counts");
  world->add_option("--threads", arguments.threads, "that Toccata uses; 1,2: measure both")
      ->delimiter(',')
      ->check(positive())
      ->capture_default_str();
  add_peers(*world, arguments.peers, {"bullet", "fcl"});
  world->add_option("--seed", arguments.seed, "another seed, another crowd")
      ->check(whole_number())
      ->capture_default_str();
  add_json(*world, arguments.json);
  world->footer(
      "Examples:\n  ./toccata bench world --count 10000 --peer bullet,fcl\n"
      "  ./toccata bench world --scene stacks --count 10000 --threads 1 --peer bullet,fcl\n"
      "  ./toccata bench world --task space-time --count 5000 --frames 200");
}

void add_robot(CLI::App& app, RobotArguments& arguments) {
  CLI::App* robot = app.add_subcommand("robot", "an arm of seven joints among a hundred boxes and three meshes");
  add_number(*robot, "--count", arguments.count, "random configurations, and edges from each");
  robot->add_option("--subdivisions", arguments.subdivisions, "of the links' meshes: 20 triangles, and four times each")
      ->check(CLI::Range(0, 6))
      ->capture_default_str();
  robot->add_option("--edge", arguments.edge, "how long an edge is, as a part of the way to another configuration")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  robot->add_option("--near", arguments.near, "how far the least distance is looked for, in metres")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  add_number(*robot, "--rounds", arguments.rounds, "how often all are asked; the fastest counts");
  add_peers(*robot, arguments.peers, {"fcl"});
  robot->add_option("--seed", arguments.seed, "another seed, other configurations")
      ->check(whole_number())
      ->capture_default_str();
  add_json(*robot, arguments.json);
  robot->footer("Example:\n  ./toccata bench robot --peer fcl");
}

void add_parts(CLI::App& app, PartsArguments& arguments) {
  CLI::App* parts = app.add_subcommand("parts", "which of many posed meshes meet, taken as surfaces");
  add_number(*parts, "--count", arguments.count, "parts of a few kinds, some of which meet");
  add_number(*parts, "--threads", arguments.threads, "that check_all uses");
  add_number(*parts, "--rounds", arguments.rounds, "how often it is asked; the median counts");
  add_peers(*parts, arguments.peers, {"fcl"});
  parts->add_option("--seed", arguments.seed, "another seed, other parts")
      ->check(whole_number())
      ->capture_default_str();
  add_json(*parts, arguments.json);
  parts->footer("Example:\n  ./toccata bench parts --count 10000 --peer fcl");
}

void add_world_queries(CLI::App& app, WorldQueriesArguments& arguments) {
  CLI::App* queries = app.add_subcommand("world-queries", "questions to all bodies of a World");
  queries
      ->add_option(
          "--task", arguments.task,
          "what a ray meets first; what a ball or box that moves does; how far the nearest is from a ball; how "
          "many a box overlaps")
      ->check(CLI::IsMember({"ray", "cast", "nearest", "overlap"}))
      ->capture_default_str();
  queries->add_option("--shape", arguments.shape, "what moves: a ball and a box in turn, or always the same; of cast")
      ->check(CLI::IsMember({"ball-box", "hull", "cylinder", "cone", "ellipsoid"}))
      ->capture_default_str();
  add_mesh_file(*queries, "--mesh", arguments.mesh)->description("one mesh instead of bodies, taken as a surface");
  add_number(*queries, "--bodies", arguments.bodies, "boxes, spheres and capsules");
  add_number(*queries, "--count", arguments.count, "questions");
  add_peers(*queries, arguments.peers, {"bullet", "fcl"});
  add_common(*queries, arguments);
  queries->footer("Example:\n  ./toccata bench world-queries --task nearest --peer fcl");
}

void add_mover(CLI::App& app, MoverArguments& arguments) {
  CLI::App* mover = app.add_subcommand("mover", "characters that walk through levels of many triangles");
  arguments.levels = walk_levels();
  mover->add_option("--level", arguments.levels, "by commas: all, where none is named")
      ->delimiter(',')
      ->check(CLI::IsMember(walk_levels()));
  add_mesh_file(*mover, "--mesh", arguments.mesh)->description("a mesh as the level instead, z up, taken as a surface");
  mover->add_option("--scale", arguments.scale, "of the mesh: a walker is 1.8 units high")
      ->check(positive())
      ->capture_default_str();
  add_number(*mover, "--triangles", arguments.triangles, "of each level, about");
  add_number(*mover, "--walks", arguments.walks, "walkers, one after the other");
  add_number(*mover, "--steps", arguments.steps, "of each");
  add_number(*mover, "--rounds", arguments.rounds, "how often all is walked; the fastest time of each step counts");
  add_peers(*mover, arguments.peers, {"bullet"});
  mover->add_option("--seed", arguments.seed, "another seed, other levels and wishes")
      ->check(whole_number())
      ->capture_default_str();
  add_json(*mover, arguments.json);
  mover->footer("Example:\n  ./toccata bench mover --level crowd,seams --peer bullet");
}

void add_process(CLI::App& app, ProcessArguments& arguments) {
  arguments.command = TOCCATA_COMMAND;
  CLI::App* process = app.add_subcommand("process", "the whole command: time and memory from start to end");
  process->add_option("--mesh", arguments.mesh, "checked against itself (default: stanford-bunny.obj of TOCCATA_DATA)");
  process->add_option("--shift", arguments.shift, "by how much the second one is moved along x")->capture_default_str();
  add_number(*process, "--objects", arguments.objects, "small meshes in the generated scene");
  add_number(*process, "--repeat", arguments.repeat, "runs; the median counts");
  process->add_option("--command", arguments.command, "the toccata command to run");
  add_json(*process, arguments.json);
  process->footer("Example:\n  ./toccata bench process --mesh part.stl --shift 2.5");
}

void add_sums(CLI::App& app, SumsArguments& arguments) {
  CLI::App* sums = app.add_subcommand("sums", "Minkowski sums of two convex hulls, and points in a ready one");
  sums->add_option("--task", arguments.task, "sum: making them; point: does a point lie in a ready sum")
      ->check(CLI::IsMember({"sum", "point"}))
      ->capture_default_str();
  add_number(*sums, "--vertices", arguments.vertices, "of each hull; they lie on a sphere");
  add_number(*sums, "--count", arguments.count, "sums, or points");
  sums->add_option("--clock", arguments.clock, "wall, or thread: the processor's time, on a busy machine")
      ->check(CLI::IsMember({"wall", "thread"}))
      ->capture_default_str();
  add_peers(*sums, arguments.peers, sum_peers());
  sums->add_option("--seed", arguments.seed, "another seed, other hulls")->check(whole_number())->capture_default_str();
  add_number(*sums, "--rounds", arguments.rounds, "how often each is asked; the fastest counts");
  add_json(*sums, arguments.json);
  sums->footer("Example:\n  ./toccata bench sums --task point --count 20000 --peer cgal");
}

void add_subdivision(CLI::App& app, SubdivisionArguments& arguments) {
  CLI::App* subdivision = app.add_subcommand("subdivision", "limit surfaces of cages: meshes of them, and distances");
  subdivision->add_option("--task", arguments.task, "mesh: within a bound; distance: from boxes, to that width")
      ->check(CLI::IsMember({"mesh", "distance"}))
      ->capture_default_str();
  subdivision->add_option("--cage", arguments.cage, "torus: regular; bipyramid: with two vertices of valence 12")
      ->check(CLI::IsMember({"torus", "bipyramid"}))
      ->capture_default_str();
  subdivision->add_option("--scheme", arguments.scheme, "how it is refined")
      ->check(CLI::IsMember({"loop", "catmull-clark"}))
      ->capture_default_str();
  subdivision->add_option("--within", arguments.within, "the bound; both cages are about 1 and 3 across")
      ->check(positive())
      ->capture_default_str();
  add_number(*subdivision, "--count", arguments.count, "distances");
  subdivision->add_option("--clock", arguments.clock, "wall, or thread: the processor's time, on a busy machine")
      ->check(CLI::IsMember({"wall", "thread"}))
      ->capture_default_str();
  add_peers(*subdivision, arguments.peers, limit_peers());
  subdivision->add_option("--seed", arguments.seed, "another seed, other poses")
      ->check(whole_number())
      ->capture_default_str();
  add_number(*subdivision, "--rounds", arguments.rounds, "how often each is asked; the fastest counts");
  add_json(*subdivision, arguments.json);
  subdivision->footer("Example:\n  ./toccata bench subdivision --task distance --within 1e-4 --peer osd");
}

void add_motion(CLI::App& app, MotionArguments& arguments) {
  CLI::App* motion =
      app.add_subcommand("motion", "when what moves first meets: features of meshes, bodies that turn, meshes");
  motion
      ->add_option("--task", arguments.task,
                   "features: the public questions, whose answers are known; bodies: convex bodies that move and turn; "
                   "meshes: bunnies, and spheres of more and more triangles; volumes: what bodies pass")
      ->check(CLI::IsMember({"features", "bodies", "meshes", "volumes"}))
      ->capture_default_str();
  motion->add_option("--data", arguments.data, "the folder that has ccd and meshes")->envname("TOCCATA_DATA");
  add_number(*motion, "--count", arguments.count, "questions of each set of bodies");
  add_number(*motion, "--most", arguments.most, "triangles of the largest sphere");
  motion->add_option("--seed", arguments.seed, "another seed, other bodies")
      ->check(whole_number())
      ->capture_default_str();
  std::vector<std::string> peers = sweep_peers();
  peers.push_back(feature_peer);
  add_peers(*motion, arguments.peers, peers);
  add_number(*motion, "--rounds", arguments.rounds, "how often each query is timed; the fastest counts");
  add_json(*motion, arguments.json);
  motion->footer("Example:\n  ./toccata bench motion\n  ./toccata bench motion --task bodies --peer bullet,fcl");
}

int run_partitions_task(const PartitionsArguments& arguments) {
  if (arguments.task == "cells") return run_partition_cells(arguments);
  if (arguments.task == "points") return run_partition_points(arguments);
  return arguments.task == "solid" ? run_partition_solid(arguments) : run_partitions(arguments);
}

/// Features have a peer of their own.
int run_motion_task(const MotionArguments& arguments) {
  const bool of_features = arguments.task == "features";
  for (const std::string& peer : arguments.peers)
    if ((peer == feature_peer) != of_features || arguments.task == "volumes")
      throw Error(fmt::format("motion: {} answers no question of --task {}", peer, arguments.task));
  if (arguments.task == "volumes") return run_swept_volumes(arguments);
  return of_features ? run_motion(arguments) : run_sweeps(arguments);
}

void add_deforming(CLI::App& app, DeformingArguments& arguments) {
  CLI::App* deforming =
      app.add_subcommand("deforming", "one step of a folded cloth against itself, of a thousand triangles and more");
  add_number(*deforming, "--most", arguments.most, "triangles of the largest cloth");
  deforming->add_option("--threads", arguments.threads, "use so many, one after another")
      ->delimiter(',')
      ->check(positive())
      ->capture_default_str();
  add_number(*deforming, "--rounds", arguments.rounds, "how often each is timed; the fastest counts");
  add_json(*deforming, arguments.json);
  deforming->footer("Example:\n  ./toccata bench deforming --threads 1,2");
}

void add_walker(CLI::App& app, WalkerArguments& arguments) {
  CLI::App* walker = app.add_subcommand("walker", "the generic walkers of trees beside loops written by hand");
  add_mesh_file(*walker, "--mesh-a", arguments.mesh_a)->capture_default_str();
  add_mesh_file(*walker, "--mesh-b", arguments.mesh_b)->capture_default_str();
  add_number(*walker, "--rounds", arguments.rounds, "how often each walk is timed; the median counts");
  walker->add_option("--only", arguments.only, "only walk, once: what valgrind counts");
  add_json(*walker, arguments.json);
  walker->footer("Example:\n  ./toccata bench walker --mesh-a a.obj --mesh-b b.obj");
}

int report_trouble(const std::string& message) {
  fmt::print(stderr, "toccata-bench: error: {}\n", message);
  return trouble;
}

int main_of(int argc, char** argv) {
  CLI::App app("Measures Toccata and its peers on the same inputs in one run, and compares the answers.",
               "toccata-bench");
  Options options;
  app.require_subcommand(1);
  app.footer("Exit code: 0, 1 when an answer of Toccata is wrong, 2 trouble.");
  add_mesh(app, options.mesh);
  add_triangle(app, options.triangle);
  add_convex(app, options.convex);
  add_casts(app, options.casts);
  add_rays(app, options.rays);
  add_self(app, options.self);
  add_decompose(app, options.decompose);
  add_refit(app, options.refit);
  add_build(app, options.build);
  add_nearest(app, options.nearest);
  add_broad(app, options.broad);
  add_world(app, options.world);
  add_parts(app, options.parts);
  add_robot(app, options.robot);
  add_world_queries(app, options.world_queries);
  add_mover(app, options.mover);
  add_partitions(app, options.partitions);
  add_process(app, options.process);
  add_sums(app, options.sums);
  add_subdivision(app, options.subdivision);
  add_motion(app, options.motion);
  add_deforming(app, options.deforming);
  add_walker(app, options.walker);
  add_proximity(app, options.proximity);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_text) {
    return app.exit(asked_for_text);
  } catch (const CLI::ParseError& error) {
    return report_trouble(std::string(error.what()) + " (--help tells the options)");
  }
  if (app.got_subcommand("mesh")) return run_mesh(options.mesh);
  if (app.got_subcommand("triangle")) return run_triangle(options.triangle);
  if (app.got_subcommand("convex")) return run_convex(options.convex);
  if (app.got_subcommand("casts")) return run_casts(options.casts);
  if (app.got_subcommand("rays")) return run_rays(options.rays);
  if (app.got_subcommand("decompose")) return run_decompose(options.decompose);
  if (app.got_subcommand("self")) return run_self(options.self);
  if (app.got_subcommand("refit")) return run_refit(options.refit);
  if (app.got_subcommand("build")) return run_build(options.build);
  if (app.got_subcommand("nearest")) return run_nearest(options.nearest);
  if (app.got_subcommand("broad")) return run_broad(options.broad);
  if (app.got_subcommand("world"))
    return options.world.task == "space-time" ? run_space_time(options.world) : run_world(options.world);
  if (app.got_subcommand("parts")) return run_parts(options.parts);
  if (app.got_subcommand("robot")) return run_robot(options.robot);
  if (app.got_subcommand("world-queries")) return run_world_queries(options.world_queries);
  if (app.got_subcommand("mover")) return run_mover(options.mover);
  if (app.got_subcommand("partitions")) return run_partitions_task(options.partitions);
  if (app.got_subcommand("sums")) return run_sums(options.sums);
  if (app.got_subcommand("subdivision")) return run_subdivision(options.subdivision);
  if (app.got_subcommand("motion")) return run_motion_task(options.motion);
  if (app.got_subcommand("deforming")) return run_deforming(options.deforming);
  if (app.got_subcommand("walker")) return run_walker(options.walker);
  if (app.got_subcommand("proximity")) return run_proximity(options.proximity);
  return run_process(options.process);
}

}  // namespace
}  // namespace toccata::bench

int main(int argc, char** argv) {
  try {
    return toccata::bench::main_of(argc, argv);
  } catch (const std::exception& error) {
    return toccata::bench::report_trouble(error.what());
  }
}
