#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "check_input.hpp"
#include "look.hpp"
#include "output.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/io/glb_file.hpp"
#include "toccata/io/mesh_file.hpp"
#include "toccata/io/output_file.hpp"
#include "toccata/narrow/minkowski.hpp"
#include "toccata/query/scene_models.hpp"
#include "view.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using Json = nlohmann::ordered_json;

ConvexHull hull_of_vertices(const TriangleMesh& mesh) { return ConvexHull(mesh.vertices()); }

/// The hull that a mesh stands for.
ConvexHull hull_of(const SceneObject& object, const TriangleMesh& mesh, bool of_any) {
  if (of_any) return hull_of_vertices(mesh);
  try {
    return hull_of_convex_mesh(mesh);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}; --hull takes its convex hull", object.name, error.what()));
  }
}

/// Keeps the hull that a posed shape refers to.
class Operand {
 public:
  Operand(const SceneObject& object, bool hull_of_any) : posed_(posed(object, hull_of_any)) {}
  Operand(const Operand&) = delete;
  Operand& operator=(const Operand&) = delete;
  [[nodiscard]] const PosedConvex& convex() const { return posed_; }

 private:
  [[nodiscard]] PosedConvex posed(const SceneObject& object, bool hull_of_any) {
    if (const auto mesh = object.mesh()) {
      hull_ = hull_of(object, *mesh, hull_of_any);
      return PosedConvex(*hull_, object.pose);
    }
    return std::visit(
        [&](const auto& shape) -> PosedConvex {
          if constexpr (std::is_constructible_v<PosedConvex, decltype(shape), const Pose&>)
            return PosedConvex(shape, object.pose);
          else
            throw Error(fmt::format("{}: a {} has no sum here; give bounded convex shapes, or a mesh", object.name,
                                    name_of(object.shape)));
        },
        object.shape);
  }

  std::optional<ConvexHull> hull_;
  PosedConvex posed_;
};

const char* name_of_kind(SumFaceKind kind) {
  constexpr const char* names[] = {"of a", "of b", "of both", "of edges"};
  return names[static_cast<std::size_t>(kind)];
}

const char* name_of_side(Sign side) {
  return side == Sign::negative ? "inside" : side == Sign::zero ? "boundary" : "outside";
}

Json numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }

Json json_of(const MinkowskiArguments& arguments, const Scene& scene, const MinkowskiSum& sum) {
  Json json = {{"schema", "toccata/minkowski/1"},
               {"version", version},
               {"operation", arguments.difference ? "difference" : "sum"},
               {"a", scene.objects[0].name},
               {"b", scene.objects[1].name},
               {"dimension", sum.dimension()},
               {"radius", sum.radius()},
               {"vertices", Json::array()},
               {"faces", Json::array()}};
  for (Index i = 0; i < sum.vertex_count(); ++i)
    json["vertices"].push_back(
        {{"on_a", sum.pair(i).on_a}, {"on_b", sum.pair(i).on_b}, {"position", numbers_of(sum.vertex(i))}});
  const HullTopology t = sum.topology();
  for (Index f = 0; sum.dimension() > 1 && f < t.face_count(); ++f)
    json["faces"].push_back({{"kind", name_of_kind(sum.face_kind(f))},
                             {"vertices", Json(std::vector<Index>(t.origin.begin() + t.face_start[f],
                                                                  t.origin.begin() + t.face_start[f + 1]))}});
  if (arguments.point)
    json["point"] = {{"position", numbers_of(*arguments.point)}, {"side", name_of_side(sum.side_of(*arguments.point))}};
  return json;
}

std::string result_name(const MinkowskiArguments& arguments) { return arguments.difference ? "A − B" : "A + B"; }

std::string table_of(const MinkowskiArguments& arguments, const Scene& scene, const MinkowskiSum& sum) {
  constexpr const char* solids[] = {"a point", "a segment", "a flat polygon", "a solid"};
  std::string text = fmt::format("{} of A = {} and B = {}: {} of {}", result_name(arguments),
                                 printable(scene.objects[0].name), printable(scene.objects[1].name),
                                 solids[sum.dimension()], counted(sum.vertex_count(), "vertex", "vertices"));
  if (sum.dimension() > 1) {
    std::array<std::size_t, 4> kinds{};
    for (Index f = 0; f < sum.topology().face_count(); ++f) ++kinds[static_cast<std::size_t>(sum.face_kind(f))];
    text += fmt::format(" and {}: {} of A, {} of B, {} of both, {} of edges",
                        counted(sum.topology().face_count(), "face"), kinds[0], kinds[1], kinds[2], kinds[3]);
  }
  if (sum.radius() > 0) text += fmt::format("; grown by {:.12g}", sum.radius());
  text += "\n";
  if (arguments.point) {
    const Sign side = sum.side_of(*arguments.point);
    text += fmt::format("{} {}\n", point_text(*arguments.point),
                        side == Sign::zero ? "lies on the boundary" : fmt::format("lies {}", name_of_side(side)));
  }
  return text;
}

