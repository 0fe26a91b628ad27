#include <algorithm>
#include <initializer_list>
#include <utility>

#include "query/subdivision/level_mesh.hpp"
#include "query/subdivision/refinement_rules.hpp"

namespace toccata {
namespace {

/// Makes the next level of a part of a level.
class LevelBuilder {
 public:
  LevelBuilder(LevelMesh& parent, std::span<const char> refined) : parent_(parent), refined_(refined) {
    child_.scheme = parent.scheme;
    child_.level = parent.level + 1;
    child_.rounding = parent.rounding + rule_rounding(parent);
    child_.largest_coordinate = parent.largest_coordinate;
    child_.most_neighbours = parent.most_neighbours;
  }

  LevelMesh built() {
    mark_vertices();
    make_points();
    make_faces();
    child_.connect();
    sharpen_edges();
    return std::move(child_);
  }

 private:
  void mark_vertices() {
    marked_.assign(parent_.points.size(), 0);
    for (Index f = 0; f < parent_.face_count(); ++f)
      if (refined_[f])
        for (const Index corner : parent_.face(f)) marked_[corner] = 1;
  }

  [[nodiscard]] bool has_marked_corner(Index face) const {
    const std::span<const Index> corners = parent_.face(face);
    return std::any_of(corners.begin(), corners.end(), [this](Index corner) { return marked_[corner] != 0; });
  }

  Index add_point(const Vec3& point, double sharpness) {
    child_.points.push_back(point);
    child_.vertex_sharpness.push_back(sharpness);
    return static_cast<Index>(child_.points.size() - 1);
  }

  void make_points() {
    const bool has_face_points = parent_.scheme == SubdivisionScheme::catmull_clark;
    point_of_face_.assign(parent_.face_count(), no_index);
    parent_.face_points.assign(has_face_points ? parent_.face_count() : 0, Vec3{});
    for (Index f = 0; f < parent_.face_count() && has_face_points; ++f) {
      if (!has_marked_corner(f)) continue;
      parent_.face_points[f] = point_for_face(parent_, f);
      point_of_face_[f] = add_point(parent_.face_points[f], 0);
    }
    Spokes spokes;
    parent_.point_of_vertex.assign(parent_.points.size(), no_index);
    for (Index v = 0; v < parent_.points.size(); ++v)
      if (marked_[v])
        parent_.point_of_vertex[v] =
            add_point(point_for_vertex(parent_, v, spokes), child_sharpness(parent_.vertex_sharpness[v]));
    parent_.point_of_edge.assign(parent_.edges.size(), no_index);
    for (Index e = 0; e < parent_.edges.size(); ++e)
      if (marked_[parent_.edges[e].ends[0]] || marked_[parent_.edges[e].ends[1]])
        parent_.point_of_edge[e] = add_point(point_for_edge(parent_, e), 0);
  }

  void make_faces() {
    parent_.child_of_side.assign(parent_.corners.size(), no_index);
    for (Index f = 0; f < parent_.face_count(); ++f) {
      for (Index side = parent_.first_side[f]; side < parent_.first_side[f + 1]; ++side)
        if (marked_[parent_.corners[side]]) parent_.child_of_side[side] = add_corner_face(f, side);
      if (parent_.scheme == SubdivisionScheme::loop) add_middle_face(f);
    }
  }

  Index add_corner_face(Index face, Index side) {
    const Index vertex = parent_.point_of_vertex[parent_.corners[side]];
    const Index after = parent_.point_of_edge[parent_.edge_of_side[side]];
    const Index before = parent_.point_of_edge[parent_.edge_of_side[parent_.previous(side)]];
    if (parent_.scheme == SubdivisionScheme::loop) return add_face(face, {vertex, after, before});
    return add_face(face, {vertex, after, point_of_face_[face], before});
  }

  void add_middle_face(Index face) {
    const Index side = parent_.first_side[face];
    const Index a = parent_.point_of_edge[parent_.edge_of_side[side]];
    const Index b = parent_.point_of_edge[parent_.edge_of_side[side + 1]];
    const Index c = parent_.point_of_edge[parent_.edge_of_side[side + 2]];
    if (a != no_index && b != no_index && c != no_index) add_face(face, {a, b, c});
  }

  Index add_face(Index parent, std::initializer_list<Index> corners) {
    child_.corners.insert(child_.corners.end(), corners);
    child_.first_side.push_back(static_cast<Index>(child_.corners.size()));
    child_.cage_face.push_back(parent_.cage_face[parent]);
    child_.whole.push_back(refined_[parent]);
    return child_.face_count() - 1;
  }

  void sharpen_edges() {
    for (Index e = 0; e < parent_.edges.size(); ++e) {
      const LevelEdge& edge = parent_.edges[e];
      const double sharpness = child_sharpness(edge.sharpness);
      const Index middle = parent_.point_of_edge[e];
      if (sharpness <= 0 || middle == no_index) continue;
      for (const Index end : edge.ends) {
        const Index half = marked_[end] ? child_.edge_between(parent_.point_of_vertex[end], middle) : no_index;
        if (half != no_index) child_.edges[half].sharpness = sharpness;
      }
    }
  }

  LevelMesh& parent_;
  std::span<const char> refined_;
  LevelMesh child_;
  std::vector<char> marked_;
  std::vector<Index> point_of_face_;
};

}  // namespace

LevelMesh subdivided(LevelMesh& parent, std::span<const char> refined) { return LevelBuilder(parent, refined).built(); }

}  // namespace toccata
