#include "shapes/quickhull.hpp"

#include <utility>

#include "core/no_index.hpp"
#include "math/constants.hpp"
#include "math/filter.hpp"

// A point is added by replacing all triangles that it sees by the triangles from it to their border, the horizon. To
// see a triangle is to lie strictly in front of it. This keeps a convex surface of triangles with area, also where
// points are coplanar:
//
// - The triangles seen are a disk. Seen from p, they are the graph of a piecewise linear convex function over the
// convex
//   region that the hull covers in the view, and such a function is continuous up to the border of the region. So the
//   horizon is one simple cycle.
// - A new triangle has area: p lies strictly in front of a triangle at its horizon edge, hence not on the edge's line.
// - A hull face F whose plane contains p is not seen and stays; beyond an edge of F that p sees in that plane lies a
// face
//   that p sees, so F grows by just the triangles from p to these edges.
//
// A point q above a triangle that is removed, and still outside, is above a new triangle, so that it is enough to
// look there: the triangles that q saw are connected; if one stays, q saw both sides of a horizon edge, and the normal
// of the new triangle at that edge is a sum of theirs with factors ≥ 0.
namespace toccata {
namespace {

constexpr std::size_t refinement = 8;

struct HullFace {
  HullTriangle triangle;
  FilteredCross normal;
  Index first_above = no_index;  // of the points that wait above this face, linked by Hull::next_above_
  Index farthest = no_index;     // of them
  Index count_above = 0;
  double height = 0;  // of the farthest, in units that belong to the face
  Index round = 0;    // in which `seen` was determined
  bool seen = false;
  bool alive = true;
};

struct HorizonEdge {
  Index from = 0;
  Index to = 0;
  Index beyond = 0;  // the face on the side that stays
};

int corner_of(const HullTriangle& triangle, Index vertex) {
  return triangle.vertices[0] == vertex ? 0 : triangle.vertices[1] == vertex ? 1 : 2;
}

class Hull {
 public:
  Hull(std::span<const Vec3> points, const std::array<Index, 4>& simplex)
      : points_(points), next_above_(points.size(), no_index), face_starting_at_(points.size(), no_index) {
    build_simplex(simplex);
    for (Index p = 0; p < points.size(); ++p) wait_above_one_of(p, fresh_);
    hold_waiting();
    for (std::size_t crowd = points.size();; crowd /= refinement) {
      add_to_crowded(crowd);
      if (crowd == 0) return;
    }
  }

  [[nodiscard]] std::vector<HullTriangle> triangles() const {
    std::vector<Index> number(faces_.size(), no_index);
    Index count = 0;
    for (Index f = 0; f < faces_.size(); ++f)
      if (faces_[f].alive) number[f] = count++;
    std::vector<HullTriangle> result;
    result.reserve(count);
    for (const HullFace& face : faces_) {
      if (!face.alive) continue;
      result.push_back(face.triangle);
      for (Index& neighbour : result.back().neighbours) neighbour = number[neighbour];
    }
    return result;
  }

 private:
  void build_simplex(const std::array<Index, 4>& s) {
    const bool first_three_face_the_fourth =
        orient3d(points_[s[0]], points_[s[1]], points_[s[2]], points_[s[3]]) == Sign::positive;
    const Index a = s[0], b = first_three_face_the_fourth ? s[2] : s[1], c = first_three_face_the_fourth ? s[1] : s[2],
                d = s[3];
    fresh_ = {new_face({{a, b, c}, {1, 2, 3}}), new_face({{b, a, d}, {0, 3, 2}}), new_face({{c, b, d}, {0, 1, 3}}),
              new_face({{a, c, d}, {0, 2, 1}})};
  }

  Index new_face(const HullTriangle& triangle) {
    Index index = static_cast<Index>(faces_.size());
    if (free_.empty()) {
      faces_.emplace_back();
    } else {
      index = free_.back();
      free_.pop_back();
      faces_[index] = {};
    }
    const auto& [a, b, c] = triangle.vertices;
    faces_[index].triangle = triangle;
    faces_[index].normal = filtered_cross(points_[b] - points_[a], points_[c] - points_[a]);
    return index;
  }

