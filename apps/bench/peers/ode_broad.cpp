#include <ode/ode.h>

#include <algorithm>

#include "broad.hpp"

namespace toccata::bench {
namespace {

void note_pair(void* pairs, dGeomID one, dGeomID other) {
  const Index a = *static_cast<Index*>(dGeomGetData(one)), b = *static_cast<Index*>(dGeomGetData(other));
  static_cast<std::vector<IndexPair>*>(pairs)->push_back({std::min(a, b), std::max(a, b)});
}

class OdeBroad final : public BroadLibrary {
 public:
  OdeBroad() {
    dInitODE2(0);
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
  }
  OdeBroad(const OdeBroad&) = delete;
  OdeBroad& operator=(const OdeBroad&) = delete;
  ~OdeBroad() override { dSpaceDestroy(space_); }

  Description description() const override {
    return {"ode", "SweepAndPruneSpace", TOCCATA_BENCH_ODE_VERSION, "as packaged"};
  }
  void add(std::span<const Aabb> boxes) override {
    numbers_.resize(boxes.size());
    for (Index number = 0; number < boxes.size(); ++number) {
      const Vec3 size = boxes[number].upper - boxes[number].lower;
      geoms_.push_back(dCreateBox(space_, size.x, size.y, size.z));
      numbers_[number] = number;
      dGeomSetData(geoms_.back(), &numbers_[number]);
      place(number, boxes[number]);
    }
  }
  void step(std::span<const Index> moved, std::span<const Aabb> boxes) override {
    for (const Index number : moved) place(number, boxes[number]);
    pairs_.clear();
    dSpaceCollide(space_, &pairs_, note_pair);
  }
  std::vector<IndexPair> pairs() const override { return pairs_; }

 private:
  void place(Index number, const Aabb& box) {
    const Vec3 centre = 0.5 * (box.lower + box.upper);
    dGeomSetPosition(geoms_[number], centre.x, centre.y, centre.z);
  }
  dSpaceID space_;
  std::vector<dGeomID> geoms_;
  std::vector<Index> numbers_;
  std::vector<IndexPair> pairs_;
};

}  // namespace

BroadLibraries ode_broad_libraries() {
  BroadLibraries libraries;
  libraries.push_back(std::make_unique<OdeBroad>());
  return libraries;
}

}  // namespace toccata::bench
