#include "toccata/query/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "math/vec3_measures.hpp"
#include "query/contacts/region_depth.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/posed_mesh_pair.hpp"
#include "shapes/union_find.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Of a triangle of whatever size.
Vec3 normal_of_any_size(const Triangle& t) {
  return unit_or_zero(cross(unit_or_zero(t[1] - t[0]), unit_or_zero(t[2] - t[0])));
}

/// −1 for a solid that is inside out, so that its triangles' normals point inwards: a mirrored one, for example.
double turn_of(const PosedMesh& mesh, bool solid) {
  if (!solid) return 1;
  const Aabb& box = mesh.box();
  const Vec3 middle = 0.5 * box.lower + 0.5 * box.upper, size = box.upper - middle;
  const double unit = std::max({size.x, size.y, size.z});
  const auto seen = [&](const Vec3& v) -> Vec3 {
    return {(v.x - middle.x) / unit, (v.y - middle.y) / unit, (v.z - middle.z) / unit};
  };
  double volume = 0;
  for (Index t = 0; t < mesh.model().element_count(); ++t) {
    const Triangle triangle = mesh.triangle(t);
    volume += dot(seen(triangle[0]), cross(seen(triangle[1]), seen(triangle[2])));
  }
  return volume < 0 ? -1 : 1;
}

/// The regions as lists of contacts, each ascending, the one with the least contact first.
std::vector<std::vector<Index>> connected(std::span<const Contact> contacts, const VertexGraph& a,
                                          const VertexGraph& b) {
  std::vector<std::array<Index, 3>> uses;  // a vertex of A, a vertex of B, a contact
  for (Index i = 0; i < contacts.size(); ++i)
    for (const Index p : a.corners(contacts[i].triangle_a))
      for (const Index q : b.corners(contacts[i].triangle_b)) uses.push_back({p, q, i});
  std::sort(uses.begin(), uses.end());
  UnionFind sets(contacts.size());
  for (std::size_t k = 1; k < uses.size(); ++k)
    if (uses[k][0] == uses[k - 1][0] && uses[k][1] == uses[k - 1][1]) sets.unite(uses[k][2], uses[k - 1][2]);
  std::map<Index, std::vector<Index>> of_leader;
  for (Index i = 0; i < contacts.size(); ++i) of_leader[sets.leader(i)].push_back(i);
  std::vector<std::vector<Index>> regions;
  for (auto& [leader, members] : of_leader) regions.push_back(std::move(members));
  return regions;
}

/// What is added up over the contacts of a region.
struct Outline {
  std::vector<Vec3> points;
  std::vector<std::pair<Vec3, int>> ends;  ///< of the crossing segments: +1 where one begins, −1 where it ends
  Vec3 of_curve;                           ///< twice the vector area, seen from the first point
  Vec3 of_faces;
  Vec3 of_normals;
};

class RegionSum {
 public:
  RegionSum(const PosedMeshPair& pair, double turn_a, double turn_b) : pair_(pair), turn_a_(turn_a), turn_b_(turn_b) {}

  void add(const Contact& contact) {
    const Triangle a = pair_.a.triangle(contact.triangle_a), b = pair_.b.triangle(contact.triangle_b);
    const IntersectionPoints found = intersection_points(contact.intersection, a, b);
    const std::span<const Vec3> points(found.points.data(), found.count);
    outline_.points.insert(outline_.points.end(), points.begin(), points.end());
    const Vec3 normal_a = turn_a_ * normal_of_any_size(a), normal_b = turn_b_ * normal_of_any_size(b);
    outline_.of_normals = outline_.of_normals + (normal_a - normal_b);
    if (contact.intersection.kind == IntersectionKind::polygon) add_polygon(points, normal_a);
    if (contact.intersection.kind == IntersectionKind::segment && contact.intersection.crossing)
      add_segment(points[0], points[1], cross(normal_a, normal_b));
  }

  [[nodiscard]] const Outline& outline() const { return outline_; }

 private:
  void add_polygon(std::span<const Vec3> points, const Vec3& normal) {
    Vec3 sum;
    for (std::size_t i = 2; i < points.size(); ++i) sum = sum + cross(points[i - 1] - points[0], points[i] - points[0]);
    outline_.of_faces = outline_.of_faces + (dot(sum, normal) < 0 ? -sum : sum);
  }

  /// So that what of A lies within B is to the left, seen from outside of A.
  void add_segment(Vec3 from, Vec3 to, const Vec3& along) {
    if (dot(to - from, along) < 0) std::swap(from, to);
    const Vec3 seen_from = outline_.points.front();
    outline_.of_curve = outline_.of_curve + cross(from - seen_from, to - seen_from);
    outline_.ends.emplace_back(from, 1);
    outline_.ends.emplace_back(to, -1);
  }

  const PosedMeshPair& pair_;
  double turn_a_;
  double turn_b_;
  Outline outline_;
};

