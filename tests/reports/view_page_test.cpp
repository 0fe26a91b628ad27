// The page that shows a scene: what it holds, and that nothing in it can be taken for markup.
#include "toccata/reports/pages.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/data.hpp"
#include "support/page.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/io/model_file.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/pairs.hpp"

namespace toccata {
namespace {

using Json = nlohmann::json;

using test::Page;

Page page_of(const Scene& scene, const CheckOptions& asked = {}, const ViewOptions& options = {}) {
  const std::vector<SceneInstance> models = scene_models(scene);
  const CheckAnswer answer = check_all(models, asked);
  const CheckReport report =
      make_check_report(models, answer, {Touching::count, asked.contacts, asked.penetration, asked.clearance, {}});
  return Page(view_page(scene, models, report, options));
}

CheckOptions contacts_and_penetration() {
  CheckOptions options;
  options.contacts = true;
  options.penetration = true;
  return options;
}

/// A vertex of a drawn mesh in the world.
Vec3 shown_vertex(const Page& page, std::size_t object, std::size_t vertex) {
  const Json& drawn = page.header["objects"][object];
  const Json& place = page.header["meshes"][drawn["mesh"].get<std::size_t>()]["vertices"];
  Vec3 at;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t number = 3 * vertex + static_cast<std::size_t>(axis);
    const double stored = place["bytes"] == 4 ? static_cast<double>(page.numbers<float>(place)[number])
                                              : static_cast<double>(page.numbers<std::uint16_t>(place)[number]);
    const double step = place["step"][static_cast<std::size_t>(axis)].get<double>();
    const double lower = place["lower"][static_cast<std::size_t>(axis)].get<double>();
    const double half = stored / 2 * step;
    at[axis] = std::isfinite(stored * step) ? lower + stored * step : lower + half + half;
  }
  const auto pose_of = [](const Json& numbers) { return Pose::from_numbers(numbers.get<std::array<double, 12>>()); };
  if (drawn.contains("fit")) at = transform(pose_of(drawn["fit"]), at);
  return transform(pose_of(page.report["objects"][object]["pose"]), at);
}

double largest_difference(const Vec3& a, const Vec3& b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST(ViewPage, HoldsTheReportAndTheMeshes) {
  const Scene scene = gear_train();
  const Page page = page_of(scene, contacts_and_penetration());
  EXPECT_EQ(page.header["format"], "toccata/view/4");
  EXPECT_EQ(page.report["schema"], "toccata/check/2");
  EXPECT_EQ(page.report["pairs"].size(), page.header["words"].size());
  ASSERT_EQ(page.header["objects"].size(), scene.objects.size());
  for (std::size_t object = 0; object < scene.objects.size(); ++object) {
    const TriangleMesh& mesh = *scene.objects[object].mesh();
    const Json& drawn = page.header["meshes"][page.header["objects"][object]["mesh"].get<std::size_t>()];
    EXPECT_EQ(drawn["triangles"]["count"], 3 * mesh.triangle_count());
    const Vec3 exact = transform(scene.objects[object].pose, mesh.vertices()[7]);
    EXPECT_LT(largest_difference(shown_vertex(page, object, 7), exact), 1e-5);
  }
}

TEST(ViewPage, ShowsWhereFacesIntersect) {
  const Page page = page_of(gear_train(), contacts_and_penetration());
  ASSERT_EQ(page.report["pairs"].size(), 1U);
  const Json& pair = page.report["pairs"][0];
  std::size_t curves = 0, faces = 0;
  for (const Json& layer : page.header["layers"]) {
    EXPECT_EQ(layer["finding"], 0);
    if (layer["kind"] == "faces") {
      ++faces;
      EXPECT_FALSE(page.numbers<std::uint32_t>(layer["data"]).empty());
      EXPECT_TRUE(layer["object"] == pair["a_index"] || layer["object"] == pair["b_index"]);
    }
    if (layer["kind"] == "segments" && layer["role"] == "contact") {
      ++curves;
      for (const float x : page.numbers<float>(layer["data"])) EXPECT_LE(std::abs(x), 1.0F);
    }
  }
  EXPECT_EQ(faces, 2U);
  EXPECT_EQ(curves, 1U);
  EXPECT_GT(page.header["words"][0]["face_pairs"], 0);
}

TEST(ViewPage, ObjectsThatShareAMeshShareItsDrawing) {
  const Scene scene = many_parts(500, 3);
  const Page page = page_of(scene);
  EXPECT_EQ(page.header["objects"].size(), 500U);
  EXPECT_LT(page.header["meshes"].size(), 20U);
}

TEST(ViewPage, NamesAreNoMarkup) {
  Scene scene = boxes_face_to_face();
  const std::string wicked = "</script><img src=x onerror=alert(1)><!-- <script>";
  scene.objects[0].name = wicked;
  scene.objects[1].name = "\xff";
  const Page page = page_of(scene, {}, {"<b>&</b>", UpAxis::y});
  EXPECT_EQ(page.report["objects"][0]["name"], wicked);
  EXPECT_EQ(page.report["objects"][1]["name"], "\\xff");
  EXPECT_EQ(page.header["title"], "<b>&</b>");
  EXPECT_EQ(page.header["up"], "y");
  EXPECT_EQ(page.html.find("<img"), std::string::npos);
  EXPECT_EQ(page.html.find("<b>&"), std::string::npos);
}

TEST(ViewPage, EveryShapeIsDrawn) {
  Scene scene;
  const auto add = [&](const std::string& name, const Shape& shape, const Pose& pose = {}) {
    scene.objects.push_back({name, shape, pose, Solid::automatic, "", {}, ""});
  };
  add("point", Point{{1, 2, 3}});
  add("segment", Segment{{0, 0, 0}, {1, 0, 0}});
  add("triangle", Triangle{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  add("floor", HalfSpace({0, 0, -1}, {0, 0, 3}));
  add("ball", Sphere(2, {1, 0, 0}), Pose::translation(5, 0, 0));
  add("ball again", Sphere(0.5));
  add("box", Box({1, 2, 3}, {1, 1, 1}));
  add("capsule", Capsule({0, 0, 0}, {0, 0, 2}, 0.5));
  add("hull", ConvexHull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  add("flat", ConvexHull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  add("rounded", Rounded(Box({1, 1, 1}), 0.25));
  const std::vector<CompoundPart> parts{{Box({1, 1, 1}), Pose{}}, {Sphere(1), Pose::translation(3, 0, 0)}};
  add("compound", Compound(parts));
  const Page page = page_of(scene, contacts_and_penetration());
  for (const Json& layer : page.header["layers"])  // of shapes, the compound alone has several faces
    EXPECT_TRUE(layer["kind"] != "faces" || layer["object"] == 11);
  const std::vector<std::size_t> triangles{0, 0, 1, 2, 0, 0, 12, 0, 4, 2, 0, 0};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Json& mesh = page.header["meshes"][page.header["objects"][i]["mesh"].get<std::size_t>()];
    const std::size_t drawn = mesh["triangles"]["count"].get<std::size_t>() / 3;
    if (triangles[i] > 0 || i < 2)
      EXPECT_EQ(drawn, triangles[i]) << scene.objects[i].name;
    else
      EXPECT_GT(drawn, 100U) << scene.objects[i].name;
  }
  EXPECT_EQ(page.header["objects"][4]["mesh"], page.header["objects"][5]["mesh"]);
  EXPECT_LT(
      std::abs(std::hypot(shown_vertex(page, 4, 9).x - 6, shown_vertex(page, 4, 9).y, shown_vertex(page, 4, 9).z) - 2),
      1e-6);
}

TEST(ViewPage, LengthsHaveSegmentsAndNumbers) {
  Scene scene;
  scene.unit = "mm";
  scene.objects.push_back({"a", Sphere(1), {}, Solid::automatic, "", {}, ""});
  scene.objects.push_back({"b", Sphere(1), Pose::translation(1.5, 0, 0), Solid::automatic, "", {}, ""});
  scene.objects.push_back({"c", Sphere(1), Pose::translation(0, 0, 5), Solid::automatic, "", {}, ""});
  CheckOptions options = contacts_and_penetration();
  options.clearance = 3.1;
  const Page page = page_of(scene, options);
  std::vector<std::string> labels;
  for (const Json& layer : page.header["layers"])
    if (layer.contains("length"))
      labels.push_back(layer["role"].get<std::string>() + " " + Json(layer["length"].get<float>()).dump());
  EXPECT_EQ(labels, (std::vector<std::string>{"depth 0.5", "distance 3.0"}));
  const Json& depth = page.report["pairs"][0]["penetration"];
  for (const Json& layer : page.header["layers"])
    EXPECT_EQ(layer.value("lower_length", depth["lower"]), depth["lower"]);
  EXPECT_EQ(std::ranges::count_if(page.header["layers"], [](const Json& l) { return l.contains("lower_length"); }), 1);
  EXPECT_EQ(page.report["unit"], "mm");
}

TEST(ViewPage, TinyHugeAndEmptyScenesFitTheFloats) {
  for (const double scale : {1e-150, 1.0, 1e150}) {
    const Page page = page_of(boxes_sharing_half({scale, 0}), contacts_and_penetration());
    for (const Json& layer : page.header["layers"]) {
      if (layer["kind"] != "segments") continue;
      for (const float x : page.numbers<float>(layer["data"])) EXPECT_LE(std::abs(x), 1.0F) << scale;
    }
  }
  EXPECT_TRUE(page_of(Scene{}).header["objects"].empty());
}

TEST(ViewPage, MeshesNearTheEndsOfTheDoublesAreDrawn) {
  for (const double size : {1.7e308, 1e-310, 5e-324}) {
    Scene scene;
    const std::vector<Vec3> vertices{{size > 1 ? -size : 0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    scene.objects.push_back(
        {"wide",
         std::make_shared<const TriangleMesh>(
             vertices, std::vector<std::array<Index, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
         {},
         Solid::automatic,
         "",
         {},
         ""});
    const Page page = page_of(scene);
    const double shown = page.header["frame"]["size"].get<double>();
    EXPECT_GE(shown, size / 2);
    EXPECT_LE(shown, size);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 at = shown_vertex(page, 0, i);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_LE(std::abs(at[axis] / size - vertices[i][axis] / size), 1e-6) << size;
    }
  }
}

TEST(ViewPage, LengthsBeyondTheDoublesAreNull) {
  Scene scene;
  scene.objects.push_back({"a", Sphere(1.7e308), {}, Solid::automatic, "", {}, ""});
  scene.objects.push_back({"b", Sphere(1.7e308), Pose::translation(1, 0, 0), Solid::automatic, "", {}, ""});
  const Page page = page_of(scene, contacts_and_penetration());
  EXPECT_TRUE(page.report["pairs"][0]["penetration"]["upper"].is_null());
  std::size_t lengths = 0;
  for (const Json& layer : page.header["layers"]) {
    if (!layer.contains("length")) continue;
    ++lengths;
    EXPECT_TRUE(layer["length"].is_null());
    for (const float x : page.numbers<float>(layer["data"])) EXPECT_LE(std::abs(x), 1.0F);
  }
  EXPECT_EQ(lengths, 1U);
}

TEST(ViewPage, TellsHowEachThingWasFound) {
  CheckOptions options = contacts_and_penetration();
  options.clearance = 0;
  const Page page = page_of(boxes_sharing_half({1, 0}), options);
  const auto method = [&](const char* question) {
    return page.header["methods"][page.header["words"][0]["methods"][question].get<std::size_t>()];
  };
  EXPECT_EQ(method("relation"), pair_cells::by_tree.text);
  EXPECT_EQ(method("penetration"), pair_cells::by_inner_parts.text);
  EXPECT_EQ(method("distance"), pair_cells::nearest_by_tree.text);
}

TEST(ViewPage, HoldsTheTreeOfTheScene) {
  Scene scene = boxes_sharing_half({1, 0});
  scene.nodes = {{"arm", {}, {}}, {"hand", Index{0}, {}}};
  EXPECT_FALSE(page_of(boxes_sharing_half({1, 0})).header.contains("nodes"));
  scene.objects[1].node = 1;
  const Page page = page_of(scene);
  EXPECT_EQ(page.header["nodes"], Json::parse(R"([{"name":"arm"},{"name":"hand","parent":0}])"));
  EXPECT_FALSE(page.header["objects"][0].contains("node"));
  EXPECT_EQ(page.header["objects"][1]["node"], 1);
}

TEST(ViewPage, ManyRoundShapesAreDrawnCoarsely) {
  const auto triangles_of = [](std::size_t count) {
    Scene scene;
    for (std::size_t i = 0; i < count; ++i)
      scene.objects.push_back({std::to_string(i),
                               Sphere(1),
                               Pose::translation(static_cast<double>(3 * i), 0, 0),
                               Solid::automatic,
                               "",
                               {},
                               ""});
    const Page page = page_of(scene);
    EXPECT_EQ(page.header["meshes"].size(), 1U);
    return page.header["meshes"][0]["triangles"]["count"].get<std::size_t>() / 3;
  };
  EXPECT_GT(triangles_of(10), 400U);
  EXPECT_LT(triangles_of(3000), 60U);
}

/// Each step begins with the way between the nearest points of two features, ever shorter, to that of the answer.
TEST(ViewPage, DrawsTheWalkThroughVoronoiRegions) {
  Scene scene;
  scene.objects.push_back({"A", Box{{1, 1, 1}}, {}, Solid::automatic, "", {}, ""});
  scene.objects.push_back({"B", Box{{1, 1, 1}}, Pose::translation(3.5, 0.5, 0.25), Solid::automatic, "", {}, ""});
  ViewOptions options;
  options.voronoi = options.voronoi_walk = true;
  const Page page = page_of(scene, {}, options);
  ASSERT_EQ(page.header["layers"].size(), 3U);
  const Json& layer = page.header["layers"][2];
  EXPECT_EQ(layer["kind"], "segments");
  EXPECT_EQ(layer["name"], "A and B: Voronoi walk");
  const auto numbers = page.numbers<float>(layer["data"]);
  double before = 1e9;
  for (const Json& step : layer["steps"]) {
    const std::size_t at = 6 * step["first"].get<std::size_t>();
    const auto across = [&](std::size_t axis) { return numbers[at + 3 + axis] - numbers[at + axis]; };
    const double length = page.header["frame"]["size"].get<double>() *
                          std::sqrt(across(0) * across(0) + across(1) * across(1) + across(2) * across(2));
    EXPECT_LT(length, before);
    before = length;
  }
  EXPECT_GT(layer["steps"].size(), 2U);
  EXPECT_NEAR(before, 1.5, 1e-6);
  EXPECT_NE(layer["steps"].back()["note"].get<std::string>().find("1.5 apart: the nearest"), std::string::npos);

  scene.objects.pop_back();
  EXPECT_THROW(page_of(scene, {}, options), Error);
  scene.objects.push_back({"ball", Sphere(1), Pose::translation(3, 0, 0), Solid::automatic, "", {}, ""});
  EXPECT_THROW(page_of(scene, {}, options), Error);
}

/// The page's boxes are those of the partition, to within the rounding that the page tells.
TEST(ViewPage, DrawsTheCellsOfAPartition) {
  Scene scene;
  const auto mesh = std::make_shared<const TriangleMesh>(icosphere_mesh(1, 3));
  scene.objects.push_back({"ball", mesh, Pose::translation(9, 0, 0), Solid::automatic, "", {}, ""});
  const Page page = page_of(scene, {}, {"ball", UpAxis::z, {}, PartitionKind::octree});
  ASSERT_EQ(page.header["layers"].size(), 1U);
  const Json& layer = page.header["layers"][0];
  EXPECT_EQ(layer["kind"], "cells");
  EXPECT_EQ(layer["object"], 0);
  const auto numbers = page.numbers<std::uint16_t>(layer["data"]);
  const auto coordinate = [&](std::size_t box, std::size_t side, std::size_t axis) {
    const Json& place = layer["data"];
    return place["lower"][axis].get<double>() + place["step"][axis].get<double>() * numbers[7 * box + 3 * side + axis];
  };
  const std::vector<PartitionLevel> levels = partition_levels(PartitionKind::octree, PartitionItems(*mesh));
  ASSERT_EQ(layer["steps"].size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Json& step = layer["steps"][i];
    const std::vector<PartitionCell>& cells = levels[i].cells;
    ASSERT_EQ(step["count"], cells.size());
    EXPECT_EQ(step["note"].get<std::string>().find(std::to_string(cells.size()) + " cell"), 0U);
    for (std::size_t k = 0; k < cells.size(); ++k)
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t box = step["first"].get<std::size_t>() + k;
        EXPECT_NEAR(coordinate(box, 0, static_cast<std::size_t>(axis)), cells[k].box.lower[axis], 4e-5);
        EXPECT_NEAR(coordinate(box, 1, static_cast<std::size_t>(axis)), cells[k].box.upper[axis], 4e-5);
      }
  }
}

TEST(ViewPage, DrawsTheLevelsOfAHierarchy) {
  Scene scene;
  const auto mesh = std::make_shared<const TriangleMesh>(icosphere_mesh(1, 3));
  scene.objects.push_back({"ball", mesh, Pose::translation(9, 0, 0), Solid::automatic, "", {}, ""});
  const Page page = page_of(scene, {}, {"ball", UpAxis::z, cost_volume<Aabb>});
  ASSERT_EQ(page.header["layers"].size(), 1U);
  const Json& layer = page.header["layers"][0];
  EXPECT_EQ(layer["kind"], "hierarchy");
  EXPECT_EQ(layer["object"], 0);
  const auto order = page.numbers<std::uint32_t>(layer["order"]);
  const auto runs = page.numbers<std::uint32_t>(layer["data"]);
  const auto faces = page.numbers<float>(layer["faces"]);
  const auto edges = page.numbers<std::uint16_t>(layer["edges_of_face"]);
  const double size = layer["size"].get<double>();
  const Vec3 lower{layer["lower"][0].get<double>(), layer["lower"][1].get<double>(), layer["lower"][2].get<double>()};
  ASSERT_EQ(order.size(), mesh->triangle_count());
  EXPECT_GT(layer["steps"].size(), 9U);
  std::size_t nodes_before = 0;
  for (const Json& step : layer["steps"]) {
    const auto first = step["first"].get<std::size_t>(), count = step["count"].get<std::size_t>();
    EXPECT_GT(count, nodes_before);
    nodes_before = count;
    EXPECT_EQ(step["faces"][1], 12 * count);  // a box
    int sides = 0;                            // that are edges: each of the 12 of a box is a side of two triangles
    const auto first_face = step["faces"][0].get<std::ptrdiff_t>(), face_count = step["faces"][1].get<std::ptrdiff_t>();
    for (auto mask = edges.begin() + first_face; mask != edges.begin() + first_face + face_count; ++mask)
      sides += (*mask & 1) + (*mask >> 1 & 1) + (*mask >> 2 & 1);
    EXPECT_EQ(static_cast<std::size_t>(sides), 24 * count);
    std::vector<Aabb> boxes;
    std::size_t held = 0;
    for (std::size_t node = 0; node < count; ++node) {
      EXPECT_EQ(runs[2 * (first + node)], held);
      Aabb box;
      for (std::size_t i = held; i < held + runs[2 * (first + node) + 1]; ++i)
        for (const Index corner : mesh->triangles()[order[i]]) box = merge(box, mesh->vertices()[corner]);
      held += runs[2 * (first + node) + 1];
      Aabb shown;
      for (std::size_t i = 0; i < std::size_t{12} * 3; ++i) {
        const std::size_t at = 9 * (step["faces"][0].get<std::size_t>() + 12 * node) + 3 * i;
        shown = merge(shown, lower + size * Vec3{faces[at], faces[at + 1], faces[at + 2]});
      }
      EXPECT_LT(largest_difference(box.lower, shown.lower), 1e-6);
      EXPECT_LT(largest_difference(box.upper, shown.upper), 1e-6);
      boxes.push_back(box);
    }
    EXPECT_EQ(held, order.size());
    std::size_t overlapping = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) overlapping += overlap(boxes[i], boxes[j]) ? 1 : 0;
    EXPECT_EQ(step["overlapping_pairs"], overlapping);
    EXPECT_GT(step["fill"], 0);
    EXPECT_LE(step["fill"], 1);
  }
}

TEST(ViewPage, EveryVolumeIsDrawn) {
  Scene scene;
  const auto mesh = std::make_shared<const TriangleMesh>(icosphere_mesh(1, 1));
  scene.objects.push_back({"round", mesh, {}, Solid::automatic, "", {}, ""});
  scene.objects.push_back({"round again", mesh, Pose::translation(0, 0, 3), Solid::automatic, "", {}, ""});
  scene.objects.push_back({"ball", Sphere(1), {}, Solid::automatic, "", {}, ""});
  for (const CostVolume volume : all_cost_volumes) {
    const Page page = page_of(scene, {}, {"", UpAxis::z, volume});
    ASSERT_EQ(page.header["layers"].size(), 2U) << name_of(volume);
    EXPECT_EQ(page.header["layers"][0]["data"], page.header["layers"][1]["data"]);
    const Json& layer = page.header["layers"][0];
    for (const Json& step : layer["steps"])
      EXPECT_TRUE(layer.contains("rounds") || step["faces"][1] >= 2 * step["count"].get<std::size_t>())
          << name_of(volume);
  }
}

/// The numbers of a round volume, in the frame of its layer.
struct Round {
  std::array<Vec3, 6> part;  // centre, two of the core, three axes

  /// Below 1 within: how far from the nearest point of the core, in the axes.
  [[nodiscard]] double reach(const Vec3& point) const {
    Vec3 rest = point - part[0];
    for (std::size_t i = 1; i < 3; ++i) {
      const double length = dot(part[i], part[i]);
      if (length > 0) rest = rest - std::clamp(dot(rest, part[i]) / length, -1.0, 1.0) * part[i];
    }
    double sum = 0;
    for (std::size_t i = 3; i < 6; ++i) sum += std::pow(dot(rest, part[i]) / dot(part[i], part[i]), 2);
    return std::sqrt(sum);
  }

  /// The rounding of the floats in the shortest axis; flat volumes have a very short one.
  [[nodiscard]] double rounding() const {
    const double least = std::min({dot(part[3], part[3]), dot(part[4], part[4]), dot(part[5], part[5])});
    return 1e-6 / std::sqrt(least);
  }
};

TEST(ViewPage, RoundVolumesAreDrawnAsWhatTheyAre) {
  Scene scene;
  const auto mesh = std::make_shared<const TriangleMesh>(torus_mesh({}));
  scene.objects.push_back({"ring", mesh, {}, Solid::automatic, "", {}, ""});
  for (const CostVolume volume :
       {cost_volume<Ball>, cost_volume<Pss>, cost_volume<Lss>, cost_volume<Rss>, cost_volume<EllipsoidBound>}) {
    const Page page = page_of(scene, {}, {"", UpAxis::z, volume});
    const Json& layer = page.header["layers"][0];
    EXPECT_FALSE(layer.contains("faces"));
    const auto numbers = page.numbers<float>(layer["rounds"]);
    const auto runs = page.numbers<std::uint32_t>(layer["data"]);
    const auto order = page.numbers<std::uint32_t>(layer["order"]);
    const double size = layer["size"].get<double>();
    const Vec3 lower{layer["lower"][0].get<double>(), layer["lower"][1].get<double>(), layer["lower"][2].get<double>()};
    ASSERT_EQ(numbers.size(), 9 * runs.size());
    for (std::size_t node = 0; node < runs.size() / 2; ++node) {
      Round round;
      for (std::size_t i = 0; i < 18; ++i) round.part[i / 3][static_cast<int>(i % 3)] = numbers[18 * node + i];
      double farthest = 0;
      for (std::size_t i = runs[2 * node]; i < runs[2 * node] + runs[2 * node + 1]; ++i)
        for (const Index corner : mesh->triangles()[order[i]])
          farthest = std::max(farthest, round.reach((1 / size) * (mesh->vertices()[corner] - lower)));
      EXPECT_LT(farthest, 1 + round.rounding()) << name_of(volume) << " " << node;
      EXPECT_GT(farthest, 0.9 - round.rounding()) << name_of(volume) << " " << node;
    }
  }
}

TEST(ViewPage, WritesNothingOverWhatIsNoPage) {
  const test::TemporaryFolder folder;
  const std::filesystem::path notes = folder.write("notes.txt", "mine");
  EXPECT_THROW(write_view_page("<!doctype html>", notes), Error);
  std::ifstream stream(notes);
  std::stringstream kept;
  kept << stream.rdbuf();
  EXPECT_EQ(kept.str(), "mine");
  EXPECT_THROW(write_view_page("<!doctype html>", folder.path()), Error);
  EXPECT_THROW(write_view_page("<!doctype html>", folder.path() / "missing" / "page.html"), Error);
  EXPECT_THROW(write_view_page("<!doctype html>", folder.write("theirs.html", "<!doctype html>\n<p>")), Error);
  std::filesystem::remove(folder.path() / "theirs.html");
  const std::string page = page_of(Scene{}).html;
  write_view_page(page, folder.path() / "page.html");
  write_view_page(page, folder.path() / "page.html");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

/// With the faces that meet and how deep, as `check --html --penetration` writes it.
std::size_t bytes_of_crossing_page(const TriangleMesh& a, const TriangleMesh& b) {
  const Aabb box = fit_aabb(a.vertices());
  const Vec3 third = (1.0 / 3) * (box.upper - box.lower);
  Scene scene;
  const auto object = [](const char* name, const TriangleMesh& mesh, const Pose& pose) {
    SceneObject made;
    made.name = name;
    made.shape = std::make_shared<const TriangleMesh>(mesh);
    made.pose = pose;
    return made;
  };
  scene.objects = {object("a", a, {}), object("b", b, Pose::translation(third.x, third.y / 4, third.z / 4))};
  const std::vector<SceneInstance> models = scene_models(scene);
  const CheckAnswer answer = check_all(models, contacts_and_penetration());
  EXPECT_EQ(answer.pairs.size(), 1U);
  EXPECT_GT(answer.pairs.empty() ? 0 : answer.pairs[0].contacts.size(), 100U);
  return view_page(scene, models, make_check_report(models, answer, {.faces = true, .penetration = true}), {}).size();
}

TEST(ViewPage, OfTwoCrossingBunniesHasAtMostThreeMegabytes) {
  const auto data = test::data_folder();
  if (!data) GTEST_SKIP() << "set TOCCATA_DATA to the folder of real models";
  const TriangleMesh bunny = read_mesh(*data / "meshes/stanford-bunny.obj");
  std::vector<Vec3> larger;
  for (const Vec3& v : bunny.vertices()) larger.push_back(1.03125 * v);
  const TriangleMesh other(std::move(larger), {bunny.triangles().begin(), bunny.triangles().end()});
  for (const TriangleMesh* second : {&bunny, &other}) {
    const std::size_t bytes = bytes_of_crossing_page(bunny, *second);
    EXPECT_LE(bytes, 3'000'000U);
    EXPECT_GT(bytes, 1'000'000U) << "this is no page of two bunnies";
  }
}

}  // namespace
}  // namespace toccata
