// A case is read as it was written, and asked again it is answered with the same bits.
#include "toccata/reports/case_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/text_file.hpp"
#include "support/mesh_soups.hpp"
#include "support/relation_cases.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/scene_file.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {
namespace {

using test::message_of;
using test::TemporaryFolder;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Mostly plain, now and then of the ends of what doubles are.
double number(Random& random, bool extreme) {
  constexpr std::array<double, 8> ends = {-0.0, 5e-324, -2.2e-308, 0x1p-1022, 1e-200, 0.1, 1e150, 0x1.fffffffffffffp0};
  if (extreme && random.below(4) == 0) return ends[random.below(ends.size())];
  return random.between(-2, 2);
}

Vec3 vector(Random& random, bool extreme) {
  return {number(random, extreme), number(random, extreme), number(random, extreme)};
}

double length(Random& random) { return random.between(0.1, 1.5); }

std::vector<Vec3> points(Random& random, std::size_t count, bool extreme) {
  std::vector<Vec3> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(vector(random, extreme));
  return all;
}

std::shared_ptr<const TriangleMesh> mesh(Random& random, bool extreme) {
  switch (random.below(4)) {
    case 0:
      return std::make_shared<const TriangleMesh>(test::box_between({-1, -1, -1}, {1, 1, 1}));
    case 1:  // a face of two triangles, and coordinates that text could lose
      return std::make_shared<const TriangleMesh>(points(random, 5, extreme),
                                                  std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}},
                                                  std::vector<Index>{0, 0, 1});
    case 2:
      return std::make_shared<const TriangleMesh>(test::random_soup(random, 3, 1, 0));
    default:  // large enough to be written in base64
      return std::make_shared<const TriangleMesh>(test::sphere_mesh(1 + random.unit(), 3));
  }
}

Shape shape(Random& random, bool extreme, int depth = 0) {
  const Vec3 p = vector(random, extreme), q = vector(random, extreme), r = vector(random, extreme);
  switch (random.below(depth < 2 ? 15 : 14)) {
    case 0:
      return Point(p);
    case 1:
      return Segment(p, q);
    case 2:
      return Triangle{{p, q, r}};
    case 3:
      return HalfSpace(p, {q.x, q.y, 1 + q.z * q.z});
    case 4:
      return Sphere(length(random), p);
    case 5:
      return Box({length(random), length(random), length(random)}, vector(random, false));
    case 6:
      return Capsule(p, q, length(random));
    case 7:
      return ConvexHull(points(random, 4 + random.below(20), extreme));
    case 8:
      return random.below(2) == 0 ? Rounded(ConvexHull(points(random, 6, extreme)), length(random))
                                  : Rounded(Box({1, length(random), 2}), length(random));
    case 9: {
      std::vector<double> heights;
      for (int i = 0; i < 12; ++i) heights.push_back(number(random, extreme));
      return HeightField(4, 3, length(random), length(random), heights);
    }
    case 10:
      return mesh(random, extreme);
    case 11:
      return Cylinder(length(random), length(random));
    case 12:
      return Cone(length(random), length(random));
    case 13:
      return Ellipsoid({length(random), length(random), length(random)});
    default: {
      const std::vector<CompoundPart> parts = {{shape(random, extreme, depth + 1), Pose::translation(-0.0, 0.5, 0)},
                                               {mesh(random, extreme), {}}};
      return Compound(parts);
    }
  }
}

/// Turned, mirrored, flattened, or as it is; a −0 in it is kept.
Pose pose(Random& random, const Shape& of, bool extreme) {
  const bool may_deform = !keeps_its_form(of) || random.below(4) == 0;  // refused then, which is an answer too
  Pose placed{random.below(3) == 0 ? Mat3{} : test::random_rotation(random), vector(random, extreme)};
  if (!may_deform || random.below(2) == 0) return placed;
  std::array<double, 12> numbers = placed.numbers();
  const std::size_t row = random.below(3);
  const double factor = random.below(2) == 0 ? -1 : random.below(2) == 0 ? 0 : -0.0;
  for (std::size_t column = 0; column < 3; ++column) numbers[3 * row + column] *= factor;
  return Pose::from_numbers(numbers);
}