/// Equal points are the same bits, but for the sign of a zero: each is the nearest to the exact one.
bool is_closed(std::vector<std::pair<Vec3, int>> ends) {
  std::sort(ends.begin(), ends.end(),
            [](const auto& s, const auto& t) { return lexicographically_less(s.first, t.first); });
  int open = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (i > 0 && ends[i].first != ends[i - 1].first && open != 0) return false;
    open += ends[i].second;
  }
  return !ends.empty() && open == 0;
}

std::vector<Vec3> distinct(std::vector<Vec3> points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

template <class Of>
std::size_t distinct_pairs(std::span<const Contact> contacts, std::span<const Index> members, const Of& of) {
  std::vector<std::pair<Index, Index>> pairs;
  for (const Index i : members) pairs.push_back(of(contacts[i]));
  std::sort(pairs.begin(), pairs.end());
  return static_cast<std::size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

class Regions {
 public:
  Regions(const PosedMeshPair& pair, std::span<const Contact> contacts)
      : pair_(pair),
        contacts_(contacts),
        graph_a_(pair.a),
        graph_b_(pair.b),
        turn_a_(turn_of(pair.a, pair.a_solid)),
        turn_b_(turn_of(pair.b, pair.b_solid)) {}

  [[nodiscard]] std::vector<ContactRegion> sorted() const {
    std::vector<ContactRegion> regions;
    for (const std::vector<Index>& members : connected(contacts_, graph_a_, graph_b_))
      regions.push_back(region_of(members));
    std::stable_sort(regions.begin(), regions.end(), [](const ContactRegion& s, const ContactRegion& t) {
      return std::pair(s.depth.value_or(0), s.area) > std::pair(t.depth.value_or(0), t.area);
    });
    return regions;
  }

 private:
  [[nodiscard]] ContactRegion region_of(const std::vector<Index>& members) const {
    RegionSum sum(pair_, turn_a_, turn_b_);
    for (const Index i : members) sum.add(contacts_[i]);
    const Outline& outline = sum.outline();
    const std::vector<Vec3> points = distinct(outline.points);
    ContactRegion region;
    region.triangle_pairs = members.size();
    region.face_pairs = distinct_pairs(
        contacts_, members, [](const Contact& contact) { return std::pair(contact.face_a, contact.face_b); });
    region.point_count = points.size();
    region.box = fit_aabb(points);
    region.closed = is_closed(outline.ends);
    const Vec3 twice = outline.of_faces + (region.closed ? outline.of_curve : Vec3{});
    region.area = std::hypot(twice.x, twice.y, twice.z) / 2;
    region.normal = unit_or_zero(region.area > 0 ? twice : outline.of_normals);
    add_depth(region, points, members);
    return region;
  }

  void add_depth(ContactRegion& region, const std::vector<Vec3>& points, const std::vector<Index>& members) const {
    for (const Vec3& point : points)
      region.deepest = region.deepest + (1.0 / static_cast<double>(points.size())) * point;
    if (!pair_.a_solid || !pair_.b_solid || !(region.area > 0)) return;
    std::vector<Index> of_a, of_b;
    for (const Index i : members) {
      of_a.push_back(contacts_[i].triangle_a);
      of_b.push_back(contacts_[i].triangle_b);
    }
    const auto lower = [&](const Vec3& p, const Vec3& q) { return dot(region.normal, p) < dot(region.normal, q); };
    std::vector<Vec3> reached_by_a = graph_a_.inside(pair_.b, of_a), reached_by_b = graph_b_.inside(pair_.a, of_b);
    reached_by_a.insert(reached_by_a.end(), points.begin(), points.end());
    reached_by_b.insert(reached_by_b.end(), points.begin(), points.end());
    region.deepest = *std::max_element(reached_by_a.begin(), reached_by_a.end(), lower);
    const Vec3 farthest = *std::min_element(reached_by_b.begin(), reached_by_b.end(), lower);
    region.depth = dot(region.normal, region.deepest - farthest);
  }

  const PosedMeshPair& pair_;
  std::span<const Contact> contacts_;
  VertexGraph graph_a_;
  VertexGraph graph_b_;
  double turn_a_;
  double turn_b_;
};

}  // namespace

std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return contact_regions(a, b, query, workspace);
}

std::vector<ContactRegion> contact_regions(const Model& a, const Model& b, const PairQuery& query,
                                           Workspace& workspace) {
  if (!a.has_mesh() || !b.has_mesh())
    throw Error(
        "contact regions are those of two meshes or height fields: ask for the contacts, or the manifold, of others");
  const PosedMeshPair pair(a, b, query);
  const auto contacts = surface_contacts(pair.a, pair.b, workspace.scratch(), query.threads);
  if (contacts.empty()) return {};
  return Regions(pair, contacts).sorted();
}

}  // namespace toccata
