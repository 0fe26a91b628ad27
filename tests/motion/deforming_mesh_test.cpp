#include "toccata/motion/deforming_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "motion/approach.hpp"
#include "support/deforming_cases.hpp"
#include "support/deforming_judge.hpp"
#include "support/error_message.hpp"
#include "support/simd_levels.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata::test {
namespace {

std::vector<Vec3> starts_of(const TriangleMesh& mesh) { return {mesh.vertices().begin(), mesh.vertices().end()}; }

/// The triangle (0, 0, 0), (4, 0, 0), (0, 4, 0), which rests.
DeformingMesh floor_triangle() { return DeformingMesh(TriangleMesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}})); }

/// A triangle whose corner 0, above (1, 1), falls from height 1 to the height given; its others stay above.
DeformingMesh falling_triangle(double to) {
  return {TriangleMesh({{1, 1, 1}, {1, 2, 4}, {2, 1, 4}}, {{0, 1, 2}}), {{1, 1, to}, {1, 2, 4}, {2, 1, 4}}};
}

const MeshFeature corner{FeatureKind::vertex, 0}, first_face{FeatureKind::face, 0};

TEST(DeformingMesh, TwoMeshesMeetWhereACornerFallsOntoAFace) {
  const DeformingMesh falling = falling_triangle(-1), floor = floor_triangle();
  EXPECT_TRUE(meets(falling, floor));
  const std::optional<MeshImpact> first = first_impact(falling, floor);
  ASSERT_TRUE(first);
  EXPECT_EQ(*first, (MeshImpact{corner, first_face, {0.5, 0.5}}));
  EXPECT_EQ(*first_impact(floor, falling), (MeshImpact{first_face, corner, {0.5, 0.5}}));
  EXPECT_FALSE(meets(falling_triangle(0x1p-1074), floor));
  EXPECT_TRUE(meets(falling_triangle(0), floor));
}

TEST(DeformingMesh, TheFreeStepEndsACellBeforeATimeThatIsToldExactly) {
  const FreeStep step = free_step(falling_triangle(-1), floor_triangle());
  EXPECT_EQ(step.fraction, 0.5 - 0x1p-40);
  ASSERT_TRUE(step.limited_by);
  EXPECT_EQ(step.limited_by->a, corner);
  EXPECT_EQ(free_step(falling_triangle(0.5), floor_triangle()).fraction, 1);
  EXPECT_FALSE(free_step(falling_triangle(0.5), floor_triangle()).limited_by);
}

TEST(DeformingMesh, AnEdgeThatPiercesAFaceAtTheStartIsTold) {
  const TriangleMesh piercing({{1, 1, 1}, {1, 1, -1}, {9, 9, 1}}, {{0, 1, 2}});
  const DeformingMesh through(piercing), floor = floor_triangle();
  const std::vector<MeshImpact> found = impacts(through, floor);
  ASSERT_FALSE(found.empty());
  for (const MeshImpact& impact : found) EXPECT_EQ(impact.time, (TimeOfImpact{0, 0}));
  EXPECT_EQ(found[0].a, (MeshFeature{FeatureKind::edge, 0}));
  EXPECT_EQ(found[0].b, first_face);
  EXPECT_EQ(free_step(through, floor).fraction, 0);
  EXPECT_EQ(free_step(through, floor).limited_by->time.upper, 0);
  EXPECT_EQ(free_steps(through, floor).of_a[0], 0);
}

TEST(DeformingMesh, ASheetThatFoldsOntoItselfMeetsItselfAndNeighboursDoNotCount) {
  const TriangleMesh sheet = square_sheet_mesh(4);
  DeformingMesh folding(sheet);
  EXPECT_FALSE(meets(folding));
  std::vector<Vec3> end = starts_of(sheet);
  for (Vec3& v : end)
    if (v.x > 0.5) v.z = 1;
  static_cast<void>(folding.move_to(end));
  EXPECT_FALSE(meets(folding));
  std::vector<Vec3> over = end;
  for (Vec3& v : over)
    if (v.x > 0.5) v = {1 - v.x, v.y, -0.25};
  static_cast<void>(folding.advance(over));
  EXPECT_TRUE(meets(folding));
  EXPECT_FALSE(wrong_impacts(DeformingPair(folding), impacts(folding), FeatureJudge::oracle));
}

