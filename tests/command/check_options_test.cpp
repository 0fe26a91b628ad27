// Every option of `toccata check` beside every other one: it works, or is refused with the reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/command.hpp"
#include "support/stand_in_browser.hpp"

namespace toccata {
namespace {

using test::run_command;
using test::TemporaryFolder;
using test::text_of;
using Words = std::vector<std::string>;
using OptionJson = nlohmann::json;

/// What a run that works left behind.
struct CheckSeen {
  std::string out;
  OptionJson question, report;  ///< null where the run told none
  const TemporaryFolder& folder;

  /// Of the report, of its pairs, or of the queries of --poses.
  [[nodiscard]] bool has_in_first(const char* field) const {
    const OptionJson& list = report.at(report.contains("queries") ? "queries" : "pairs");
    return list.empty() || list[0].contains(field);
  }
};

/// Whether it shows what an option asked for.
using OptionEffect = std::function<bool(const CheckSeen&)>;

struct OptionSample {
  Words words;               ///< which begin with the option
  OptionEffect effect = {};  ///< none: nothing of these boxes changes
  std::string company = {};  ///< the option without which it says nothing
  bool is_of_report = true;  ///< what it changes is seen in the report, which a check that was stopped does not have
};

/// Null where the text is no JSON.
OptionJson parsed(const std::string& text) { return OptionJson::accept(text) ? OptionJson::parse(text) : OptionJson(); }

/// By options; where it has kinds of values, one of each.
using OptionSamples = std::map<std::string, std::vector<OptionSample>>;

OptionEffect asks(const char* field, const OptionJson& value) {
  return [=](const CheckSeen& seen) { return seen.question.value(field, OptionJson()) == value; };
}

OptionEffect tells(const char* field) {
  return [=](const CheckSeen& seen) { return seen.report.contains(field); };
}

OptionEffect tells_of_the_first(const char* field) {
  return [=](const CheckSeen& seen) { return seen.has_in_first(field); };
}

/// The object of this number is moved, as its pose says.
OptionEffect poses_at(std::size_t object) {
  return [=](const CheckSeen& seen) { return seen.report.at("objects")[object].at("pose")[9] != 0; };
}

OptionSample writes(const char* option, const char* file, std::string_view begin, const char* company = "") {
  const OptionEffect effect = [=](const CheckSeen& seen) { return text_of(seen.folder / file).starts_with(begin); };
  return {{option, file}, effect, company, false};
}

/// As above, of an option that changes the file of another.
OptionSample changes(Words words, const char* file, std::string_view begin, const char* company) {
  return {std::move(words), writes("", file, begin).effect, company, false};
}

OptionSamples samples_of_objects() {
  const auto is_resized = [](const CheckSeen& seen) { return seen.report.at("objects")[0].at("pose")[0] != 1; };
  const auto is_read_from_input = [](const CheckSeen& seen) {
    return seen.report.at("objects")[1].at("source").get<std::string>().starts_with("generated");
  };
  const auto is_first_named = [](const CheckSeen& seen) {
    return seen.report.at("objects")[0].at("source") == "a.obj";
  };
  const auto are_solids = [](bool solids) {
    return [=](const CheckSeen& seen) { return seen.report.at("objects")[0].at("solid") == solids; };
  };
  const Words pose{"1", "0", "0", "0", "1", "0", "0", "0", "1", "0.5", "0", "0"};
  const auto posed = [&](const char* option) {
    Words words{option};
    words.insert(words.end(), pose.begin(), pose.end());
    return words;
  };
  return {{"--unit", {{{"--unit", "mm"}, is_resized}, {{"--unit", "ft"}, is_resized}}},
          {"--scale", {{{"--scale", "2"}, is_resized}, {{"--scale", "0.5"}, is_resized}}},
          {"--pose-a", {{posed("--pose-a"), poses_at(0)}, {{"--pose-a", "0.5", "0", "0"}, poses_at(0)}}},
          {"--pose-b", {{posed("--pose-b"), poses_at(1)}, {{"--pose-b", "0.5", "0", "0"}, poses_at(1)}}},
          {"--poses", {{{"--poses", "poses.txt"}, tells("queries")}, {{"--poses", "both.txt"}, tells("queries")}}},
          {"--solid", {{{"--solid", "none"}, are_solids(false)}, {{"--solid", "by-winding"}, are_solids(true)}}},
          {"--names", {{{"--names", "list.txt"}, is_first_named}}},
          {"--format", {{{"--format", "json"}, is_read_from_input}}},
          {"--split", {{{"--split"}}}},
          {"--close", {{{"--close", "0.001"}}, {{"--close", "0.01"}}}},
          {"--tessellation", {{{"--tessellation", "1mm"}}, {{"--tessellation", "0.5"}}}},
          {"--cache", {{{"--cache", "trees"}}}},
          {"--threads", {{{"--threads", "2"}}, {{"--threads", "1"}}}}};
}

OptionSamples samples_of_questions() {
  const char *depths = "--penetration", *baseline = "--baseline";
  const auto is_stopped = [](const CheckSeen& seen) { return seen.report.at("unfinished") == 1; };
  const auto clearance_is = [](const OptionJson& all) {
    return [=](const CheckSeen& seen) {
      return seen.report.at("clearance") == seen.question.at("clearance") &&
             (seen.report.at("clearance") == "all") == all;
    };
  };
  return {
      {"--touching",
       {{{"--touching", "ignore"}, asks("touching", "ignore")}, {{"--touching", "count"}, asks("touching", "count")}}},
      {"--penetration", {{{depths}, tells_of_the_first("penetration")}}},
      {"--precision",
       {{{"--precision", "0.5"}, asks("precision", 0.5), depths},
        {{"--precision", "0.01"}, asks("precision", 0.01), depths}}},
      {"--time-per-depth",
       {{{"--time-per-depth", "9"}, asks("time_per_depth", 9), depths},
        {{"--time-per-depth", "0.001"}, asks("time_per_depth", 0.001), depths}}},
      {"--clearance", {{{"--clearance", "3"}, clearance_is(false)}, {{"--clearance", "all"}, clearance_is(true)}}},
      {"--clearance-of",
       {{{"--clearance-of", "a,b=3"}, tells("pair_clearances")},
        {{"--clearance-of", "a,b=all"}, tells("pair_clearances")}}},
      {"--rules", {{{"--rules", "rules.txt"}, tells("left_out")}, {{"--rules", "depths.txt"}, tells("tolerance")}}},
      {"--ignore", {{{"--ignore", "c*"}, tells("left_out")}, {{"--ignore", "a,a"}, tells("left_out")}}},
      {"--between", {{{"--between", "a,b"}, tells("left_out")}, {{"--between", "b"}, tells("left_out")}}},
      {"--baseline", {{{baseline, "old.json"}, tells("baseline")}, {{baseline, "apart.json"}, tells("baseline")}}},
      {"--fail-on", {{{"--fail-on", "hard"}}, {{"--fail-on", "new"}, tells("baseline"), baseline}}},
      {"--sort", {{{"--sort", "severity"}, asks("sort", "severity")}, {{"--sort", "objects"}}}},
      {"--group", {{{"--group", "part"}, asks("group", "part")}, {{"--group", "region"}, tells("groups")}}},
      {"--tolerance",
       {{{"--tolerance", "0.5"}, tells("tolerance")}, {{"--tolerance", "2"}, tells("within_tolerance")}}},
      {"--volume", {{{"--volume"}, tells_of_the_first("kind")}}},
      {"--self", {{{"--self"}, tells("self_contacts")}}},
      {"--faces", {{{"--faces"}, asks("faces", true)}}},
      {"--stop-after", {{{"--stop-after", "600"}}, {{"--stop-after", "1e-9"}, is_stopped}}}};
}

OptionSamples samples_of_output() {
  const auto is_json = [](const CheckSeen& seen) {
    const OptionJson report = parsed(seen.out);
    return report.is_object() && report.value("schema", "").starts_with("toccata/check");
  };
  const auto are_json_lines = [](const CheckSeen& seen) {
    return parsed(seen.out.substr(seen.out.rfind('\n', seen.out.size() - 2) + 1)).contains("complete");
  };
  const auto is_csv = [](const CheckSeen& seen) {
    const std::string head = seen.out.substr(0, seen.out.find('\n'));
    return head.starts_with("a,b,") || head.starts_with("query,") || head.starts_with("object,");
  };
  const char *bcf = "--bcf", *png = "--png", *picture = "page.png", *png_begin = "\x89PNG";
  return {{"--json", {{{"--json"}, is_json, "", false}}},
          {"--csv", {{{"--csv"}, is_csv, "", false}}},
          {"--stream", {{{"--stream"}, are_json_lines, "", false}}},
          {"--junit", {writes("--junit", "found.xml", "<?xml")}},
          {"--sarif", {writes("--sarif", "found.sarif", "{")}},
          {"--bcf", {writes(bcf, "found.bcf", "PK")}},
          {"--bcf-version",
           {changes({"--bcf-version", "3.0"}, "found.bcf", "PK", bcf),
            changes({"--bcf-version", "2.1"}, "found.bcf", "PK", bcf)}},
          {"--overlap-bodies", {writes("--overlap-bodies", "bodies.glb", "glTF")}},
          {"--html", {writes("--html", "page.html", "<!doctype html>")}},
          {"--png", {writes(png, picture, png_begin)}},
          {"--size",
           {changes({"--size", "64x48"}, picture, png_begin, png),
            changes({"--size", "400x300"}, picture, png_begin, png)}},
          {"--look",
           {changes({"--look", "theme=dark"}, picture, png_begin, png),
            changes({"--look", "camera=front"}, picture, png_begin, png)}},
          {"--glb", {writes("--glb", "scene.glb", "glTF")}},
          {"--save-case", {writes("--save-case", "case.json", "{")}}};
}

const OptionSamples& samples() {
  static const OptionSamples all = [] {
    OptionSamples together = samples_of_objects();
    together.merge(samples_of_questions());
    together.merge(samples_of_output());
    return together;
  }();
  return all;
}

/// The options that the help tells.
std::set<std::string> options_told() {
  const std::string help = run_command({"check", "--help"}).out;
  std::set<std::string> options;
  for (std::size_t line = 0; line != std::string::npos; line = help.find("\n  -", line + 1)) {
    const std::size_t end_of_line = help.find('\n', line + 1), name = help.find("--", line);
    if (line == 0 || name == std::string::npos || name > end_of_line) continue;
    options.insert(help.substr(name, help.find_first_of(" \n,", name) - name));
  }
  options.erase("--help");
  options.erase("--distributed");  // becomes another program (over_ranks_test.cpp)
  return options;
}

/// Words that are refused together.
const std::vector<std::pair<std::string, std::string>>& refused_together() {
  static const std::vector<std::pair<std::string, std::string>> all = [] {
    std::vector<std::pair<std::string, std::string>> pairs{
        {"--csv", "--json"}, {"--pose-a", "--poses"}, {"--pose-b", "--poses"}};
    const auto add = [&](const std::string& option, const Words& others) {
      for (const std::string& other : others) pairs.emplace_back(option, other);
    };
    const Words of_pairs{"--baseline",     "--bcf",        "--between",   "--clearance",
                         "--clearance-of", "--group",      "--ignore",    "--junit",
                         "--rules",        "--sarif",      "--sort",      "--overlap-bodies",
                         "--stream",       "--stop-after", "--tolerance", "--volume"};
    add("--poses", of_pairs);
    add("--poses", {"--self", "by-winding"});
    add("--self", of_pairs);
    add("--self", {"--fail-on", "--penetration", "--solid", "--touching"});
    add("--stream", {"--baseline", "--csv", "--group", "--json", "--save-case", "--sort", "by-winding"});
    return pairs;
  }();
  return all;
}

bool contains(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

class CheckOptionsTogether : public testing::Test {
 protected:
  void SetUp() override {
    const std::string box =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    folder.write("a.obj", box);
    folder.write("b.obj", box);
    folder.write("list.txt", "a.obj\n");
    folder.write("input.json", R"({"format": "toccata-scene", "version": 1, "objects": [
      {"name": "b", "generate": "box", "parameters": {"half-x": 0.5, "half-y": 0.5, "half-z": 0.5}}]})");
    folder.write("poses.txt", "1 0 0 0 1 0 0 0 1 0.25 0 0\n");
    folder.write("both.txt", "1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0 0 0 1 0.25 0 0\n");
    folder.write("rules.txt", "boxes = a, b\nbetween boxes, boxes\n");
    folder.write("depths.txt", "tolerance a, b = 0.25\n");
    folder.write("old.json", run_command({"check", "a.obj", "b.obj", "--json"}, folder.path()).out);
    folder.write("apart.json",
                 run_command({"check", "a.obj", "b.obj", "--json", "--pose-b", "9", "0", "0"}, folder.path()).out);
  }

