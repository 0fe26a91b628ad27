#include "narrow/quadrics/contact/contact_patch.hpp"

#include <cmath>

#include "math/vec3_measures.hpp"
#include "narrow/triangles/contact_faces.hpp"

namespace toccata {
namespace {

/// What parts of a side may be off by, as a share of its length.
constexpr double rounding_of_parts = 0x1p-44;

/// A direction across the normal: in the plane of two axes, of the two that are most across it.
Vec3 unit_across(const Vec3& normal) {
  const Vec3 m = magnitudes(normal);
  if (m.x <= m.y && m.x <= m.z) return unit_or_zero(cross({1, 0, 0}, normal));
  return unit_or_zero(cross(m.y <= m.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, normal));
}

bool is_across(const Vec3& along, const Vec3& normal) {
  return !(along == Vec3{}) && std::fabs(dot(unit_or_zero(along), normal)) <= cosine_across;
}

void lean(ContactPatch& patch, const Vec3& normal) {
  patch.slope_x = -normal.x / normal.z;
  patch.slope_y = -normal.y / normal.z;
}

/// The quarter that a point is in, from the first axis on to the second one, around.
Index quarter(const Vec3& u) {
  if (u.x > 0 && u.y >= 0) return 0;
  if (u.x <= 0 && u.y > 0) return 1;
  return u.x < 0 && u.y <= 0 ? 2 : 3;
}

/// What one of two generators turns to a direction.
class RoundSides {
 public:
  RoundSides(const PlainBody& body, const ContactFrame& frame, double outwards, ContactPatch& patch)
      : body_(body), frame_(frame), direction_(outwards * frame.z), patch_(patch) {}

  void fill() {
    const Vec3 upwards = body_.plain_centre(1) - body_.plain_centre(0);
    const Vec3 across = unit_or_zero(cross(unit_or_zero(body_.plain_column(0)), unit_or_zero(body_.plain_column(1))));
    const Vec3 cap = dot(across, upwards) < 0 ? -across : across;
    const double facing = dot(cap, direction_);
    if (-facing >= cosine_of_facing) return fill_cap(0, cap);
    if (facing >= cosine_of_facing && !body_.has_tip()) return fill_cap(1, cap);
    fill_line();
  }

 private:
  void fill_cap(Index generator, const Vec3& normal) {
    patch_.kind = ContactPatch::Kind::disc;
    patch_.whole = {ConvexFeature::Kind::face, generator};
    patch_.first_rim = 4 * generator;
    patch_.centre = frame_.placed(body_.plain_centre(generator));
    for (std::size_t j = 0; j < 2; ++j) patch_.column[j] = frame_.turned(body_.plain_column(j));
    lean(patch_, frame_.turned(normal));
  }

  /// The line of the side that is farthest along the direction, or the end of it that is.
  void fill_line() {
    const Vec3 along = unit_or_zero(body_.along_columns(direction_)), rim = body_.map(along);
    const Vec3 low = body_.plain_centre(0) + rim, high = body_.plain_centre(1) + (body_.has_tip() ? Vec3{} : rim);
    const PatchCorner at_low{frame_.placed(low), {ConvexFeature::Kind::edge, quarter(along)}, {}};
    const PatchCorner at_high{frame_.placed(high),
                              body_.has_tip() ? ConvexFeature{ConvexFeature::Kind::vertex, 0}
                                              : ConvexFeature{ConvexFeature::Kind::edge, 4 + quarter(along)},
                              {}};
    if (!(along == Vec3{}) && is_across(high - low, direction_)) {
      patch_.kind = ContactPatch::Kind::line;
      patch_.whole = {ConvexFeature::Kind::face, body_.has_tip() ? Index{1} : Index{2}};
      patch_.corners = {at_low, at_high};
      patch_.side = {frame_.placed(body_.plain_centre(0)),
                     frame_.turned(body_.plain_centre(1) - body_.plain_centre(0)),
                     {frame_.turned(body_.plain_column(0)), frame_.turned(body_.plain_column(1))},
                     body_.has_tip()};
      return;
    }
    const PatchCorner& end = dot(high - low, direction_) > 0 ? at_high : at_low;
    patch_.whole = end.here;
    patch_.centre = end.at;
  }

  const PlainBody& body_;
  const ContactFrame& frame_;
  Vec3 direction_;
  ContactPatch& patch_;
};

/// What a polytope turns to a direction.
class FlatSides {
 public:
  FlatSides(const PosedPolytope& shape, const Vec3& origin, const ContactFrame& frame, double outwards,
            ContactPatch& patch)
      : shape_(shape),
        origin_(origin),
        frame_(frame),
        outwards_{0, 0, outwards},
        direction_(outwards * frame.z),
        face_(facing_face(shape, direction_)),
        patch_(patch) {}

  void fill(const Vec3& touching) {
    patch_.whole = {ConvexFeature::Kind::vertex, face_.vertex};
    patch_.centre = place(face_.vertex) + shape_.radius() * outwards_;
    if (face_.face == ContactFace::none) return;
    if (face_.facing >= cosine_of_facing) return fill_polygon(touching);
    const Index half_edge = most_across();
    if (half_edge != ContactFace::none) fill_line(half_edge);
  }

 private:
  [[nodiscard]] Vec3 place(Index vertex) const { return frame_.placed(shape_.vertex(vertex) - origin_); }

