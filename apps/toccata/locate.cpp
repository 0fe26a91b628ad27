#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "arguments.hpp"
#include "load.hpp"
#include "number_checks.hpp"
#include "option_kinds.hpp"
#include "output.hpp"
#include "subcommands.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/methods/msp_tree.hpp"
#include "toccata/query/nearest.hpp"
#include "words.hpp"

namespace toccata::command {
namespace {

using LocateJson = nlohmann::ordered_json;

struct LocateArguments {
  std::string file;
  std::vector<std::string> point_words;
  std::string points;  ///< a file
  std::string by = "mesh";
  BspOptions tree{};
  bool says_growth = false;
  Format format = Format::table;
};

/// What is known of a point; the last two only on the surface, where the way of asking tells them.
struct LocatedPoint : PointLocation {
  std::optional<Index> triangle{};
  std::optional<Feature> feature{};
};

/// One of the three ways to tell where points lie.
struct PointLocator {
  std::string words;  ///< what it is, for people
  LocateJson tree;    ///< its size; null of the mesh's own tree
  std::function<LocatedPoint(const Vec3&)> locate;
};

/// The one object of the file, a mesh.
const SceneObject& object_to_locate_in(const Scene& scene, const std::string& file) {
  if (scene.objects.size() != 1 || !scene.objects[0].mesh())
    throw Error(fmt::format(
        "{}: where points lie is told of one mesh, and here {}; name a file with one mesh", file,
        scene.objects.size() == 1 ? "is a shape that is none" : fmt::format("are {} objects", scene.objects.size())));
  return scene.objects[0];
}

PointLocator locator_of(const Model& model, const Pose& pose) {
  return {"its own tree", LocateJson(), [model, pose](const Vec3& point) {
            LocatedPoint found{locate(point, model, pose)};
            if (found.side == Side::boundary) found.triangle = nearest_point(point, model, {.pose = pose})->element;
            return found;
          }};
}

PointLocator locator_of(const BspTree& tree) {
  const BspStatistics& s = tree.statistics();
  return {fmt::format("a BSP tree of {}, {} across an axis, with {} ({:.2f} of each triangle), depth {} ({:.1f} on "
                      "average), {}",
                      counted(s.nodes, "plane"), grouped(s.axis_nodes), counted(s.fragments, "fragment"), s.growth(),
                      s.depth, s.mean_depth, counted(s.bytes, "byte")),
          {{"planes", s.nodes},
           {"axis_planes", s.axis_nodes},
           {"cells", s.leaves},
           {"fragments", s.fragments},
           {"growth", s.growth()},
           {"depth", s.depth},
           {"mean_depth", s.mean_depth},
           {"bytes", s.bytes}},
          [tree](const Vec3& point) {
            const BspLocation found = tree.locate(point);
            LocatedPoint told{found};
            if (found.side == Side::boundary) told.triangle = found.triangle;
            return told;
          }};
}

PointLocator locator_of(const MspTree& tree) {
  const MspStatistics& s = tree.statistics();
  return {fmt::format("an MSP tree of {}, {} and {}, with regions on {} of faces, {} of edges and {}, depth {}, {}",
                      counted(s.planes, "plane"), counted(s.lines, "line"), counted(s.points, "point"),
                      counted(s.faces, "part"), counted(s.edges, "part"), counted(s.vertices, "vertex", "vertices"),
                      s.depth, counted(s.bytes, "byte")),
          {{"planes", s.planes},
           {"lines", s.lines},
           {"points", s.points},
           {"regions_on_faces", s.faces},
           {"regions_on_edges", s.edges},
           {"regions_on_vertices", s.vertices},
           {"splits", s.splits},
           {"depth", s.depth},
           {"bytes", s.bytes}},
          [tree](const Vec3& point) {
            const MspLocation found = tree.locate(point);
            LocatedPoint told{found};
            if (found.side == Side::boundary) told.triangle = found.triangle, told.feature = found.feature;
            return told;
          }};
}

PointLocator locator_of(const Model& model, const Pose& pose, const LocateArguments& arguments) {
  if (arguments.by == "mesh") return locator_of(model, pose);
  // An open mesh is refused as such, wherever it stands.
  if (model.closed() && !(pose == Pose{}))
    throw Error("the tree is asked in the mesh's own coordinates, and this mesh is scaled or posed");
  if (arguments.by == "bsp") return locator_of(BspTree(model, arguments.tree));
  return locator_of(MspTree(model, arguments.tree));
}

/// With where it is, or what else answers.
Error refusal_of(const Error& error, const Model& model, const LocateArguments& arguments) {
  std::string hint;
  if (!model.closed())
    hint = with_name("; `{0} inspect FILE --faults` tells where all of it is");
  else if (arguments.by != "mesh")
    hint = "; --by mesh answers about this mesh";
  return Error(fmt::format("{}: {}{}", arguments.file, error.what(), hint));
}

std::string name_of_located(Side side) {
  return side == Side::inside ? "inside" : side == Side::boundary ? "boundary" : "outside";
}

std::string name_of_feature(FeatureKind kind) {
  return kind == FeatureKind::vertex ? "vertex" : kind == FeatureKind::edge ? "edge" : "face";
}

/// The ends of an edge, or the one vertex; of a face none.
std::vector<Index> vertices_of(const Feature& feature, const std::array<Index, 3>& triangle) {
  if (feature.kind == FeatureKind::face) return {};
  if (feature.kind == FeatureKind::vertex) return {triangle[feature.index]};
  return {triangle[feature.index], triangle[(feature.index + 1U) % 3]};
}

std::vector<std::string> row_of(const LocatedPoint& found, const TriangleMesh& mesh) {
  if (found.side != Side::boundary)
    return {name_of_located(found.side), found.side == Side::inside && found.winding_number != 1
                                             ? fmt::format("wound around {} times", found.winding_number)
                                             : ""};
  std::string what;
  if (found.feature) {
    const std::vector<Index> vertices = vertices_of(*found.feature, mesh.triangles()[*found.triangle]);
    if (vertices.empty()) what = "within ";
    if (vertices.size() == 1) what = fmt::format("vertex {}, of ", vertices[0]);
    if (vertices.size() == 2) what = fmt::format("edge from vertex {} to {}, of ", vertices[0], vertices[1]);
  }
  return {"on it", fmt::format("{}triangle {}, face {}", what, *found.triangle, mesh.face_of(*found.triangle))};
}

LocateJson report_of(const LocatedPoint& found, const TriangleMesh& mesh) {
  LocateJson json = {{"side", name_of_located(found.side)}};
  if (found.side != Side::boundary) json["winding_number"] = found.winding_number;
  if (found.triangle) {
    json["triangle"] = *found.triangle;
    json["face"] = mesh.face_of(*found.triangle);
  }
  if (found.feature) {
    json["feature"] = name_of_feature(found.feature->kind);
    json["vertices"] = vertices_of(*found.feature, mesh.triangles()[*found.triangle]);
  }
  return json;
}

/// Before long work.
void require_growth(const LocateArguments& arguments) {
  if (arguments.says_growth && arguments.by == "mesh")
    throw Error("--max-growth is of BSP and MSP trees, and the mesh's own is asked: say --by bsp or --by msp as well");
}

std::vector<Vec3> points_to_locate(const LocateArguments& arguments) {
  if (!arguments.points.empty()) return read_points(arguments.points);
  if (!arguments.point_words.empty()) return {parse_point(arguments.point_words, "--point")};
  if (arguments.by == "mesh")
    throw Error(
        "no point is given: name one with --point X Y Z, or a file with --points; without, --by bsp and --by "
        "msp tell of the tree alone");
  return {};
}

/// In nanoseconds, by the clock on the wall.
double time_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count();
}

/// Everything that is told.
struct LocateAnswer {
  std::shared_ptr<const TriangleMesh> mesh;
  PointLocator locator{};
  std::vector<LocatedPoint> found{};
  double build_ns = 0;  ///< with the model
  double point_ns = 0;  ///< on average
};

LocateAnswer located(const SceneObject& object, const std::vector<Vec3>& points, const LocateArguments& arguments) {
  LocateAnswer answer{object.mesh()};
  std::optional<Model> model;
  answer.build_ns = time_of([&] { model.emplace(answer.mesh); });
  try {
    answer.build_ns += time_of([&] { answer.locator = locator_of(*model, object.pose, arguments); });
    const double asked_ns = time_of([&] {
      for (const Vec3& point : points) answer.found.push_back(answer.locator.locate(point));
    });
    if (!points.empty()) answer.point_ns = asked_ns / static_cast<double>(points.size());
  } catch (const Error& error) {
    throw refusal_of(error, *model, arguments);
  }
  return answer;
}

std::string time_words(double ns) {
  return ns < 1e9 ? fmt::format("{:.3g} ms", 1e-6 * ns) : fmt::format("{:.3g} s", 1e-9 * ns);
}

std::string text_of(const LocateAnswer& answer, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (const LocatedPoint& found : answer.found) {
    rows.push_back(row_of(found, *answer.mesh));
    rows.back().insert(rows.back().begin(), fmt::format("point {}", rows.size() - 1));
  }
  std::string text =
      fmt::format("{}: {}, by {}, made in {}", printable(name), counted(answer.mesh->triangle_count(), "triangle"),
                  answer.locator.words, time_words(answer.build_ns));
  if (!rows.empty()) text += fmt::format("; a point takes {:.3g} µs", 1e-3 * answer.point_ns);
  return text + "\n" + (rows.empty() ? "" : columns(rows, 2));
}

std::string json_of(const LocateAnswer& answer, const LocateArguments& arguments) {
  LocateJson json = {{"schema", "toccata/locate/1"}, {"version", version},
                     {"file", arguments.file},       {"triangles", answer.mesh->triangle_count()},
                     {"by", arguments.by},           {"tree", answer.locator.tree},
                     {"build_ns", answer.build_ns},  {"point_ns", answer.point_ns},
                     {"points", LocateJson::array()}};
  for (const LocatedPoint& found : answer.found) json["points"].push_back(report_of(found, *answer.mesh));
  return json.dump(1, ' ', false, LocateJson::error_handler_t::replace) + "\n";
}

int run_locate(const LocateArguments& arguments) {
  require_growth(arguments);
  const std::vector<Vec3> points = points_to_locate(arguments);
  InputArguments input;
  input.files = {arguments.file};
  const LoadedScene loaded = load(input);
  print_warnings(loaded.warnings);
  const SceneObject& object = object_to_locate_in(loaded.scene, arguments.file);
  const LocateAnswer answer = located(object, points, arguments);
  print_answer(arguments.format == Format::json ? json_of(answer, arguments) : text_of(answer, object.name));
  return 0;
}

}  // namespace

