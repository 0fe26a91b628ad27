#include "query/contacts/region_members.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "query/relation/relation_locality.hpp"
#include "shapes/union_find.hpp"

namespace toccata {
namespace {

void unite_neighbours(std::span<const Contact> contacts, VertexGraph& a, VertexGraph& b, UnionFind& sets) {
  std::vector<std::array<Index, 3>> uses;  // a vertex of A, a vertex of B, a contact
  for (Index i = 0; i < contacts.size(); ++i)
    for (const Index p : a.corners(contacts[i].element_a))
      for (const Index q : b.corners(contacts[i].element_b)) uses.push_back({p, q, i});
  std::sort(uses.begin(), uses.end());
  for (std::size_t k = 1; k < uses.size(); ++k)
    if (uses[k][0] == uses[k - 1][0] && uses[k][1] == uses[k - 1][1]) sets.unite(uses[k][2], uses[k - 1][2]);
}

/// A way through the inside, as far as some of its points tell: at no even distances, as what is repeated is.
bool leads_inside(const Vec3& from, const Vec3& to, const PosedMesh& solid) {
  const auto is_inside = [&](double share) { return is_interior(from + share * (to - from), solid); };
  constexpr std::array shares{0.5, 0.25, 0.75, 0.0957, 0.1803, 0.3337, 0.4193, 0.5821, 0.6683, 0.8101, 0.9052};
  return from != to && std::all_of(shares.begin(), shares.end(), is_inside);
}

double squared_distance(const Vec3& p, const Vec3& q) { return dot(p - q, p - q); }

/// Joins contacts, which are numbered as they are, and pieces, which are numbered from some number on.
class InnerJoin {
 public:
  InnerJoin(std::span<const Contact> contacts, const VertexGraph& graph, const SurfaceWithin& within,
            const VertexGraph& solid, ContactSide side, Index first_piece, UnionFind& sets)
      : contacts_(contacts),
        graph_(graph),
        within_(within),
        solid_(solid),
        side_(side),
        first_piece_(first_piece),
        sets_(sets) {}

  void join() {
    for (const auto& one : within_.in_contact()) join_within(one);
  }

 private:
  using PointsOfSets = std::map<Index, std::vector<Vec3>>;

  /// Some points of each set's contacts on the triangle.
  [[nodiscard]] PointsOfSets points_on(const SurfaceWithin::TriangleInContact& one) {
    constexpr std::size_t most = 16;
    std::map<Index, std::vector<Index>> of_sets;
    for (const Index contact : one.contacts) of_sets[sets_.leader(contact)].push_back(contact);
    PointsOfSets points;
    if (of_sets.size() == 1) {
      points[of_sets.begin()->first] = {};
      return points;
    }
    for (const auto& [set, contacts] : of_sets)
      for (std::size_t i = 0; i < contacts.size(); i += contacts.size() / most + 1)
        points[set].push_back(middle_of(contacts_[contacts[i]]));
    return points;
  }

  [[nodiscard]] Vec3 middle_of(const Contact& contact) const {
    const Triangle own = graph_.mesh().triangle(triangle_of(contact, side_));
    const Triangle other =
        solid_.mesh().triangle(triangle_of(contact, side_ == ContactSide::a ? ContactSide::b : ContactSide::a));
    const bool is_a = side_ == ContactSide::a;
    const IntersectionPoints found = intersection_points(contact.intersection, is_a ? own : other, is_a ? other : own);
    Vec3 middle;
    for (std::size_t i = 0; i < found.count; ++i) middle = middle + (1.0 / found.count) * found.points[i];
    return middle;
  }

  void join_within(const SurfaceWithin::TriangleInContact& one) {
    const PointsOfSets sets = points_on(one);
    for (const Index corner : one.corners) {
      const Index piece = within_.piece_of(corner);
      if (piece == SurfaceWithin::none) continue;
      for (const auto& [set, points] : sets)
        if (sets.size() == 1 || leads_to(graph_.position(corner), points)) sets_.unite(first_piece_ + piece, set);
    }
    for (auto first = sets.begin(); first != sets.end(); ++first)
      for (auto second = std::next(first); second != sets.end(); ++second)
        if (sets_.leader(first->first) != sets_.leader(second->first) && are_joined(first->second, second->second))
          sets_.unite(first->first, second->first);
  }

  [[nodiscard]] bool leads_to(const Vec3& from, const std::vector<Vec3>& points) const {
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
      return squared_distance(from, p) < squared_distance(from, q);
    });
    return leads_inside(from, *nearest, solid_.mesh());
  }

