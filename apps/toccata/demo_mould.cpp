#include "demo_mould.hpp"

#include <algorithm>
#include <cmath>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata::command {

namespace {

/// The faces of an open mesh, as many scans are, stand in the hole as surfaces; a closed one inside out would fill it.
void require_outside_out(const std::string& file, const TriangleMesh& mesh) {
  const MeshHealth health = inspect(mesh);
  if (health.closed && !(health.signed_volume > 0))
    throw Error(file + " is inside out or has no volume, so it leaves no hole in a wall; turn its faces over");
}

}  // namespace

Scene mould_scene(const std::string& file, double factor) {
  const Scene read = read_scene(file);
  if (read.objects.size() != 1 || !read.objects[0].mesh() || read.objects[0].mesh()->triangle_count() == 0)
    throw Error(file + " is not one mesh of triangles; name a file of one mesh, or a generated one");
  const TriangleMesh& mesh = *read.objects[0].mesh();
  const Aabb box = fit_aabb(mesh.vertices());
  const Vec3 size = box.upper - box.lower;
  const double largest = std::max({size.x, size.y, size.z});
  if (!(largest > 0) || !std::isfinite(largest))
    throw Error(file + " has no size, or one that no double holds; scale it");
  require_outside_out(file, mesh);
  MouldShape shape;
  shape.factor = factor;
  shape.about = box.lower + 0.5 * size;
  shape.margin = 0.1 * largest;
  Scene scene = inside_negative_image(mesh, shape);
  scene.objects[0].source = file;
  return scene;
}

}  // namespace toccata::command
