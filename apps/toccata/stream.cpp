#include "stream.hpp"

#include <nlohmann/json.hpp>

#include "toccata/core/version.hpp"

namespace toccata::command {
namespace {

using StreamJson = nlohmann::ordered_json;

std::string stream_line(const StreamJson& json) {
  return json.dump(-1, ' ', false, StreamJson::error_handler_t::replace) + "\n";
}

}  // namespace

std::string stream_head(const Scene& scene) {
  StreamJson objects = StreamJson::array();
  for (const SceneObject& object : scene.objects) objects.push_back(object.name);
  return stream_line({{"schema", "toccata/check-stream/1"},
                      {"version", version},
                      {"unit", scene.unit},
                      {"objects", std::move(objects)}});
}

std::string stream_end(const CheckInput& input, const CheckReport& report) {
  StreamJson json = {{"complete", report.unfinished == 0},
                     {"pairs", report.pairs.size() + report.not_kept},
                     {"candidate_pairs", report.candidate_pairs},
                     {"unfinished", report.unfinished},
                     {"ignored_touching", report.ignored_touching}};
  if (report.left_out) json["left_out"] = *report.left_out;
  json["warnings"] = input.loaded.warnings;
  return stream_line(json);
}

}  // namespace toccata::command