/// In every family exactly the pairs that the oracle finds are told, and their times.
TEST(DeformingMesh, EveryPairOfFeaturesIsToldAsTheOracleTellsIt) {
  for (const std::string& family : deforming_families()) {
    Random random(11);
    for (int i = 0; i < 2; ++i) {
      const DeformingMesh mesh = random_deforming_case(family, random).made();
      const auto wrong = wrong_impacts(DeformingPair(mesh), impacts(mesh), FeatureJudge::oracle);
      EXPECT_FALSE(wrong) << family << ' ' << i << ": " << *wrong;
      const DeformingMesh other = random_deforming_case(family, random).made();
      const auto wrong_of_two = wrong_impacts({mesh, other}, impacts(mesh, other), FeatureJudge::oracle);
      EXPECT_FALSE(wrong_of_two) << family << ' ' << i << ": " << *wrong_of_two;
    }
  }
}

/// A sheet with a wave in it, which is pressed together until its folds meet.
DeformingMesh pressed_sheet(int cells) {
  const TriangleMesh flat = square_sheet_mesh(cells);
  std::vector<Vec3> start = starts_of(flat), end = start;
  Random random(3);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double x = start[i].x, wave = std::sin(20 * x);
    start[i].z = 0.1 * wave;
    end[i] = {0.08 * x + 0.02 * wave * std::cos(20 * x), start[i].y + 0.001 * random.between(-1, 1), 0.1 * wave};
  }
  return {flat.with_vertices(std::move(start)), std::move(end)};
}

TEST(DeformingMesh, TheTreeLosesNoPairOfALargerMesh) {
  const DeformingMesh mesh = pressed_sheet(16);
  const std::vector<MeshImpact> found = impacts(mesh);
  EXPECT_GT(found.size(), 100U);
  const auto wrong = wrong_impacts(DeformingPair(mesh), found, FeatureJudge::library);
  EXPECT_FALSE(wrong) << *wrong;
}

