#include "narrow/exact/exact_interior.hpp"

#include <array>
#include <optional>
#include <vector>

#include "math/wide_integer.hpp"
#include "narrow/exact/exact_support.hpp"
#include "toccata/math/predicates.hpp"

// Where the origin is not in the interior, some normal n, not 0, has n · d ≥ 0 for every vertex d of A − B. A few
// vertices W are known at a time. A normal that does for them is tried on all vertices: either it does for all, or the
// vertex that is least along it is a new one. When no normal is left for W, there is none. It ends because there are
// finitely many vertices.
namespace toccata {
namespace {

using Normal = std::optional<IntegerVector>;

IntegerVector difference_over(const Difference& d, int exponent) {
  return scaled_wide(d.head, exponent) - scaled_wide(d.tail, exponent);
}

/// A positive multiple of the cross product.
IntegerVector cross_of(const Difference& u, const Difference& v) {
  const std::array<Vec3, 4> points{u.head, u.tail, v.head, v.tail};
  const int exponent = common_exponent(points);
  return cross(difference_over(u, exponent), difference_over(v, exponent));
}

/// A vector that is not 0 and at a right angle to the difference.
IntegerVector perpendicular_to(const Difference& d) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    IntegerVector normal = cross_of(d, {axis, {}});
    if (!is_zero(normal)) return normal;
  }
  return scaled_wide(Vec3{1, 0, 0}, 0);
}

int bits_of(const IntegerVector& v) {
  unsigned most = 0;
  for (const WideInteger& c : v.along)
    if (c != 0) most = std::max(most, static_cast<unsigned>(msb(abs(c))));
  return static_cast<int>(most);
}

/// Somewhere in the middle of the cone of the rays: their sum, brought to about one length.
IntegerVector middle_of(const std::vector<IntegerVector>& rays) {
  int most = 0;
  for (const IntegerVector& ray : rays) most = std::max(most, bits_of(ray));
  IntegerVector sum;
  for (const IntegerVector& ray : rays)
    sum = sum + (WideInteger(1) << static_cast<unsigned>(most - bits_of(ray))) * ray;
  return sum;
}

class KnownVertices {
 public:
  void append(const Difference& vertex) { vertices_.push_back(vertex); }

  /// A normal, not 0, that has none of the vertices before it, if there is one.
  ///
  /// When the vertices span space the normals form a cone without a line, whose extreme rays are at right angles to two
  /// of the vertices, and nothing is left of it when there are none. When they span a plane, both its normals do.
  [[nodiscard]] Normal normal() const {
    std::vector<IntegerVector> rays;
    bool span_space = false;
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      for (std::size_t j = i + 1; j < vertices_.size(); ++j) {
        const Sides sides = sides_of(i, j);
        span_space = span_space || sides.before || sides.behind;
        if (sides.before && sides.behind) continue;
        const IntegerVector ray = cross_of(vertices_[i], vertices_[j]);
        if (is_zero(ray)) continue;
        if (!sides.before && !sides.behind) return ray;
        rays.push_back(sides.before ? ray : -ray);
      }
    if (span_space) return rays.empty() ? Normal() : middle_of(rays);
    for (const Difference& vertex : vertices_)
      if (!(vertex.head == vertex.tail)) return perpendicular_to(vertex);
    return perpendicular_to({});
  }

 private:
  struct Sides {
    bool before = false;  ///< some vertex has a positive product with the cross product of the two
    bool behind = false;
  };

  [[nodiscard]] Sides sides_of(std::size_t i, std::size_t j) const {
    Sides sides;
    for (std::size_t k = 0; k < vertices_.size() && !(sides.before && sides.behind); ++k) {
      if (k == i || k == j) continue;
      const Sign side = triple_product_sign(vertices_[i], vertices_[j], vertices_[k]);
      sides.before = sides.before || side == Sign::positive;
      sides.behind = sides.behind || side == Sign::negative;
    }
    return sides;
  }

  std::vector<Difference> vertices_;
};

/// The vertex that is least along the normal, if it lies behind it.
std::optional<Difference> vertex_behind(const PosedPolytope& a, const PosedPolytope& b, const IntegerVector& normal) {
  const Difference least{a.vertex(least_vertices(a, normal).front()), b.vertex(least_vertices(b, -normal).front())};
  const std::array<Vec3, 2> points{least.head, least.tail};
  const WideInteger height = dot(normal, difference_over(least, common_exponent(points)));
  return height < 0 ? std::optional(least) : std::nullopt;
}

Difference difference_of(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& pairs, std::size_t i) {
  return {a.vertex(pairs.a[i]), b.vertex(pairs.b[i])};
}

}  // namespace

bool origin_within_tetrahedron(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& four) {
  const auto volume = [&](std::size_t i, std::size_t j, std::size_t k) {
    return triple_product_sign(difference_of(a, b, four, i), difference_of(a, b, four, j),
                               difference_of(a, b, four, k));
  };
  const Sign sign = volume(1, 2, 3);
  return sign != Sign::zero && volume(0, 2, 3) == -sign && volume(0, 1, 3) == sign && volume(0, 1, 2) == -sign;
}

bool interiors_meet(const PosedPolytope& a, const PosedPolytope& b, const VertexPairs& hint) {
  if (hint.size == 4 && origin_within_tetrahedron(a, b, hint)) return true;
  KnownVertices known;
  for (std::size_t i = 0; i < hint.size; ++i) known.append(difference_of(a, b, hint, i));
  while (const Normal normal = known.normal()) {
    const std::optional<Difference> behind = vertex_behind(a, b, *normal);
    if (!behind) return false;
    known.append(*behind);
  }
  return true;
}

}  // namespace toccata