  /// Adds points to the faces that have more of them than `crowd` above. So all sides are refined alike: of a prism
  /// done one end first, the vertices of the other end would be seen to have long fans, replaced by fans again and
  /// again.
  void add_to_crowded(std::size_t crowd) {
    std::vector<Index> later;
    while (!waiting_.empty()) {
      const Index index = waiting_.back();
      waiting_.pop_back();
      const HullFace& face = faces_[index];
      if (!face.alive || face.count_above == 0) continue;
      if (face.count_above > crowd)
        add(face.farthest, index);
      else
        later.push_back(index);
    }
    waiting_ = std::move(later);
  }

  struct Height {
    bool above = false;
    double value = 0;  // rounded; only a preference is made of it
  };

  [[nodiscard]] Height height(const HullFace& face, Index point) const {
    const auto& [a, b, c] = face.triangle.vertices;
    const Filtered product = filtered_triple_product(face.normal, points_[point] - points_[a]);
    if (product.is_positive()) return {true, product.value};
    if (product.is_negative()) return {};
    const bool above = orient3d(points_[a], points_[b], points_[c], points_[point]) == Sign::positive;
    return {above, std::isnan(product.value) ? infinity : product.value};
  }

  /// Equal points always wait above the same face, so the tie makes the first of them count.
  void wait_above_one_of(Index point, const std::vector<Index>& candidates) {
    for (const Index index : candidates) {
      HullFace& face = faces_[index];
      const Height h = height(face, point);
      if (!h.above) continue;
      if (face.first_above == no_index || h.value > face.height || (h.value == face.height && point < face.farthest)) {
        face.farthest = point;
        face.height = h.value;
      }
      ++face.count_above;
      next_above_[point] = std::exchange(face.first_above, point);
      return;
    }
  }

  void hold_waiting() {
    for (const Index face : fresh_)
      if (faces_[face].first_above != no_index) waiting_.push_back(face);
  }

  void add(Index point, Index face_below) {
    find_seen(point, face_below);
    fresh_.clear();
    for (const HorizonEdge& edge : horizon_) join(edge, point);
    for (const Index f : fresh_) link_around(f);
    for (const Index f : seen_) {
      for (Index p = faces_[f].first_above; p != no_index;) {
        const Index next = next_above_[p];
        if (p != point) wait_above_one_of(p, fresh_);
        p = next;
      }
      faces_[f].alive = false;
    }
    free_.insert(free_.end(), seen_.begin(), seen_.end());
    hold_waiting();
  }

  bool is_seen(Index f, Index point) {
    HullFace& face = faces_[f];
    if (face.round != round_) {
      face.round = round_;
      face.seen = height(face, point).above;
      if (face.seen) seen_.push_back(f);
    }
    return face.seen;
  }

  void find_seen(Index point, Index start) {
    ++round_;
    seen_.clear();
    horizon_.clear();
    is_seen(start, point);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const HullTriangle triangle = faces_[seen_[i]].triangle;
      for (std::size_t e = 0; e < 3; ++e)
        if (!is_seen(triangle.neighbours[e], point))
          horizon_.push_back({triangle.vertices[e], triangle.vertices[(e + 1) % 3], triangle.neighbours[e]});
    }
  }

  /// The triangle from a horizon edge to the point; its other two neighbours come later.
  void join(const HorizonEdge& edge, Index point) {
    const Index face = new_face({{edge.from, edge.to, point}, {edge.beyond, no_index, no_index}});
    HullTriangle& beyond = faces_[edge.beyond].triangle;
    beyond.neighbours[static_cast<std::size_t>(corner_of(beyond, edge.to))] = face;
    face_starting_at_[edge.from] = face;
    fresh_.push_back(face);
  }

  void link_around(Index face) {
    const Index next = face_starting_at_[faces_[face].triangle.vertices[1]];
    faces_[face].triangle.neighbours[1] = next;
    faces_[next].triangle.neighbours[2] = face;
  }

  std::span<const Vec3> points_;
  std::vector<HullFace> faces_;
  std::vector<Index> free_;
  std::vector<Index> next_above_;
  std::vector<Index> face_starting_at_;  // of the vertices of the present horizon
  std::vector<Index> waiting_;           // faces with points above, perhaps removed since
  std::vector<Index> seen_;
  std::vector<HorizonEdge> horizon_;
  std::vector<Index> fresh_;
  Index round_ = 0;
};

}  // namespace

std::vector<HullTriangle> quickhull(std::span<const Vec3> points, const std::array<Index, 4>& simplex) {
  return Hull(points, simplex).triangles();
}

}  // namespace toccata