TEST(DeformingMesh, AnswersHaveTheSameBitsOnAnyNumberOfThreadsAndAtEverySimdLevel) {
  const DeformingMesh mesh = pressed_sheet(24), floor(TriangleMesh({{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}, {{0, 1, 2}}));
  const ImpactOptions near{.separation = 0.001};
  const auto alone = impacts(mesh), with_floor = impacts(mesh, floor), apart = impacts(mesh, near);
  const auto steps = free_steps(mesh, near);
  at_every_simd_level([&](SimdLevel) {
    for (const int threads : {1, 3}) {
      EXPECT_EQ(impacts(mesh, {.threads = threads}), alone);
      EXPECT_EQ(impacts(mesh, floor, {.threads = threads}), with_floor);
      EXPECT_EQ(impacts(mesh, {.separation = 0.001, .threads = threads}), apart);
      EXPECT_EQ(free_steps(mesh, {.separation = 0.001, .threads = threads}), steps);
      EXPECT_EQ(first_impact(mesh, {.threads = threads}), alone.front());
    }
  });
}

/// As a whole, by the same way.
DeformingMesh moved_by(const TriangleMesh& mesh, const Vec3& way) {
  std::vector<Vec3> end = starts_of(mesh);
  for (Vec3& v : end) v += way;
  return {mesh, std::move(end)};
}

TriangleMesh placed_at(const TriangleMesh& mesh, const Vec3& by) {
  const DeformingMesh moved = moved_by(mesh, by);
  return mesh.with_vertices({moved.end().begin(), moved.end().end()});
}

void expect_first_of_all(const DeformingMesh& a, const DeformingMesh& b, double separation) {
  const std::vector<MeshImpact> all = impacts(a, b, {.separation = separation});
  for (const int threads : {1, 2, 3, 8}) {
    const auto first = first_impact(a, b, {.separation = separation, .threads = threads});
    ASSERT_EQ(first, all.empty() ? std::nullopt : std::optional(all.front())) << threads;
  }
}

// What begins to meet later than what is found already is left out; the first is the same, also of many at one time.
TEST(DeformingMesh, TheFirstImpactIsThatOfAllOnAnyNumberOfThreads) {
  const TriangleMesh ball = icosphere_mesh(1, 2), box = box_mesh({1, 1, 1});
  const DeformingMesh resting(ball), resting_box(box);
  Random random(3);
  for (const double separation : {0.0, 0.02}) {
    for (const Vec3& way : {Vec3{1.5, 0, 0}, Vec3{4, 0, 0}, Vec3{8, 0.5, 0.25}})
      expect_first_of_all(moved_by(placed_at(ball, {-3, 0.1, 0.05}), way), resting, separation);
    // All of a face at once.
    expect_first_of_all(moved_by(placed_at(box, {-3, 0, 0}), {4, 0, 0}), resting_box, separation);
    expect_first_of_all(moved_by(placed_at(box, {-3, 0.25, 0.5}), {2, 0, 0}), resting_box, separation);
    for (const std::string& family : deforming_families())
      for (int i = 0; i < 5; ++i) {
        const DeformingMesh a = random_deforming_case(family, random).made(),
                            b = random_deforming_case(family, random).made();
        expect_first_of_all(a, b, separation);
      }
  }
}

TEST(DeformingMesh, AnApproachThatIsAskedForUntilATimeIsTheSameOrComesLater) {
  Random random(4);
  const auto point = [&] { return Vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; };
  int later = 0;
  for (int i = 0; i < 300; ++i) {
    const EdgeEdge pair{{{{point(), point()}, {point(), point()}}}, {{{point(), point()}, {point(), point()}}}};
    const auto all = time_of_approach(differences(pair), 0.1);
    const double latest = random.between(0, 1);
    const auto until = time_of_approach(differences(pair), 0.1, latest);
    const bool is_in_time = all && all->time.lower <= latest;
    EXPECT_TRUE(until == all || (!is_in_time && !until)) << i;
    later += all && !until;
  }
  EXPECT_GT(later, 20);
}

TEST(DeformingMesh, RefittedOrBuiltAnewTheAnswersAreTheSame) {
  const DeformingMesh built = pressed_sheet(12);
  DeformingMesh stepped(square_sheet_mesh(12).with_vertices({built.start().begin(), built.start().end()}));
  EXPECT_LT(stepped.move_to({built.start().begin(), built.start().end()}).growth, 1.01);
  EXPECT_GT(stepped.move_to({built.end().begin(), built.end().end()}).volumes_updated, 0U);
  EXPECT_EQ(impacts(stepped), impacts(built));
  std::vector<Vec3> after(built.end().begin(), built.end().end());
  for (Vec3& v : after) v.x = -v.x;
  static_cast<void>(stepped.advance(after));
  const DeformingMesh anew(square_sheet_mesh(12).with_vertices({built.end().begin(), built.end().end()}), after);
  EXPECT_EQ(impacts(stepped), impacts(anew));
}

TEST(DeformingMesh, ProgressIsToldToTheEndAndMayCancel) {
  const TriangleMesh ball = noise_sphere_mesh({.subdivisions = 3});
  std::vector<Vec3> through(ball.vertices().begin(), ball.vertices().end());
  for (Vec3& v : through) v = v + Vec3{0.5, 0, 0};
  const DeformingMesh moving(ball, through), still(ball);
  for (const int threads : {1, 3}) {
    std::size_t last = 0, of = 0;
    const Progress count = [&](std::size_t done, std::size_t total) {
      EXPECT_EQ(done, last + 1);
      last = done, of = total;
    };
    const ImpactOptions counted{.threads = threads, .progress = count}, uncounted{.threads = threads};
    EXPECT_EQ(free_steps(moving, counted), free_steps(moving, uncounted));
    EXPECT_GT(of, 1U);
    EXPECT_EQ(last, of);
    last = 0;
    EXPECT_EQ(impacts(moving, still, counted), impacts(moving, still, uncounted));
    EXPECT_EQ(last, of);
    const Progress cancel = [](std::size_t done, std::size_t) {
      if (done == 2) throw std::runtime_error("enough");
    };
    const ImpactOptions cancelled{.threads = threads, .progress = cancel};
    EXPECT_THROW((void)impacts(moving, still, cancelled), std::runtime_error);
    EXPECT_THROW((void)free_steps(moving, cancelled), std::runtime_error);
  }
}

TEST(DeformingMesh, BadInputIsAnErrorThatNamesIt) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh sheet = square_sheet_mesh(1);
  DeformingMesh mesh(sheet);
  const auto with = [&](std::vector<Vec3> end) { return message_of([&] { static_cast<void>(mesh.move_to(end)); }); };
  EXPECT_NE(with({{0, 0, 0}}).find("a mesh of 4 vertices is to move to 1 positions"), std::string::npos);
  std::vector<Vec3> end = starts_of(sheet);
  end[2].y = none;
  EXPECT_NE(with(end).find("vertex 2"), std::string::npos);
  EXPECT_TRUE(std::equal(mesh.end().begin(), mesh.end().end(), sheet.vertices().begin()));
  for (const double separation : {-1.0, none, HUGE_VAL}) {
    const std::string message = message_of([&] { static_cast<void>(impacts(mesh, {.separation = separation})); });
    EXPECT_NE(message.find("separation"), std::string::npos);
  }
}