Scene scene(Random& random, std::size_t objects) {
  constexpr std::array<const char*, 5> units = {"m", "mm", "unit", "0.3 m", "in"};
  Scene made;
  made.unit = units[random.below(units.size())];
  const bool extreme = random.below(3) == 0;
  for (std::size_t i = 0; i < objects; ++i) {
    SceneObject object;
    object.name = i % 2 == 0 ? "größe " + std::to_string(i) : "</script> \"" + std::to_string(i);
    object.shape = i > 0 && random.below(3) == 0 ? made.objects[0].shape : shape(random, extreme);
    object.pose = pose(random, object.shape, extreme);
    object.solid = random.below(4) == 0 ? Solid::none : Solid::automatic;
    object.group = random.below(4) == 0 ? "g" : "";
    object.source = random.below(2) == 0 ? "somewhere/" + std::to_string(i) : "";
    if (random.below(2) == 0) object.node = static_cast<Index>(i);
    made.objects.push_back(std::move(object));
    made.nodes.push_back({"node " + std::to_string(random.below(3)), {}, pose(random, Point(), extreme)});
    if (i > 0 && random.below(3) > 0) made.nodes.back().parent = static_cast<Index>(random.below(i));
  }
  return made;
}

std::vector<PairQuery> queries(Random& random, const Scene& of) {
  std::vector<PairQuery> made;
  for (std::size_t i = random.below(60); i-- > 0;)  // more than 41 are in base64
    made.push_back({{test::random_rotation(random), vector(random, true)},
                    {Mat3{}, vector(random, false)},
                    of.objects[0].solid,
                    of.objects[1].solid});
  return made;
}

SceneQuestion question(Random& random, const Scene& of) {
  const bool yes = random.below(2) == 0;
  const double reach = random.below(3) == 0 ? std::numeric_limits<double>::infinity() : length(random);
  switch (random.below(14)) {
    case 0: {
      CheckQuestion check{yes ? Touching::ignore : Touching::count, random.below(2) == 0, random.below(2) == 0, {}, {}};
      if (!yes) check.clearance = reach;
      if (!yes && of.objects.size() > 2 && of.objects[0].group.empty())
        check.pair_clearances = {{2, 0, length(random)}};
      else if (random.below(2) == 0)
        check.rules = {{{{of.objects[0].name, "x*"}, {"*"}}}, {{{"a?\\*"}, {of.objects[1].name}}}};
      if (random.below(2) == 0) check.order = PairOrder::severity;
      if (random.below(2) == 0) {
        const FormerPair was{of.objects[0].name, of.objects[1].name, RelationKind::touching, Containment::b_in_a};
        check.baseline = Baseline{"old.json", {was, {"gone", "too", RelationKind::apart, Containment::none}}, {}};
        check.baseline->objects = {{of.objects[1].name, of.objects[1].pose, std::nullopt},
                                   {of.objects[0].name, of.objects[0].pose, Aabb{{-1, 0, 0.25}, vector(random, true)}}};
      }
      return check;
    }
    case 1:
      return CheckPosesQuestion{queries(random, of), yes ? Touching::ignore : Touching::count, random.below(2) == 0,
                                random.below(2) == 0};
    case 2:
      return SelfQuestion{yes};
    case 3:
      return DistanceQuestion{random.below(of.objects.size())};
    case 4:
      if (yes) {
        const Pose end{rotation_about({1, 2, 3}, 50), 2.0 * vector(random, false)};
        return SweepQuestion{.keys = {{0, Pose{}}, {1, end}}, .screw = random.below(2) == 0, .stop_before = 0.125};
      }
      return DistancePosesQuestion{queries(random, of)};
    case 5: {
      RayQuestion rays;
      for (int i = 0; i < 5; ++i)
        rays.rays.push_back({.origin = 3.0 * vector(random, false), .motion = vector(random, false) + Vec3{0, 0, 9}});
      return rays;
    }
    case 6: {
      const Vec3 lower = vector(random, false);
      if (yes) return FacesQuestion{Ball{lower, length(random)}};
      return FacesQuestion{Aabb{lower, lower + Vec3{length(random), 0, length(random)}}};
    }
    case 8:
      if (of.objects.size() == 2) return MinkowskiQuestion{yes, true, vector(random, true)};
      return HierarchyQuestion{};
    case 9:
      return CrowdQuestion{"static",
                           40,
                           3,
                           {BroadPhaseMethod::brute_force, BroadPhaseMethod::automatic},
                           random.bits(),
                           1,
                           yes ? CrowdBounds::balls : CrowdBounds::oriented};
    case 10:
      return CrowdWorldQuestion{30,
                                3,
                                yes ? BroadPhaseMethod::uniform_grid : BroadPhaseMethod::automatic,
                                random.bits(),
                                1,
                                yes ? "terrain" : "stacks"};
    case 7:
      return InspectQuestion{false, random.below(4) == 0, yes};
    case 11: {
      SubdivideQuestion subdivide;
      subdivide.scheme = yes ? SubdivisionScheme::loop : SubdivisionScheme::catmull_clark;
      subdivide.within = 0.25 * length(random);
      subdivide.max_triangles = 4096;
      if (yes) subdivide.crease_angle = random.between(0, 90);
      return subdivide;
    }
    case 12: {
      WalkQuestion walk;
      walk.from = vector(random, false);
      walk.motions = points(random, 3, false);
      return walk;
    }
    default:
      return NearestQuestion{points(random, 4, true), 1 + random.below(3), reach, yes};
  }
}

