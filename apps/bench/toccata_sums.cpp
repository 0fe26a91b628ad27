#include <optional>

#include "sums.hpp"
#include "toccata/core/version.hpp"
#include "toccata/methods/minkowski.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata::bench {
namespace {

Description as_toccata(const char* variant) { return {"toccata", variant, std::string(version), TOCCATA_BENCH_FLAGS}; }

/// What both ways need.
class OfHulls : public SumLibrary {
 public:
  void prepare(std::span<const SumPair> pairs) override { pairs_.assign(pairs.begin(), pairs.end()); }

 protected:
  [[nodiscard]] const SumPair& pair(std::size_t i) const { return pairs_[i]; }

 private:
  std::vector<SumPair> pairs_;
};

class ByOverlay final : public OfHulls {
 public:
  [[nodiscard]] Description description() const override { return as_toccata("overlay, SumLocator"); }
  Index make(std::size_t i) override {
    return minkowski_sum(PosedPolytope(pair(i).a), PosedPolytope(pair(i).b)).vertex_count();
  }
  void make_ready() override { ready_.emplace(minkowski_sum(PosedPolytope(pair(0).a), PosedPolytope(pair(0).b))); }
  [[nodiscard]] bool contains(const Vec3& point) override { return ready_->contains(point); }

 private:
  std::optional<SumLocator> ready_;
};

/// Without the overlay: the hull of all sums of vertices, rounded; and without a ready sum: by GJK.
class ByHullOfAll final : public OfHulls {
 public:
  [[nodiscard]] Description description() const override { return as_toccata("hull of all sums, overlap"); }
  Index make(std::size_t i) override {
    std::vector<Vec3> sums;
    for (Index v = 0; v < pair(i).a.vertex_count(); ++v)
      for (Index w = 0; w < pair(i).b.vertex_count(); ++w) sums.push_back(pair(i).a.vertex(v) + pair(i).b.vertex(w));
    return ConvexHull(sums).vertex_count();
  }
  void make_ready() override {
    std::vector<Vec3> mirrored;
    for (Index v = 0; v < pair(0).b.vertex_count(); ++v) mirrored.push_back(-pair(0).b.vertex(v));
    mirrored_.emplace(mirrored);
  }
  /// A and −B moved there.
  [[nodiscard]] bool contains(const Vec3& point) override {
    return overlap(PosedPolytope(pair(0).a), PosedPolytope(*mirrored_, Pose{Mat3{}, point}), &workspace_);
  }

 private:
  std::optional<ConvexHull> mirrored_;
  SimplexCache workspace_;
};

}  // namespace

SumLibraries toccata_sum_libraries() {
  SumLibraries libraries;
  libraries.push_back(std::make_unique<ByOverlay>());
  libraries.push_back(std::make_unique<ByHullOfAll>());
  return libraries;
}

std::vector<std::string> sum_peers() { return {"cgal"}; }

SumLibraries sum_libraries(const std::vector<std::string>& peers) {
  SumLibraries libraries = toccata_sum_libraries();
  if (!peers.empty())
    for (auto& peer : cgal_sum_libraries()) libraries.push_back(std::move(peer));
  return libraries;
}

}  // namespace toccata::bench
