#include <CGAL/Box_intersection_d/Box_d.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include <algorithm>

#include "broad.hpp"

namespace toccata::bench {
namespace {

class Numbered : public CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_NONE> {
 public:
  Numbered(const Aabb& box, Index number)
      : Box_d(std::array{box.lower.x, box.lower.y, box.lower.z}.data(),
              std::array{box.upper.x, box.upper.y, box.upper.z}.data()),
        number_(number) {}
  using ID = std::size_t;
  [[nodiscard]] ID id() const { return number_; }
  [[nodiscard]] Index number() const { return number_; }

 private:
  Index number_;
};

class CgalBroad final : public BroadLibrary {
 public:
  Description description() const override {
    return {"cgal", "box_self_intersection_d", CGAL_VERSION_STR, "-O3 -DNDEBUG"};
  }
  void add(std::span<const Aabb>) override {}
  void step(std::span<const Index>, std::span<const Aabb> boxes) override {
    numbered_.clear();
    for (Index number = 0; number < boxes.size(); ++number) numbered_.emplace_back(boxes[number], number);
    pairs_.clear();
    CGAL::box_self_intersection_d(numbered_.begin(), numbered_.end(), [&](const Numbered& a, const Numbered& b) {
      pairs_.push_back({std::min(a.number(), b.number()), std::max(a.number(), b.number())});
    });
  }
  std::vector<IndexPair> pairs() const override { return pairs_; }

 private:
  std::vector<Numbered> numbered_;
  std::vector<IndexPair> pairs_;
};

}  // namespace

BroadLibraries cgal_broad_libraries() {
  BroadLibraries libraries;
  libraries.push_back(std::make_unique<CgalBroad>());
  return libraries;
}

}  // namespace toccata::bench
