#include <fmt/format.h>

#include "broad.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/version.hpp"

namespace toccata::bench {
namespace {

class ToccataBroad final : public BroadLibrary {
 public:
  ToccataBroad(BroadPhaseMethod method, int threads) : method_(method), phase_({method, threads}) {}

  Description description() const override {
    return {"toccata", std::string(name_of(method_)), version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  void add(std::span<const Aabb> boxes) override { phase_.add(boxes); }
  void step(std::span<const Index> moved, std::span<const Aabb> boxes) override {
    to_.clear();
    for (const Index number : moved) to_.push_back(boxes[number]);
    phase_.move(moved, to_);
    phase_.update();
  }
  std::vector<IndexPair> pairs() const override { return {phase_.pairs().begin(), phase_.pairs().end()}; }
  std::string reason() const override { return phase_.reason(); }
  std::size_t bytes() const override { return phase_.bytes(); }

 private:
  BroadPhaseMethod method_;
  BroadPhase phase_;
  std::vector<Aabb> to_;
};

}  // namespace

BroadLibraries toccata_broad_libraries(const std::vector<std::string>& methods, int threads) {
  BroadLibraries libraries;
  for (const std::string& method : methods)
    libraries.push_back(std::make_unique<ToccataBroad>(broad_phase_method(method), threads));
  return libraries;
}

}  // namespace toccata::bench