  /// The words of some samples, and of what these need beside them.
  static Words words_of(const std::vector<const OptionSample*>& asked) {
    Words words;
    const auto add = [&](const Words& more) { words.insert(words.end(), more.begin(), more.end()); };
    for (const OptionSample* sample : asked) add(sample->words);
    for (const OptionSample* sample : asked)
      if (!sample->company.empty() && !contains(words, sample->company)) add(samples().at(sample->company)[0].words);
    return words;
  }

  test::CommandResult check(const Words& asked) {
    Words words{"check"};
    if (!contains(asked, "--names")) words.push_back("a.obj");
    words.push_back(contains(asked, "--format") ? "-" : "b.obj");
    words.insert(words.end(), asked.begin(), asked.end());
    return run_command(words, folder.path(), folder / "input.json");
  }

  /// One beside the other: refused with the reason, or what each asks for is there.
  void expect_together(const OptionSample& one, const OptionSample& other) {
    Words words = words_of({&one, &other});
    SCOPED_TRACE(testing::PrintToString(words));
    for (const auto& [first, second] : refused_together())
      if (contains(words, first) && contains(words, second)) return expect_refusal(check(words), first, second);
    // The case has the question and the answer of every run, whatever form it is told in.
    if (!contains(words, "--stream") && !contains(words, "--save-case"))
      words.insert(words.end(), {"--save-case", "case.json"});
    for (const char* file :
         {"case.json", "found.xml", "found.sarif", "found.bcf", "bodies.glb", "page.html", "page.png", "scene.glb"})
      std::filesystem::remove(folder / file);
    expect_effects(check(words), {&one, &other});
  }

