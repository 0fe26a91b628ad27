#include "nearest_race.hpp"

#include <mpi.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include "run_ranks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"

namespace toccata {
namespace {

using NearestOfAll = std::vector<std::vector<GlobalAnswer<Distance>>>;

struct AnsweredQuestions {
  NearestOfAll answers;
  double seconds = 0, waited = 0;
};

/// Places about the middles of boxes that live here.
std::vector<SceneInstance> questions_of(const DistributedWorld& world, std::size_t count) {
  const std::vector<GlobalId> here = world.bodies();
  Random random(static_cast<std::uint64_t>(1 + world.rank()));
  std::vector<SceneInstance> questions;
  for (std::size_t i = 0; i < count && !here.empty(); ++i) {
    const auto by = [&] { return random.between(-0.5, 0.5); };
    const double x = by(), y = by(), z = by();
    const Vec3& middle = world.body(here[random.below(here.size())]).pose.offset;
    questions.push_back({Point{}, Pose::translation(middle + Vec3{x, y, z})});
  }
  return questions;
}

AnsweredQuestions ask(DistributedWorld& world, std::span<const SceneInstance> questions, std::size_t k) {
  // The tree over the boxes is made with the first question.
  static_cast<void>(world.nearest_bodies_each({}, k));
  const double waited_before = world.seconds_waited();
  const auto begin = std::chrono::steady_clock::now();
  AnsweredQuestions answered{world.nearest_bodies_each(questions, k)};
  answered.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  answered.waited = world.seconds_waited() - waited_before;
  return answered;
}

}  // namespace

NearestRates nearest_rates(const CrowdOfRanks& wanted, std::size_t count, std::size_t k) {
  const Crowd crowd(wanted.scene, wanted.count, wanted.seed);
  DistributedWorld world = world_of_crowd(crowd, wanted);
  const std::vector<SceneInstance> questions = questions_of(world, count);
  const AnsweredQuestions among = ask(world, questions, k);
  const std::array<double, 2> own{among.seconds, among.seconds - among.waited};
  std::array<double, 2> most{};
  MPI_Reduce(own.data(), most.data(), 2, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  NearestRates rates;
  if (world.rank() == 0) {
    CrowdOfRanks single = wanted;
    single.communicator = MPI_Comm_c2f(MPI_COMM_SELF);
    DistributedWorld all = world_of_crowd(crowd, single);
    const AnsweredQuestions alone = ask(all, questions, k);
    if (alone.answers != among.answers) throw Error("the nearest boxes of all ranks are not those of one");
    const auto asked = static_cast<double>(count);
    rates = {asked / alone.seconds, asked / most[0], asked / most[1]};
  }
  wait_idly();
  return rates;
}

}  // namespace toccata
