#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/world/character_mover.hpp>

#include "object_questions.hpp"
#include "values.hpp"

// The character mover (world/character_mover.hpp), bound once for levels that are a SceneIndex and for Worlds.
namespace toccata::python {

template <class Objects, class Bound>
class CharacterQuestions {
 public:
  using Id = typename Objects::Id;
  using State = MoverState<Id>;
  using Step = MoverStep<Id>;
  using Hit = MoverContact<Id>;
  using Told = ObjectsTold<Objects>;

  CharacterQuestions(nb::module_& module, nb::class_<Bound>& bound, std::string prefix)
      : module_(module), bound_(bound), prefix_(std::move(prefix)) {}

  void bind() {
    bind_contact();
    bind_state();
    bind_step();
    bind_question();
  }

 private:
  [[nodiscard]] std::string name(const char* kind) const { return prefix_ + kind; }

  static nb::tuple state_of_hit(const Hit& hit) {
    return nb::make_tuple(hit.object, hit.element, tuple_of(hit.point), tuple_of(hit.normal));
  }
  static Hit hit_of_state(const nb::tuple& state) {
    if (state.size() != 4) throw Error("a pickled contact of a character of another version");
    return {nb::cast<Id>(state[0]), nb::cast<Index>(state[1]), vector_of(nb::object(state[2]), "point"),
            vector_of(nb::object(state[3]), "normal")};
  }

  static nb::tuple state_of_step(const Step& step) {
    return nb::make_tuple(step.state, tuple_of(step.moved), tuple_of(step.carried), tuple_of(step.pushed_out),
                          step.contacts, step.met_wall, step.met_ceiling, step.stepped, step.tight, step.stuck,
                          step.crushed, step.cut_short);
  }
  static Step step_of_state(const nb::tuple& state) {
    if (state.size() != 12) throw Error("a pickled step of a character of another version");
    const auto told = [&](std::size_t i) { return nb::cast<bool>(state[i]); };
    return {nb::cast<State>(state[0]),
            vector_of(nb::object(state[1]), "moved"),
            vector_of(nb::object(state[2]), "carried"),
            vector_of(nb::object(state[3]), "pushed_out"),
            nb::cast<std::vector<Hit>>(state[4]),
            told(5),
            told(6),
            told(7),
            told(8),
            told(9),
            told(10),
            told(11)};
  }

  void bind_contact() {
    nb::class_<Hit> bound(module_, name("MoverContact").c_str(),
                          "Something that a character stands on, or met on its way.");
    bound.def_ro("object", &Hit::object, "Which.")
        .def_ro("element", &Hit::element, "The element, of a mesh the triangle.")
        .def_prop_ro(
            "point", [](const Hit& hit) { return array_of(hit.point); }, "The nearest of the object, shape (3,).")
        .def_prop_ro(
            "normal", [](const Hit& hit) { return array_of(hit.normal); }, "Unit, from there to the shape; shape (3,).")
        .def("__repr__", [kind = name("MoverContact")](const Hit& hit) {
          return fmt::format("<toccata.{} at element {}>", kind, hit.element);
        });
    bind_answer_value(bound, &state_of_hit, &hit_of_state);
  }

  void bind_state() {
    nb::class_<State> bound(module_, name("MoverState").c_str(),
                            "Where a character is: all that is known of it from one step to the next. Its pose is in "
                            "the world. Raises Error for what is no pose.");
    bound
        .def(
            "__init__",
            [](State* place, const PoseLike& pose, const std::optional<Hit>& ground) {
              new (place) State{pose_of(pose, "pose"), ground};
            },
            nb::arg("pose") = nb::none(), nb::arg("ground") = nb::none())
        .def_ro("pose", &State::pose, "Of the shape; a step changes its offset alone.")
        .def_ro("ground", &State::ground, "What it stands on; None: it is in the air.")
        .def("__repr__", [kind = name("MoverState")](const State& state) {
          const Vec3 at = state.pose.offset;
          return fmt::format("<toccata.{} at ({}, {}, {}), {}>", kind, at.x, at.y, at.z,
                             state.ground ? "on ground" : "in the air");
        });
    bind_value(bound, [](const State& state) { return nb::make_tuple(state.pose, state.ground); });
  }