/// A surface that is subdivided has to be a mesh, and alone.
void make_cage_of(Scene& scene, Random& random) {
  scene.objects.resize(1);
  scene.objects[0].shape = std::make_shared<const TriangleMesh>(test::sphere_mesh(1 + random.unit(), 2));
  scene.objects[0].pose = Pose{test::random_rotation(random), vector(random, false)};
}

/// Its answer tells times.
bool is_measured(const SceneQuestion& question) {
  const auto* inspect = std::get_if<InspectQuestion>(&question);
  return is_of_crowd(question) || (inspect != nullptr && inspect->partitions);
}

TEST(CaseFile, EveryQuestionAboutEveryShapeHasTheSameAnswerToTheBit) {
  const TemporaryFolder folder;
  std::array<int, std::variant_size_v<SceneQuestion>> answered{};
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Case made{scene(random, 2 + random.below(3)), {}, {}};
    made.question = question(random, made.scene);
    if (std::holds_alternative<SubdivideQuestion>(*made.question)) make_cage_of(made.scene, random);
    made.answer = replay(made).answer;
    if (!made.answer.starts_with("{\"error\"")) ++answered[made.question->index()];
    write_case(made, folder / "case.json");
    const Case read = read_case(folder / "case.json");
    EXPECT_EQ(read.scene.unit, made.scene.unit);
    EXPECT_EQ(read.question->index(), made.question->index());
    EXPECT_EQ(replay(read).difference, "");
    if (!is_measured(*made.question)) {
      EXPECT_EQ(replay(read).answer, made.answer);
    }
    write_case({read.scene, read.question, made.answer}, folder / "again.json");
    EXPECT_EQ(text_of(folder / "again.json"), text_of(folder / "case.json"));
  }
  for (std::size_t i = 0; i < answered.size(); ++i)
    if (i != SceneQuestion(CostQuestion{}).index() && i != SceneQuestion(DecomposeQuestion{}).index()) {
      EXPECT_GE(answered[i], 1) << "question " << i;
    }
}

