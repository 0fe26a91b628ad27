#include "support/deforming_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "oracle/convex.hpp"
#include "oracle/triangles.hpp"
#include "support/motion_judge.hpp"
#include "toccata/bounds/aabb.hpp"

namespace toccata::test {
namespace {

using FeaturesOfPair = std::variant<VertexFace, EdgeEdge>;

/// The features of a mesh, found without what the library knows of them.
struct FeatureLists {
  explicit FeatureLists(const DeformingMesh& of) : mesh(of) {
    std::set<std::pair<Index, Index>> ends;
    for (const auto& [a, b, c] : of.triangles()) {
      vertices.insert({a, b, c});
      for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        if (from != to) ends.insert(std::minmax(from, to));
    }
    edges.assign(ends.begin(), ends.end());
  }

  [[nodiscard]] MovingPoint way(Index vertex) const { return {mesh.start()[vertex], mesh.end()[vertex]}; }
  [[nodiscard]] std::array<MovingPoint, 2> edge(Index number) const {
    return {way(edges[number].first), way(edges[number].second)};
  }
  [[nodiscard]] std::array<MovingPoint, 3> face(Index number) const {
    const auto& [a, b, c] = mesh.triangles()[number];
    return {way(a), way(b), way(c)};
  }
  [[nodiscard]] std::set<Index> vertices_of(const MeshFeature& f) const {
    if (f.kind == FeatureKind::vertex) return {f.number};
    if (f.kind == FeatureKind::edge) return {edges[f.number].first, edges[f.number].second};
    const auto& [a, b, c] = mesh.triangles()[f.number];
    return {a, b, c};
  }

  const DeformingMesh& mesh;
  std::set<Index> vertices;
  std::vector<std::pair<Index, Index>> edges;
};

/// What lies in the boxes around the ways of the points; minima and maxima of doubles are exact.
template <std::size_t first_count, std::size_t second_count>
bool ways_are_apart(const std::array<MovingPoint, first_count>& first,
                    const std::array<MovingPoint, second_count>& second) {
  const auto box_around = [](const auto& points) {
    Aabb box;
    for (const MovingPoint& p : points) box = merge(merge(box, p.start), p.end);
    return box;
  };
  return !overlap(box_around(first), box_around(second));
}
bool ways_are_apart(const VertexFace& pair) { return ways_are_apart(std::array{pair.vertex}, pair.face); }
bool ways_are_apart(const EdgeEdge& pair) { return ways_are_apart(pair.a, pair.b); }

/// Goes over all pairs of features and compares what is said of each with what was found.
class ImpactJudge {
 public:
  ImpactJudge(const DeformingPair& meshes, std::span<const MeshImpact> found, FeatureJudge judge)
      : meshes_(meshes), a_(meshes.a), b_(meshes.b), found_(found), judge_(judge) {}

  ImpactVerdict verdict() {
    const std::optional<std::string> wrong = fault();
    return {wrong, judged_};
  }

 private:
  std::optional<std::string> fault() {
    const auto before = [](const MeshImpact& x, const MeshImpact& y) {
      return std::tie(x.time.lower, x.time.upper, x.a, x.b) < std::tie(y.time.lower, y.time.upper, y.a, y.b);
    };
    for (std::size_t i = 1; i < found_.size(); ++i)
      if (!before(found_[i - 1], found_[i])) return "two impacts are not in order, or one is told twice";
    look_at_vertices(a_, b_, false);
    if (!meshes_.is_within_one) look_at_vertices(b_, a_, true);
    look_at_edges();
    look_at_pierced(a_, b_, false);
    if (!meshes_.is_within_one) look_at_pierced(b_, a_, true);
    if (wrong_.empty() && matched_ != found_.size()) return "an impact is told of features that are no pair";
    return wrong_.empty() ? std::nullopt : std::optional(wrong_);
  }

  [[nodiscard]] bool are_asked_about(const FeatureLists& x, const MeshFeature& f, const FeatureLists& y,
                                     const MeshFeature& g) const {
    if (!meshes_.is_within_one) return true;
    const std::set<Index> of_f = x.vertices_of(f), of_g = y.vertices_of(g);
    return std::none_of(of_f.begin(), of_f.end(), [&](Index vertex) { return of_g.count(vertex) != 0; });
  }

  const MeshImpact* found_of(const MeshFeature& a, const MeshFeature& b) const {
    const auto it =
        std::find_if(found_.begin(), found_.end(), [&](const MeshImpact& i) { return i.a == a && i.b == b; });
    return it == found_.end() ? nullptr : &*it;
  }

  /// What was found of the two, which counts as looked at.
  std::optional<TimeOfImpact> told(const MeshFeature& a, const MeshFeature& b) {
    const MeshImpact* const found = found_of(a, b);
    if (!found) return {};
    ++matched_;
    if (found->status != Status::exact) wrong_ = "a status that is not exact";
    return found->time;
  }

  template <class Pair>
  void compare(const MeshFeature& a, const MeshFeature& b, const Pair& pair) {
    const std::optional<TimeOfImpact> time = told(a, b);
    if (ways_are_apart(pair)) {
      if (time) wrong_ = "a contact of features whose ways are apart";
      return;
    }
    ++judged_;
    if (judge_ == FeatureJudge::library) {
      if (time != time_of_impact(pair)) wrong_ = "not what the two features alone are told: " + test::told(pair);
    } else if (const auto wrong = wrong_answer(pair, time)) {
      wrong_ = *wrong + ": " + test::told(pair);
    }
  }

