#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "toccata/io/report.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/query/cost.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::command {

/// How a subcommand writes its answer to standard output.
enum class Format { table, json, csv };

/// Files to read and what their numbers mean.
struct InputArguments {
  std::vector<std::string> files;
  std::string folder;  ///< where relative names begin; empty: the current one
  std::string unit;    ///< of plain mesh files: mm, cm, m, in, ft, or metres per unit; empty: as the file says
  double scale = 1;
  std::string wanted;  ///< what the subcommand takes, for the error when there are none
};

/// What is asked about, and where it is.
struct PosedArguments {
  InputArguments input;
  std::optional<Pose> pose_a;
  std::optional<Pose> pose_b;
  std::string poses;                 ///< a file of queries about two objects; empty: all are asked about as they are
  std::optional<Solid> solid;        ///< overrides what the scene says
  std::string save_case;             ///< a file for what is asked and the answer; empty: none
  std::string html;                  ///< a page to write besides; empty: none
  std::string png;                   ///< a picture of it
  std::string size;                  ///< of the picture, "1200x800"; empty: that
  std::string look;                  ///< what the picture shows: the end of a link to the page
  std::string glb;                   ///< a GLB file
  std::string glb_option = "--glb";  ///< how it is named on the command line
  Format format = Format::table;
  int threads = 0;
};

struct CheckArguments : PosedArguments {
  bool self = false;  ///< each object against itself, instead of against the others
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
  std::string clearance;                   ///< a length, or "all"; empty: none is asked for
  std::vector<std::string> clearances_of;  ///< "NAME,NAME=LENGTH"
};

struct ViewArguments : CheckArguments {
  std::string up;             ///< "y" or "z"; empty: as the files say
  std::string hierarchy;      ///< the name of a bounding volume; empty: none is drawn
  std::string partition;      ///< the name of a partition of space; empty: none is drawn
  bool voronoi = false;       ///< the Voronoi regions of convex objects
  bool voronoi_walk = false;  ///< and the walk of each pair through them
};

struct DistanceArguments : PosedArguments {};

struct ReplayArguments {
  std::string file;
  std::string save_case;  ///< the case with the answer of now; empty: none
  Format format = Format::table;
  int threads = 0;
};

struct RayArguments : PosedArguments {
  std::optional<Vec3> from;
  std::optional<Vec3> to;
  std::string rays;  ///< a file of rays; empty: the one from `from` to `to`
};

struct FacesArguments : PosedArguments {
  std::optional<Region> region;
};

struct CostArguments : PosedArguments {
  CostOptions options;
  std::size_t rows = 10;  ///< of each table; 0: all
  std::string svg;        ///< a plot to write; empty: none
};

struct PlotArguments {
  std::string file;  ///< a report in JSON
  std::string svg;
};

struct NearestArguments : PosedArguments {
  std::optional<Vec3> point;
  std::string points;  ///< a file of points; empty: `point`
  std::size_t k = 1;
  std::string within;  ///< a length; empty: any
  bool sides = false;  ///< tells on which side of the surface each point is
};

struct MinkowskiArguments : PosedArguments {
  std::string mesh;  ///< a file for the boundary; empty: none
  MinkowskiQuestion question;
};

struct InspectArguments : PosedArguments {
  bool volumes = false;     ///< every bounding volume and hierarchy of meshes, too
  bool partitions = false;  ///< every partition of space over the triangles of meshes, too
  bool faults = false;      ///< where the faults of meshes are, too
  bool hierarchy = false;   ///< the tree of nodes instead of the objects
};

struct TreeArguments {
  std::string file;
  std::string save;   ///< where the tree is written
  std::string check;  ///< a tree file; one of the two is given
  int threads = 0;
};

struct DecomposeArguments : PosedArguments {
  DecomposeArguments() { glb_option = "-o or --glb"; }

  DecomposeQuestion question;  ///< but for its concavity
  std::string concavity;       ///< a length; empty: 0
};

struct PairsArguments {
  Format format = Format::table;
};

struct CrowdArguments : PosedArguments {
  CrowdArguments() { threads = 1; }

  std::string scene = "uniform";
  std::size_t count = 100'000;
  std::size_t frames = 60;
  std::string method = "auto";
  std::string bounds = "boxes";  ///< "boxes", "balls" or "oriented"
  bool world = false;            ///< bodies of many shapes in a World instead of boxes
  bool compare = false;          ///< all methods instead of the one
  std::uint64_t seed = 1;
  std::string cells = "method";  ///< those that the page shows, or "tracked"
};

struct DemoArguments {
  std::string write_folder;  ///< empty: run the demo
  Format format = Format::table;
  int threads = 0;
};

/// Each runs a subcommand and returns the exit code: 0 nothing to report, 1 something. Trouble is an exception.
int run_check(const CheckArguments& arguments);
int run_check_poses(const CheckArguments& arguments);
int run_check_self(const CheckArguments& arguments);
int run_view(const ViewArguments& arguments);
int run_inspect(const InspectArguments& arguments);
int run_inspect_hierarchy(const InspectArguments& arguments);
int run_distance(const DistanceArguments& arguments);
int run_distance_poses(const DistanceArguments& arguments);
int run_replay(const ReplayArguments& arguments);
int run_ray(const RayArguments& arguments);
int run_faces(const FacesArguments& arguments);
int run_cost(const CostArguments& arguments);
int run_plot(const PlotArguments& arguments);
int run_tree(const TreeArguments& arguments);
int run_decompose(const DecomposeArguments& arguments);
int run_nearest(const NearestArguments& arguments);
int run_minkowski(const MinkowskiArguments& arguments);
int run_pairs(const PairsArguments& arguments);
int run_crowd(const CrowdArguments& arguments);
int run_demo(const DemoArguments& arguments);

}  // namespace toccata::command
