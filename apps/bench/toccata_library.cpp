#include <fmt/format.h>

#include <optional>

#include "library.hpp"
#include "toccata/core/simd.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/distance_cache.hpp"
#include "toccata/query/overlap.hpp"

namespace toccata::bench {
namespace {

Description described(const std::string& variant) {
  return {"toccata", variant, version,
          fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
}

/// How distances of meshes on their way are asked for; of everything else there is one way.
enum class DistanceWay { alone, cached };

std::size_t bytes_of(const WideBvh& tree) {
  return tree.blocks.capacity() * sizeof tree.blocks[0] + tree.items.capacity() * sizeof tree.items[0];
}

class ToccataMeshes : public MeshLibrary {
 public:
  explicit ToccataMeshes(DistanceWay way) : way_(way) {}

  Description description() const override {
    return described(std::string(name_of(simd_level())) + (way_ == DistanceWay::cached ? ", cached" : ""));
  }

  std::string obstacle(Task task, int threads) const override {
    if (way_ == DistanceWay::alone) return {};
    if (task != Task::coherent_distance) return "keeps nothing for this";
    return threads > 1 ? "a cache is for one thread" : "";
  }

  void build(const TriangleMesh& a, const TriangleMesh& b) override {
    // Models share their mesh with whoever made it; this one does not own it.
    a_.emplace(std::shared_ptr<const TriangleMesh>(std::shared_ptr<void>(), &a));
    b_.emplace(std::shared_ptr<const TriangleMesh>(std::shared_ptr<void>(), &b));
    cache_.clear();
  }

  std::size_t bytes() const override { return bytes_of(a_->wide_bvh()) + bytes_of(b_->wide_bvh()); }

  bool spreads_queries(Task task, int threads) override {
    threads_ = task == Task::contacts ? threads : 1;
    return threads_ > 1;
  }

  Answer answer(Task task, const PosePair& poses) const override {
    // As surfaces, since that is what the peers answer about.
    const PairQuery query{poses.a, poses.b, Solid::none, Solid::none, threads_};
    thread_local Workspace workspace;
    if (task == Task::overlap) return {overlap(*a_, *b_, query, workspace), {}};
    if (asks_distance(task)) return distance_answer(query);
    const auto found = contacts(*a_, *b_, query, workspace);
    Answer answer;
    answer.pairs.reserve(found.size());
    for (const Contact& contact : found) answer.pairs.emplace_back(contact.element_a, contact.element_b);
    answer.overlap = !answer.pairs.empty();
    return answer;
  }

 private:
  /// Where the queries have nothing to do with each other, what was nearest before helps none of them.
  Answer distance_answer(const PairQuery& query) const {
    thread_local Workspace workspace;
    const Distance found =
        way_ == DistanceWay::cached ? distance(*a_, *b_, query, cache_) : distance(*a_, *b_, query, workspace);
    return {found.upper == 0, {{found.element_a, found.element_b}}, found.upper};
  }

  DistanceWay way_;
  std::optional<Model> a_;
  std::optional<Model> b_;
  int threads_ = 1;
  mutable DistanceCache cache_;
};

using TriangleMethod = bool (*)(const Triangle&, const Triangle&);

class ToccataTriangles : public TriangleLibrary {
 public:
  ToccataTriangles(std::string variant, TriangleMethod method) : variant_(std::move(variant)), method_(method) {}

  Description description() const override { return described(variant_); }
  void prepare(std::span<const TriangleQuestion> questions) override { questions_ = questions; }
  void answer(std::size_t first, std::span<char> answers) const override {
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i] = method_(questions_[first + i].a, questions_[first + i].b) ? 1 : 0;
  }

 private:
  std::string variant_;
  TriangleMethod method_;
  std::span<const TriangleQuestion> questions_;
};

bool meets(const Triangle& a, const Triangle& b) { return intersect(a, b).kind != IntersectionKind::none; }

}  // namespace

MeshLibraries toccata_mesh_libraries() {
  MeshLibraries libraries;
  libraries.push_back(std::make_unique<ToccataMeshes>(DistanceWay::alone));
  libraries.push_back(std::make_unique<ToccataMeshes>(DistanceWay::cached));
  return libraries;
}

TriangleLibraries toccata_triangle_libraries() {
  TriangleLibraries libraries;
  libraries.push_back(std::make_unique<ToccataTriangles>("penetration", overlap_by_penetration));
  libraries.push_back(std::make_unique<ToccataTriangles>(
      "separating axes", static_cast<bool (*)(const Triangle&, const Triangle&)>(overlap_by_separating_axes)));
  libraries.push_back(std::make_unique<ToccataTriangles>("intersection (what is common)", meets));
  return libraries;
}

}  // namespace toccata::bench
