// An MSP tree against every triangle in rationals: which vertex, edge or face a point lies on, and on which side it
// lies where it is on none.
#include "methods/msp_checks.hpp"
#include "support/case_seeds.hpp"
#include "toccata/core/random.hpp"

namespace toccata::test {
namespace {

/// Up to here the winding number too is computed in rationals; above, it is that of `locate`, which has a sweep.
constexpr Index most_in_rationals = 128;

struct MspSubject {
  explicit MspSubject(NamedMesh named)
      : name(std::move(named.name)),
        model(std::move(named.mesh)),
        tree(model),
        truth(oracle::solid_set(model.mesh(), Pose{})) {}

  [[nodiscard]] Vec3 corner(Index triangle, int i) const { return vertex_of(model.mesh(), triangle, i); }

  std::string name;
  Model model;
  MspTree tree;
  oracle::MeshSet truth;
};

/// Made once.
const std::vector<MspSubject>& msp_subjects() {
  static const std::vector<MspSubject> all = [] {
    std::vector<MspSubject> subjects;
    for (NamedMesh& named : closed_meshes_and_more()) subjects.emplace_back(std::move(named));
    return subjects;
  }();
  return all;
}

/// In the box of the mesh and a little beyond.
Vec3 place_around(const MspSubject& subject, Random& random) {
  const Aabb& box = subject.model.bounds();
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = box.lower[axis] + random.between(-0.1, 1.1) * (box.upper[axis] - box.lower[axis]);
  return p;
}

/// One of 1/8 to 7/8: on a grid, what is so far along an edge is a double.
double eighths(Random& random) { return 0.125 * static_cast<double>(1 + random.below(7)); }

/// On the plane of a triangle, mostly beyond it; or level with vertices, on planes across axes.
Vec3 on_extension(const MspSubject& subject, const std::array<Vec3, 3>& corners, Random& random) {
  const auto& [a, b, c] = corners;
  const auto steps = [&] { return static_cast<double>(random.below(9)) - 4; };
  if (random.below(2) == 0) return a + (steps() * (b - a) + steps() * (c - a));
  Vec3 level = place_around(subject, random);
  const int axis = static_cast<int>(random.below(3));
  level[axis] = a[axis];
  if (random.below(2) == 0) level[(axis + 1) % 3] = b[(axis + 1) % 3];
  return level;
}

Vec3 point_of(const std::string& family, const MspSubject& subject, Random& random) {
  const auto t = static_cast<Index>(random.below(subject.model.mesh().triangle_count()));
  const int i = static_cast<int>(random.below(3));
  const Vec3 a = subject.corner(t, i), b = subject.corner(t, i + 1), c = subject.corner(t, i + 2);
  if (family == "in space") return place_around(subject, random);
  if (family == "on vertices") return a;
  if (family == "on edges") return a + eighths(random) * (b - a);
  if (family == "on faces") return a + (eighths(random) * (b - a) + 0.125 * (c - b));
  return on_extension(subject, {a, b, c}, random);
}

std::string location_fault(const MspSubject& subject, const Vec3& p) {
  const MspLocation found = subject.tree.locate(p), truth = location_by_all(p, subject.model);
  if (found.side != truth.side || found.winding_number != truth.winding_number) return "located otherwise";
  if (found.triangle != truth.triangle) return "another triangle";
  if (!(found.feature == truth.feature)) return "another feature";
  if (subject.model.mesh().triangle_count() > most_in_rationals) return "";
  const oracle::Location slow = oracle::locate(oracle::exact(p), subject.truth);
  if ((found.side == Side::boundary) != slow.on_face) return "on the surface otherwise than in rationals";
  return found.winding_number == slow.winding_number ? "" : "another winding number than in rationals";
}

/// The last place beside it, in some direction.
Vec3 beside(Vec3 p, Random& random) {
  const int axis = static_cast<int>(random.below(3));
  p[axis] = std::nextafter(p[axis], random.below(2) == 0 ? -HUGE_VAL : HUGE_VAL);
  return p;
}

SweepResult run_msp_trees(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return run_cases(family, seed, cases, [&](std::uint64_t case_seed) -> std::string {
    Random random(case_seed);
    const std::vector<MspSubject>& all = msp_subjects();
    const MspSubject& subject = all[random.below(all.size())];
    const Vec3 p = point_of(family, subject, random);
    for (const Vec3& q : {p, beside(p, random)}) {
      const std::string fault = is_finite(q) ? location_fault(subject, q) : "";
      if (!fault.empty()) return subject.name + ": " + fault;
    }
    return "";
  });
}

const bool msp_trees_known = register_sweep({"msp-trees",
                                             {"in space", "on vertices", "on edges", "on faces", "on extensions"},
                                             10'000,
                                             300,
                                             run_msp_trees,
                                             1'000,
                                             12});

}  // namespace
}  // namespace toccata::test
