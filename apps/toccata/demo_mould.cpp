#include "demo_mould.hpp"

#include <algorithm>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::command {

Scene mould_scene(const std::string& file, double factor) {
  const Scene read = read_scene(file);
  if (read.objects.size() != 1 || !read.objects[0].mesh() || read.objects[0].mesh()->triangle_count() == 0)
    throw Error(file + " is not one mesh of triangles; name a file of one mesh, or a generated one");
  const TriangleMesh& mesh = *read.objects[0].mesh();
  const Aabb box = fit_aabb(mesh.vertices());
  const Vec3 size = box.upper - box.lower;
  MouldShape shape;
  shape.factor = factor;
  shape.about = box.lower + 0.5 * size;
  shape.margin = 0.1 * std::max({size.x, size.y, size.z});
  Scene scene = inside_negative_image(mesh, shape);
  scene.objects[0].source = file;
  return scene;
}

}  // namespace toccata::command
