#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <span>

#include "motion/edge_and_face.hpp"
#include "motion/feature_boxes.hpp"
#include "motion/mesh_topology.hpp"
#include "motion/moving_polygon.hpp"
#include "toccata/motion/deforming_mesh.hpp"
#include "toccata/trees/walk.hpp"

namespace toccata {

/// What is done with two features whose ways come near each other: with a vertex and a face, or two edges, and with an
/// edge and a face that meet at the start. Says whether more is wanted, and until when: triangles that certainly meet
/// only later than `latest` are left out.
template <class Sink>
concept FeatureSink = requires(Sink& sink, const MeshFeature& a, const MeshFeature& b, const MovingPolygon<3>& triangle,
                               const MovingPolygon<4>& parallelogram) {
  { sink.see(a, b, triangle) } -> std::convertible_to<bool>;
  { sink.see(a, b, parallelogram) } -> std::convertible_to<bool>;
  { sink.see_pierced(a, b) } -> std::convertible_to<bool>;
  { sink.latest() } -> std::convertible_to<double>;
};

/// A mesh of a question, with the boxes by which its features are told apart quickly.
struct BoxedMesh {
  const DeformingMesh& mesh;
  std::span<const VertexBoxes> boxes;
};

/// A triangle of it.
struct BoxedTriangle {
  BoxedTriangle(const BoxedMesh& of, Index triangle)
      : mesh(of.mesh), number(triangle), features(mesh.topology().of_triangle[triangle]), corner(features.corner) {
    for (std::size_t i = 0; i < 3; ++i) box[i] = &of.boxes[corner[i]];
  }

  [[nodiscard]] MovingPoint way(std::size_t i) const { return {mesh.start()[corner[i]], mesh.end()[corner[i]]}; }
  [[nodiscard]] const Vec3& start(std::size_t i) const { return mesh.start()[corner[i]]; }
  [[nodiscard]] Triangle face_at_start() const { return {{start(0), start(1), start(2)}}; }
  [[nodiscard]] bool owns_any() const { return (features.own_vertices | features.own_edges) != 0; }
  [[nodiscard]] MeshFeature vertex(std::size_t i) const { return {FeatureKind::vertex, corner[i]}; }
  [[nodiscard]] MeshFeature edge(std::size_t i) const { return {FeatureKind::edge, features.edge[i]}; }
  [[nodiscard]] MeshFeature face() const { return {FeatureKind::face, number}; }
  [[nodiscard]] FloatBox face_box() const { return around(edge_box(0), box[2]->way); }
  [[nodiscard]] FloatBox edge_box(std::size_t i) const { return around(box[i]->way, box[next(i)]->way); }
  [[nodiscard]] FloatBox face_box_at_start() const { return around(edge_box_at_start(0), box[2]->start); }
  [[nodiscard]] FloatBox edge_box_at_start(std::size_t i) const { return around(box[i]->start, box[next(i)]->start); }
  static std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

  /// The box around where it is at a time, a multiple of a cell.
  [[nodiscard]] Aabb box_at(double time) const {
    return merge(merge(moment_box(way(0), time), moment_box(way(1), time)), moment_box(way(2), time));
  }

  const DeformingMesh& mesh;
  Index number;
  const MeshTopology::OfTriangle& features;
  const std::array<Index, 3>& corner;
  std::array<const VertexBoxes*, 3> box;
};

/// Three corners of a triangle as bits.
class CornerSet {
 public:
  explicit CornerSet(unsigned bits) : bits_(bits) {}
  [[nodiscard]] bool has(std::size_t i) const { return (bits_ >> i & 1U) != 0; }
  [[nodiscard]] bool has_end_of_edge(std::size_t i) const { return has(i) || has(BoxedTriangle::next(i)); }

 private:
  unsigned bits_;
};

/// Finds the pairs of features of candidate pairs of triangles. Each is found where the triangles meet that answer for
/// its features (a face for itself), and so once.
template <FeatureSink Sink>
class FeaturePairs {
 public:
  struct Question {
    BoxedMesh a;
    BoxedMesh b;
    bool is_within_one = false;  ///< a and b are one mesh: features that share a vertex are left out
    bool looks_at_start = true;
  };

  FeaturePairs(const Question& question, Sink& sink) : question_(question), sink_(sink) {}

  /// Says whether more is wanted.
  bool see(std::span<const ItemPair> pairs) {
    for (const auto& [first, second] : pairs) {
      const BoxedTriangle a(question_.a, first), b(question_.b, second);
      if (!a.owns_any() && !b.owns_any()) continue;
      const double latest = sink_.latest();
      if (latest < 1 && stay_apart(a.box_at(0), b.box_at(0), a.box_at(latest), b.box_at(latest))) continue;
      if (!see(a, b, common_corners(a, b), common_corners(b, a))) return false;
    }
    return true;
  }

