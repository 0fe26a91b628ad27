#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "exchange.hpp"
#include "finding_words.hpp"
#include "named_files.hpp"
#include "toccata/core/version.hpp"
#include "words.hpp"

// OASIS, "Static Analysis Results Interchange Format (SARIF) Version 2.1.0", 2020.
namespace toccata::command {
namespace {

using SarifJson = nlohmann::ordered_json;

struct SarifRule {
  std::string_view id;
  std::string_view text;
};

constexpr std::array sarif_rules{
    SarifRule{"overlapping", "Two solids overlap."}, SarifRule{"crossing", "A surface and another object cross."},
    SarifRule{"touching", "Two objects touch."}, SarifRule{"clearance", "Two objects are nearer than their clearance."},
    SarifRule{"undecided", "Whether two objects collide could not be decided; it counts as if they did."}};

/// The file that holds the object, of those that were named.
std::string file_of(const Findings& findings, std::size_t object) {
  const std::vector<std::size_t>& first = findings.input.loaded.first_object;
  const auto file = static_cast<std::size_t>(std::upper_bound(first.begin(), first.end(), object) - first.begin() - 1);
  const std::vector<std::string>& files = findings.arguments.input.files;
  const std::string& name = files[std::min(file, files.size() - 1)];
  return name == standard_input ? "standard input" : name;
}

SarifJson location_of(const Findings& findings, std::size_t object) {
  const std::string name = printable(findings.input.loaded.scene.objects[object].name);
  return {{"physicalLocation", {{"artifactLocation", {{"uri", in_address(file_of(findings, object))}}}}},
          {"logicalLocations", SarifJson::array({{{"name", name}, {"kind", "object"}}})}};
}

std::string fingerprint_of(const std::string& a, const std::string& b) {
  return digits_of(std::min(a, b) + '\0' + std::max(a, b));
}

void add_numbers(SarifJson& properties, const ReportedPair& pair) {
  if (pair.penetration && pair.penetration->upper > 0)
    properties["depth"] = {{"lower", pair.penetration->lower}, {"upper", pair.penetration->upper}};
  if (pair.distance) properties["distance"] = {{"lower", pair.distance->lower}, {"upper", pair.distance->upper}};
  if (pair.moved_by) properties["moved_by"] = *pair.moved_by;
  if (pair.winding)
    properties["winding"] = {
        {"value", pair.winding->value}, {"lower", pair.winding->lower}, {"upper", pair.winding->upper}};
}

/// What `--volume` asks for.
void add_kind_and_volume(SarifJson& properties, const ReportedPair& pair) {
  properties["kind"] = name_of(pair.kind);
  if (pair.piercing != ClashPiercing::none) properties["piercing"] = name_of(pair.piercing);
  if (pair.volume)
    properties["volume"] = {{"lower", pair.volume->lower},
                            {"upper", pair.volume->upper},  // null beyond all doubles
                            {"status", name_of(pair.volume->status)}};
  if (const auto& point = pair.common_point) properties["point"] = {point->x, point->y, point->z};
}

SarifJson result_of(const Findings& findings, const ReportedPair& pair) {
  const Scene& scene = findings.input.loaded.scene;
  const std::string &a = scene.objects[pair.a].name, &b = scene.objects[pair.b].name;
  SarifJson result = {{"ruleId", kind_of_finding(pair)},
                      {"level", findings.is_failure(pair) ? "error" : "note"},
                      {"message", {{"text", sentence_of(scene, pair)}}},
                      {"locations", SarifJson::array({location_of(findings, pair.a), location_of(findings, pair.b)})},
                      {"partialFingerprints", {{"toccataPair/v1", fingerprint_of(a, b)}}}};
  if (findings.report.baseline) {
    const Since since = since_baseline(pair);
    result["baselineState"] = since == Since::added ? "new" : since == Since::known ? "unchanged" : "updated";
  }
  SarifJson properties = {{"relation", name_of(pair.relation.kind)}, {"status", name_of(pair.relation.status)}};
  if (pair.tolerance != ToleranceVerdict::none) properties["tolerance"] = name_of(pair.tolerance);
  if (const std::string by = tolerance_decided_by(pair); !by.empty()) properties["tolerance_by"] = by;
  add_numbers(properties, pair);
  if (findings.report.has_volume) add_kind_and_volume(properties, pair);
  result["properties"] = std::move(properties);
  return result;
}

/// The result for what is in the baseline and no longer found.
SarifJson absent_result_of(const GonePair& gone) {
  const std::string text = fmt::format("{} and {}: {}", printable(gone.was.a), printable(gone.was.b),
                                       gone.reason == GoneReason::apart ? "no clash now" : "not looked at now");
  return {{"ruleId", gone.was.kind == RelationKind::apart ? "clearance" : name_of(gone.was.kind)},
          {"level", "none"},
          {"message", {{"text", text}}},
          {"partialFingerprints", {{"toccataPair/v1", fingerprint_of(gone.was.a, gone.was.b)}}},
          {"baselineState", gone.reason == GoneReason::apart ? "absent" : "unchanged"}};
}

SarifJson driver() {
  SarifJson rules = SarifJson::array();
  for (const SarifRule& rule : sarif_rules)
    rules.push_back({{"id", rule.id}, {"shortDescription", {{"text", rule.text}}}});
  return {{"name", "Toccata"}, {"version", version}, {"rules", std::move(rules)}};
}

}  // namespace

std::string sarif_json(const Findings& findings) {
  SarifJson results = SarifJson::array(), notifications = SarifJson::array();
  for (const ReportedPair& pair : findings.report.pairs) results.push_back(result_of(findings, pair));
  for (const GonePair& gone : findings.report.gone) results.push_back(absent_result_of(gone));
  for (const std::string& warning : findings.input.loaded.warnings)
    notifications.push_back({{"level", "warning"}, {"message", {{"text", printable(warning)}}}});
  const SarifJson invocation = {{"executionSuccessful", findings.report.unfinished == 0},
                                {"toolExecutionNotifications", std::move(notifications)}};
  SarifJson run = {{"tool", {{"driver", driver()}}},
                   {"invocations", SarifJson::array({invocation})},
                   {"results", std::move(results)}};
  const SarifJson document = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                              {"version", "2.1.0"},
                              {"runs", SarifJson::array({std::move(run)})}};
  return document.dump(1, ' ', false, SarifJson::error_handler_t::replace) + "\n";
}

}  // namespace toccata::command
