#include "support/evidence.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace toccata::test {
namespace {

using Json = nlohmann::ordered_json;
constexpr const char* format_name = "toccata-evidence-1";

Json to_ranges(const std::vector<std::uint64_t>& shards) {
  Json ranges = Json::array();
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t end = i + 1;
    while (end < shards.size() && shards[end] == shards[end - 1] + 1) ++end;
    ranges.push_back({shards[i], shards[end - 1]});
    i = end;
  }
  return ranges;
}

std::vector<std::uint64_t> from_ranges(const Json& ranges) {
  std::vector<std::uint64_t> shards;
  for (const Json& range : ranges) {
    for (auto shard = range.at(0).get<std::uint64_t>(); shard <= range.at(1).get<std::uint64_t>(); ++shard) {
      shards.push_back(shard);
    }
  }
  return shards;
}

Json to_json(const EvidenceRun& run) {
  Json json{{"version", run.version}, {"commit", run.commit}, {"shards", to_ranges(run.shards)},
            {"cases", run.cases},     {"wrong", run.wrong},   {"seconds", run.seconds}};
  if (!run.first_failure.empty()) json["first_failure"] = run.first_failure;
  return json;
}

EvidenceRun run_from_json(const Json& json) {
  return {.version = json.at("version"),
          .commit = json.at("commit"),
          .shards = from_ranges(json.at("shards")),
          .cases = json.at("cases"),
          .wrong = json.at("wrong"),
          .seconds = json.at("seconds"),
          .first_failure = json.value("first_failure", "")};
}

Json to_json(const FamilyEvidence& family) {
  Json runs = Json::array();
  for (const EvidenceRun& run : family.runs) runs.push_back(to_json(run));
  return {{"cases", family.cases()}, {"wrong", family.wrong()}, {"seconds", family.seconds()}, {"runs", runs}};
}

}  // namespace

std::uint64_t FamilyEvidence::cases() const {
  std::uint64_t sum = 0;
  for (const EvidenceRun& run : runs) sum += run.cases;
  return sum;
}

std::uint64_t FamilyEvidence::cases_of(const std::string& commit) const {
  std::uint64_t sum = 0;
  for (const EvidenceRun& run : runs)
    if (run.commit == commit) sum += run.cases;
  return sum;
}

std::uint64_t FamilyEvidence::wrong() const {
  std::uint64_t sum = 0;
  for (const EvidenceRun& run : runs) sum += run.wrong;
  return sum;
}

double FamilyEvidence::seconds() const {
  double sum = 0;
  for (const EvidenceRun& run : runs) sum += run.seconds;
  return sum;
}

std::uint64_t FamilyEvidence::next_shard() const {
  std::uint64_t next = 0;
  const auto done = [&](const EvidenceRun& run) { return std::ranges::binary_search(run.shards, next); };
  while (std::ranges::any_of(runs, done)) ++next;
  return next;
}

Evidence Evidence::read(const std::filesystem::path& file, const std::string& name) {
  Evidence evidence;
  evidence.name_ = name;
  std::ifstream stream(file);
  if (!stream) return evidence;
  try {
    const Json json = Json::parse(stream);
    if (json.at("format") != format_name) throw std::runtime_error("its format is not " + std::string(format_name));
    for (const auto& [family, content] : json.at("families").items()) {
      for (const Json& run : content.at("runs")) evidence.families_[family].runs.push_back(run_from_json(run));
    }
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + " is not an evidence file: " + error.what());
  }
  return evidence;
}

void Evidence::write(const std::filesystem::path& file) const {
  Json families = Json::object();
  for (const auto& [family, content] : families_) families[family] = to_json(content);
  const std::filesystem::path unfinished = file.string() + ".unfinished";
  {
    std::ofstream stream(unfinished);
    stream << Json{{"format", format_name}, {"name", name_}, {"families", families}}.dump(1) << '\n';
    if (!stream.flush()) throw std::runtime_error("cannot write " + unfinished.string());
  }
  std::filesystem::rename(unfinished, file);
}

void Evidence::add(const std::string& family, std::uint64_t shard, const SweepResult& result, double seconds,
                   const std::string& version, const std::string& commit) {
  std::vector<EvidenceRun>& runs = families_[family].runs;
  auto run = std::ranges::find_if(
      runs, [&](const EvidenceRun& known) { return known.version == version && known.commit == commit; });
  if (run == runs.end()) run = runs.insert(run, EvidenceRun{.version = version, .commit = commit});
  run->shards.insert(std::ranges::upper_bound(run->shards, shard), shard);
  run->cases += result.cases;
  run->wrong += result.wrong;
  run->seconds += seconds;
  if (result.wrong > 0 && run->first_failure.empty()) run->first_failure = result.first_failure;
}

const FamilyEvidence& Evidence::family(const std::string& name) const {
  static const FamilyEvidence nothing_yet;
  const auto found = families_.find(name);
  return found == families_.end() ? nothing_yet : found->second;
}

}  // namespace toccata::test