/// Counts are compared, in an order of their own; times and what follows from them are not.
TEST(CaseFile, CostsAreComparedWithoutTheirTimes) {
  const TemporaryFolder folder;
  const Model ball(std::make_shared<const TriangleMesh>(generate_mesh("icosphere")));
  const std::vector<SceneInstance> models = {{ball}, {ball, Pose::translation(1.5, 0, 0)}};
  CostQuestion question{{{{}, Pose::translation(1.5, 0, 0)}, {{}, Pose::translation(1.25, 0.5, -0.0)}}, {}};
  question.options.volumes = {cost_volume<Obb>, cost_volume<Ball>, CostVolume::wide};
  question.options.arities = {2, 4};
  question.options.methods = {BvhMethod::median, BvhMethod::heuristic};
  question.options.workloads = {CostWorkload::rigid};
  question.options.task = CostTask::contacts;
  question.options.most_rigid = 2;
  Case made{scene_of(models), question, {}};
  made.answer = replay(made).answer;
  write_case(made, folder / "case.json");
  const Case read = read_case(folder / "case.json");
  EXPECT_EQ(replay(read).difference, "");
  const CostOptions& options = std::get<CostQuestion>(*read.question).options;
  EXPECT_EQ(options.arities, question.options.arities);
  EXPECT_EQ(options.methods, question.options.methods);
  EXPECT_EQ(options.volumes, question.options.volumes);
  EXPECT_EQ(options.most_work, question.options.most_work);
  auto answer = nlohmann::ordered_json::parse(made.answer);
  std::reverse(answer["rows"].begin(), answer["rows"].end());
  answer["rows"][0]["F_ns"] = 0;
  EXPECT_EQ(answer_difference(made.answer, answer.dump()), "");
  answer["rows"][0]["N_bv"] = 0;
  EXPECT_NE(answer_difference(made.answer, answer.dump()).find("/N_bv: recorded "), std::string::npos);
}

bool same_bits(double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); }

TEST(CaseFile, MeshesKeepEveryBitAndFaceAndAreWrittenOnce) {
  const TemporaryFolder folder;
  for (const std::size_t count : {4UL, 4000UL}) {  // as text, and in base64
    Random random(count);
    std::vector<Vec3> vertices = points(random, count, true);
    std::vector<std::array<Index, 3>> triangles;
    std::vector<Index> faces;
    for (Index i = 0; i + 2 < count; ++i) {
      triangles.push_back({i, i + 1, i + 2});
      faces.push_back(i / 2);
    }
    const auto shared = std::make_shared<const TriangleMesh>(vertices, triangles, faces);
    const Model model(shared);
    write_case({scene_of(std::vector<SceneInstance>{{model}, {model, Pose::translation(1, 0, 0)}}), {}, {}},
               folder / "case.json");
    const Case read = read_case(folder / "case.json");
    ASSERT_EQ(read.scene.objects.size(), 2U);
    EXPECT_EQ(read.scene.objects[0].name, "a");
    const TriangleMesh& mesh = *read.scene.objects[0].mesh();
    EXPECT_EQ(&mesh, read.scene.objects[1].mesh().get());
    ASSERT_EQ(mesh.vertices().size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(same_bits(mesh.vertices()[i][axis], vertices[i][axis])) << i;
    EXPECT_TRUE(std::equal(triangles.begin(), triangles.end(), mesh.triangles().begin(), mesh.triangles().end()));
    for (Index i = 0; i < mesh.triangle_count(); ++i) EXPECT_EQ(mesh.face_of(i), faces[i]);
  }
}

TEST(CaseFile, AnErrorIsAnAnswerToo) {
  Case made{scene_of(std::vector<SceneInstance>{
                {Model(Sphere(1)), Pose::from_numbers({2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})}, {Model(Sphere(1))}}),
            DistanceQuestion{},
            {}};
  made.answer = replay(made).answer;
  EXPECT_NE(made.answer.find("\"error\""), std::string::npos) << made.answer;
  EXPECT_EQ(replay(made).difference, "");
}

TEST(CaseFile, TellsWhereAnotherAnswerDiffers) {
  Case made{scene_of(std::vector<SceneInstance>{{Model(Point())}, {Model(Point()), Pose::translation(1, 0, 0)}}),
            DistanceQuestion{},
            {}};
  made.answer = replay(made).answer;
  const std::string right = "\"upper\":1.0";
  made.answer.replace(made.answer.find(right), right.size(), "\"upper\":1.5");
  EXPECT_TRUE(replay(made).difference.starts_with("/pairs/0/upper: recorded 1.5")) << replay(made).difference;
  EXPECT_EQ(answer_difference(R"({"a": 0.0})", R"({"a": -0.0})"), "/a: recorded 0.0, now -0.0");
  EXPECT_EQ(answer_difference(R"({"a": [1]})", R"({"a": [1, 2]})"), "/a: recorded 1 entries, now 2");
  EXPECT_EQ(answer_difference(R"({"a": 1})", R"({"b": 1})"), "/a: recorded 1, now nothing");
  EXPECT_EQ(answer_difference(R"({"version": "1", "warnings": ["x"]})", R"({"version": "2", "warnings": []})"), "");
}

TEST(CaseFile, WhatIsInItsPlaceIsOnlyReplacedWhenItIsAScene) {
  const TemporaryFolder folder;
  const Case plain{scene_of(std::vector<SceneInstance>{{Model(Sphere(1))}}), {}, {}};
  folder.write("mesh.obj", "v 0 0 0\n");
  EXPECT_NE(message_of([&] { write_case(plain, folder / "mesh.obj"); }).find("is not a case of Toccata"),
            std::string::npos);
  EXPECT_EQ(text_of(folder / "mesh.obj"), "v 0 0 0\n");
  write_case(plain, folder / "case.json");
  write_case(plain, folder / "case.json");
  EXPECT_NE(message_of([&] { write_case(plain, folder / "no/case.json"); }).find("cannot be written"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              write_case({plain.scene, {}, "{"}, folder / "case.json");
            }).find("not JSON"),
            std::string::npos);
  EXPECT_EQ(read_case(folder / "case.json").scene.objects.size(), 1U);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 2);
}

