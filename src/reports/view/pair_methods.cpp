#include "reports/view/pair_methods.hpp"

#include <algorithm>
#include <string>

#include "toccata/reports/report.hpp"

namespace toccata::io {

std::size_t PairMethods::number_of(ShapeQuestion question, Index a, Index b) {
  const PairCell cell = pair_cell(question, kind_of(models_[a].model.shape()), kind_of(models_[b].model.shape()));
  const Json text = cell.text == pair_cells::by_parts.text ? "what holds for their parts" : std::string(cell.text);
  const auto found = std::find(texts_.begin(), texts_.end(), text);
  if (found != texts_.end()) return static_cast<std::size_t>(found - texts_.begin());
  texts_.push_back(text);
  return texts_.size() - 1;
}

Json words_of(const Relation& relation, const char* apart) {
  const bool is_apart = relation.kind == RelationKind::apart;
  return {{"verb", is_apart ? apart : verb_of(relation)}, {"remark", remark_on(relation)}};
}

}  // namespace toccata::io
