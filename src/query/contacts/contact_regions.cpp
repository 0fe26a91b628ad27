#include "toccata/query/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "math/vec3_measures.hpp"
#include "query/contacts/common_shadow.hpp"
#include "query/contacts/outward_turn.hpp"
#include "query/contacts/region_depth.hpp"
#include "query/contacts/region_members.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/posed_mesh_pair.hpp"
#include "query/volume/perturbed_pair.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

/// What is added up over the contacts of a region.
struct Outline {
  std::vector<Vec3> points;
  std::vector<std::pair<Vec3, int>> ends;  ///< of the crossing segments: +1 where one begins, −1 where it ends
  Vec3 of_curve;                           ///< twice the vector area, seen from the first point
  Vec3 of_faces;
  Vec3 of_normals;
  double length = 0;        ///< of all borders of faces and crossing segments
  double normal_sizes = 0;  ///< the sum of the normals' lengths
};

/// A sum that is no more than that part of what was added is rounding, and has no direction.
constexpr double least_share_of_sum = 0x1p-44;

double greatest_coordinate(std::span<const Vec3> points) {
  double greatest = 0;
  for (const Vec3& point : points) greatest = std::max(greatest, largest_magnitude(point));
  return greatest;
}

/// The vector area, or the zero vector where it is rounding: where a solid is held from all sides, its faces cancel.
Vec3 twice_vector_area(const Outline& outline, bool closed) {
  const Vec3 twice = outline.of_faces + (closed ? outline.of_curve : Vec3{});
  const double rounding = least_share_of_sum * greatest_coordinate(outline.points) * outline.length;
  return plain_length(twice) > rounding ? twice : Vec3{};
}

Vec3 sum_of_normals(const Outline& outline) {
  return plain_length(outline.of_normals) > least_share_of_sum * outline.normal_sizes ? outline.of_normals : Vec3{};
}

class RegionSum {
 public:
  RegionSum(const PosedMeshPair& pair, double turn_a, double turn_b) : pair_(pair), turn_a_(turn_a), turn_b_(turn_b) {}

  void add(const Contact& contact) {
    const Triangle a = pair_.a.triangle(contact.element_a), b = pair_.b.triangle(contact.element_b);
    const IntersectionPoints found = intersection_points(contact.intersection, a, b);
    const std::span<const Vec3> points(found.points.data(), found.count);
    outline_.points.insert(outline_.points.end(), points.begin(), points.end());
    const Vec3 normal_a = turn_a_ * normal_of_any_size(a), normal_b = turn_b_ * normal_of_any_size(b);
    outline_.of_normals = outline_.of_normals + (normal_a - normal_b);
    outline_.normal_sizes += plain_length(normal_a) + plain_length(normal_b);
    if (contact.intersection.kind == IntersectionKind::polygon) add_polygon(points, normal_a);
    if (contact.intersection.kind == IntersectionKind::segment && contact.intersection.crossing)
      add_segment(points[0], points[1], cross(normal_a, normal_b));
  }

  [[nodiscard]] const Outline& outline() const { return outline_; }

 private:
  void add_polygon(std::span<const Vec3> points, const Vec3& normal) {
    const Vec3 sum = twice_area_of(points);
    for (std::size_t i = 0; i < points.size(); ++i)
      outline_.length += plain_length(points[(i + 1) % points.size()] - points[i]);
    outline_.of_faces = outline_.of_faces + (dot(sum, normal) < 0 ? -sum : sum);
  }