  void bind_step() {
    const auto vector_told = [](Vec3 Step::*member) {
      return [member](const Step& step) { return array_of(step.*member); };
    };
    nb::class_<Step> bound(module_, name("MoverStep").c_str(), "What came of a step of a character.");
    bound.def_ro("state", &Step::state, "Where it is now.")
        .def_prop_ro("moved", vector_told(&Step::moved), "By how much in all, shape (3,).")
        .def_prop_ro("carried", vector_told(&Step::carried), "By how much of it on or by objects that moved.")
        .def_prop_ro("pushed_out", vector_told(&Step::pushed_out), "And out of what it began in.")
        .def_ro("contacts", &Step::contacts, "Met by its own motion, in the order in which they were.")
        .def_ro("met_wall", &Step::met_wall, "One of them is too steep to be walked on.")
        .def_ro("met_ceiling", &Step::met_ceiling, "One faces down as ground faces up.")
        .def_ro("stepped", &Step::stepped, "Up a step.")
        .def_ro("tight", &Step::tight, "It is still nearer to something than it stays.")
        .def_ro("stuck", &Step::stuck, "It still overlaps something: there was no way out.")
        .def_ro("crushed", &Step::crushed, "Something that moved its way could not push it aside.")
        .def_ro("cut_short", &Step::cut_short, "It may not have gone as far as it can; the contacts tell why.")
        .def("__repr__", [kind = name("MoverStep")](const Step& step) {
          return fmt::format("<toccata.{}: moved ({}, {}, {}), {} contacts>", kind, step.moved.x, step.moved.y,
                             step.moved.z, step.contacts.size());
        });
    bind_answer_value(bound, &state_of_step, &step_of_state);
  }

  static std::vector<MovedObject<Id>> moved_objects(nb::handle given) {
    std::vector<MovedObject<Id>> moved;
    if (given.is_none()) return moved;
    if (!is_list(given)) throw Error("moved: a list of pairs (object, pose before) is needed");
    for (const nb::handle each : given) {
      Id id{};
      if (!PyTuple_Check(each.ptr()) || nb::len(each) != 2 || !nb::try_cast(nb::object(each[0]), id))
        throw Error(fmt::format("moved: entry {} is no pair (object, pose before)", moved.size()));
      moved.push_back({id, pose_of(nb::object(each[1]), fmt::format("moved, entry {}", moved.size()))});
    }
    return moved;
  }

  void bind_question() {
    bound_.def(
        "move_character",
        [](const Bound& bound, const AnyShape& shape, const State& start, const ArrayLike& motion,
           const MoverOptions& options, const nb::object& only, const nb::object& moved) {
          const Vec3 way = vector_of(motion, "motion");
          const auto objects = moved_objects(moved);
          const auto filter = Told::filter_of(bound, only);
          return without_lock([&, copy = shape.model, from = start, chosen = options] {
            return bound.ask([&](const ObjectQueries<Objects>& level) {
              return move_character(level, copy, from, way, chosen, filter, std::span<const MovedObject<Id>>(objects));
            });
          });
        },
        nb::arg("shape"), nb::arg("start"), nb::arg("motion"), nb::arg("options") = MoverOptions{}, nb::kw_only(),
        nb::arg("only") = nb::none(), nb::arg("moved") = nb::none(), nb::sig(signature_.c_str()),
        "One step of a character: a convex shape goes from a state by `motion`, shape (3,) in the world and the unit "
        "of "
        "the coordinates, as far as these objects let it, and slides along what it meets; nothing tunnels, which is "
        "proved. On ground a motion that has no part "
        "along "
        "`up` is walked, over slopes, up and down steps. `moved` tells what was elsewhere before the step: pairs "
        "(object, "
        "pose before). Raises Error when a number is not finite, the shape is of another kind, or an object is not "
        "here.");
  }

  nb::module_& module_;
  nb::class_<Bound>& bound_;
  std::string prefix_;
  std::string signature_ = fmt::format(
      "def move_character(self, shape: Shape, start: {0}MoverState, motion: numpy.typing.ArrayLike, options: "
      "MoverOptions "
      "= ..., *, only: {1} | None = None, moved: collections.abc.Sequence[tuple[{2}, toccata._typing.PoseLike | None]] "
      "| "
      "None = None) -> {0}MoverStep",
      prefix_, std::is_same_v<Id, Index> ? "numpy.typing.ArrayLike" : "BodyFilter",
      std::is_same_v<Id, Index> ? "int" : "BodyId");
};

}  // namespace toccata::python
