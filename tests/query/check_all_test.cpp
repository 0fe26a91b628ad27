#include "toccata/query/check_all.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "query/scenes/check_wanted.hpp"
#include "support/mesh_pairs.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

Model unit_box() { return Model(test::box_between({0, 0, 0}, {1, 1, 1})); }

SceneInstance posed(const Model& model, double x, const std::string& name = "", const std::string& group = "") {
  return {model, Pose::translation(x, 0, 0), Solid::automatic, name, group};
}

bool same(const CheckAnswer& x, const CheckAnswer& y) {
  if (x.candidate_pairs != y.candidate_pairs || x.pairs.size() != y.pairs.size()) return false;
  for (std::size_t i = 0; i < x.pairs.size(); ++i) {
    const PairAnswer &p = x.pairs[i], &q = y.pairs[i];
    if (p.a != q.a || p.b != q.b || p.relation != q.relation || !test::same(p.contacts, q.contacts)) return false;
  }
  return true;
}

std::string message_of(const std::vector<SceneInstance>& models) {
  try {
    (void)check_all(models);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Surfaces scattered so that some meet.
std::vector<SceneInstance> scattered(std::uint64_t seed, int count) {
  Random random(seed);
  const Model soup(test::random_soup(random, 30, 0.2, 0)), box = unit_box();
  std::vector<SceneInstance> models;
  for (int i = 0; i < count; ++i) {
    Pose pose{test::random_rotation(random), {4 * random.unit(), 4 * random.unit(), 4 * random.unit()}};
    models.push_back({i % 2 == 0 ? soup : box, pose, Solid::none, "", i % 5 == 0 ? "fives" : ""});
  }
  return models;
}

TEST(CheckAll, NothingAmongNone) {
  EXPECT_TRUE(check_all({}).pairs.empty());
  EXPECT_EQ(check_all({}).candidate_pairs, 0U);
}

TEST(CheckAll, ARowOfBoxes) {
  const Model box = unit_box();
  const std::vector<SceneInstance> row{posed(box, 3.5), posed(box, 0), posed(box, 1), posed(box, 1.5)};
  const CheckAnswer answer = check_all(row);
  ASSERT_EQ(answer.pairs.size(), 2U);
  EXPECT_EQ(answer.candidate_pairs, 2U);
  EXPECT_EQ(answer.pairs[0].a, 1U);
  EXPECT_EQ(answer.pairs[0].b, 2U);
  EXPECT_EQ(answer.pairs[1].a, 2U);
  EXPECT_EQ(answer.pairs[1].b, 3U);
  EXPECT_TRUE(answer.pairs[0].contacts.empty()) << "not asked for";
}

TEST(CheckAll, OneGroupIsNotCheckedAgainstItself) {
  const Model box = unit_box();
  const std::vector<SceneInstance> models{posed(box, 0, "", "robot"), posed(box, 0.5, "", "robot"),
                                          posed(box, 0.7, "", "table"), posed(box, 0.9)};
  const CheckAnswer answer = check_all(models);
  EXPECT_EQ(answer.candidate_pairs, 5U);
  EXPECT_EQ(answer.pairs.size(), 5U);
}

TEST(CheckAll, AgreesWithThePairQuestions) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<SceneInstance> models = scattered(seed, 40);
    const CheckAnswer answer = check_all(models, {.contacts = true});
    std::size_t next = 0;
    for (Index i = 0; i < models.size(); ++i)
      for (Index j = i + 1; j < models.size(); ++j) {
        const bool one_group = !models[i].group.empty() && models[i].group == models[j].group;
        const PairQuery query{models[i].pose, models[j].pose, Solid::none, Solid::none};
        const auto expected = test::contacts_by_brute_force(models[i].model, models[j].model, query);
        if (one_group || expected.empty()) continue;
        ASSERT_LT(next, answer.pairs.size());
        EXPECT_EQ(answer.pairs[next].a, i);
        EXPECT_EQ(answer.pairs[next].b, j);
        EXPECT_TRUE(test::same(answer.pairs[next].contacts, expected));
        ++next;
      }
    EXPECT_EQ(next, answer.pairs.size());
  }
}

