#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "arguments.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "single_mesh.hpp"
#include "toccata/query/convex_parts.hpp"

namespace toccata::bench {

int run_decompose(const DecomposeArguments& arguments) {
  const Model model(single_mesh(arguments.mesh));
  ConvexParts parts;
  std::vector<double> seconds;
  for (int round = 0; round < arguments.rounds; ++round)
    seconds.push_back(seconds_of([&] { parts = decompose(model, {.max_parts = arguments.parts}); }, Clock::thread));
  const double fastest = *std::min_element(seconds.begin(), seconds.end());
  auto report = report_of("decompose", {{"mesh", arguments.mesh},
                                        {"triangles", model.mesh().triangle_count()},
                                        {"max_parts", arguments.parts},
                                        {"rounds", arguments.rounds}});
  report["results"] = {{{"library", "toccata"},
                        {"seconds", fastest},
                        {"parts", parts.parts.size()},
                        {"mesh_volume", parts.mesh_volume},
                        {"excess", parts.excess},
                        {"concavity", parts.concavity}}};
  if (arguments.json)
    fmt::print("{}\n", report.dump(2));
  else
    fmt::print("{} triangles: {} parts, {:.2f} % larger than the solid, in {:.2f} s of the thread\n",
               model.mesh().triangle_count(), parts.parts.size(), 100 * parts.excess / parts.mesh_volume, fastest);
  return 0;
}

}  // namespace toccata::bench
