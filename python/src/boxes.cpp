#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/broad/broad_phase.hpp>
#include <toccata/core/error.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {
namespace {

Indices index_pairs_told(std::vector<IndexPair> pairs) {
  static_assert(sizeof(IndexPair) == 2 * sizeof(Index));
  return nb::borrow<Indices>(array_over<Index>(std::move(pairs), {2}));
}

/// A BroadPhase as Python holds it: as HeldWorld.
class HeldBoxes {
 public:
  explicit HeldBoxes(const BroadPhaseOptions& options) : phase_(options) {}

  template <class Use>
  auto with(const Use& use) const {
    const nb::gil_scoped_release released;
    const std::lock_guard guard(*mutex_);
    return use(phase_);
  }

 private:
  std::unique_ptr<std::mutex> mutex_ = std::make_unique<std::mutex>();
  mutable BroadPhase phase_;
};

BroadPhaseOptions options_of(const std::string& method, int threads) {
  return {.method = broad_phase_method(method), .threads = threads};
}

/// overlapping_pairs, which `look` may end by what it throws: it is called now and then as pairs are found.
std::vector<IndexPair> looking_pairs(std::span<const Aabb> boxes, const BroadPhaseOptions& options,
                                     const Progress& look) {
  constexpr unsigned between = 512;  // pairs, of which millions are found in a tenth of a second
  std::exception_ptr ending;
  std::atomic<bool> ended = false;
  const auto asker = std::this_thread::get_id();
  const auto looked_for = [&](const IndexPair&) {
    thread_local unsigned seen = 0;
    if (++seen % between != 0) return true;
    if (std::this_thread::get_id() == asker && !ended) try {
        look(0, 0);
      } catch (...) {
        ending = std::current_exception();
        ended = true;
      }
    if (ended) throw Error("ended");  // on all threads
    return true;
  };
  try {
    return overlapping_pairs(boxes, options, looked_for);
  } catch (...) {
    if (ended) std::rethrow_exception(ending);
    throw;
  }
}

std::size_t boxes_in_use(const BroadPhase& phase) {
  std::size_t count = 0;
  for (Index number = 0; number < phase.size(); ++number) count += phase.in_use(number) ? 1 : 0;
  return count;
}

std::vector<IndexPair> kept(std::span<const IndexPair> pairs) { return {pairs.begin(), pairs.end()}; }

void bind_overlapping_pairs(nb::module_& module) {
  module.def(
      "overlapping_pairs",
      [](const ArrayLike& boxes, const std::string& method, int threads) {
        const std::vector<Aabb> given = boxes_of(boxes, "boxes");
        const BroadPhaseOptions options = options_of(method, threads);
        return index_pairs_told(Interruptible(threads).ask(
            [&](const BatchOptions& batch) { return looking_pairs(given, options, batch.progress); }));
      },
      nb::arg("boxes"), nb::kw_only(), nb::arg("method") = "auto", nb::arg("threads") = all_threads,
      "Which of many boxes overlap, touching included: shape (N, 2, 3), of each the least corner and the greatest. "
      "Pairs of "
      "indices, shape (K, 2), ascending. In the world and any unit. All methods ('auto', 'brute-force', "
      "'sort-and-sweep' …) find the same. Raises "
      "Error "
      "naming a box of which a side is no number.");
}

void bind_broad_phase(nb::module_& module) {
  nb::class_<HeldBoxes> bound(module, "BroadPhase",
                              R"(Boxes that move, and the pairs of them that overlap; touching counts.

Boxes have the shape (N, 2, 3), in the world and any unit, and numbers that stay theirs until they are removed. One thread
uses it at a time. Raises Error for a method that there is not.)");
  bound
      .def(
          "__init__",
          [](HeldBoxes* place, const std::string& method, int threads) {
            new (place) HeldBoxes(options_of(method, threads));
          },
          nb::kw_only(), nb::arg("method") = "auto", nb::arg("threads") = own_thread)
      .def(
          "add",
          [](const HeldBoxes& held, const ArrayLike& boxes) {
            const std::vector<Aabb> given = boxes_of(boxes, "boxes");
            return nb::borrow<Indices>(
                array_over<Index>(held.with([&](BroadPhase& phase) { return phase.add(given); }), {}));
          },
          nb::arg("boxes"),
          "The numbers given to the boxes, shape (N, 2, 3), in their order. Raises Error naming a box of "
          "which a side is no number.")
      .def(
          "remove",
          [](const HeldBoxes& held, const ArrayLike& numbers) {
            const std::vector<Index> given = indices_of(numbers, 1, "numbers");
            held.with([&](BroadPhase& phase) { phase.remove(given); });
          },
          nb::arg("numbers"),
          "Removes boxes by their numbers, shape (N,). Raises Error naming a number that is in use no "
          "more.")
      .def(
          "move",
          [](const HeldBoxes& held, const ArrayLike& numbers, const ArrayLike& boxes) {
            const std::vector<Index> given = indices_of(numbers, 1, "numbers");
            const std::vector<Aabb> places = boxes_of(boxes, "boxes");
            held.with([&](BroadPhase& phase) { phase.move(given, std::span<const Aabb>(places)); });
          },
          nb::arg("numbers"), nb::arg("boxes"),
          "Gives box numbers[i] the place boxes[i], shapes (N,) and (N, 2, 3). Raises Error "
          "like add and remove.")
      .def(
          "update",
          [](const HeldBoxes& held) {
            return index_pairs_told(held.with([](BroadPhase& phase) { return kept(phase.update()); }));
          },
          "The pairs of the boxes as they are now, shape (K, 2), ascending. Ctrl-C is taken when they are found.")
      .def(
          "changes",
          [](const HeldBoxes& held) {
            PairChanges changes = held.with([](const BroadPhase& phase) { return phase.changes(); });
            return nb::make_tuple(index_pairs_told(std::move(changes.begin)), index_pairs_told(std::move(changes.end)));
          },
          "Pairs that the last update found and the one before did not, and the reverse.",
          nb::sig("def changes(self) -> tuple[toccata._typing.Indices, toccata._typing.Indices]"))
      .def_prop_ro(
          "method",
          [](const HeldBoxes& held) {
            return std::string(held.with([](const BroadPhase& phase) { return name_of(phase.method()); }));
          },
          "That of the last update, never 'auto'.")
      .def("__len__",
           [](const HeldBoxes& held) { return held.with([](const BroadPhase& phase) { return phase.size(); }); })
      .def("__repr__", [](const HeldBoxes& held) {
        return held.with([](const BroadPhase& phase) {
          return fmt::format("<toccata.BroadPhase of {} boxes>", boxes_in_use(phase));
        });
      });
  bind_refusal(bound, "keep the boxes where they come from, and add them to a new BroadPhase");
}

}  // namespace

void bind_boxes(nb::module_& module) {
  bind_overlapping_pairs(module);
  bind_broad_phase(module);
}

}  // namespace toccata::python