TEST(CheckAll, AnyThreadCountGivesTheSameAnswer) {
  const std::vector<SceneInstance> models = scattered(9, 60);
  const CheckAnswer one = check_all(models, {.contacts = true, .threads = 1});
  EXPECT_FALSE(one.pairs.empty());
  for (const int threads : {0, 2, 3, 8})
    EXPECT_TRUE(same(one, check_all(models, {.contacts = true, .threads = threads})));
}

TEST(CheckAll, ErrorsNameTheModelEvenWhenItIsFarFromAll) {
  const Model box = unit_box();
  std::vector<SceneInstance> models{posed(box, 0, "table"), posed(box, 100, "lamp"), posed(box, 200)};
  models[1].pose.linear[0] = {};
  EXPECT_NE(message_of(models).find("\"lamp\""), std::string::npos) << message_of(models);
  models[1].solid = Solid::none;
  EXPECT_EQ(message_of(models), "no error");
  models[2].pose.offset.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of(models).find("object 2"), std::string::npos) << message_of(models);
}

TEST(CheckAll, ProgressCountsEveryCandidatePair) {
  const std::vector<SceneInstance> models = scattered(2, 40);
  std::size_t last = 0, total = 0;
  const CheckAnswer answer = check_all(models, {.progress = [&](std::size_t done, std::size_t of) {
                                         EXPECT_EQ(done, last + 1);
                                         last = done;
                                         total = of;
                                       }});
  EXPECT_EQ(last, answer.candidate_pairs);
  EXPECT_EQ(total, answer.candidate_pairs);
}

/// Whoever wants an end gets the brackets so far, however early.
TEST(CheckAll, DepthsEndWhereTheCheckIsStopped) {
  const Model rock(noise_sphere_mesh({.subdivisions = 3}));
  const std::vector<SceneInstance> models = {posed(rock, 0), posed(rock, 0.7)};
  CheckOptions options;
  options.penetration = true;
  options.depth.precision = 1e-6;
  options.threads = 1;
  const PairAnswer whole = check_all(models, options).pairs.at(0);
  EXPECT_EQ(whole.depth_end, DepthEnd::exhausted);
  for (const int calls : {1, 2, 10, 100}) {
    int left = calls;  // the first is before the pair is begun
    const CheckWatch watch{.stop = [&] { return left-- <= 0; }};
    const WantedAnswer stopped = check_wanted(models, options, {}, watch);
    ASSERT_EQ(stopped.answer.pairs.size(), 1U);
    const PairAnswer& pair = stopped.answer.pairs[0];
    EXPECT_EQ(pair.depth_end, DepthEnd::out_of_time);
    EXPECT_LE(pair.penetration->lower, whole.penetration->lower);
    EXPECT_GE(pair.penetration->upper, whole.penetration->upper);
    EXPECT_EQ(pair.relation, whole.relation);
    ASSERT_EQ(pair.regions.size(), whole.regions.size());
    for (std::size_t i = 0; i < pair.regions.size(); ++i) {
      EXPECT_LE(pair.regions[i].depth->lower, whole.regions[i].depth->upper);
      EXPECT_GE(pair.regions[i].depth->upper, whole.regions[i].depth->lower);
    }
  }
}

TEST(CheckAll, ProgressCanCancel) {
  const std::vector<SceneInstance> models = scattered(2, 40);
  std::size_t calls = 0;
  const Progress cancel = [&](std::size_t, std::size_t) {
    if (++calls == 3) throw std::runtime_error("cancelled");
  };
  for (const int threads : {1, 4}) {
    calls = 0;
    EXPECT_THROW((void)check_all(models, {.threads = threads, .progress = cancel}), std::runtime_error);
    EXPECT_EQ(calls, 3U) << "not told again after it threw";
  }
}

}  // namespace
}  // namespace toccata