  void look_at_vertices(const FeatureLists& x, const FeatureLists& y, bool turned) {
    for (const Index v : x.vertices) {
      for (Index t = 0; t < y.mesh.triangles().size(); ++t) {
        const MeshFeature vertex{FeatureKind::vertex, v}, face{FeatureKind::face, t};
        if (!are_asked_about(x, vertex, y, face)) continue;
        compare(turned ? face : vertex, turned ? vertex : face, VertexFace{x.way(v), y.face(t)});
      }
    }
  }

  void look_at_edges() {
    for (Index i = 0; i < a_.edges.size(); ++i) {
      for (Index j = meshes_.is_within_one ? i + 1 : 0; j < b_.edges.size(); ++j) {
        const MeshFeature a{FeatureKind::edge, i}, b{FeatureKind::edge, j};
        if (are_asked_about(a_, a, b_, b)) compare(a, b, EdgeEdge{a_.edge(i), b_.edge(j)});
      }
    }
  }

  void look_at_pierced(const FeatureLists& x, const FeatureLists& y, bool turned) {
    for (Index i = 0; i < x.edges.size(); ++i) {
      for (Index t = 0; t < y.mesh.triangles().size(); ++t) {
        const MeshFeature edge{FeatureKind::edge, i}, face{FeatureKind::face, t};
        if (!are_asked_about(x, edge, y, face)) continue;
        const std::optional<TimeOfImpact> time = told(turned ? face : edge, turned ? edge : face);
        if (time != (meet_at_start(x.edge(i), y.face(t)) ? std::optional(TimeOfImpact{0, 0}) : std::nullopt))
          wrong_ = fmt::format("edge {} and triangle {} at the start", i, t);
      }
    }
  }

  [[nodiscard]] bool meet_at_start(const std::array<MovingPoint, 2>& edge,
                                   const std::array<MovingPoint, 3>& face) const {
    const Triangle segment{{edge[0].start, edge[1].start, edge[1].start}};
    const Triangle triangle{{face[0].start, face[1].start, face[2].start}};
    if (judge_ == FeatureJudge::library) return overlap(segment, triangle);
    return oracle::overlap(oracle::exact(segment), oracle::exact(triangle));
  }

  const DeformingPair& meshes_;
  FeatureLists a_;
  FeatureLists b_;
  std::span<const MeshImpact> found_;
  FeatureJudge judge_;
  std::size_t matched_ = 0;
  std::size_t judged_ = 0;
  std::string wrong_;
};

oracle::RationalPoint at_time(const MovingPoint& p, const oracle::Rational& t) {
  const oracle::Rational before = oracle::Rational(1) - t;
  return before * oracle::exact(p.start) + t * oracle::exact(p.end);
}

template <std::size_t count>
oracle::ConvexSet set_at(const std::array<MovingPoint, count>& points, const oracle::Rational& t) {
  oracle::ConvexSet set;
  for (const MovingPoint& p : points) set.vertices.push_back(at_time(p, t));
  return set;
}

/// The sign of (distance at the time) − separation.
int compared_distance(const VertexFace& pair, double time, double separation) {
  const oracle::Rational t = oracle::exact(time);
  return oracle::compare_distance(set_at(std::array{pair.vertex}, t), set_at(pair.face, t), oracle::exact(separation));
}
int compared_distance(const EdgeEdge& pair, double time, double separation) {
  const oracle::Rational t = oracle::exact(time);
  return oracle::compare_distance(set_at(pair.a, t), set_at(pair.b, t), oracle::exact(separation));
}

/// Free means at all times before `lower`, and where there is no approach at all times.
template <class Pair>
std::optional<std::string> fault_of_approach(const Pair& pair, const std::optional<MeshImpact>& told,
                                             double separation) {
  if (told && told->status == Status::exact && compared_distance(pair, told->time.upper, separation) > 0)
    return "they are farther apart at the upper end";
  const double until = told ? told->time.lower : 1;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 0.96875, 1.0}) {
    if (told && (until == 0 || part == 1)) break;
    if (compared_distance(pair, part * until, separation) <= 0) return "an approach is missed, or told too late";
  }
  return std::nullopt;
}

}  // namespace

ImpactVerdict verdict_on_impacts(const DeformingPair& meshes, std::span<const MeshImpact> found, FeatureJudge judge) {
  return ImpactJudge(meshes, found, judge).verdict();
}

std::optional<std::string> wrong_impacts(const DeformingPair& meshes, std::span<const MeshImpact> found,
                                         FeatureJudge judge) {
  return verdict_on_impacts(meshes, found, judge).wrong;
}

std::optional<std::string> wrong_approach(const VertexFace& pair, const std::optional<MeshImpact>& told,
                                          double separation) {
  return fault_of_approach(pair, told, separation);
}
std::optional<std::string> wrong_approach(const EdgeEdge& pair, const std::optional<MeshImpact>& told,
                                          double separation) {
  return fault_of_approach(pair, told, separation);
}

}  // namespace toccata::test
