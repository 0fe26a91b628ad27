// OpenSubdiv refines everything alike and puts the points into the limit; how far the triangles between them are from
// it is not told. Distances from them are Toccata's.
#include <opensubdiv/version.h>

#include <optional>

#include "query/osd_level.hpp"
#include "subdivisions.hpp"
#include "toccata/query/distance.hpp"

namespace toccata::bench {
namespace {

class OsdLimit : public LimitLibrary {
 public:
  [[nodiscard]] Description description() const override {
    return {"osd", "limit points of level " + std::to_string(levels_), std::to_string(OPENSUBDIV_VERSION_NUMBER),
            "-O3 -DNDEBUG"};
  }
  std::vector<Vec3> make(const SubdivisionCage& cage, double within) override {
    if (levels_ == 0) levels_ = levels_for(cage, within);
    const test::PeerLevel level = test::peer_level(cage, levels_);
    std::vector<Vec3> points;
    for (const test::WeightedPoint& p : level.limits) points.push_back(p.at);
    triangles_ = level.triangles;
    return points;
  }
  void make_ready(const SubdivisionCage& cage, double within) override {
    std::vector<Vec3> points = make(cage, within);
    model_.emplace(TriangleMesh(std::move(points), triangles_));
    within_ = within;
  }
  [[nodiscard]] LimitInterval distance(const Model& other, const Pose& pose) override {
    const Distance found = toccata::distance(*model_, other, {.pose_b = pose, .solid_a = Solid::none});
    return {found.lower - within_, found.upper + within_};
  }

 private:
  int levels_ = 0;
  double within_ = 0;
  std::vector<std::array<Index, 3>> triangles_;
  std::optional<Model> model_;
};

}  // namespace

LimitLibraries osd_limit_libraries() {
  LimitLibraries libraries;
  libraries.push_back(std::make_unique<OsdLimit>());
  return libraries;
}

}  // namespace toccata::bench
