#include <nanobind/nanobind.h>

#include <memory>
#include <mutex>

#include <fmt/format.h>

#include <toccata/query/distance_cache.hpp>

#include "described.hpp"
#include "pair_arguments.hpp"
#include "values.hpp"

namespace toccata::python {
namespace {

/// A DistanceCache as Python holds it: one thread uses it at a time.
struct HeldCache {
  std::unique_ptr<std::mutex> mutex = std::make_unique<std::mutex>();
  std::unique_ptr<DistanceCache> cache = std::make_unique<DistanceCache>();

  template <class Use>
  auto with(const Use& use) const {
    const nb::gil_scoped_release released;
    const std::lock_guard guard(*mutex);
    return use(*cache);
  }
};

}  // namespace

void bind_caches(nb::module_& module) {
  nb::class_<HeldCache> bound(
      module, "DistanceCache",
      "What is kept of one question of distance for the next about the same two meshes, which have moved "
      "little in between. It changes no bit of any answer. It belongs to the first two meshes asked about. "
      "Lengths are in the unit of the coordinates (what holds for a while: J. Basch, J. Erickson, L. Guibas, J. "
      "Hershberger, L. Zhang, \"Kinetic collision detection between two simple polygons\", 1999).");
  bound.def("__init__", [](HeldCache* place) { new (place) HeldCache(); })
      .def(
          "distance",
          [](const HeldCache& held, const AnyShape& a, const AnyShape& b, const PoseLike& pose_a,
             const PoseLike& pose_b, Solid solid_a, Solid solid_b) {
            const PairQuery query = query_of(pose_a, pose_b, solid_a, solid_b);
            return held.with(
                [&, x = a.model, y = b.model](DistanceCache& cache) { return distance(x, y, query, cache); });
          },
          nb::arg("a"), nb::arg("b"), nb::arg("pose_a") = nb::none(), nb::arg("pose_b") = nb::none(), nb::kw_only(),
          nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
          "What distance answers, to the last bit, in the unit of the coordinates. Raises Error like it, and for "
          "another mesh "
          "than the first time.")
      .def(
          "clear", [](const HeldCache& held) { held.with([](DistanceCache& cache) { cache.clear(); }); },
          "Forgets everything, also which meshes it was used for.")
      .def_prop_ro(
          "questions",
          [](const HeldCache& held) {
            return held.with([](const DistanceCache& cache) { return cache.counts().questions; });
          },
          "How many were asked with it.")
      .def_prop_ro(
          "searches",
          [](const HeldCache& held) {
            return held.with([](const DistanceCache& cache) { return cache.counts().searches; });
          },
          "Of them, those that were searched as without a cache.")
      .def("__repr__", [](const HeldCache&) { return "<toccata.DistanceCache>"; });
  bind_refusal(bound, "make a new one, with which all answers are the same");
}

}  // namespace toccata::python
