// A BSP tree against the answers of the model that it was made of: in general places, and on the mesh's vertices, edges
// and faces, and on what these extend to.
#include "methods/bsp_checks.hpp"
#include "support/case_seeds.hpp"

namespace toccata::test {
namespace {

/// What a case is asked about.
struct BspCase {
  BspCase(const BspSubject& of, Random& random)
      : subject(of), points(telling_points(of.model, 24, random.below(std::uint64_t{1} << 32))) {}

  [[nodiscard]] Vec3 point(Random& random) const { return points[random.below(points.size())]; }
  [[nodiscard]] Vec3 place(Random& random) const {
    const Aabb& box = subject.model.bounds();
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = box.lower[axis] + random.between(-0.3, 1.3) * (box.upper[axis] - box.lower[axis]);
    return p;
  }

  const BspSubject& subject;
  std::vector<Vec3> points;
};

std::string fault_of_move(const BspCase& c, const PlacedPolytope& placed, const Vec3& motion, bool is_traced) {
  const std::optional<ShapeHit> truth =
      cast_shape(model_of_placed(placed), motion, c.subject.model, PairQuery{.pose_a = placed.pose});
  return is_traced ? trace_fault(c.subject, placed, motion, truth) : cast_fault(c.subject, placed, motion, truth);
}

std::string fault_of(const std::string& family, const BspCase& c, Random& random) {
  const BspSubject& subject = c.subject;
  if (family == "points") return located_fault(subject, c.point(random));
  const Vec3 from = c.point(random), to = c.point(random), way = to - from;
  if (family == "rays") return way == Vec3{} || !is_finite(way) ? "" : ray_fault(subject, from, way);
  if (family == "segments") return segment_fault(subject, from, to);
  // Nothing that is turned is as small as the least doubles.
  const bool is_telling = family.ends_with(" on planes") || subject.name == "denormal";
  const PlacedPolytope placed = is_telling ? telling_placed(c.points, subject.size(), random)
                                           : random_placed(c.place(random), subject.size(), random);
  if (family.starts_with("shapes")) return shape_fault(subject, placed);
  const Vec3 motion = is_telling ? way : c.place(random) - c.place(random);
  return fault_of_move(c, placed, motion, family.starts_with("traces"));
}

SweepResult run_bsp_trees(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) -> std::string {
    Random random(case_seed);
    const std::vector<BspSubject>& all = bsp_subjects();
    std::size_t number = random.below(all.size());
    // A few are enough of those where all is decided by rationals.
    if (is_slow(all[number].name) && random.below(16) != 0) number = 0;
    const std::string fault = fault_of(family, BspCase(all[number], random), random);
    return fault.empty() ? "" : all[number].name + ": " + fault;
  });
}

const bool bsp_trees_known = register_sweep({"bsp-trees",
                                             {"points", "rays", "segments", "shapes", "shapes on planes", "casts",
                                              "casts on planes", "traces", "traces on planes"},
                                             10'000,
                                             60,
                                             run_bsp_trees,
                                             1'000,
                                             12});

}  // namespace
}  // namespace toccata::test
