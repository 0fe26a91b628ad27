#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"
#include "cost_words.hpp"

namespace CLI {
class App;
}

namespace toccata::command {

/// What the options say before they become arguments.
struct Options {
  CheckArguments check;
  ViewArguments view;
  DistanceArguments distance;
  RayArguments ray;
  ReplayArguments replay;
  std::vector<std::string> from;
  std::vector<std::string> to;
  FacesArguments faces;
  std::vector<std::string> box;
  std::vector<std::string> ball;
  CostArguments cost;
  PlotArguments plot;
  CostWords cost_words;
  NearestArguments nearest;
  MinkowskiArguments minkowski;
  std::vector<std::string> point;
  InspectArguments inspect;
  TreeArguments tree;
  DecomposeArguments decompose;
  CrowdArguments crowd;
  DemoArguments demo;
  bool json = false;
  bool csv = false;
  std::vector<std::string> pose_a;
  std::vector<std::string> pose_b;
  std::string solid;
  std::string touching = "count";
};

/// All subcommands and their options; what is given of them goes into `options`.
void add_subcommands(CLI::App& app, Options& options);

/// {0} in the text becomes what the command was called as.
std::string with_name(const char* text);

}  // namespace toccata::command