/// What is wrong, and what the message must name.
struct Fault {
  const char* members;
  const char* part;
};

TEST(CaseFile, WhatIsWrongIsNamed) {
  const TemporaryFolder folder;
  const std::string object = R"("objects": [{"name": "a", "mesh": "m"}])";
  const std::vector<Fault> faults = {
      {R"("meshes": {"m": {"vertices": [[0, 0, 0], [1, 0]], "triangles": [[0, 0, 0]]}}, )", "/meshes/m/vertices/1"},
      {R"("meshes": {"m": {"vertices": [[0, 0, 0]], "triangles": [[0, 0, 1]]}}, )", "/meshes/m"},
      {R"("meshes": {"m": {"vertices": [[0, 0, 0]], "triangles": [[0, 0, 4294967296]]}}, )", "/meshes/m/triangles/0/2"},
      {R"("meshes": {"m": {"vertices": [[0, 0, 0]], "triangles": [[0, 0, -1]]}}, )", "/meshes/m/triangles/0/2"},
      {R"("meshes": {"m": {"vertices": [[0, 0, 0]], "triangles": []}}, )", "/meshes/m"},
      {R"("meshes": {"m": {"vertices": [[0, 0, 0]], "triangles": [[0, 0, 0]], "faces": [0, 0]}}, )", "/meshes/m"},
      {R"("meshes": {"m": {"vertices": "AAAA", "triangles": [[0, 0, 0]]}}, )", "/meshes/m/vertices: the text holds 3"},
      {R"("meshes": {"m": {"vertices": "A A", "triangles": [[0, 0, 0]]}}, )", "not base64"},
      {R"("meshes": {"m": {"vertices": "AAAAAAAA+H8AAAAAAAAAAAAAAAAAAAAA", "triangles": [[0, 0, 0]]}}, )",
       "vertex 0 has a number that is not finite"},
      {R"("meshes": {"m": {"vertices": [[0, 0, null]], "triangles": [[0, 0, 0]]}}, )", "/meshes/m/vertices/0/2"},
      {R"("meshes": {"m": {"triangles": [[0, 0, 0]]}}, )", "\"vertices\" is missing"},
      {R"("meshes": {"m": {"vertices": [], "triangles": [], "normals": []}}, )", "\"normals\""},
      {R"("meshes": {"n": {}}, )", "there is no mesh named \"m\""},
      {R"("meshes": [], )", "/meshes: this is not an object"},
      {"", "there is no mesh named"}};
  for (const Fault& fault : faults) {
    const auto file = folder.write(
        "case.json", R"({"format": "toccata-scene", "version": 1, )" + std::string(fault.members) + object + "}");
    const std::string message = message_of([&] { (void)read_case(file); });
    EXPECT_NE(message.find(fault.part), std::string::npos) << fault.members << "\n" << message;
    EXPECT_NE(message.find("case.json"), std::string::npos) << message;
  }
}