  /// So that what of A lies within B is to the left, seen from outside of A.
  void add_segment(Vec3 from, Vec3 to, const Vec3& along) {
    if (dot(to - from, along) < 0) std::swap(from, to);
    outline_.length += plain_length(to - from);
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

/// What two solids have in common, as far as it hangs on their contacts.
struct CommonPart {
  SurfaceWithin a_in_b;
  SurfaceWithin b_in_a;
  std::vector<PlanePiece> cut_pieces;  ///< of the triangles in contact
};

class Regions {
 public:
  Regions(const Model& a, const Model& b, const PairQuery& query, const PosedMeshPair& pair,
          std::span<const Contact> contacts, SearchScratch& scratch)
      : a_(a),
        b_(b),
        query_(query),
        pair_(pair),
        contacts_(contacts),
        graph_a_(pair.a),
        graph_b_(pair.b),
        turn_a_(pair.a_solid ? outward_turn(pair.a, contacts.front().element_a) : 1),
        turn_b_(pair.b_solid ? outward_turn(pair.b, contacts.front().element_b) : 1) {
    if (!pair.a_solid || !pair.b_solid) return;
    common_.emplace(CommonPart{SurfaceWithin(graph_a_, pair.b, contacts, ContactSide::a),
                               SurfaceWithin(graph_b_, pair.a, contacts, ContactSide::b),
                               {}});
    cut_triangles();
    depth_.emplace(a, b, query, pair, turn_a_, turn_b_, scratch);
  }

  [[nodiscard]] std::vector<ContactRegion> sorted() {
    const std::vector<RegionMembers> all =
        common_ ? regions_of_solids(contacts_, graph_a_, common_->a_in_b, graph_b_, common_->b_in_a)
                : regions_of_surfaces(contacts_, graph_a_, graph_b_);
    const std::vector<std::vector<PlanePiece>> cut_pieces = pieces_of_each(all);
    std::vector<ContactRegion> regions;
    for (std::size_t i = 0; i < all.size(); ++i) regions.push_back(region_of(all[i], cut_pieces[i]));
    tell_touching(regions);
    const auto depth_of = [](const ContactRegion& region) { return region.depth ? region.depth->lower : 0; };
    std::stable_sort(regions.begin(), regions.end(), [&](const ContactRegion& s, const ContactRegion& t) {
      return std::pair(depth_of(s), s.area) > std::pair(depth_of(t), t.area);
    });
    return regions;
  }

 private:
  /// Where no depth was found, there may be none: whether the two have only their surfaces in common is exact.
  void tell_touching(std::vector<ContactRegion>& regions) const {
    const auto is_open = [](const ContactRegion& region) { return region.depth && region.depth->lower == 0; };
    if (std::none_of(regions.begin(), regions.end(), is_open)) return;
    if (relation(a_, b_, query_).kind == RelationKind::overlapping) return;
    for (ContactRegion& region : regions) region.depth = ContactRegion::Depth{};
  }

  void cut_triangles() {
    const TriangleCutter of_a(graph_a_, turn_a_, graph_b_, turn_b_, contacts_, ContactSide::a),
        of_b(graph_b_, turn_b_, graph_a_, turn_a_, contacts_, ContactSide::b);
    for (const auto& one : common_->a_in_b.in_contact()) of_a.add_pieces(common_->a_in_b, one, common_->cut_pieces);
    for (const auto& one : common_->b_in_a.in_contact()) of_b.add_pieces(common_->b_in_a, one, common_->cut_pieces);
  }

  [[nodiscard]] std::vector<std::vector<PlanePiece>> pieces_of_each(const std::vector<RegionMembers>& regions) const {
    std::vector<std::vector<PlanePiece>> pieces(regions.size());
    if (!common_) return pieces;
    std::vector<std::size_t> region_of_contact(contacts_.size());
    for (std::size_t i = 0; i < regions.size(); ++i)
      for (const Index contact : regions[i].contacts) region_of_contact[contact] = i;
    for (const PlanePiece& piece : common_->cut_pieces) pieces[region_of_contact[piece.contact]].push_back(piece);
    return pieces;
  }

  [[nodiscard]] ContactRegion region_of(const RegionMembers& members, std::span<const PlanePiece> cut_pieces) {
    RegionSum sum(pair_, turn_a_, turn_b_);
    for (const Index i : members.contacts) sum.add(contacts_[i]);
    const Outline& outline = sum.outline();
    const std::vector<Vec3> points = distinct(outline.points);
    ContactRegion region;
    region.triangle_pairs = members.contacts.size();
    region.face_pairs = distinct_pairs(
        contacts_, members.contacts, [](const Contact& contact) { return std::pair(contact.face_a, contact.face_b); });
    region.point_count = points.size();
    region.box = fit_aabb(points);
    region.closed = is_closed(outline.ends);
    region.curve_count = curve_count_of(members);
    for (const Vec3& point : points)
      region.deepest = region.deepest + (1.0 / static_cast<double>(points.size())) * point;
    region.deepest = nearest_point_of(region.box, region.deepest);
    const Vec3 twice = twice_vector_area(outline, region.closed);
    region.area = std::hypot(twice.x, twice.y, twice.z) / 2;
    region.normal = unit_or_zero(region.area > 0 ? twice : sum_of_normals(outline));
    if (common_) add_common_part(region, members, cut_pieces);
    return region;
  }

  [[nodiscard]] std::size_t curve_count_of(const RegionMembers& members) {
    CrossingCurves curves;
    for (const Index i : members.contacts) {
      const Contact& contact = contacts_[i];
      const Triangle a = pair_.a.triangle(contact.element_a), b = pair_.b.triangle(contact.element_b);
      if (!has_area(a) || !has_area(b)) continue;
      const EdgesThrough through = perturbed_edges_through(a, b);
      if (through.any()) curves.add(graph_a_, contact.element_a, graph_b_, contact.element_b, through);
    }
    return curves.count();
  }

  void add_common_part(ContactRegion& region, const RegionMembers& members,
                       std::span<const PlanePiece> cut_pieces) const {
    const std::vector<Vec3> of_a = vertices_of(common_->a_in_b, members.pieces_of_a),
                            of_b = vertices_of(common_->b_in_a, members.pieces_of_b);
    for (const std::vector<Vec3>* vertices : {&of_a, &of_b})
      for (const Vec3& vertex : *vertices) region.box = merge(region.box, vertex);
    const FoundDepth found = depth_->within(region.box, of_a, of_b);
    region.depth = found.bracket;
    if (found.bracket.lower > 0) {
      region.deepest = found.deepest.point;
      const Vec3 across = unit_or_zero(found.deepest.on_a - found.deepest.on_b);
      region.normal = across == Vec3{} ? unit_or_zero(found.deepest.on_a - found.deepest.point) : across;
    }
    region.area = shadow_area(region.normal, members, cut_pieces);
  }

  [[nodiscard]] static std::vector<Vec3> vertices_of(const SurfaceWithin& within, const std::vector<Index>& pieces) {
    std::vector<Vec3> vertices;
    for (const Index piece : pieces) {
      const std::vector<Vec3>& more = within.pieces()[piece].vertices;
      vertices.insert(vertices.end(), more.begin(), more.end());
    }
    return vertices;
  }

  [[nodiscard]] double shadow_area(const Vec3& normal, const RegionMembers& members,
                                   std::span<const PlanePiece> cut_pieces) const {
    double twice = 0;
    for (const PlanePiece& piece : cut_pieces) twice += piece.weight * std::abs(dot(normal, piece.area));
    const auto add_inner = [&](const PosedMesh& mesh, const SurfaceWithin& within, const std::vector<Index>& pieces) {
      for (const Index piece : pieces)
        for (const Index triangle : within.pieces()[piece].triangles) {
          const Triangle t = mesh.triangle(triangle);
          twice += std::abs(dot(normal, cross(t[1] - t[0], t[2] - t[0]))) / 2;
        }
    };
    add_inner(pair_.a, common_->a_in_b, members.pieces_of_a);
    add_inner(pair_.b, common_->b_in_a, members.pieces_of_b);
    return twice / 2;
  }

  const Model& a_;
  const Model& b_;
  const PairQuery& query_;
  const PosedMeshPair& pair_;
  std::span<const Contact> contacts_;
  VertexGraph graph_a_;
  VertexGraph graph_b_;
  double turn_a_;
  double turn_b_;
  std::optional<CommonPart> common_;
  std::optional<CommonDepth> depth_;
};

std::vector<ContactRegion> with_normals_turned(std::vector<ContactRegion> regions) {
  for (ContactRegion& region : regions) region.normal = Vec3{} - region.normal;
  return regions;
}

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
  if (!overlap(pair.a.box(), pair.b.box())) return {};
  // In one order, so that all that is rounded is the same whichever is named first.
  if (!comes_first(pair.a, pair.b)) {
    const PairQuery other{query.pose_b, query.pose_a, query.solid_b, query.solid_a, query.threads};
    return with_normals_turned(contact_regions(b, a, other, workspace));
  }
  const auto contacts = surface_contacts(pair.a, pair.b, workspace.scratch(), query.threads);
  if (contacts.empty()) return {};
  return Regions(a, b, query, pair, contacts, workspace.scratch()).sorted();
}

}  // namespace toccata
