#pragma once

#include <toccata/query/batch.hpp>
#include <toccata/query/signed_distance.hpp>

#include "answers.hpp"

namespace toccata::python {

template <>
struct Described<Distance> {
  static constexpr const char* name = "Distance";
  static constexpr const char* doc =
      "How far apart two posed shapes are, in the unit of the coordinates: the exact distance lies in [lower, upper], "
      "whose width is at most 1e-12 of upper. Both are 0 when they meet.";
  static constexpr std::tuple fields{
      field<Distance, &Distance::lower>("lower", "The exact distance is at least this."),
      field<Distance, &Distance::upper>("upper", "The exact distance is at most this; 0 when the shapes meet."),
      field<Distance, &Distance::on_a>("on_a", "The nearest point of A, in the world; shape (3,)."),
      field<Distance, &Distance::on_b>("on_b", "The nearest point of B, in the world; shape (3,)."),
      field<Distance, &Distance::status>("status", "How far the answer can be trusted."),
      field<Distance, &Distance::element_a>("element_a", "The element of A, of a mesh the triangle."),
      field<Distance, &Distance::element_b>("element_b", "The element of B."),
      field<Distance, &Distance::face_a>("face_a", "The face of A, as its file counts them from 0."),
      field<Distance, &Distance::face_b>("face_b", "The face of B.")};
};

template <>
struct Described<Penetration> {
  static constexpr const char* name = "Penetration";
  static constexpr const char* doc =
      "The shortest way to part two solids: the exact depth lies in [lower, upper], in the unit of the coordinates. "
      "Both are 0 when they are apart or touch. Of meshes the bracket may be wide.";
  static constexpr std::tuple fields{
      field<Penetration, &Penetration::lower>("lower", "The exact depth is at least this."),
      field<Penetration, &Penetration::upper>("upper", "Moved this far along the direction, B no longer overlaps A."),
      field<Penetration, &Penetration::direction>("direction", "Unit vector from A to B; shape (3,)."),
      field<Penetration, &Penetration::on_a>("on_a", "The deepest point of A within B; shape (3,)."),
      field<Penetration, &Penetration::on_b>("on_b", "The deepest point of B within A; shape (3,)."),
      field<Penetration, &Penetration::status>("status", "How far the answer can be trusted.")};
};

template <>
struct Described<Relation> {
  static constexpr const char* name = "Relation";
  static constexpr const char* doc = "How two posed shapes lie; exact, touching included.";
  static constexpr std::tuple fields{
      field<Relation, &Relation::kind>("kind", "Apart, touching, overlapping (two solids) or crossing (a surface)."),
      field<Relation, &Relation::containment>("containment", "Whether one contains the other."),
      field<Relation, &Relation::side_unresolved>(
          "side_unresolved",
          "Two surfaces touch, and the faces alone do not tell whether they pass through each other."),
      field<Relation, &Relation::a_solid>("a_solid", "A was taken as a solid."),
      field<Relation, &Relation::b_solid>("b_solid", "B was taken as a solid."),
      field<Relation, &Relation::status>("status", "How far the answer can be trusted.")};
};

template <>
struct Described<RayHit> {
  static constexpr const char* name = "RayHit";
  static constexpr const char* doc = "What a ray meets first.";
  static constexpr std::tuple fields{
      field<RayHit, &RayHit::lower>("lower", "The exact fraction of the way is at least this."),
      field<RayHit, &RayHit::upper>("upper", "The exact fraction of the way is at most this; from 0 to 1."),
      field<RayHit, &RayHit::point>("point", "Where, in the world; shape (3,)."),
      field<RayHit, &RayHit::normal>("normal", "Unit, against the ray; zero where it starts inside. Shape (3,)."),
      field<RayHit, &RayHit::status>("status", "How far the answer can be trusted."),
      field<RayHit, &RayHit::element>("element", "The element, of a mesh the triangle."),
      field<RayHit, &RayHit::face>("face", "The face, as its file counts them from 0.")};
};

template <>
struct Described<ShapeHit> {
  static constexpr const char* name = "ShapeHit";
  static constexpr const char* doc = "Where a moving shape first meets another.";
  static constexpr std::tuple fields{
      field<ShapeHit, &ShapeHit::lower>("lower", "The exact fraction of the way is at least this."),
      field<ShapeHit, &ShapeHit::upper>("upper", "The exact fraction of the way is at most this; from 0 to 1."),
      field<ShapeHit, &ShapeHit::point>("point", "Where they meet then, in the world; shape (3,)."),
      field<ShapeHit, &ShapeHit::normal>("normal", "Unit, from B to A, which moves; shape (3,)."),
      field<ShapeHit, &ShapeHit::status>("status", "How far the answer can be trusted."),
      field<ShapeHit, &ShapeHit::element_a>("element_a", "The element of A, of a mesh the triangle."),
      field<ShapeHit, &ShapeHit::element_b>("element_b", "The element of B."),
      field<ShapeHit, &ShapeHit::face_a>("face_a", "The face of A, as its file counts them from 0."),
      field<ShapeHit, &ShapeHit::face_b>("face_b", "The face of B.")};
};

template <>
struct Described<SurfacePoint> {
  static constexpr const char* name = "SurfacePoint";
  static constexpr const char* doc = "The point of a surface that is nearest to a given one.";
  static constexpr std::tuple fields{
      field<SurfacePoint, &SurfacePoint::lower>("lower", "The exact distance is at least this."),
      field<SurfacePoint, &SurfacePoint::upper>("upper", "The exact distance is at most this."),
      field<SurfacePoint, &SurfacePoint::point>("point", "The nearest point, in the world; shape (3,)."),
      field<SurfacePoint, &SurfacePoint::element>("element", "The element, of a mesh the triangle."),
      field<SurfacePoint, &SurfacePoint::face>("face", "The face, as its file counts them from 0."),
      field<SurfacePoint, &SurfacePoint::status>("status", "How far the answer can be trusted.")};
};

template <>
struct Described<SignedDistance> {
  static constexpr const char* name = "SignedDistance";
  static constexpr const char* doc =
      "How far a point is from a surface, negative inside: the exact one lies in [lower, upper].";
  static constexpr std::tuple fields{
      field<SignedDistance, &SignedDistance::lower>("lower", "The exact signed distance is at least this."),
      field<SignedDistance, &SignedDistance::upper>("upper", "The exact signed distance is at most this."),
      field<SignedDistance, &SignedDistance::nearest>("nearest", "The nearest point of the surface; shape (3,)."),
      field<SignedDistance, &SignedDistance::element>("element", "The element, of a mesh the triangle."),
      field<SignedDistance, &SignedDistance::face>("face", "The face, as its file counts them from 0."),
      field<SignedDistance, &SignedDistance::side>("side", "Inside, outside, or on the boundary."),
      field<SignedDistance, &SignedDistance::sign_by>("sign_by", "What told the side."),
      field<SignedDistance, &SignedDistance::status>("status", "How far the answer can be trusted.")};
};

template <>
struct Described<WindingNumber> {
  static constexpr const char* name = "WindingNumber";
  static constexpr const char* doc =
      "The generalised winding number of a mesh around a point: the exact one lies in [lower, upper].";
  static constexpr std::tuple fields{
      field<WindingNumber, &WindingNumber::value>("value", "1 inside a closed mesh and 0 outside, up to rounding."),
      field<WindingNumber, &WindingNumber::lower>("lower", "The exact one is at least this."),
      field<WindingNumber, &WindingNumber::upper>("upper", "The exact one is at most this."),
      field<WindingNumber, &WindingNumber::status>("status", "not_converged: the interval is wider than asked for.")};
};

template <>
struct Described<Contact> {
  static constexpr const char* name = "Contact";
  static constexpr const char* doc = "Two elements, one of each shape, that have a point in common.";
  static constexpr std::tuple fields{
      field<Contact, &Contact::element_a>("element_a", "The element of A, of a mesh the triangle."),
      field<Contact, &Contact::element_b>("element_b", "The element of B."),
      field<Contact, &Contact::face_a>("face_a", "The face of A, as its file counts them from 0."),
      field<Contact, &Contact::face_b>("face_b", "The face of B."),
      field<Contact, &Contact::intersection, &Intersection::kind>("kind", "Point, segment or polygon."),
      field<Contact, &Contact::intersection, &Intersection::coplanar>("coplanar", "All six vertices lie in a plane."),
      field<Contact, &Contact::intersection, &Intersection::crossing>("crossing", "They pass through each other."),
      field<Contact, &Contact::intersection, &Intersection::count>("point_count",
                                                                   "Corners of what they have in common.")};
};

/// A contact and the corners of what its triangles have in common.
struct ContactWithPoints {
  Contact contact;
  std::array<Vec3, 6> points{};
};

template <>
struct Described<ContactWithPoints> {
  static constexpr const char* name = "Contact";
  static constexpr const char* doc = Described<Contact>::doc;
  static constexpr auto fields =
      std::tuple_cat(fields_within<ContactWithPoints, &ContactWithPoints::contact>(Described<Contact>::fields),
                     std::tuple{field<ContactWithPoints, &ContactWithPoints::points>("points", "")});
};

template <>
struct Described<ContactCount> {
  static constexpr const char* name = "ContactCount";
  static constexpr const char* doc = "How many triangles, and how many faces of the files, meet.";
  static constexpr std::tuple fields{field<ContactCount, &ContactCount::triangle_pairs>("triangle_pairs", ""),
                                     field<ContactCount, &ContactCount::face_pairs>("face_pairs", "")};
};

}  // namespace toccata::python
