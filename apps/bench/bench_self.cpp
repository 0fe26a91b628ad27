#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "arguments.hpp"
#include "oracle/meshes.hpp"
#include "report.hpp"
#include "self.hpp"
#include "single_mesh.hpp"
#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

struct MeasuredSelf {
  Result result;
  TrianglePairs pairs;
};

MeasuredSelf measured(SelfLibrary& library, int rounds) {
  MeasuredSelf one;
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) times.push_back(1e6 * seconds_of([&] { one.pairs = library.pairs(); }));
  std::sort(one.pairs.begin(), one.pairs.end());
  one.result.who = library.description();
  one.result.task = "self";
  one.result.queries = 1;
  summarise({*std::min_element(times.begin(), times.end())}, one.result);
  return one;
}

TrianglePairs only_in(const TrianglePairs& some, const TrianglePairs& others) {
  TrianglePairs found;
  std::set_difference(some.begin(), some.end(), others.begin(), others.end(), std::back_inserter(found));
  return found;
}

/// In rational arithmetic.
bool meet(const oracle::MeshSet& mesh, Index i, Index j) {
  return !oracle::self_intersecting_pairs({{mesh.triangles[i], mesh.triangles[j]}}).empty();
}

/// Counts the pairs that differ, and judges each.
void judge(const TriangleMesh& mesh, std::vector<MeasuredSelf>& measured) {
  const oracle::MeshSet exact = oracle::surface_set(mesh, {});
  MeasuredSelf& first = measured.front();
  for (MeasuredSelf& one : measured)
    for (const auto& [some, others] : {std::pair{&first, &one}, std::pair{&one, &first}})
      for (const auto& [i, j] : only_in(some->pairs, others->pairs)) {
        ++one.result.disagreements;
        (meet(exact, i, j) ? others : some)->result.wrong += 1;
      }
}

}  // namespace

int run_self(const SelfArguments& arguments) {
  SelfLibraries libraries = toccata_self_libraries();
  for (const std::string& peer : arguments.peers)
    for (auto& library : peer == "cgal" ? cgal_self_libraries() : SelfLibraries{})
      libraries.push_back(std::move(library));
  const TriangleMesh mesh = *single_mesh(arguments.mesh);
  std::vector<MeasuredSelf> all;
  Measurements measurements;
  for (auto& library : libraries) {
    if (library->prepare(mesh))
      all.push_back(measured(*library, arguments.rounds));
    else
      measurements.not_measured.push_back(
          {library->description(), "self", 1, "takes no mesh with a triangle without area or an edge of three faces"});
    library.reset();
  }
  judge(mesh, all);
  for (const MeasuredSelf& one : all) measurements.results.push_back(one.result);
  auto report = report_of("self", {{"mesh", arguments.mesh},
                                   {"triangles", mesh.triangle_count()},
                                   {"rounds", arguments.rounds},
                                   {"pairs", all.front().pairs.size()}});
  return print_results(std::move(report), measurements, arguments.json);
}

}  // namespace toccata::bench
