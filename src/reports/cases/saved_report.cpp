#include "toccata/reports/scene_question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <variant>

#include "io/formats/file_bytes.hpp"
#include "io/formats/json.hpp"
#include "io/formats/utf8.hpp"
#include "io/scenes/solid_words.hpp"
#include "reports/questions/question_kinds.hpp"
#include "toccata/core/error.hpp"

namespace toccata {

using io::Json;

namespace {

constexpr std::string_view document_end = "\n}\n";

Json json_of(const Asked& asked) {
  Json json = {{"folder", io::as_utf8(asked.folder)}};
  Json& files = json["files"] = Json::array();
  for (const AskedFile& file : asked.files)
    files.push_back({{"name", io::as_utf8(file.name)}, {"digest", file.digest}});
  if (!asked.unit.empty()) json["unit"] = asked.unit;
  if (asked.scale != 1) json["scale"] = asked.scale;
  if (asked.split) json["split"] = true;
  if (!asked.tessellation.empty()) json["tessellation"] = asked.tessellation;
  if (!asked.close.empty()) json["close"] = asked.close;
  if (asked.pose_a) json["pose_a"] = asked.pose_a->numbers();
  if (asked.pose_b) json["pose_b"] = asked.pose_b->numbers();
  if (asked.solid) json["solid"] = io::word_of(*asked.solid);
  json["query"] = io::json_of(asked.question);
  return json;
}

std::optional<Pose> pose_of(const io::JsonValue& asked, const char* key) {
  if (!asked.has(key)) return std::nullopt;
  const std::vector<double> numbers = asked.at(key).numbers(12);
  std::array<double, 12> twelve{};
  std::copy(numbers.begin(), numbers.end(), twelve.begin());
  return Pose::from_numbers(twelve);
}

std::vector<AskedFile> files_of(const io::JsonValue& list, const SceneQuestion& question) {
  std::vector<AskedFile> files;
  for (const io::JsonValue& file : list.elements()) {
    file.expect_keys({"name", "digest"});
    files.push_back({file.at("name").text(), file.at("digest").text()});
  }
  if (files.empty() && !is_of_crowd(question)) list.fail("no file is named", "ask again");
  return files;
}

double scale_of(const io::JsonValue& asked) {
  if (!asked.has("scale")) return 1;
  const double scale = asked.at("scale").number();
  if (!(scale > 0)) asked.at("scale").fail("the scale is not positive", "ask again");
  return scale;
}

Asked asked_of(const io::JsonValue& value) {
  value.expect_keys(
      {"folder", "files", "unit", "scale", "split", "tessellation", "close", "pose_a", "pose_b", "solid", "query"});
  Asked asked;
  asked.folder = value.at("folder").text();
  asked.unit = value.text_or("unit", "");
  asked.scale = scale_of(value);
  asked.split = value.flag_or("split", false);
  asked.tessellation = value.text_or("tessellation", "");
  asked.close = value.text_or("close", "");
  asked.pose_a = pose_of(value, "pose_a");
  asked.pose_b = pose_of(value, "pose_b");
  if (value.has("solid")) asked.solid = io::solid_of(value.at("solid"));
  asked.question = io::question_of(value.at("query"));
  asked.files = files_of(value.at("files"), asked.question);
  return asked;
}

nlohmann::json document_in(const std::filesystem::path& path) {
  const io::FileBytes bytes = io::read_file(path);
  return io::parse_json(bytes.span(), path.string(), io::RepeatedKeys::refused);
}

bool is_schema(const nlohmann::json& document) {
  if (!document.is_object() || !document.contains("schema") || !document["schema"].is_string()) return false;
  return document["schema"].get_ref<const std::string&>().starts_with("toccata/");
}

/// Reports of questions are named after them: toccata/check-poses/2.
void require_answer(const io::JsonValue& top, const SceneQuestion& question) {
  if (!top.at("schema").text().starts_with("toccata/" + name_of(question) + "/"))
    top.at("schema").fail(fmt::format("this is no answer to the question {} in \"asked\"", name_of(question)),
                          "ask again");
}

[[noreturn]] void refuse_without_asked(const io::JsonValue& top) {
  top.fail("the report does not say what was asked: no question was, or an earlier version wrote it",
           "ask again with --json, and name that file");
}

}  // namespace

std::string with_asked(std::string report, const Asked& asked) {
  if (!report.ends_with(document_end)) throw Error("this is no report in JSON; hand over what report_json made");
  report.resize(report.size() - document_end.size());
  return report + ",\n  \"asked\": " + json_of(asked).dump(-1, ' ', false, Json::error_handler_t::replace) +
         std::string(document_end);
}

bool is_report(const std::filesystem::path& path) { return is_schema(document_in(path)); }

SavedReport read_report(const std::filesystem::path& path) {
  const nlohmann::json document = document_in(path);
  const std::string file = path.string();
  const io::JsonValue top(document, file);
  if (!is_schema(document)) top.fail("this is no report of Toccata", "name a file that a subcommand wrote with --json");
  if (!top.has("asked")) refuse_without_asked(top);
  SavedReport saved{asked_of(top.at("asked")), {}, document.dump()};
  require_answer(top, saved.asked.question);
  for (const io::JsonValue& object : top.elements("objects")) saved.sources.push_back(object.at("source").text());
  return saved;
}

}  // namespace toccata
