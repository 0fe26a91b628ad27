#include <fmt/format.h>

#include "parts.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

Description described(const char* variant) {
  return {"toccata", variant, version,
          fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
}

class CheckAll final : public PartsLibrary {
 public:
  explicit CheckAll(int threads) : threads_(threads) {}
  Description description() const override { return described("check_all"); }
  void build(std::span<const SceneInstance> parts) override { parts_ = parts; }
  std::vector<IndexPair> pairs() override {
    std::vector<IndexPair> found;
    for (const PairAnswer& pair : check_all(parts_, {.threads = threads_}).pairs) found.push_back({pair.a, pair.b});
    return found;
  }

 private:
  int threads_;
  std::span<const SceneInstance> parts_;
};

/// What a program without a broad phase does: a box around each part, every pair of boxes, and a question for each that
/// overlap.
class EveryPair final : public PartsLibrary {
 public:
  Description description() const override { return described("every pair"); }
  void build(std::span<const SceneInstance> parts) override { parts_ = parts; }
  std::vector<IndexPair> pairs() override {
    std::vector<Aabb> boxes;
    for (const SceneInstance& part : parts_) boxes.push_back(box_of(part));
    std::vector<IndexPair> found;
    Workspace workspace;
    for (const IndexPair& pair : overlapping_pairs_by_brute_force(boxes)) {
      const SceneInstance &a = parts_[pair.first], &b = parts_[pair.second];
      if (overlap(a.model, b.model, {a.pose, b.pose, a.solid, b.solid}, workspace)) found.push_back(pair);
    }
    return found;
  }

 private:
  static Aabb box_of(const SceneInstance& part) {
    Aabb box;
    for (const Vec3& vertex : part.model.mesh().vertices()) box = merge(box, transform(part.pose, vertex));
    return box;
  }
  std::span<const SceneInstance> parts_;
};

}  // namespace

PartsLibraries toccata_parts(int threads) {
  PartsLibraries libraries;
  libraries.push_back(std::make_unique<CheckAll>(threads));
  libraries.push_back(std::make_unique<EveryPair>());
  return libraries;
}

}  // namespace toccata::bench
