#include <string>
#include <vector>

#include "io/formats/file_error.hpp"
#include "io/formats/mesh_text.hpp"
#include "reports/view/display_mesh.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {

void write_parts(const DecomposeReport& report, const std::string& path) {
  const Scene scene = parts_scene(report, "");
  std::vector<TriangleMesh> meshes;
  meshes.reserve(scene.objects.size());  // they are pointed at
  std::vector<io::WrittenMesh> written;
  for (const SceneObject& part : scene.objects) {
    io::DisplayMesh shown = io::display_mesh(Model(part.shape));
    if (shown.triangles.empty()) continue;
    meshes.emplace_back(transform(part.pose, shown.vertices), std::move(shown.triangles));
    written.push_back({part.name, &meshes.back()});
  }
  if (written.empty())
    io::fail_in_file(path,
                     {"no part has a face that could be written", "leave it out, and read the parts with --json"});
  io::write_mesh_file(written, path);
}

}  // namespace toccata
