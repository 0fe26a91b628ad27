#pragma once

#include <span>

#include "io/formats/json.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata::io {

/// How things were found, by the table of pairs: texts, each once, and their numbers.
class PairMethods {
 public:
  explicit PairMethods(std::span<const SceneInstance> models) : models_(models) {}

  std::size_t number_of(ShapeQuestion question, Index a, Index b);
  [[nodiscard]] const Json& texts() const { return texts_; }

 private:
  std::span<const SceneInstance> models_;
  Json texts_ = Json::array();
};

/// What a page says of a relation; `apart` where the two are.
[[nodiscard]] Json words_of(const Relation& relation, const char* apart);

}  // namespace toccata::io
