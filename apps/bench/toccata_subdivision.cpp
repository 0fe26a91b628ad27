#include <optional>
#include <string>

#include "subdivisions.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::bench {
namespace {

std::vector<Vec3> vertices_of(const SubdividedMesh& mesh) {
  return {mesh.mesh.vertices().begin(), mesh.mesh.vertices().end()};
}

class WhereNeeded : public LimitLibrary {
 public:
  [[nodiscard]] Description description() const override {
    const std::string size = triangles_ == 0 ? "" : ", " + std::to_string(triangles_) + " triangles";
    return {"toccata", "where needed" + size, version, TOCCATA_BENCH_FLAGS};
  }
  std::vector<Vec3> make(const SubdivisionCage& cage, double within) override {
    const SubdividedMesh mesh = refine(cage, {.tolerance = within});
    triangles_ = mesh.mesh.triangle_count();
    return vertices_of(mesh);
  }
  void make_ready(const SubdivisionCage& cage, double within) override {
    cage_ = cage;
    within_ = within;
  }
  [[nodiscard]] LimitInterval distance(const Model& other, const Pose& pose) override {
    const LimitDistance found =
        toccata::distance(*cage_, other, {.pair = {.pose_b = pose, .solid_a = Solid::none}, .tolerance = 2 * within_});
    return {found.lower, found.upper};
  }

 private:
  Index triangles_ = 0;
  std::optional<SubdivisionCage> cage_;
  double within_ = 0;
};

class Everything : public LimitLibrary {
 public:
  [[nodiscard]] Description description() const override {
    return {"toccata", "everything alike, level " + std::to_string(levels_), version, TOCCATA_BENCH_FLAGS};
  }
  std::vector<Vec3> make(const SubdivisionCage& cage, double within) override {
    if (levels_ == 0) levels_ = levels_for(cage, within);
    return vertices_of(refine(cage, {.levels = levels_}));
  }
  void make_ready(const SubdivisionCage& cage, double within) override {
    levels_ = levels_for(cage, within);
    const SubdividedMesh mesh = refine(cage, {.levels = levels_});
    within_ = mesh.distance_to_limit;
    model_.emplace(mesh.mesh);
  }
  [[nodiscard]] LimitInterval distance(const Model& other, const Pose& pose) override {
    const Distance found = toccata::distance(*model_, other, {.pose_b = pose, .solid_a = Solid::none});
    return {found.lower - within_, found.upper + within_};
  }

 private:
  int levels_ = 0;
  double within_ = 0;
  std::optional<Model> model_;
};

}  // namespace

int levels_for(const SubdivisionCage& cage, double within) {
  for (int levels = 1; levels < 12; ++levels) {
    const SubdividedMesh mesh = refine(cage, {.levels = levels});
    if (mesh.distance_to_limit <= within) return levels;
    if (mesh.status != Status::exact && mesh.deepest_level < levels) break;
  }
  throw Error("refining everything alike would need more than four million triangles: choose a larger --within");
}

LimitLibraries toccata_limit_libraries() {
  LimitLibraries libraries;
  libraries.push_back(std::make_unique<WhereNeeded>());
  libraries.push_back(std::make_unique<Everything>());
  return libraries;
}

std::vector<std::string> limit_peers() { return {"osd"}; }

}  // namespace toccata::bench