 private:
  /// `common_a` are the corners of a that b has, too.
  bool see(const BoxedTriangle& a, const BoxedTriangle& b, CornerSet common_a, CornerSet common_b) {
    if (!see_vertices<false>(a, b, common_a) || !see_vertices<true>(b, a, common_b) || !see_edges(a, b)) return false;
    return !question_.looks_at_start || (see_pierced<false>(a, b, common_a) && see_pierced<true>(b, a, common_b));
  }

  [[nodiscard]] CornerSet common_corners(const BoxedTriangle& of, const BoxedTriangle& with) const {
    if (!question_.is_within_one) return CornerSet(0);
    const auto bit = [&](std::size_t i) -> unsigned {
      const Index v = of.corner[i];
      return static_cast<unsigned>(v == with.corner[0] || v == with.corner[1] || v == with.corner[2]) << i;
    };
    return CornerSet(bit(0) | bit(1) | bit(2));
  }

  /// Calls `see(i)` for the bits that are set, until it returns false.
  template <class See>
  static bool each_own(unsigned bits, const See& see) {
    for (; bits != 0; bits &= bits - 1)
      if (!see(static_cast<std::size_t>(std::countr_zero(bits)))) return false;
    return true;
  }

  /// The vertices are those of the second mesh where `turned`.
  template <bool turned>
  bool see_vertices(const BoxedTriangle& of_vertices, const BoxedTriangle& of_face, CornerSet common) {
    if (of_vertices.features.own_vertices == 0) return true;
    const FloatBox face_box = of_face.face_box();
    return each_own(of_vertices.features.own_vertices, [&](std::size_t i) {
      return common.has(i) || boxes_are_apart(of_vertices.box[i]->way, face_box) ||
             see_vertex_and_face<turned>(of_vertices, i, of_face);
    });
  }

  template <bool turned>
  bool see_vertex_and_face(const BoxedTriangle& of_vertex, std::size_t i, const BoxedTriangle& of_face) {
    const MovingPoint vertex = of_vertex.way(i);
    const std::array face{of_face.way(0), of_face.way(1), of_face.way(2)};
    const MovingPolygon<3> polygon{{{&face[0], &vertex}, {&face[1], &vertex}, {&face[2], &vertex}}};
    return in_order<turned>(of_vertex.vertex(i), of_face.face(),
                            [&](const auto& a, const auto& b) { return sink_.see(a, b, polygon); });
  }

  bool see_edges(const BoxedTriangle& a, const BoxedTriangle& b) {
    return each_own(a.features.own_edges, [&](std::size_t i) {
      const FloatBox box = a.edge_box(i);
      return each_own(b.features.own_edges, [&](std::size_t j) {
        return boxes_are_apart(box, b.edge_box(j)) || share_an_end(a, i, b, j) || see_two_edges(a, i, b, j);
      });
    });
  }

  [[nodiscard]] bool share_an_end(const BoxedTriangle& a, std::size_t i, const BoxedTriangle& b, std::size_t j) const {
    if (!question_.is_within_one) return false;
    const Index a0 = a.corner[i], a1 = a.corner[BoxedTriangle::next(i)];
    const Index b0 = b.corner[j], b1 = b.corner[BoxedTriangle::next(j)];
    return a0 == b0 || a0 == b1 || a1 == b0 || a1 == b1;
  }

  bool see_two_edges(const BoxedTriangle& a, std::size_t i, const BoxedTriangle& b, std::size_t j) {
    const std::array p{a.way(i), a.way(BoxedTriangle::next(i))}, q{b.way(j), b.way(BoxedTriangle::next(j))};
    const MovingPolygon<4> polygon{{{&p[0], &q[0]}, {&p[1], &q[0]}, {&p[1], &q[1]}, {&p[0], &q[1]}}};
    return in_order<false>(a.edge(i), b.edge(j),
                           [&](const auto& x, const auto& y) { return sink_.see(x, y, polygon); });
  }

  /// Edges that meet a face at the start; of the second mesh where `turned`.
  template <bool turned>
  bool see_pierced(const BoxedTriangle& of_edges, const BoxedTriangle& of_face, CornerSet common) {
    if (of_edges.features.own_edges == 0) return true;
    const FloatBox face_box = of_face.face_box_at_start();
    return each_own(of_edges.features.own_edges, [&](std::size_t i) {
      if (common.has_end_of_edge(i) || boxes_are_apart(of_edges.edge_box_at_start(i), face_box)) return true;
      const Vec3 &from = of_edges.start(i), &to = of_edges.start(BoxedTriangle::next(i));
      if (!segment_meets_triangle(from, to, of_face.face_at_start())) return true;
      return in_order<turned>(of_edges.edge(i), of_face.face(),
                              [&](const auto& a, const auto& b) { return sink_.see_pierced(a, b); });
    });
  }

  /// Shows two features in order: of two meshes, that of the first comes first; of one mesh, the lesser.
  template <bool turned, class See>
  bool in_order(const MeshFeature& a, const MeshFeature& b, const See& see) const {
    return (question_.is_within_one ? b < a : turned) ? see(b, a) : see(a, b);
  }

  const Question& question_;
  Sink& sink_;
};

}  // namespace toccata
