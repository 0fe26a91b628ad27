#include "toccata/shapes/shape.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "toccata/core/error.hpp"

namespace toccata {
namespace {

void require_part(const CompoundPart& part, std::size_t number) {
  if (!is_finite(part.pose))
    throw Error(fmt::format("the pose ({}) of part {} of a compound has a number that is not finite",
                            fmt::join(part.pose.numbers(), ", "), number));
  const auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&part.shape);
  if (mesh != nullptr && !*mesh)
    throw Error(fmt::format("part {} of a compound is a mesh, and the pointer given is null", number));
}

template <DescribedShape S>
constexpr std::string_view name_for(std::type_identity<S>) {
  return S::name;
}
constexpr std::string_view name_for(std::type_identity<Triangle>) { return "triangle"; }
constexpr std::string_view name_for(std::type_identity<ConvexHull>) { return "convex hull"; }
constexpr std::string_view name_for(std::type_identity<Rounded>) { return "rounded shape"; }
constexpr std::string_view name_for(std::type_identity<HeightField>) { return "height field"; }
constexpr std::string_view name_for(std::type_identity<std::shared_ptr<const TriangleMesh>>) { return "mesh"; }
constexpr std::string_view name_for(std::type_identity<Compound>) { return "compound"; }

}  // namespace

struct Compound::Parts {
  std::vector<CompoundPart> all;
  int levels = 0;  ///< of compounds, this one included
};

int Compound::levels_of(std::span<const CompoundPart> parts) {
  int below = 0;
  for (const CompoundPart& part : parts)
    if (const auto* compound = std::get_if<Compound>(&part.shape)) below = std::max(below, compound->parts_->levels);
  return below + 1;
}

Compound::Compound(std::span<const CompoundPart> parts)
    : parts_(std::make_shared<const Parts>(Parts{{parts.begin(), parts.end()}, levels_of(parts)})) {
  if (parts.empty()) throw Error("a compound needs at least one part");
  if (parts_->levels > most_compound_levels)
    throw Error(fmt::format("compounds are nested more than {} deep; put their parts side by side into one",
                            most_compound_levels));
  for (std::size_t i = 0; i < parts.size(); ++i) require_part(parts[i], i);
}

Compound::Compound(std::initializer_list<CompoundPart> parts) : Compound(std::span(parts.begin(), parts.size())) {}

std::span<const CompoundPart> Compound::parts() const { return parts_->all; }

std::string_view name_of(ShapeKind kind) {
  static constexpr auto names =
      AllShapes::of_each([]<class S>(std::type_identity<S> type) -> std::string_view { return name_for(type); });
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name_of(const Shape& shape) { return name_of(kind_of(shape)); }

}  // namespace toccata
