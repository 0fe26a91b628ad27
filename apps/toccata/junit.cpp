#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "exchange.hpp"
#include "finding_words.hpp"
#include "words.hpp"

// The form of JUnit's reports that continuous integration reads (Jenkins, GitLab, Azure …): a suite, a test case for
// each pair that is told, and a failure in those that make the check fail.
namespace toccata::command {
namespace {

void set(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

void add_case(pugi::xml_node suite, const Findings& findings, const ReportedPair& pair) {
  const Scene& scene = findings.input.loaded.scene;
  pugi::xml_node one = suite.append_child("testcase");
  set(one, "classname", "toccata.check");
  set(one, "name",
      fmt::format("{} – {}", printable(scene.objects[pair.a].name), printable(scene.objects[pair.b].name)));
  std::string text = sentence_of(scene, pair);
  const std::string message = text;
  for (const std::string& detail : details_of(scene, pair, findings.report.baseline.has_value())) text += "\n" + detail;
  if (!findings.is_failure(pair)) {
    one.append_child("system-out").text().set(text.c_str());
    return;
  }
  pugi::xml_node failure = one.append_child("failure");
  set(failure, "type", kind_of_finding(pair));
  set(failure, "message", message);
  failure.text().set(text.c_str());
}

/// What a report tells how many of.
struct JunitCounts {
  std::size_t tests = 0, failures = 0, errors = 0;
};

void add_counts(pugi::xml_node node, const JunitCounts& counts) {
  set(node, "tests", fmt::format("{}", counts.tests));
  set(node, "failures", fmt::format("{}", counts.failures));
  set(node, "errors", fmt::format("{}", counts.errors));
}

JunitCounts counts_of(const Findings& findings) {
  const CheckReport& report = findings.report;
  const auto failures =
      static_cast<std::size_t>(std::count_if(report.pairs.begin(), report.pairs.end(), findings.is_failure));
  const std::size_t errors = report.unfinished > 0 ? 1 : 0;
  // Without a case a report counts as one that tests nothing.
  return {std::max<std::size_t>(1, report.pairs.size() + errors), failures, errors};
}

/// The only case that is about no pair.
void add_case_of_all(pugi::xml_node suite, const CheckReport& report) {
  if (!report.pairs.empty() && report.unfinished == 0) return;
  pugi::xml_node one = suite.append_child("testcase");
  set(one, "classname", "toccata.check");
  set(one, "name", report.unfinished == 0 ? "nothing collides" : "all pairs are looked at");
  if (report.unfinished == 0) return;
  pugi::xml_node error = one.append_child("error");
  set(error, "type", "stopped");
  set(error, "message", counted(report.unfinished, "pair") + " not looked at");
}

}  // namespace

std::string junit_xml(const Findings& findings) {
  const CheckReport& report = findings.report;
  const JunitCounts counts = counts_of(findings);
  pugi::xml_document document;
  document.append_child(pugi::node_comment).set_value(" JUnit XML of Toccata ");
  pugi::xml_node suites = document.append_child("testsuites");
  set(suites, "name", "toccata");
  add_counts(suites, counts);
  pugi::xml_node suite = suites.append_child("testsuite");
  set(suite, "name", "toccata check");
  add_counts(suite, counts);
  for (const ReportedPair& pair : report.pairs) add_case(suite, findings, pair);
  add_case_of_all(suite, report);
  std::string told = counted(findings.input.loaded.scene.objects.size(), "object") + ", " +
                     counted(report.candidate_pairs - report.unfinished, "pair") + " looked at";
  for (const std::string& warning : findings.input.loaded.warnings) told += "\nwarning: " + printable(warning);
  suite.append_child("system-out").text().set(told.c_str());
  std::ostringstream text;
  document.save(text, " ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

}  // namespace toccata::command
