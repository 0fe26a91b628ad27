#include "toccata/io/distance_report.hpp"

#include "io/report_parts.hpp"
#include "io/utf8.hpp"

namespace toccata {
namespace {

std::string line_of(const ReportedDistance& pair, const Scene& scene) {
  const Distance& d = pair.distance;
  return io::line_of({{"a", io::as_utf8(scene.objects[pair.a].name)},
                      {"b", io::as_utf8(scene.objects[pair.b].name)},
                      {"a_index", pair.a},
                      {"b_index", pair.b},
                      {"lower", d.lower},
                      {"upper", d.upper},
                      {"on_a", io::json_of(d.on_a)},
                      {"on_b", io::json_of(d.on_b)},
                      {"status", name_of(d.status)}});
}

}  // namespace

std::string distance_report_json(const Scene& scene, std::span<const Posed> models,
                                 std::span<const ReportedDistance> distances, std::span<const std::string> warnings) {
  return io::with_list(io::document(io::report_head("toccata/distance/1", scene, models, warnings)), "pairs",
                       distances.size(), [&](std::size_t i) { return line_of(distances[i], scene); });
}

}  // namespace toccata