  static void expect_refusal(const test::CommandResult& run, const std::string& first, const std::string& second) {
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(first), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(second), std::string::npos) << run.err;
  }

  void expect_effects(const test::CommandResult& run, const std::vector<const OptionSample*>& asked) {
    EXPECT_NE(run.exit_code, 2) << run.err;
    EXPECT_FALSE(run.out.empty());
    EXPECT_EQ(run.err.find("error"), std::string::npos) << run.err;
    const OptionJson told = parsed(text_of(folder / "case.json"));
    CheckSeen seen{run.out, {}, {}, folder};
    if (told.is_object()) seen.question = told.at("query"), seen.report = told.value("answer", OptionJson());
    // A case does not have the answer of a check that was stopped.
    if (seen.report.is_null()) seen.report = parsed(run.out);
    for (const OptionSample* sample : asked) {
      if (!sample->effect || (sample->is_of_report && seen.report.is_null())) continue;
      EXPECT_TRUE(sample->effect(seen)) << sample->words[0] << ": " << seen.question << seen.report << run.out;
    }
  }

  TemporaryFolder folder;
  test::StandInBrowser browser{test::drawing_script()};
};

TEST_F(CheckOptionsTogether, EveryOptionHasASample) {
  std::set<std::string> known;
  for (const auto& [option, of_option] : samples()) known.insert(option);
  EXPECT_EQ(options_told(), known);
}

