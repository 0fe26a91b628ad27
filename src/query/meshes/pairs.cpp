#include "toccata/query/pairs.hpp"

namespace toccata {

std::string_view name_of(ShapeQuestion question) {
  constexpr std::array<std::string_view, question_count> names = {"overlap",  "relation",    "contacts", "manifold",
                                                                  "distance", "penetration", "cast-ray", "cast-shape"};
  return names[static_cast<std::size_t>(question)];
}

}  // namespace toccata
