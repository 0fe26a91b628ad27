#include "io/view/contact_geometry.hpp"

#include <algorithm>

namespace toccata::io {
namespace {

/// A point, a segment, or a convex polygon: its area and its outline.
void add_meeting(ContactGeometry& found, const std::vector<Vec3>& points) {
  if (points.size() == 1) found.points.push_back(points[0]);
  for (std::size_t i = 0; i + 1 < points.size() || (i + 1 == points.size() && points.size() > 2); ++i) {
    found.segments.push_back(points[i]);
    found.segments.push_back(points[(i + 1) % points.size()]);
  }
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    for (const std::size_t corner : {std::size_t{0}, i, i + 1}) found.triangles.push_back(points[corner]);
}

}  // namespace

ContactGeometry contact_geometry(const ReportedPair& pair) {
  ContactGeometry found;
  for (const ReportedFacePair& faces : pair.face_pairs)
    for (const ReportedMeeting& meeting : faces.meetings) add_meeting(found, meeting.points);
  return found;
}

std::vector<Index> meeting_faces(const ReportedPair& pair, Index ReportedFacePair::*side) {
  std::vector<Index> faces;
  for (const ReportedFacePair& found : pair.face_pairs) faces.push_back(found.*side);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace toccata::io
