#include <fmt/format.h>

#include <optional>

#include "nearest.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/batch.hpp"

namespace toccata::bench {
namespace {

double distance_of(const SurfacePoint& found) { return 0.5 * (found.lower + found.upper); }

class ToccataNearest : public NearestLibrary {
 public:
  explicit ToccataNearest(std::string variant) : variant_(std::move(variant)) {}

  Description description() const override {
    return {"toccata", variant_, version,
            fmt::format("{}, {} -ffp-contract=off", TOCCATA_BENCH_COMPILER, TOCCATA_BENCH_FLAGS)};
  }
  void prepare(const TriangleMesh& mesh) override { model_.emplace(mesh); }

 protected:
  std::string variant_;
  std::optional<Model> model_;
};

class ArraysOfPoints : public ToccataNearest {
 public:
  using ToccataNearest::ToccataNearest;
  void answer(std::span<const Vec3> points, std::span<double> distances) override {
    BatchOptions options;
    options.threads = 1;
    const auto found = nearest_point_each(points, *model_, {}, options);
    for (std::size_t i = 0; i < found.size(); ++i) distances[i] = distance_of(*found[i]);
  }
};

class SinglePoints : public ToccataNearest {
 public:
  using ToccataNearest::ToccataNearest;
  void answer(std::span<const Vec3> points, std::span<double> distances) override {
    for (std::size_t i = 0; i < points.size(); ++i)
      distances[i] = distance_of(*nearest_point(points[i], *model_, {}, workspace_));
  }

 private:
  Workspace workspace_;
};

}  // namespace

NearestLibraries toccata_nearest_libraries() {
  NearestLibraries libraries;
  libraries.push_back(std::make_unique<ArraysOfPoints>("arrays of points"));
  libraries.push_back(std::make_unique<SinglePoints>("one point, posed for each"));
  return libraries;
}

}  // namespace toccata::bench
