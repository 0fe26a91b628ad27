#include <fmt/format.h>

#include <algorithm>

#include "early_end.hpp"
#include "exchange.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "toccata/reports/pages.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// The first of the pairs without a body, and how many more there are.
std::string left_out_text(const Findings& findings, const OverlapBodiesGlb& made) {
  constexpr std::size_t most_told = 3;
  const auto name_of = [&](Index object) { return printable(findings.input.models[object].name); };
  const std::size_t told = std::min(made.left_out.size(), most_told);
  std::string text;
  for (std::size_t i = 0; i < told; ++i) {
    const auto& [place, reason] = made.left_out[i];
    const ReportedPair& pair = findings.report.pairs[place];
    text += fmt::format("{} × {}: {}; ", name_of(pair.a), name_of(pair.b), reason);
  }
  if (made.left_out.size() > told) text += fmt::format("and {} more; ", grouped(made.left_out.size() - told));
  return text.substr(0, text.size() - 2);
}

}  // namespace

ExchangeContent overlap_bodies_content(const Findings& findings) {
  const PosedArguments& arguments = findings.arguments;
  const EarlyEnd end(arguments.stop_after);
  OverlapBodiesGlb made;
  {
    ProgressBar bar("overlap bodies");
    made = overlap_bodies_glb(
        findings.input.loaded.scene, findings.input.models, findings.report,
        {.title = title_of(arguments.input.files), .up = up_of(arguments)},
        {.threads = arguments.threads, .progress = bar.callback(), .stop = [&] { return end.is_due(); }},
        arguments.exchange.overlap_bodies);
  }
  if (!made.left_out.empty())
    print_warnings({fmt::format("{}: {} no body: {}", printable(arguments.exchange.overlap_bodies),
                                counted(made.left_out.size(), "pair that overlaps has", "pairs that overlap have"),
                                left_out_text(findings, made))});
  std::string holds = counted(made.bodies, "overlap body", "overlap bodies");
  if (!made.left_out.empty())
    holds +=
        fmt::format("; {} none", counted(made.left_out.size(), "pair that overlaps has", "pairs that overlap have"));
  if (made.stopped > 0) holds += ": stopped before all were made";
  return {std::move(made.write), std::move(holds), made.stopped > 0};
}

}  // namespace toccata::command
