#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace toccata::bench {

/// What the benchmarks of many queries have in common.
struct QueryArguments {
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  bool verify = false;
  bool json = false;
};

struct MeshArguments : QueryArguments {
  std::string mesh_a;
  std::string mesh_b;
  std::string poses;                  ///< a file; empty: random poses
  std::optional<std::size_t> random;  ///< how many queries; with a file: its poses, moved
  bool near = false;
  double size_b = 0;          ///< B's diagonal as a part of A's; 0: as it is
  std::optional<double> gap;  ///< how far random poses are from contact, or ways are moved apart; of the smaller
  double motion = 0.01;       ///< of coherent-distance: a step, as a part of the smaller diagonal
  std::string task = "overlap";
  std::vector<int> threads{1};
  std::string simd;  ///< empty: the highest level
  std::string clock = "wall";
  std::string answers;  ///< a file to write
};

struct TriangleArguments : QueryArguments {
  std::size_t count = 100000;
  std::string family = "random";
};

struct ConvexArguments : QueryArguments {
  std::string pair = "hull";
  std::size_t vertices = 32;  ///< of each hull
  std::string task = "distance";
  std::string regime = "near";
  double gap = 0.01;  ///< of near, as a part of the smaller shape's reach; negative: so deep
  std::size_t count = 2000;
};

struct CastsArguments : QueryArguments {
  std::string pair = "cylinder-box";
  std::string regime = "hit";
  std::size_t count = 2000;
};

struct RaysArguments : QueryArguments {
  std::string mesh;
  std::size_t count = 100000;
  bool camera = false;  ///< neighbours in the array go side by side
};

struct DecomposeArguments {
  std::string mesh;
  std::string mesh_b;        ///< of pairs; empty: the same
  std::string task = "cut";  ///< or a question about pairs of decomposed meshes
  std::vector<std::string> peers;
  std::size_t random = 1000;  ///< so many poses of pairs
  std::uint64_t seed = 1;
  std::size_t parts = 32;
  int rounds = 1;
  bool json = false;
};

struct SelfArguments {
  std::string mesh;
  std::vector<std::string> peers;
  int rounds = 3;
  bool json = false;
};

struct RefitArguments {
  std::string mesh;
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  int threads = 1;
  bool json = false;
};

struct PartitionsArguments {
  std::string mesh;
  std::vector<std::string> peers;
  std::string task = "box";  ///< or "pairs", "cells", "solid", "points"
  std::size_t queries = 1000;
  std::uint64_t seed = 1;
  int rounds = 3;
  std::string clock = "wall";
  bool json = false;
};

struct BuildArguments {
  std::string mesh;
  std::vector<int> threads = {1, 2};
  int rounds = 5;
  bool json = false;
};

struct NearestArguments : QueryArguments {
  std::string mesh;
  std::string where = "far";
  std::size_t count = 100000;
};

struct BroadArguments {
  std::string task = "frames";
  std::string scene = "uniform";
  std::size_t count = 100000;
  int frames = 60;
  std::vector<std::string> methods{"auto"};
  std::vector<std::string> peers;
  double seconds = 20;  ///< of frames, for each peer and method
  std::uint64_t seed = 1;
  int threads = 1;
  bool json = false;
};

struct WorldArguments {
  std::string task = "peers";
  std::string scene;  ///< of the task space-time; empty: all
  int rounds = 3;     ///< of the task space-time; the least times count
  std::size_t count = 50000;
  double contact = 0.05;  ///< the share of bodies in contact
  int frames = 20;
  std::vector<int> threads{1, 2};
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  bool json = false;
};

struct PartsArguments {
  std::size_t count = 10000;
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  int threads = 1;
  bool json = false;
};

struct WorldQueriesArguments : QueryArguments {
  std::string task = "ray";
  std::string shape = "ball-box";  ///< that moves
  std::string mesh;                ///< instead of bodies
  std::size_t bodies = 50000;
  std::size_t count = 10000;
};

