#include "exchange.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <functional>
#include <variant>
#include <vector>

#include "option_kinds.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/reports/output_file.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

/// How many of the findings are no clash.
std::string within_text(const CheckReport& report) {
  const auto within = std::count_if(report.pairs.begin(), report.pairs.end(), [](const ReportedPair& pair) {
    return pair.tolerance == ToleranceVerdict::within;
  });
  return within == 0 ? "" : fmt::format(", {} of them within the tolerance", within);
}

/// What a file of all findings is written from.
template <OutputKind kind, std::string (*bytes)(const Findings&)>
ExchangeContent findings_content(const Findings& findings) {
  const auto write = [content = bytes(findings)](const std::filesystem::path& file) {
    write_output(content, file, kind);
  };
  return {write, counted(findings.report.pairs.size(), "finding") + within_text(findings.report)};
}

/// A kind of file, where the arguments name it, and what makes it.
struct ExchangeFormat {
  const char* option;
  std::string ExchangeFiles::*file;
  OutputKind kind;
  ExchangeContent (*content)(const Findings&);
};

constexpr std::array exchange_formats{
    ExchangeFormat{"--junit", &ExchangeFiles::junit, OutputKind::junit, findings_content<OutputKind::junit, junit_xml>},
    ExchangeFormat{"--sarif", &ExchangeFiles::sarif, OutputKind::sarif,
                   findings_content<OutputKind::sarif, sarif_json>},
    ExchangeFormat{"--bcf", &ExchangeFiles::bcf, OutputKind::bcf, findings_content<OutputKind::bcf, bcf_zip>},
    ExchangeFormat{"--overlap-bodies", &ExchangeFiles::overlap_bodies, OutputKind::glb, overlap_bodies_content}};

}  // namespace

void add_exchange(CLI::App& app, ExchangeFiles& files) {
  add_file(app, "--junit", files.junit, "write JUnit XML, for continuous integration (docs/reference/exchange.md)",
           "FILE.xml");
  add_file(app, "--sarif", files.sarif, "write SARIF 2.1.0, for code scanning", "FILE.sarif");
  CLI::Option* bcf =
      add_file(app, "--bcf", files.bcf, "write BCF, for programs that exchange issues of building models", "FILE.bcf");
  app.add_option("--bcf-version", files.bcf_version, "the version of BCF that --bcf writes")
      ->check(CLI::IsMember({"2.1", "3.0"}))
      ->capture_default_str()
      ->needs(bcf);
  add_file(app, "--overlap-bodies", files.overlap_bodies,
           "write GLB of what each two solids that overlap have in common, as closed meshes", "FILE.glb");
}

void require_exchange(const PosedArguments& arguments) {
  std::vector<NamedOutput> outputs{{"--html", arguments.html},
                                   {"--png", arguments.png},
                                   {"--glb", arguments.glb},
                                   {"--save-case", arguments.save_case}};
  for (const ExchangeFormat& format : exchange_formats)
    outputs.push_back({format.option, arguments.exchange.*format.file});
  require_distinct(outputs, arguments.input.files);
  for (const ExchangeFormat& format : exchange_formats)
    if (const std::string& file = arguments.exchange.*format.file; !file.empty()) require_output(file, format.kind);
}

ExchangeTold write_exchange(const CheckInput& input, const SceneAnswer& answer, const PosedArguments& arguments,
                            const IsFailure& is_failure) {
  ExchangeTold told;
  for (const ExchangeFormat& format : exchange_formats) {
    const std::string& file = arguments.exchange.*format.file;
    if (file.empty()) continue;
    const auto* report = std::get_if<CheckReport>(&answer);
    if (report == nullptr)
      throw Error(
          fmt::format("{} tells pairs of a check, and another question was asked: leave it out", format.option));
    const ExchangeContent content = format.content({input, *report, arguments, is_failure});
    const UninterruptedWriting writing;
    content.write(file);
    told.lines += fmt::format("{}: {}.\n", printable(file), content.holds);
    told.was_stopped = told.was_stopped || content.was_stopped;
  }
  return told;
}

}  // namespace toccata::command
