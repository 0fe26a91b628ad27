#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/mesh_soups.hpp"
#include "toccata/methods.hpp"
#include "toccata/reports.hpp"
#include "toccata/toccata.hpp"

namespace toccata {
namespace {

SceneInstance at(const Model& model, double x, double y, double z) { return {model, Pose::translation(x, y, z)}; }

/// A ground, shapes of all kinds over it, some of them in a group.
std::vector<SceneInstance> shelf() {
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1})), ball(icosphere_mesh(1, 2));
  const std::vector<CompoundPart> parts{{Sphere{0.5}, {}}, {Sphere{0.5}, Pose::translation(0, 0, 3)}};
  const Model pair{Compound(parts)};
  std::vector<SceneInstance> models{at(HalfSpace{{}, {0, 0, 1}}, 0, 0, 0),
                                    at(cube, 0, 0, 1.25),
                                    at(ball, 3, 0, 2),
                                    at(Sphere{1}, 3.5, 3, 1),
                                    at(pair, 0, 4, 1),
                                    at(cube, 0.5, 0.5, 1.5),
                                    at(Point{}, 1, 4, 1)};
  models[3].group = models[4].group = "twins";
  return models;
}

TEST(CheckClearance, TellsThePairsThatAreAsNear) {
  const std::vector<SceneInstance> models = shelf();
  for (const double clearance : {0.0, 0.25, std::nextafter(0.25, 0.0), 1.0, 2.5, HUGE_VAL}) {
    SCOPED_TRACE(clearance);
    const CheckAnswer answer = check_all(models, {.clearance = clearance, .threads = 2});
    std::size_t next = 0;
    for (Index i = 0; i < models.size(); ++i)
      for (Index j = i + 1; j < models.size(); ++j) {
        if (!models[i].group.empty() && models[i].group == models[j].group) continue;
        const PairQuery query{models[i].pose, models[j].pose};
        if (!within_distance(models[i].model, models[j].model, clearance, query)) continue;
        ASSERT_LT(next, answer.pairs.size());
        const PairAnswer& found = answer.pairs[next++];
        EXPECT_EQ(std::pair(found.a, found.b), std::pair(i, j));
        EXPECT_EQ(found.relation, relation(models[i].model, models[j].model, query));
        EXPECT_EQ(found.distance, distance(models[i].model, models[j].model, query));
      }
    EXPECT_EQ(next, answer.pairs.size());
  }
}

TEST(CheckClearance, ThatIsExactlyTheDistanceCounts) {
  const Model cube(test::box_between({-1, -1, -1}, {1, 1, 1}));
  const double gap = 0x1p-40;
  const std::vector<SceneInstance> models{at(cube, 0, 0, 0), at(cube, 2 + gap, 0, 0)};
  EXPECT_EQ(check_all(models, {.clearance = gap}).pairs.size(), 1U);
  EXPECT_EQ(check_all(models, {.clearance = std::nextafter(gap, 0)}).pairs.size(), 0U);
  EXPECT_EQ(check_all(models).pairs.size(), 0U);
}

// The interval of a quadric tells no better; that of other shapes is decided within.
TEST(CheckClearance, WithinTheIntervalOfASmoothShapeIsUndecided) {
  const Model egg(Ellipsoid({1, 2, 3})), cone(Cone(1, 2)), box(Box({1, 1, 1}));
  const std::vector<CompoundPart> parts{{Sphere{0.1}, Pose::translation(9, 9, 9)}, {Cone{1, 2}, {}}};
  for (const Model& other : {cone, egg, Model{Compound(parts)}, Model(test::box_between({-1, -1, -1}, {1, 1, 1}))}) {
    const std::vector<SceneInstance> models{at(egg, 0, 0, 0), at(other, 4, 3, 2)};
    const Distance apart = distance(egg, other, {{}, models[1].pose});
    ASSERT_LT(apart.lower, apart.upper);
    const auto told = [&](double clearance) { return check_all(models, {.clearance = clearance}).pairs; };
    ASSERT_EQ(told(apart.upper).size(), 1U);
    EXPECT_EQ(told(apart.upper)[0].relation.status, Status::exact);
    ASSERT_EQ(told(apart.lower).size(), 1U);
    EXPECT_EQ(told(apart.lower)[0].relation.kind, RelationKind::apart);
    EXPECT_EQ(told(apart.lower)[0].relation.status, Status::undecided);
    EXPECT_TRUE(told(apart.lower * (1 - 1e-11)).empty());
  }
  const std::vector<SceneInstance> boxes{at(box, 0, 0, 0), at(box, 4, 3, 2.5)};
  const Distance apart = distance(box, box, {{}, boxes[1].pose});
  for (const PairAnswer& pair : check_all(boxes, {.clearance = apart.upper}).pairs)
    EXPECT_EQ(pair.relation.status, Status::exact);
}

TEST(CheckClearance, OfAPairGoesBeforeThatOfAll) {
  const std::vector<SceneInstance> models{at(Sphere{1}, 0, 0, 0), at(Sphere{1}, 3, 0, 0), at(Sphere{1}, 0, 4, 0)};
  const auto told = [&](double common, const std::vector<PairClearance>& of_pairs) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const PairAnswer& pair : check_all(models, {.clearance = common, .pair_clearances = of_pairs}).pairs)
      pairs.emplace_back(pair.a, pair.b);
    return pairs;
  };
  using Pairs = std::vector<std::pair<Index, Index>>;
  EXPECT_EQ(told(1, {}), (Pairs{{0, 1}}));
  EXPECT_EQ(told(1, {{1, 0, 0.5}}), (Pairs{}));
  EXPECT_EQ(told(0, {{2, 1, 3}}), (Pairs{{1, 2}}));
  EXPECT_EQ(told(1, {{0, 2, 2}, {2, 0, 2}}), (Pairs{{0, 1}, {0, 2}}));
  EXPECT_EQ(told(HUGE_VAL, {}).size(), 3U);
}

