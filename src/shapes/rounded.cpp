#include "toccata/shapes/shape.hpp"

#include <utility>

#include "shapes/validation.hpp"

namespace toccata {
namespace {

// All cores but a triangle, which is plain data, were checked when they were made.
void require_core(const Rounded::Core& core) {
  if (const auto* triangle = std::get_if<Triangle>(&core))
    for (const Vec3& vertex : triangle->vertex) require_finite(vertex, "a vertex of a rounded triangle");
}

}  // namespace

Rounded::Rounded(Core core, double radius) : core_(std::move(core)), radius_(radius) {
  require_positive(radius, "the radius of a rounded shape");
  require_core(core_);
}

}  // namespace toccata
