#pragma once

#include <utility>

#include "toccata/query/convex_parts.hpp"
#include "toccata/query/model.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata {

/// A model and convex parts that contain it: the parts are asked first, and what they cannot rule out is asked of the
/// model, so no answer depends on them. Copies share all.
class ModelWithParts {
 public:
  /// `parts` must be those of the model (`decompose`).
  ModelWithParts(Model model, const ConvexParts& parts) : model_(std::move(model)), parts_(parts.compound()) {}

  /// A model that is its own only part.
  ModelWithParts(const Model& model) : model_(model), parts_(model) {}

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const Model& parts() const { return parts_; }

 private:
  Model model_;
  Model parts_;
};

/// Are the posed models apart for certain, as their parts are farther apart than what rounding can move? Posed vertices
/// are rounded, so a posed hull may be left of what it contains by some units in the last place; that is made up for.
/// False says nothing.
[[nodiscard]] bool parts_are_apart(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query = {});

/// What `overlap` of the two models answers, always, and where the parts are apart without asking about the models.
/// Throws as that does.
[[nodiscard]] bool overlap(const ModelWithParts& a, const ModelWithParts& b, const PairQuery& query = {});

}  // namespace toccata