TEST(DeformingMesh, APromiseOfAFreeStartThatIsBrokenNamesTheFeatures) {
  const DeformingMesh touching(TriangleMesh({{1, 1, 0}, {1, 2, 4}, {2, 1, 4}}, {{0, 1, 2}})), floor = floor_triangle();
  const std::string message = message_of([&] { static_cast<void>(free_step(touching, floor, {.starts_free = true})); });
  EXPECT_NE(message.find("vertex 0 and triangle 0"), std::string::npos) << message;
  EXPECT_EQ(free_step(falling_triangle(0.5), floor, {.starts_free = true}).fraction, 1);
  EXPECT_TRUE(first_impact(touching, floor, {.separation = 0.5, .starts_free = true}));
}

TEST(DeformingMesh, ASeparationIsReachedBeforeTheContact) {
  const DeformingMesh falling = falling_triangle(-1), floor = floor_triangle();
  const std::optional<MeshImpact> first = first_impact(falling, floor, {.separation = 0.25});
  ASSERT_TRUE(first);
  EXPECT_EQ(first->status, Status::exact);
  EXPECT_LE(first->time.lower, 0.375);
  EXPECT_GE(first->time.upper, 0.375);
  EXPECT_LE(first->time.upper - first->time.lower, 0x1p-30);
  EXPECT_FALSE(meets(falling_triangle(0.25 + 1e-9), floor, {.separation = 0.25}));
  // What lies within rounding of the separation counts as reached.
  EXPECT_TRUE(meets(falling_triangle(0.25), floor, {.separation = 0.25}));
  EXPECT_EQ(first_impact(falling, floor, {.separation = 2})->time, (TimeOfImpact{0, 0}));
}

/// Each vertex goes its own part of its way, as much as it may, and nothing meets.
void expect_independent_steps_are_free(const DeformingMesh& mesh, double separation, Random& random) {
  const std::vector<double> steps = free_steps(mesh, {.separation = separation});
  for (const int how : {0, 1, 2}) {
    std::vector<Vec3> end(mesh.end().begin(), mesh.end().end());
    for (std::size_t v = 0; v < end.size(); ++v) {
      const double part = how == 0 ? 1 : how == 1 ? random.unit() : static_cast<double>(random.below(2));
      end[v] = mesh.start()[v] + part * steps[v] * (end[v] - mesh.start()[v]);
    }
    DeformingMesh stepped = mesh;
    static_cast<void>(stepped.move_to(end));
    // Slightly less, because the positions above are rounded.
    const double wanted = separation * (1 - 1e-9);
    const auto found = first_impact(stepped, {.separation = wanted});
    EXPECT_TRUE(!found || found->time.upper == 0) << found->time.lower;
  }
}

TEST(DeformingMesh, VerticesThatStopWhereTheyMayOneByOneMeetNothing) {
  Random random(5);
  for (const char* family : {"soup", "grid", "fold", "planted"})
    for (int i = 0; i < 40; ++i)
      for (const double separation : {0.0, 0.01})
        expect_independent_steps_are_free(random_deforming_case(family, random).made(), separation, random);
  expect_independent_steps_are_free(pressed_sheet(24), 0, random);
}

TEST(DeformingMesh, VerticesThatSlideAlongSomethingAreNotStopped) {
  const TriangleMesh low({{1, 1, 0.01}, {1, 1.5, 0.01}, {1.5, 1, 0.01}}, {{0, 1, 2}});
  const DeformingMesh sliding(low, {{3, 0.5, 0.01}, {3, 1, 0.02}, {3.5, 0.5, 0.01}});
  for (const double part : free_steps(sliding, floor_triangle()).of_a) EXPECT_EQ(part, 1);
  for (const double part : free_steps(sliding, floor_triangle(), {.separation = 0.0099}).of_a) EXPECT_EQ(part, 1);
  for (const double part : free_steps(sliding, floor_triangle(), {.separation = 0.0101}).of_a) EXPECT_EQ(part, 0);
}

TEST(DeformingMesh, VerticesThatNothingIsNearGoAllTheirWay) {
  const FreeSteps steps = free_steps(falling_triangle(-1), floor_triangle());
  EXPECT_GT(steps.of_a[0], 0.49);
  EXPECT_LT(steps.of_a[0], 0.5);
  EXPECT_EQ(steps.of_b.size(), 3U);
  DeformingMesh sheet(square_sheet_mesh(8));
  std::vector<Vec3> end(sheet.end().begin(), sheet.end().end());
  for (Vec3& v : end) v += Vec3{5, 5, 5};
  static_cast<void>(sheet.move_to(end));
  EXPECT_EQ(free_step(sheet).fraction, 1);
}

}  // namespace
}  // namespace toccata::test
