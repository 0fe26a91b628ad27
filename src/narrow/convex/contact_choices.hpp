#pragma once

// What manifolds of all shapes take as one contact.
namespace toccata {

/// Faces and edges that turn farther away from each other, by about two degrees, touch in single points.
inline constexpr double cosine_of_face_contact = 0.9995;

/// A gap of this part of the size of the contact still belongs to it, so that a resting box keeps its four points.
inline constexpr double gap_of_resting = 0x1p-10;

/// An edge pair of two boxes has to be this much less deep than the best face: faces give more points.
inline constexpr double edge_share = 0.98;

}  // namespace toccata
