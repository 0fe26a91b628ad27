#include <fmt/format.h>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/version.hpp>

#include "partitions.hpp"

namespace toccata::bench {
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Value = std::pair<Box, Index>;

Box box_of(const Aabb& box) {
  return {{box.lower.x, box.lower.y, box.lower.z}, {box.upper.x, box.upper.y, box.upper.z}};
}

enum class Filling { packed, one_by_one };

template <class Parameters>
class BoostTree final : public PartitionLibrary {
 public:
  BoostTree(const char* variant, Filling filling) : variant_(variant), filling_(filling) {}

  [[nodiscard]] Description description() const override {
    return {"boost", variant_, fmt::format("{}.{}", BOOST_VERSION / 100'000, BOOST_VERSION / 100 % 1'000),
            "-O3 -DNDEBUG"};
  }
  void build(std::span<const Aabb> boxes) override {
    values_.clear();
    for (Index number = 0; number < boxes.size(); ++number) values_.emplace_back(box_of(boxes[number]), number);
    tree_ = filling_ == Filling::packed ? Tree(values_) : Tree();
    if (filling_ == Filling::one_by_one)
      for (const Value& value : values_) tree_.insert(value);
  }
  [[nodiscard]] std::size_t bytes() const override { return 0; }
  [[nodiscard]] std::vector<Index> overlapping(const Aabb& box) const override {
    std::vector<Index> found;
    tree_.query(geometry::index::intersects(box_of(box)), numbers_into(found));
    return found;
  }
  [[nodiscard]] std::vector<IndexPair> pairs() const override {
    std::vector<IndexPair> pairs;
    std::vector<Index> found;
    for (const auto& [box, number] : values_) {
      found.clear();
      tree_.query(geometry::index::intersects(box), numbers_into(found));
      for (const Index other : found)
        if (number < other) pairs.push_back({number, other});
    }
    return pairs;
  }

 private:
  using Tree = geometry::index::rtree<Value, Parameters>;

  static auto numbers_into(std::vector<Index>& found) {
    return boost::make_function_output_iterator([&found](const Value& value) { found.push_back(value.second); });
  }

  const char* variant_;
  Filling filling_;
  std::vector<Value> values_;
  Tree tree_;
};

}  // namespace

PartitionLibraries boost_partitions() {
  using namespace geometry::index;
  PartitionLibraries all;
  all.push_back(std::make_unique<BoostTree<quadratic<16>>>("R-tree of 16, packed", Filling::packed));
  all.push_back(std::make_unique<BoostTree<quadratic<16>>>("R-tree of 16, quadratic, box by box", Filling::one_by_one));
  all.push_back(std::make_unique<BoostTree<rstar<16>>>("R*-tree of 16, box by box", Filling::one_by_one));
  return all;
}

}  // namespace toccata::bench