bool is_glb(const std::string& file) { return file.ends_with(".glb"); }

ViewTarget page_target_of(const MinkowskiArguments& arguments) {
  if (arguments.png.empty() && !(arguments.size.empty() && arguments.look.empty()))
    throw Error("--size and --look are of a picture: say where it shall be written with --png FILE.png");
  ViewTarget target = target_of(arguments);
  if (!target.picture) return target;
  require_known_keys(arguments.look);
  target.picture->look = arguments.look;
  if (!arguments.size.empty()) set_size(*target.picture, arguments.size);
  return target;
}

void require_files(const MinkowskiArguments& arguments, const ViewTarget& page) {
  require_view(page, arguments);
  require_distinct({{"-o", arguments.mesh}, {"--html", arguments.html}, {"--png", arguments.png}},
                   arguments.input.files);
  if (is_glb(arguments.mesh)) require_output(arguments.mesh, OutputKind::glb);
}

SceneObject object_of(const MinkowskiArguments& arguments, const MinkowskiSum& sum) {
  SceneObject object{};
  object.name = result_name(arguments);
  object.shape = sum.as_shape();
  object.source = "computed";
  return object;
}

/// The result alone.
std::string glb_of(const MinkowskiArguments& arguments, const MinkowskiSum& sum, const std::string& unit) {
  Scene scene;
  scene.unit = unit;
  scene.objects.push_back(object_of(arguments, sum));
  const std::vector<Posed> models = scene_models(scene, 1);
  return scene_glb(scene, models, CheckReport{});
}

std::string write_files(const MinkowskiArguments& arguments, CheckInput input, const MinkowskiSum& sum,
                        const ViewTarget& page) {
  std::string told;
  const std::string what =
      fmt::format("{} with {}", result_name(arguments), counted(sum.topology().face_count(), "face"));
  if (draws_something(page)) {
    input.loaded.scene.objects.push_back(object_of(arguments, sum));
    input.models = scene_models(input.loaded.scene, 1);
    write_view(page, input, CheckReport{});
    if (!page.path.empty()) told += fmt::format("{}: {}; open it in a browser.\n", printable(page.path), what);
    if (page.picture) told += fmt::format("{}: a picture of {}.\n", printable(page.picture->path), what);
  }
  if (arguments.mesh.empty()) return told;
  const std::string glb = is_glb(arguments.mesh) ? glb_of(arguments, sum, input.loaded.scene.unit) : "";
  const UninterruptedWriting writing;
  if (is_glb(arguments.mesh))
    write_glb(glb, arguments.mesh);
  else
    write_mesh(sum.as_mesh(), arguments.mesh);
  return told + fmt::format("{}: {}.\n", printable(arguments.mesh), what);
}

}  // namespace

int run_minkowski(const MinkowskiArguments& arguments) {
  const ViewTarget page = page_target_of(arguments);
  require_files(arguments, page);
  CheckInput input = read_check_input(arguments);
  const Scene& scene = input.loaded.scene;
  if (scene.objects.size() != 2)
    throw Error(fmt::format("a sum is of two objects, A and B; here {} {}", scene.objects.size() == 1 ? "is" : "are",
                            scene.objects.size()));
  const Operand a(scene.objects[0], arguments.hull), b(scene.objects[1], arguments.hull);
  const MinkowskiSum sum =
      arguments.difference ? minkowski_difference(a.convex(), b.convex()) : minkowski_sum(a.convex(), b.convex());
  print_warnings(input.loaded.warnings);
  const std::string answer = arguments.format == Format::json ? json_of(arguments, scene, sum).dump(1) + "\n"
                                                              : table_of(arguments, scene, sum);
  const std::string told = write_files(arguments, std::move(input), sum, page);
  print_answer(answer + (arguments.format == Format::json ? "" : told));
  return arguments.point && !sum.contains(*arguments.point) ? 1 : 0;
}

}  // namespace toccata::command