TEST(CaseFile, AWrongQuestionIsNamed) {
  const TemporaryFolder folder;
  const std::string ball = R"("objects": [{"name": "a", "shape": {"type": "sphere", "radius": 1}}], )";
  const std::vector<Fault> faults = {
      {R"("query": {"question": "distanse"})", "did you mean distance?"},
      {R"("query": {})", "\"question\" is missing"},
      {R"("query": {"question": "distance", "first_objects": -1})", "/query/first_objects"},
      {R"("query": {"question": "distance", "first_objects": 1e300})", "/query/first_objects"},
      {R"("query": {"question": "distance", "frist_objects": 1})", "did you mean"},
      {R"("query": {"question": "check", "touching": "maybe"})", "/query/touching"},
      {R"("query": {"question": "check", "clearance": -1})", "/query/clearance"},
      {R"("query": {"question": "check", "faces": 1})", "/query/faces"},
      {R"("query": {"question": "ray", "rays": [[0, 0, 0, 1, 0]]})", "/query/rays/0"},
      {R"("query": {"question": "ray", "rays": "AAAAAAAA8D8="})", "a ray is 48"},
      {R"("query": {"question": "check-poses", "poses": [[1]]})", "/query/poses/0"},
      {R"("query": {"question": "faces"})", "a region is a box or a ball"},
      {R"("query": {"question": "nearest", "points": [[0, 0, 0]], "k": 0})", "/query/k"},
      {R"("answer": {})", "answers no \"query\""}};
  for (const Fault& fault : faults) {
    const auto file = folder.write(
        "case.json", R"({"format": "toccata-scene", "version": 1, )" + ball + std::string(fault.members) + "}");
    const std::string message = message_of([&] { (void)read_case(file); });
    EXPECT_NE(message.find(fault.part), std::string::npos) << fault.members << "\n" << message;
  }
  const auto newer = folder.write("newer.json", R"({"format": "toccata-scene", "version": 2, "objects": []})");
  EXPECT_NE(message_of([&] { (void)read_case(newer); }).find("this version is not known"), std::string::npos);
}

/// However a file is cut short, that is told; nothing is read of it.
TEST(CaseFile, CutShortItIsRefused) {
  const TemporaryFolder folder;
  Case made{scene_of(std::vector<SceneInstance>{
                {Model(Sphere(1))}, {Model(std::make_shared<const TriangleMesh>(test::sphere_mesh(1, 3)))}}),
            DistanceQuestion{},
            {}};
  made.answer = replay(made).answer;
  write_case(made, folder / "case.json");
  const std::string text = text_of(folder / "case.json");
  for (std::size_t length = 1; length + 2 < text.size(); length += 997) {
    const auto file = folder.write("cut.json", text.substr(0, length));
    EXPECT_NE(message_of([&] { (void)read_case(file); }).find("not valid JSON"), std::string::npos) << length;
  }
}

/// What walks a document would need as much of the stack.
TEST(CaseFile, NestedTooDeepItIsRefused) {
  const TemporaryFolder folder;
  const auto message_for = [&](const std::string& answer) {
    const auto file = folder.write("case.json", R"({"format": "toccata-scene", "version": 1, "objects": [
      {"name": "a", "shape": {"type": "sphere", "radius": 1}}],
      "query": {"question": "distance"}, "answer": )" +
                                                    answer + "}");
    return message_of([&] { (void)read_case(file); });
  };
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  const std::string deep = "case.json:3: arrays and objects are nested more than 1000 deep";
  EXPECT_EQ(message_for(nested(999)), "");
  EXPECT_NE(message_for(nested(1000)).find(deep), std::string::npos) << message_for(nested(1000));
  EXPECT_NE(message_for(nested(100'000)).find(deep), std::string::npos);
  EXPECT_NE(message_for(std::string(100'000, '[')).find(deep), std::string::npos);
  EXPECT_EQ(message_for("\"\\\"" + std::string(2000, '{') + "\\\\\""), "");  // within a text
}

TEST(CaseFile, APlainSceneHoldsNoQuestion) {
  const Case plain{scene_of(std::vector<SceneInstance>{{Model(Sphere(1))}}), {}, {}};
  EXPECT_NE(message_of([&] { (void)replay(plain); }).find("holds no question"), std::string::npos);
}

}  // namespace
}  // namespace toccata
