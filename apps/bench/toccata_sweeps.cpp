#include <fmt/format.h>

#include <iterator>
#include <map>

#include "sweeps.hpp"
#include "toccata/core/version.hpp"

namespace toccata::bench {
namespace {

using SweepMaker = SweepOffer (*)(const SweepWork&);

const std::map<std::string, SweepMaker>& sweep_makers() {
  static const std::map<std::string, SweepMaker> all{{"bullet", bullet_sweeps}, {"fcl", fcl_sweeps}};
  return all;
}

/// `sweep` of two Models, which are made before; as peers do, it makes the motions of the poses at both ends for each
/// question.
class ToccataSweeps : public SweepLibrary {
 public:
  Description description() const override {
    return {"toccata", "sweep", version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }

  void prepare(const SweepWork& work) override {
    work_ = &work;
    const auto model_of = [](const auto& shape) { return Model(shape); };
    for (const SweepPair& pair : work.pairs)
      models_.push_back({std::visit(model_of, pair.a), std::visit(model_of, pair.b)});
  }

  void answer(std::size_t first, std::span<SweepAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const SweepQuestion& question = work_->questions[first + i];
      const auto& [a, b] = models_[question.pair];
      const std::optional<ShapeHit> hit = sweep(a, question.a.motion(), b, question.b.motion(), {}, workspace_);
      if (hit)
        answers[i] = {true, hit->status == Status::exact, hit->lower, hit->upper};
      else
        answers[i] = {false, true, 0, 0};
    }
  }

  PosePair poses_at(std::size_t number, double time) override {
    const SweepQuestion& question = work_->questions[number];
    return {question.a.motion().at(time), question.b.motion().at(time)};
  }

 private:
  struct Models {
    Model a;
    Model b;
  };
  const SweepWork* work_ = nullptr;
  std::vector<Models> models_;
  Workspace workspace_;
};

}  // namespace

std::vector<std::string> sweep_peers() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : sweep_makers()) names.push_back(name);
  return names;
}

SweepOffer toccata_sweeps(const SweepWork&) {
  SweepOffer offer;
  offer.libraries.push_back(std::make_unique<ToccataSweeps>());
  return offer;
}

SweepOffer sweep_libraries(const std::vector<std::string>& peers, const SweepWork& work) {
  SweepOffer offer = toccata_sweeps(work);
  for (const std::string& name : peers) {
    SweepOffer more = sweep_makers().at(name)(work);
    std::move(more.libraries.begin(), more.libraries.end(), std::back_inserter(offer.libraries));
    std::move(more.unasked.begin(), more.unasked.end(), std::back_inserter(offer.unasked));
  }
  return offer;
}

}  // namespace toccata::bench
