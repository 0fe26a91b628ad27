#include <fmt/format.h>

#include <optional>

#include "refits.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata::bench {
namespace {

ProbeAnswers answers_of(const Model& model, const Probes& probes) {
  ProbeAnswers answers;
  PairQuery query;
  query.solid_a = Solid::none;
  for (const Segment& segment : probes.segments) answers.segments.push_back(overlap(model, segment, query));
  for (const auto& [centre, radius] : probes.balls) {
    query.pose_b.offset = centre;
    answers.balls.push_back(overlap(model, Sphere(radius), query));
  }
  return answers;
}

Description described(std::string variant) {
  return {"toccata", std::move(variant), version,
          fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
}

/// The boxes of the tree alone, as peers do.
class ToccataTree : public RefitLibrary {
 public:
  explicit ToccataTree(int threads) : threads_(threads) {}
  Description description() const override { return described("the tree's boxes"); }
  void build(const TriangleMesh& mesh) override {
    mesh_.emplace(mesh);
    tree_ = Model(mesh).wide_bvh();
  }
  void give(const TriangleMesh& mesh) override { mesh_.emplace(mesh); }
  void refit() override { static_cast<void>(toccata::refit(tree_, *mesh_, threads_)); }
  ProbeAnswers answers(const Probes&) override { return {}; }

 private:
  int threads_;
  std::optional<TriangleMesh> mesh_;
  WideBvh tree_;
};

/// Model::deform: also what copies the triangles and looks whether all vertices are finite.
class ToccataModel : public RefitLibrary {
 public:
  explicit ToccataModel(int threads) : threads_(threads) {}
  Description description() const override { return described("Model::deform"); }
  void build(const TriangleMesh& mesh) override { model_.emplace(mesh); }
  void give(const TriangleMesh& mesh) override { vertices_.assign(mesh.vertices().begin(), mesh.vertices().end()); }
  void refit() override { static_cast<void>(model_->deform(std::move(vertices_), threads_)); }
  ProbeAnswers answers(const Probes& probes) override { return answers_of(*model_, probes); }

 private:
  int threads_;
  std::optional<Model> model_;
  std::vector<Vec3> vertices_;
};

}  // namespace

RefitLibraries toccata_refit_libraries(int threads) {
  RefitLibraries libraries;
  libraries.push_back(std::make_unique<ToccataTree>(threads));
  libraries.push_back(std::make_unique<ToccataModel>(threads));
  return libraries;
}

}  // namespace toccata::bench
