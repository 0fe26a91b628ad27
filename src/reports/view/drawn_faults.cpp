#include "reports/view/drawn_faults.hpp"

namespace toccata::io {
namespace {

constexpr std::size_t most_of_a_kind = 100;

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void join(InspectFinding& all, const MeshFault& fault) {
  append(all.fault->edges, fault.edges);
  append(all.fault->triangles, fault.triangles);
  append(all.fault->vertices, fault.vertices);
  ++all.groups;
}

/// Faults come kind by kind, the larger first.
void add_faults(std::vector<InspectFinding>& findings, Index object, const std::vector<MeshFault>& faults) {
  std::size_t of_kind = 0;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    of_kind = i > 0 && faults[i].kind == faults[i - 1].kind ? of_kind + 1 : 1;
    if (of_kind > most_of_a_kind + 1)
      join(findings.back(), faults[i]);
    else
      findings.push_back({object, faults[i]});
  }
}

}  // namespace

std::vector<InspectFinding> inspect_findings(const InspectReport& report) {
  std::vector<InspectFinding> findings;
  for (std::size_t i = 0; i < report.objects.size(); ++i) {
    const auto object = static_cast<Index>(i);
    findings.push_back({object});
    add_faults(findings, object, report.objects[i].faults);
  }
  return findings;
}

FaultGeometry geometry_of(const MeshFault& fault, const TriangleMesh& mesh, const Pose& pose) {
  FaultGeometry shown;
  const auto place = [&](Index vertex) { return transform(pose, mesh.vertices()[vertex]); };
  for (const auto& [from, to] : fault.edges) append(shown.segments, {place(from), place(to)});
  for (const Index triangle : fault.triangles) {
    const auto& corners = mesh.triangles()[triangle];
    const std::vector<Vec3> placed = {place(corners[0]), place(corners[1]), place(corners[2])};
    append(shown.segments, {placed[0], placed[1], placed[1], placed[2], placed[2], placed[0]});
    append(fault.kind == MeshFaultKind::duplicate_triangles ? shown.triangles : shown.points, placed);
  }
  for (const Index vertex : fault.vertices) shown.points.push_back(place(vertex));
  return shown;
}

}  // namespace toccata::io
