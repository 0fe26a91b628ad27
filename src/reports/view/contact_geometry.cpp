#include "reports/view/contact_geometry.hpp"

#include <algorithm>

namespace toccata::io {
namespace {

/// A point, a segment, or a convex polygon: its area and its outline.
void add_intersection(ContactGeometry& found, const std::vector<Vec3>& points) {
  if (points.size() == 1) found.points.push_back(points[0]);
  for (std::size_t i = 0; i + 1 < points.size() || (i + 1 == points.size() && points.size() > 2); ++i) {
    found.segments.push_back(points[i]);
    found.segments.push_back(points[(i + 1) % points.size()]);
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    for (const std::size_t corner : {std::size_t{0}, i, i + 1}) found.triangles.push_back(points[corner]);
}

std::vector<Index> each_once(std::vector<Index> faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

ContactGeometry contact_geometry(const std::vector<ReportedFacePair>& pairs) {
  ContactGeometry found;
  for (const ReportedFacePair& faces : pairs)
    for (const ReportedIntersection& intersection : faces.intersections) add_intersection(found, intersection.points);
  return found;
}

std::vector<Index> intersecting_faces(const std::vector<ReportedFacePair>& pairs, Index ReportedFacePair::*side) {
  std::vector<Index> faces;
  for (const ReportedFacePair& found : pairs) faces.push_back(found.*side);
  return each_once(std::move(faces));
}

std::vector<Index> faces_intersecting(const std::vector<ReportedFacePair>& pairs) {
  std::vector<Index> faces;
  for (const ReportedFacePair& found : pairs) faces.insert(faces.end(), {found.face_a, found.face_b});
  return each_once(std::move(faces));
}

}  // namespace toccata::io