TEST_F(CheckOptionsTogether, EveryPairWorksOrIsRefusedWithTheReason) {
  for (auto one = samples().begin(); one != samples().end(); ++one)
    for (auto other = std::next(one); other != samples().end(); ++other)
      expect_together(one->second[0], other->second[0]);
}

TEST_F(CheckOptionsTogether, EverySecondValueWorksBesideWhatDecidesTheAnswer) {
  for (const auto& [option, of_option] : samples())
    for (std::size_t value = 1; value < of_option.size(); ++value)
      for (const char* other : {"--json", "--stream", "--poses", "--self", "--baseline", "--rules", "--tolerance"})
        if (option != other) expect_together(of_option[value], samples().at(other)[0]);
}

TEST_F(CheckOptionsTogether, WhatIsGivenTwiceIsTroubleUnlessItMayBeRepeated) {
  const std::set<std::string> repeatable = {"--clearance-of", "--rules", "--ignore", "--between"};
  const std::set<std::string> flags = {"--penetration", "--self",  "--faces",  "--json",
                                       "--csv",         "--split", "--stream", "--volume"};
  for (const auto& [option, of_option] : samples()) {
    if (flags.contains(option)) continue;
    Words words = words_of({&of_option[0]});
    words.insert(words.end(), of_option[0].words.begin(), of_option[0].words.end());
    const int code = check(words).exit_code;
    if (option == "--rules")
      EXPECT_EQ(code, 2) << "its set would be there twice";
    else
      EXPECT_EQ(code == 2, !repeatable.contains(option)) << option;
  }
}

TEST(CheckOptions, AnEmptyWordIsToldByItsOption) {
  const test::TemporaryFolder folder;
  for (const auto& [option, missing] :
       {std::pair("--precision", "a number must be given"), std::pair("--time-per-depth", "seconds must be given"),
        std::pair("--unit", "a unit must be given"), std::pair("--tolerance", "a length must be given")}) {
    const auto result =
        test::run_command({"check", "gen:box", "gen:torus", "--penetration", option, ""}, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(std::string(option) + ": " + missing), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace toccata