struct MoverArguments {
  std::vector<std::string> levels;  ///< by name
  std::string mesh;                 ///< instead of them
  double scale = 1;                 ///< of the mesh
  std::size_t triangles = 200000;   ///< of each level
  std::size_t walks = 20;
  std::size_t steps = 500;  ///< of each walk
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  bool json = false;
};

struct ProcessArguments {
  std::string command;
  std::string mesh;  ///< empty: stanford-bunny.obj of TOCCATA_DATA
  double shift = 0.02;
  std::size_t objects = 1000;
  int repeat = 5;
  bool json = false;
};

struct SubdivisionArguments {
  std::string cage = "torus";
  std::string scheme = "catmull-clark";
  std::string task = "distance";  ///< or mesh
  double within = 1e-3;           ///< of the cage's diagonal, about
  std::size_t count = 20;         ///< poses of the other
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  std::string clock = "wall";
  bool json = false;
};

struct SumsArguments {
  std::string task = "sum";
  std::size_t vertices = 32;
  std::size_t count = 1000;
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 5;
  std::string clock = "wall";
  bool json = false;
};

struct MotionArguments {
  std::string task = "features";
  std::string data;          ///< a folder with ccd and meshes
  std::size_t count = 1000;  ///< of each set of bodies
  std::size_t most = 81920;  ///< triangles of the largest mesh that is generated
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 5;
  bool json = false;
};

struct DeformingArguments {
  std::size_t most = 100000;  ///< triangles of the largest cloth
  std::vector<int> threads{1};
  int rounds = 5;
  bool json = false;
};

struct WalkerArguments {
  std::string mesh_a = "gen:torus-knot";
  std::string mesh_b = "gen:noise-sphere?subdivisions=5";
  int rounds = 11;
  std::string only;  ///< not empty: no measurement, but just this walk; what is run to have its instructions counted
  bool json = false;
};

struct ProximityArguments {
  std::string task = "gap";  ///< or "size"
  std::vector<std::string> peers;
  int rounds = 11;  ///< the least time counts
  bool json = false;
};

struct RobotArguments {
  std::size_t count = 20000;
  int subdivisions = 3;  ///< of the links' meshes
  double edge = 0.1;     ///< how long an edge is, as a part of the way to another configuration
  double near = 0.2;     ///< how far a distance is looked for
  std::vector<std::string> peers;
  std::uint64_t seed = 1;
  int rounds = 3;
  bool json = false;
};

// Exit codes: 0, or 1 when Toccata was wrong somewhere. Trouble is thrown.
int run_mesh(const MeshArguments& arguments);
int run_triangle(const TriangleArguments& arguments);
int run_convex(const ConvexArguments& arguments);
int run_casts(const CastsArguments& arguments);
int run_rays(const RaysArguments& arguments);
int run_decompose(const DecomposeArguments& arguments);
int run_decomposed(const DecomposeArguments& arguments);
int run_self(const SelfArguments& arguments);
int run_refit(const RefitArguments& arguments);
int run_partitions(const PartitionsArguments& arguments);
int run_partition_cells(const PartitionsArguments& arguments);
int run_partition_solid(const PartitionsArguments& arguments);
int run_partition_points(const PartitionsArguments& arguments);
int run_build(const BuildArguments& arguments);
int run_nearest(const NearestArguments& arguments);
int run_broad(const BroadArguments& arguments);
int run_world(const WorldArguments& arguments);
int run_space_time(const WorldArguments& arguments);
int run_parts(const PartsArguments& arguments);
int run_world_queries(const WorldQueriesArguments& arguments);
int run_mover(const MoverArguments& arguments);
int run_proximity(const ProximityArguments& arguments);
int run_process(const ProcessArguments& arguments);
int run_sums(const SumsArguments& arguments);
int run_subdivision(const SubdivisionArguments& arguments);
int run_motion(const MotionArguments& arguments);
int run_sweeps(const MotionArguments& arguments);
int run_swept_volumes(const MotionArguments& arguments);
int run_deforming(const DeformingArguments& arguments);
int run_walker(const WalkerArguments& arguments);
int run_robot(const RobotArguments& arguments);

}  // namespace toccata::bench