TEST(CheckClearance, ContactHasADistanceUnderEveryLength) {
  const std::vector<SceneInstance> models{at(Box{{1, 1, 1}}, 0, 0, 0), at(Box{{1, 1, 1}}, 2, 0, 0),
                                          at(Sphere{1}, 0, 1, 0)};
  for (const double clearance : {0.0, 1.0}) {
    const CheckAnswer answer = check_all(models, {.clearance = clearance});
    ASSERT_GE(answer.pairs.size(), 2U);
    for (const PairAnswer& pair : answer.pairs) {
      ASSERT_TRUE(pair.distance);
      if (pair.relation.kind != RelationKind::apart) {
        EXPECT_EQ(pair.distance->upper, 0);
      }
    }
  }
  for (const PairAnswer& pair : check_all(models).pairs) EXPECT_FALSE(pair.distance);
}

/// The first is near all others by its clearance to the farthest; each other pair counts by its own.
TEST(CheckClearance, CandidatesAreNearByTheClearanceOfThePair) {
  const std::vector<SceneInstance> models{at(Sphere{1}, 0, 0, 0), at(Sphere{1}, 4, 0, 0), at(Sphere{1}, 0, 40, 0)};
  const auto candidates = [&](double common, const std::vector<PairClearance>& of_pairs) {
    return check_all(models, {.clearance = common, .pair_clearances = of_pairs}).candidate_pairs;
  };
  EXPECT_EQ(candidates(0, {}), 0U);
  EXPECT_EQ(candidates(0, {{0, 2, 38}}), 1U);
  EXPECT_EQ(candidates(0, {{2, 0, HUGE_VAL}}), 1U);
  EXPECT_EQ(candidates(2, {{0, 2, 38}}), 2U);
  EXPECT_EQ(candidates(2, {{0, 2, 37}}), 1U);
  EXPECT_EQ(candidates(2, {{0, 1, 1}}), 0U);
  EXPECT_EQ(candidates(HUGE_VAL, {{0, 1, 1}}), 2U);
}

std::string error_of(const std::vector<SceneInstance>& models, const std::vector<PairClearance>& of_pairs) {
  try {
    static_cast<void>(check_all(models, {.pair_clearances = of_pairs}));
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(CheckClearance, RefusesTwoLengthsForAPairAndOneWithinAGroup) {
  std::vector<SceneInstance> models{at(Sphere{1}, 0, 0, 0), at(Sphere{1}, 3, 0, 0), at(Sphere{1}, 6, 0, 0)};
  models[0].name = "table";
  models[1].group = models[2].group = "arm";
  const std::string twice = error_of(models, {{0, 1, 1}, {1, 0, 2}});
  EXPECT_NE(twice.find("object \"table\" and object 1"), std::string::npos) << twice;
  const std::string within = error_of(models, {{2, 1, 1}});
  EXPECT_NE(within.find("group \"arm\""), std::string::npos) << within;
  EXPECT_EQ(error_of(models, {{0, 1, 1}, {1, 0, 1}}), "");
}

TEST(CheckClearance, IsReportedWithoutWhatTouchesAndWithoutDistances) {
  const std::vector<SceneInstance> models{at(Box{{1, 1, 1}}, 0, 0, 0), at(Box{{1, 1, 1}}, 2, 0, 0)};
  Scene scene;
  for (const char* const name : {"a", "b"}) {
    SceneObject& object = scene.objects.emplace_back();
    object.name = name;
    object.shape = Box{{1, 1, 1}};
  }
  const CheckAnswer answer = check_all(models);
  for (const ReportOptions& options : {ReportOptions{.touching = Touching::ignore, .clearance = 0},
                                       ReportOptions{.touching = Touching::ignore, .pair_clearances = {{0, 1, 0}}}}) {
    EXPECT_TRUE(make_check_report(models, answer, options).pairs.empty());
    EXPECT_EQ(make_check_report(models, answer, options).ignored_touching, 1U);
  }
  const CheckReport report = make_check_report(models, answer, {.clearance = 0});
  EXPECT_EQ(report_json(scene, models, report).find("\"distance\""), std::string::npos);
  const std::string csv = report_csv(scene, report);
  const std::string head = csv.substr(0, csv.find('\n')), line = csv.substr(head.size() + 1);
  EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(head.begin(), head.end(), ',')) << csv;
}

TEST(CheckClearance, RefusesWhatIsNoLengthAndPairsThatAreNot) {
  const std::vector<SceneInstance> models{at(Sphere{1}, 0, 0, 0), at(Sphere{1}, 3, 0, 0)};
  for (const double wrong : {-1.0, -HUGE_VAL, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(check_all(models, {.clearance = wrong})), Error);
    EXPECT_THROW(static_cast<void>(check_all(models, {.pair_clearances = {{0, 1, wrong}}})), Error);
  }
  EXPECT_THROW(static_cast<void>(check_all(models, {.pair_clearances = {{0, 2, 1}}})), Error);
  EXPECT_THROW(static_cast<void>(check_all(models, {.pair_clearances = {{1, 1, 1}}})), Error);
}

}  // namespace
}  // namespace toccata
