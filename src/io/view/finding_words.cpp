#include "io/view/finding_words.hpp"

#include <algorithm>
#include <string>

#include "io/view/drawn_faults.hpp"
#include "toccata/io/report.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata::io {
namespace {

/// How things were found, by the table of pairs: texts, each once, and their numbers.
class Methods {
 public:
  explicit Methods(std::span<const SceneInstance> models) : models_(models) {}

  std::size_t number_of(ShapeQuestion question, Index a, Index b) {
    const PairCell cell = pair_cell(question, kind_of(models_[a].model.shape()), kind_of(models_[b].model.shape()));
    const Json text = cell.text == pair_cells::by_parts.text ? "what holds for their parts" : std::string(cell.text);
    const auto found = std::find(texts_.begin(), texts_.end(), text);
    if (found != texts_.end()) return static_cast<std::size_t>(found - texts_.begin());
    texts_.push_back(text);
    return texts_.size() - 1;
  }

  [[nodiscard]] const Json& texts() const { return texts_; }

 private:
  std::span<const SceneInstance> models_;
  Json texts_ = Json::array();
};

Json words_of(const Relation& relation, const char* apart) {
  const bool is_apart = relation.kind == RelationKind::apart;
  return {{"verb", is_apart ? apart : verb_of(relation)}, {"remark", remark_on(relation)}};
}

/// The words of one answer after the other. Where there are none, the report tells all.
struct Words {
  Methods& methods;

  Json operator()(const CheckReport& report) const {
    Json words = Json::array();
    for (const ReportedPair& pair : report.pairs) {
      Json entry = words_of(pair.relation, "is closer than its clearance to");
      if (report.has_faces) entry["face_pairs"] = pair.face_pairs.size();
      Json& by = entry["methods"] = {{"relation", methods.number_of(ShapeQuestion::relation, pair.a, pair.b)}};
      if (pair.penetration) by["penetration"] = methods.number_of(ShapeQuestion::penetration, pair.a, pair.b);
      if (pair.distance) by["distance"] = methods.number_of(ShapeQuestion::distance, pair.a, pair.b);
      words.push_back(std::move(entry));
    }
    return words;
  }

  Json operator()(const PosesReport& report) const {
    Json by = {{"relation", methods.number_of(ShapeQuestion::relation, 0, 1)}};
    if (!report.penetrations.empty()) by["penetration"] = methods.number_of(ShapeQuestion::penetration, 0, 1);
    Json words = Json::array();
    for (std::size_t i = 0; i < report.relations.size(); ++i) {
      Json& entry = words.emplace_back(words_of(report.relations[i], "is apart from"));
      if (i < report.face_pairs.size())
        entry["face_pairs"] = report.face_pairs[i].size();
      else if (!report.face_pairs.empty())
        entry["face_pairs"] = nullptr;
      entry["methods"] = by;
    }
    return words;
  }

  Json operator()(const DistanceReport& report) const {
    Json words = Json::array();
    for (const ReportedDistance& pair : report.pairs)
      words.push_back({{"methods", {{"distance", methods.number_of(ShapeQuestion::distance, pair.a, pair.b)}}}});
    return words;
  }

  Json operator()(const DistancePosesReport& report) const {
    const Json entry = {{"methods", {{"distance", methods.number_of(ShapeQuestion::distance, 0, 1)}}}};
    return Json(report.distances.size(), entry);
  }

  Json operator()(const RayReport& report) const {
    Json words = Json::array();
    for (const ReportedRay& ray : report.rays) {
      words.push_back(Json::object());
      if (ray.hit.hit)
        words.back()["methods"] = {{"cast", methods.number_of(ShapeQuestion::cast_ray, ray.object, ray.object)}};
    }
    return words;
  }

  Json operator()(const FacesReport& report) const {
    Json words = Json::array();
    for (const ReportedFaces& found : report.found)
      words.push_back(
          {{"object", found.object}, {"faces", distinct_faces(found.found).size()}, {"triangles", found.found.size()}});
    return words;
  }

  Json operator()(const InspectReport& report) const {
    Json words = Json::array();
    for (const InspectFinding& finding : inspect_findings(report)) {
      Json& entry = words.emplace_back(Json{{"object", finding.object}});
      if (!finding.fault) continue;
      entry["fault"] = name_of(finding.fault->kind);
      entry["count"] = finding.fault->count();
      entry["groups"] = finding.groups;
    }
    return words;
  }

  template <class Other>
  Json operator()(const Other&) const {
    return Json::array();
  }
};

}  // namespace

void add_words(Json& header, std::span<const SceneInstance> models, const SceneAnswer& answer) {
  Methods methods(models);
  header["words"] = std::visit(Words{methods}, answer);
  header["methods"] = methods.texts();
}

}  // namespace toccata::io
