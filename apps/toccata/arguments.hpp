#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::command {

/// How a subcommand writes its answer to standard output.
enum class Format { table, json, csv, stream };

/// Files to read and what their numbers mean.
struct InputArguments {
  std::vector<std::string> files;
  std::vector<std::string> warnings;  ///< of what folders hold beside these
  std::string folder;                 ///< where relative names begin; empty: the current one
  std::string unit;  ///< of plain mesh files: mm, cm, m, in, ft, or metres per unit; empty: as the file says
  double scale = 1;
  std::string names;         ///< a file that lists files; empty: none
  std::string format;        ///< of standard input; empty: it is not read
  bool split = false;        ///< parts of mesh files are objects
  std::string tessellation;  ///< how near the mesh of a curved surface is to be to it, a length; empty: as is usual
  std::string close;         ///< how wide the gaps of meshes are that are closed, a length; empty: none are
  std::string cache;         ///< a folder of trees from run to run; empty: none
  int threads = 0;           ///< to read with
  std::string wanted;        ///< what the subcommand takes, for the error when there are none
};

/// Files for other programs; those that are empty are not asked for.
struct ExchangeFiles {
  std::string junit, sarif, bcf, overlap_bodies;
  std::string bcf_version = "2.1";
};

/// What is asked about, and where it is.
struct PosedArguments {
  InputArguments input;
  std::optional<Pose> pose_a;
  std::optional<Pose> pose_b;
  std::string poses;           ///< a file of queries about two objects; empty: all are asked about as they are
  std::optional<Solid> solid;  ///< overrides what the scene says
  std::string save_case;       ///< a file for what is asked and the answer; empty: none
  std::string html;            ///< a page to write besides; empty: none
  std::string png;             ///< a picture of it
  std::string size;            ///< of the picture, "1200x800"; empty: that
  std::string look;            ///< what the picture shows: the end of a link to the page
  std::string up;              ///< "y" or "z"; empty: as the files say
  std::string glb;             ///< a GLB file
  ExchangeFiles exchange;
  std::string glb_option = "--glb";  ///< how it is named on the command line
  Format format = Format::table;
  int threads = 0;
  double stop_after = std::numeric_limits<double>::infinity();  ///< in seconds, of the whole run of a check

  // As they are written, for `take_words`.
  std::vector<std::string> pose_a_words, pose_b_words;
  std::string solid_word;
};

struct CheckArguments : PosedArguments {
  bool self = false;                    ///< each object against itself, instead of against the others
  std::string touching_word = "count";  ///< as it is written
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
  std::string precision_word, time_per_depth_word;  ///< of penetrations, as they are written
  std::string clearance;                            ///< a length, or "all"; empty: none is asked for
  std::vector<std::string> clearances_of;           ///< "NAME,NAME=LENGTH"
};

struct CrowdArguments : PosedArguments {
  CrowdArguments() { threads = 1; }

  std::string scene = "uniform";
  std::size_t count = 100'000;
  std::size_t frames = 60;
  std::string method = "auto";
  std::string bounds = "boxes";  ///< "boxes", "balls" or "oriented"
  bool world = false;            ///< bodies of many shapes in a World instead of boxes
  std::string bodies = "fly";    ///< what these do, one of body_crowd_scenes
  bool compare = false;          ///< all methods instead of the one
  std::uint64_t seed = 1;
  std::string cells = "method";  ///< those that the page shows, or "tracked"
};

}  // namespace toccata::command