  void fill_polygon(const Vec3& touching) {
    const HullTopology topology = shape_.topology();
    patch_.kind = ContactPatch::Kind::polygon;
    patch_.whole = {ConvexFeature::Kind::face, face_.face};
    const Vec3 normal = frame_.turned(face_.normal), grown = shape_.radius() * normal;
    double twice_area = 0;
    for (Index h = face_.first(); h < face_.last(); ++h) {
      const Vec3 p = place(topology.origin[h]) + grown, q = place(topology.target(h)) + grown;
      patch_.corners.push_back({p,
                                {ConvexFeature::Kind::vertex, topology.origin[h]},
                                {ConvexFeature::Kind::edge, edge_number(topology, h)}});
      twice_area += p.x * q.y - p.y * q.x;
    }
    patch_.turn = twice_area < 0 ? -1 : 1;
    // The plane is as rough as its normal far from where it is held.
    patch_.centre = frame_.placed(touching) + (grown - shape_.radius() * outwards_);
    lean(patch_, normal);
  }

  /// The edge at the farthest vertex that is most across the direction, if one is so at all.
  [[nodiscard]] Index most_across() const {
    const HullTopology topology = shape_.topology();
    const Index start = topology.leaving[face_.vertex];
    if (topology.origin[start] != face_.vertex) return ContactFace::none;
    Index best = ContactFace::none, half_edge = start;
    double least = cosine_across;
    do {
      const Vec3 along = shape_.vertex(topology.target(half_edge)) - shape_.vertex(face_.vertex);
      const double cosine = std::fabs(dot(unit_or_zero(along), direction_));
      if (!(along == Vec3{}) && cosine <= least) {
        best = half_edge;
        least = cosine;
      }
      half_edge = topology.next(topology.twin[half_edge]);
    } while (half_edge != start);
    return best;
  }

  void fill_line(Index half_edge) {
    const HullTopology topology = shape_.topology();
    const Index from = topology.origin[half_edge], to = topology.target(half_edge);
    patch_.kind = ContactPatch::Kind::line;
    patch_.whole = {ConvexFeature::Kind::edge, edge_number(topology, half_edge)};
    const Vec3 axis = place(to) - place(from), along = unit_or_zero(axis);
    const Vec3 grown = shape_.radius() * unit_or_zero(outwards_ - dot(along, outwards_) * along);
    patch_.corners = {{place(from) + grown, {ConvexFeature::Kind::vertex, from}, {}},
                      {place(to) + grown, {ConvexFeature::Kind::vertex, to}, {}}};
    if (shape_.radius() > 0) patch_.side = {place(from), axis, {grown, cross(along, grown)}};
  }

  const PosedPolytope& shape_;
  const Vec3& origin_;
  const ContactFrame& frame_;
  Vec3 outwards_;   ///< in the contact's frame
  Vec3 direction_;  ///< the same, in the pair's
  ContactFace face_;
  ContactPatch& patch_;
};

}  // namespace

ContactFrame::ContactFrame(const Vec3& at, const Vec3& normal)
    : origin(at), x(unit_across(normal)), y(cross(normal, x)), z(normal) {}

// The root of a t² + 2 b t + c that is nearer to 0, t above the point.
std::optional<double> RoundSide::height_near(const Vec3& at) const {
  const Vec3 to_x = cross(column[1], axis), to_y = cross(axis, column[0]), to_s = cross(column[0], column[1]);
  const double volume = dot(to_s, axis);
  const Vec3 from = at - base;
  const Vec3 u{dot(to_x, from) / volume, dot(to_y, from) / volume, 0}, way{to_x.z / volume, to_y.z / volume, 0};
  const double s = dot(to_s, from) / volume, s_way = to_s.z / volume;
  const double width = tapers ? 1 - s : 1, width_way = tapers ? -s_way : 0;
  const double a = dot(way, way) - width_way * width_way, b = dot(u, way) - width * width_way,
               c = dot(u, u) - width * width;
  const double squared = b * b - a * c;
  if (!(squared >= 0) || b == 0) return {};
  const double t = -c / (b + std::copysign(std::sqrt(squared), b)), part = s + t * s_way;
  if (!(part >= -rounding_of_parts && part <= 1 + rounding_of_parts)) return {};
  return at.z + t;
}

double ContactPatch::height(const Vec3& at) const {
  if (kind != Kind::line) return centre.z + (slope_x * (at.x - centre.x) + slope_y * (at.y - centre.y));
  const Vec3 from = corners[0].at, way = corners[1].at - from;
  const double part = (way.x * (at.x - from.x) + way.y * (at.y - from.y)) / (way.x * way.x + way.y * way.y);
  return from.z + part * way.z;
}

Vec3 ContactPatch::on_unit_disc(const Vec3& at) const {
  const Vec3 &p = column[0], &q = column[1];
  const double area = p.x * q.y - p.y * q.x, x = at.x - centre.x, y = at.y - centre.y;
  return {(x * q.y - y * q.x) / area, (p.x * y - p.y * x) / area, 0};
}

ConvexFeature ContactPatch::rim_at(const Vec3& u) const { return {ConvexFeature::Kind::edge, first_rim + quarter(u)}; }

ContactPatch patch_of(const PlainBody& body, const ContactFrame& frame, double outwards,
                      std::pmr::memory_resource& memory) {
  ContactPatch patch(memory);
  if (body.generator_count() == 1) {
    patch.whole = {ConvexFeature::Kind::face, 0};
    patch.centre = frame.placed(body.support(outwards * frame.z).point);
  } else {
    RoundSides(body, frame, outwards, patch).fill();
  }
  return patch;
}

ContactPatch patch_of(const PosedPolytope& shape, const Vec3& origin, const ContactFrame& frame, double outwards,
                      const Vec3& touching, std::pmr::memory_resource& memory) {
  ContactPatch patch(memory);
  FlatSides(shape, origin, frame, outwards, patch).fill(touching);
  return patch;
}

}  // namespace toccata