  [[nodiscard]] bool are_joined(const std::vector<Vec3>& some, const std::vector<Vec3>& others) const {
    Vec3 from = some.front(), to = others.front();
    for (const Vec3& p : some)
      for (const Vec3& q : others)
        if (squared_distance(p, q) < squared_distance(from, to)) std::tie(from, to) = std::pair(p, q);
    return leads_inside(from, to, solid_.mesh());
  }

  std::span<const Contact> contacts_;
  const VertexGraph& graph_;
  const SurfaceWithin& within_;
  const VertexGraph& solid_;
  ContactSide side_;
  Index first_piece_;
  UnionFind& sets_;
};

/// A set without a contact is none: its leader is its least member.
std::vector<RegionMembers> members_of(UnionFind& sets, std::size_t contacts, std::size_t of_a, std::size_t of_b) {
  std::map<Index, RegionMembers> of_leader;
  for (Index i = 0; i < contacts; ++i) of_leader[sets.leader(i)].contacts.push_back(i);
  for (Index i = 0; i < of_a + of_b; ++i) {
    const Index leader = sets.leader(static_cast<Index>(contacts) + i);
    if (leader >= contacts) continue;
    if (i < of_a)
      of_leader[leader].pieces_of_a.push_back(i);
    else
      of_leader[leader].pieces_of_b.push_back(i - static_cast<Index>(of_a));
  }
  std::vector<RegionMembers> regions;
  for (auto& [leader, members] : of_leader) regions.push_back(std::move(members));
  return regions;
}

}  // namespace

std::vector<RegionMembers> regions_of_surfaces(std::span<const Contact> contacts, VertexGraph& a, VertexGraph& b) {
  UnionFind sets(contacts.size());
  unite_neighbours(contacts, a, b, sets);
  return members_of(sets, contacts.size(), 0, 0);
}

std::vector<RegionMembers> regions_of_solids(std::span<const Contact> contacts, VertexGraph& a,
                                             const SurfaceWithin& a_within, VertexGraph& b,
                                             const SurfaceWithin& b_within) {
  const std::size_t of_a = a_within.pieces().size(), of_b = b_within.pieces().size();
  UnionFind sets(contacts.size() + of_a + of_b);
  unite_neighbours(contacts, a, b, sets);
  const auto first_of_a = static_cast<Index>(contacts.size()), first_of_b = static_cast<Index>(first_of_a + of_a);
  InnerJoin(contacts, a, a_within, b, ContactSide::a, first_of_a, sets).join();
  InnerJoin(contacts, b, b_within, a, ContactSide::b, first_of_b, sets).join();
  return members_of(sets, contacts.size(), of_a, of_b);
}

std::optional<ContactSide> side_that_pierces(std::span<const Contact> contacts, VertexGraph& a,
                                             const SurfaceWithin& a_within, VertexGraph& b,
                                             const SurfaceWithin& b_within) {
  const std::size_t of_a = a_within.pieces().size(), of_b = b_within.pieces().size();
  const auto count = static_cast<Index>(contacts.size()), first_of_b = static_cast<Index>(count + of_a);
  UnionFind curves(count), by_a(count + of_a), by_b(count + of_b), regions(count + of_a + of_b);
  for (UnionFind* sets : {&curves, &by_a, &by_b, &regions}) unite_neighbours(contacts, a, b, *sets);
  InnerJoin(contacts, a, a_within, b, ContactSide::a, count, by_a).join();
  InnerJoin(contacts, b, b_within, a, ContactSide::b, count, by_b).join();
  InnerJoin(contacts, a, a_within, b, ContactSide::a, count, regions).join();
  InnerJoin(contacts, b, b_within, a, ContactSide::b, first_of_b, regions).join();
  struct Counts {
    std::size_t curves = 0, by_a = 0, by_b = 0;
  };
  std::map<Index, Counts> of_regions;
  for (Index i = 0; i < count; ++i) {
    Counts& counts = of_regions[regions.leader(i)];
    if (curves.leader(i) == i) ++counts.curves;
    if (by_a.leader(i) == i) ++counts.by_a;
    if (by_b.leader(i) == i) ++counts.by_b;
  }
  std::optional<ContactSide> side;
  for (const auto& [leader, counts] : of_regions) {
    if (counts.curves < 2) continue;
    if (counts.by_a == counts.by_b) return {};
    const ContactSide here = counts.by_a < counts.by_b ? ContactSide::a : ContactSide::b;
    if (side && *side != here) return {};
    side = here;
  }
  return side;
}

}  // namespace toccata