Subcommand add_locate(CLI::App& app) {
  const auto arguments = std::make_shared<LocateArguments>();
  CLI::App* locate = app.add_subcommand("locate", "whether points are inside a closed mesh, outside or on it, exactly");
  locate->add_option("file", arguments->file, "a file with one closed mesh")->required();
  CLI::Option* point = add_point(*locate, "--point", arguments->point_words, "the point, in the world");
  add_file(*locate, "--points", arguments->points, "many points: a file with three numbers a line")->excludes(point);
  locate
      ->add_option(
          "--by", arguments->by,
          "mesh: the mesh's own tree, ready at once; bsp: a BSP tree, for very many points; msp: one that also "
          "tells the vertex, edge or face that a point lies on")
      ->check(CLI::IsMember({"mesh", "bsp", "msp"}))
      ->capture_default_str();
  locate
      ->add_option("--max-growth", arguments->tree.max_growth,
                   "a BSP or MSP tree is given up beyond so many fragments a triangle, 1 or more")
      ->type_name("NUMBER")
      ->check(number_from(1))
      ->capture_default_str();
  add_json(*locate, arguments->format, "write JSON (docs/reference/locate-report.md)");
  locate->footer(
      with_name("How far points are from a surface, closed or not, tells `{0} nearest`.\n\n"
                "Exit code: 0 answered, 2 trouble: no closed mesh, or for the trees one that intersects itself.\n\n"
                "Example:\n  {0} locate part.stl --point 0 0 5\n"
                "  {0} locate part.stl --points points.txt --by msp --json\n  {0} locate part.stl --by bsp"));
  return {locate, [arguments, locate] {
            arguments->says_growth = locate->count("--max-growth") > 0;
            return run_locate(*arguments);
          }};
}

}  // namespace toccata::command
