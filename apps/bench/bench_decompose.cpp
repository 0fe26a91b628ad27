#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "arguments.hpp"
#include "decomposing.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/query/convex_parts.hpp"

namespace toccata::bench {
namespace {

struct Cut {
  ConvexParts parts;
  double seconds = 0;  ///< of the thread; the fastest round
};

Cut cut(const Model& model, const DecomposeArguments& arguments) {
  Cut result;
  std::vector<double> seconds;
  for (int round = 0; round < arguments.rounds; ++round)
    seconds.push_back(
        seconds_of([&] { result.parts = decompose(model, {.max_parts = arguments.parts}); }, Clock::thread));
  result.seconds = *std::ranges::min_element(seconds);
  return result;
}

std::string line_of(const std::string& who, std::size_t parts, double excess, double seconds) {
  return fmt::format("{}: {} parts, {:.2f} % larger than the solid, in {:.3g} s of the thread", who, parts,
                     100 * excess, seconds);
}

}  // namespace

int run_decompose(const DecomposeArguments& arguments) {
  if (arguments.task != "cut") return run_decomposed(arguments);
  const Model model(single_mesh(arguments.mesh));
  const auto [parts, seconds] = cut(model, arguments);
  auto report = report_of("decompose", {{"mesh", arguments.mesh},
                                        {"triangles", model.mesh().triangle_count()},
                                        {"max_parts", arguments.parts},
                                        {"rounds", arguments.rounds}});
  report["results"] = {{{"library", "toccata"},
                        {"seconds", seconds},
                        {"parts", parts.parts.size()},
                        {"mesh_volume", parts.mesh_volume},
                        {"excess", parts.excess},
                        {"concavity", parts.concavity}}};
  std::string lines = fmt::format("{} triangles\n", model.mesh().triangle_count()) +
                      line_of("toccata", parts.parts.size(), parts.excess / parts.mesh_volume, seconds);
  if (!arguments.peers.empty()) {
    const PeerParts peer = cgal_convex_parts(model.mesh());
    const double excess = peer.volume - parts.mesh_volume;
    report["results"].push_back({{"library", peer.who.library},
                                 {"variant", peer.who.variant},
                                 {"version", peer.who.version},
                                 {"seconds", peer.seconds},
                                 {"parts", peer.parts},
                                 {"excess", excess}});
    lines += "\n" + line_of(peer.who.library, peer.parts, excess / parts.mesh_volume, peer.seconds) +
             " (exact, with no limit of parts)";
  }
  fmt::print("{}\n", arguments.json ? report.dump(2) : lines);
  return 0;
}

}  // namespace toccata::bench
