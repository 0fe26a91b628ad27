#include "motions.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nanobind/stl/optional.h>

#include <toccata/core/error.hpp>
#include <toccata/core/parallel.hpp>
#include <toccata/motion/swept_volume.hpp>
#include <toccata/motion/time_of_impact.hpp>

#include "calls.hpp"
#include "described.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {

template <>
struct Described<TimeOfImpact> {
  static constexpr const char* name = "TimeOfImpact";
  static constexpr const char* doc = "When two moving features first meet.";
  static constexpr std::tuple fields{field<TimeOfImpact, &TimeOfImpact::lower>("lower", ""),
                                     field<TimeOfImpact, &TimeOfImpact::upper>("upper", "")};
};

namespace {

using HeldFunction = std::shared_ptr<nb::callable>;

/// A RigidMotion as Python holds it, and the function of Python that tells it, if any: every copy of the motion shares
/// that in its own function.
struct HeldMotion : RigidMotion {
  HeldMotion(RigidMotion motion, std::weak_ptr<nb::callable> of = {})
      : RigidMotion(std::move(motion)), function(std::move(of)) {}

  std::weak_ptr<nb::callable> function;
};

/// What a motion is told by may lead back to it, which Python's collector has to see: but only where no other copy
/// keeps the function.
int visit_motion(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  const auto& function = nb::inst_ptr<HeldMotion>(self)->function;
  if (function.use_count() != 1) return 0;
  const HeldFunction held = function.lock();
  Py_VISIT(held->ptr());
  return 0;
}

int clear_motion(PyObject* self) {
  if (nb::inst_ready(self)) *nb::inst_ptr<HeldMotion>(self) = HeldMotion(Pose{});
  return 0;
}

PyType_Slot motion_slots[] = {{Py_tp_traverse, reinterpret_cast<void*>(visit_motion)},
                              {Py_tp_clear, reinterpret_cast<void*>(clear_motion)},
                              {0, nullptr}};

}  // namespace

RigidMotion motion_of(nb::handle given, std::string_view what) {
  if (nb::isinstance<HeldMotion>(given)) return nb::cast<const HeldMotion&>(given);
  return {pose_of(given, what)};
}

std::vector<RigidMotion> motions_of(nb::handle given, std::string_view what) {
  if (nb::isinstance<HeldMotion>(given)) return {nb::cast<const HeldMotion&>(given)};
  if (!is_list(given)) throw Error(fmt::format("{}: a RigidMotion is needed, or a list of them", what));
  std::vector<RigidMotion> motions;
  for (const nb::handle motion : given) {
    if (!nb::isinstance<HeldMotion>(motion))
      throw Error(fmt::format("{}: entry {} is no RigidMotion", what, motions.size()));
    motions.push_back(nb::cast<const HeldMotion&>(motion));
  }
  return motions;
}

namespace {

nb::list pieces_of(const HeldMotion& motion) {
  nb::list pieces;
  for (const RigidMotion::Piece& piece : motion.pieces())
    pieces.append(nb::make_tuple(piece.begin, piece.end, piece.start,
                                 nb::make_tuple(tuple_of(piece.move.centre), tuple_of(piece.move.axis),
                                                piece.move.turns, tuple_of(piece.move.translation))));
  return pieces;
}

RigidMotion::Piece piece_told_back(nb::handle given, std::size_t number) {
  const auto is_tuple_of = [](nb::handle told, std::size_t count) {
    return (PyTuple_Check(told.ptr()) || PyList_Check(told.ptr())) && nb::len(told) == count;
  };
  const std::string what = fmt::format("pieces, entry {}", number);
  RigidMotion::Piece piece;
  if (!is_tuple_of(given, 4) || !is_tuple_of(nb::object(given[3]), 4) ||
      !nb::try_cast(nb::object(given[0]), piece.begin) || !nb::try_cast(nb::object(given[1]), piece.end) ||
      !nb::try_cast(nb::object(given[3][2]), piece.move.turns))
    throw Error(fmt::format("{}: (begin, end, start, (centre, axis, turns, translation)) is needed", what));
  piece.start = pose_of(nb::object(given[2]), what);
  piece.move.centre = vector_of(nb::object(given[3][0]), what);
  piece.move.axis = vector_of(nb::object(given[3][1]), what);
  piece.move.translation = vector_of(nb::object(given[3][3]), what);
  return piece;
}

RigidMotion of_pieces(const nb::object& given) {
  if (!is_list(given)) throw Error("pieces: a list is needed, as `pieces` of a RigidMotion tells it");
  std::vector<RigidMotion::Piece> pieces;
  for (const nb::handle piece : given) pieces.push_back(piece_told_back(piece, pieces.size()));
  return RigidMotion::of_pieces(std::move(pieces));
}

Making making_of_motion(const HeldMotion& motion) {
  if (motion.pieces().empty())
    throw nb::type_error(
        "a RigidMotion that is told by a function cannot be pickled: pickle what the function is made of, and make the "
        "motion anew (RigidMotion.of)");
  nb::dict named;
  named["pieces"] = pieces_of(motion);
  return {nb::tuple(), named};
}

/// Two that are told by functions are never known to be equal.
bool equal_pieces(const RigidMotion& a, const RigidMotion& b) {
  const auto equal = [](const RigidMotion::Piece& x, const RigidMotion::Piece& y) {
    return x.begin == y.begin && x.end == y.end && x.start == y.start && x.move == y.move;
  };
  return !a.pieces().empty() && std::ranges::equal(a.pieces(), b.pieces(), equal);
}

HeldMotion through(const ArrayLike& times, const PosesLike& poses, const ArrayLike& centre) {
  const Doubles numbers = doubles(times, "times");
  const Poses at = poses_of(poses, "poses");
  if (numbers.shape.size() != 1 || at.is_single() || at.size() != numbers.rows())
    throw Error("times, poses: as many times as poses are needed, two at least");
  std::vector<MotionKey> keys;
  for (std::size_t i = 0; i < at.size(); ++i) keys.push_back({numbers.data[i], at[i]});
  return RigidMotion::through(keys, vector_of(centre, "centre"));
}

/// A function of Python, for threads of C++: what holds it may be copied and ended without the interpreter's lock.
HeldFunction held_without_lock(nb::callable function) {
  const auto end = [](nb::callable* held) {
    if (!nb::is_alive()) return;
    const nb::gil_scoped_acquire acquired;
    delete held;
  };
  return {new nb::callable(std::move(function)), end};
}

HeldMotion by_function(nb::callable pose_at, double speed, double turns, const ArrayLike& centre, double rounding) {
  HeldFunction held = held_without_lock(std::move(pose_at));
  const std::weak_ptr<nb::callable> function = held;
  auto asked_with_lock = [held = std::move(held)](double time) {
    const nb::gil_scoped_acquire acquired;
    const Turns::WithinFunction within;
    const nb::object pose = (*held)(time);
    if (pose.is_none()) throw Error("pose_at returns None: it has to return the pose at that time");
    return pose_of(pose, "what pose_at returns");
  };
  return {RigidMotion::of(std::move(asked_with_lock), {vector_of(centre, "centre"), speed, turns, rounding}), function};
}

using BoundMotion = nb::class_<HeldMotion>;

nb::tuple origin_told() { return nb::make_tuple(0.0, 0.0, 0.0); }

void bind_constructors(BoundMotion& bound) {
  bound
      .def(
          "__init__",
          [](HeldMotion* place, const PoseLike& start, const ArrayLike& translation, double turns,
             const ArrayLike& axis, const ArrayLike& centre) {
            const RigidMove move{vector_of(centre, "centre"), vector_of(axis, "axis"), turns,
                                 vector_of(translation, "translation")};
            new (place) HeldMotion(RigidMotion(pose_of(start, "start"), move));
          },
          nb::arg("start") = nb::none(), nb::arg("translation") = origin_told(), nb::arg("turns") = 0.0,
          nb::arg("axis") = nb::make_tuple(0.0, 0.0, 1.0), nb::arg("centre") = origin_told())
      .def(
          "__init__", [](HeldMotion* place, const nb::object& pieces) { new (place) HeldMotion(of_pieces(pieces)); },
          nb::kw_only(), nb::arg("pieces"),
          nb::sig("def __init__(self, *, pieces: collections.abc.Sequence[tuple[float, float, "
                  "toccata._typing.PoseLike | None, tuple[numpy.typing.ArrayLike, numpy.typing.ArrayLike, float, "
                  "numpy.typing.ArrayLike]]]) -> None"));
}

void bind_makers(BoundMotion& bound) {
  bound
      .def_static(
          "straight",
          [](const PoseLike& start, const ArrayLike& translation) -> HeldMotion {
            return RigidMotion::straight(pose_of(start, "start"), vector_of(translation, "translation"));
          },
          nb::arg("start").none(), nb::arg("translation"),
          "Straight on from a pose by a translation, shape (3,), in the world and the unit of the coordinates, without "
          "a turn. "
          "Raises Error when a number is not finite.")
      .def_static(
          "between",
          [](const PoseLike& start, const PoseLike& end, const ArrayLike& centre) -> HeldMotion {
            return RigidMotion::between(pose_of(start, "start"), pose_of(end, "end"), vector_of(centre, "centre"));
          },
          nb::arg("start").none(), nb::arg("end").none(), nb::arg("centre") = origin_told(),
          "From one pose to another: the centre, a point of the shape's own frame, goes straight on, and the shape "
          "turns about it the shorter way at an even speed. The centre has the shape (3,), in the unit of the "
          "coordinates. "
          "Raises Error when no turn leads from one to the other.")
      .def_static(
          "screw",
          [](const PoseLike& start, const PoseLike& end) -> HeldMotion {
            return RigidMotion::screw(pose_of(start, "start"), pose_of(end, "end"));
          },
          nb::arg("start").none(), nb::arg("end").none(),
          "From one pose to another about one axis and along it (M. Chasles, 1830). Raises Error like between.")
      .def_static("through", &through, nb::arg("times"), nb::arg("poses"), nb::arg("centre") = origin_told(),
                  "Through poses at times, shape (N,), that ascend from 0 to 1, as between each and the next; the "
                  "centre in the "
                  "unit of the coordinates. Raises Error like between, and for other times.")
      .def_static(
          "of", &by_function, nb::arg("pose_at"), nb::kw_only(), nb::arg("speed"), nb::arg("turns") = 0.0,
          nb::arg("centre") = origin_told(), nb::arg("rounding") = 0.0,
          nb::sig("def of(pose_at: collections.abc.Callable[[float], toccata._typing.PoseLike], *, speed: float, "
                  "turns: float = 0.0, centre: numpy.typing.ArrayLike = (0.0, 0.0, 0.0), rounding: float = 0.0) "
                  "-> RigidMotion"),
          "Any motion: where the shape is, told by a function of the time from 0 to 1, and what it never exceeds: "
          "the speed of the point `centre`, shape (3,), of the shape's own frame, in the unit of the coordinates, and "
          "how fast "
          "it turns about it, in whole turns; rounding: how far off the function may be. Answers are true of all "
          "such motions. The function is asked from any thread, with the interpreter's lock, and has to return the "
          "same for the same time; what it raises comes out of the question. Raises Error when a bound is negative "
          "or not finite.");
}

void bind_parts_of_motion(BoundMotion& bound) {
  bound
      .def(
          "at", [](const HeldMotion& motion, double time) { return motion.at(time); }, nb::arg("time"),
          "The pose at a time from 0 to 1, rounded. Raises Error for another time.")
      .def(
          "carrying",
          [](const HeldMotion& motion, const PoseLike& fixed) {
            return HeldMotion(motion.carrying(pose_of(fixed, "fixed")), motion.function);
          },
          nb::arg("fixed"),
          "How something moves that is fixed to the shape: placed by a pose in its frame. Raises Error for what is no "
          "pose.")
      .def_prop_ro("pieces", &pieces_of, "(begin, end, start, (centre, axis, turns, translation)) of each piece.",
                   nb::sig("def pieces(self) -> list[tuple[float, float, Pose, tuple[tuple[float, float, float], "
                           "tuple[float, float, float], float, tuple[float, float, float]]]]"))
      .def("__repr__", [](const HeldMotion& motion) {
        return fmt::format("<toccata.RigidMotion of {} pieces>", motion.pieces().size());
      });
}

void bind_manners_of_motions(BoundMotion& bound) {
  bind_copying(bound);
  bind_pickling(bound, &making_of_motion);
  bound
      .def(
          "__eq__",
          [](nb::handle_t<HeldMotion> self, const nb::object& other) {
            return self.is(other) || (nb::isinstance<HeldMotion>(other) &&
                                      equal_pieces(made_value<HeldMotion>(self), made_value<HeldMotion>(other)));
          },
          nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", [](nb::handle_t<HeldMotion> self) {
        const HeldMotion& motion = made_value<HeldMotion>(self);
        return motion.pieces().empty() ? nb::hash(nb::int_(reinterpret_cast<std::uintptr_t>(self.ptr())))
                                       : nb::hash(nb::tuple(pieces_of(motion)));
      });
}

void bind_motion(nb::module_& module) {
  BoundMotion bound(module, "RigidMotion", nb::type_slots(motion_slots),
                    R"(How a shape moves, without changing its form, in the time from 0 to 1.

At the part s of it a world point w is at centre + R(axis, s * turns) (w - centre) + s * translation, where R turns
counter-clockwise about the axis and 1 is a whole turn; starting from where the shape is under `start`. RigidMotion(pose)
rests. RigidMotion(pieces=…) is made of what `pieces` tells, whose times go on from each other from 0 to 1; whether their places do is not looked at. Vectors have the shape (3,); lengths are in the unit of the coordinates. Immutable. Raises Error when a number is not
finite, and for pieces whose times do not.)");
  bind_constructors(bound);
  bind_makers(bound);
  bind_parts_of_motion(bound);
  bind_manners_of_motions(bound);
}

/// `motion` rests or moves; the shape starts at its pose.
void bind_sweep(nb::module_& module) {
  module.def(
      "sweep",
      [](const AnyShape& a, const MotionLike& motion_a, const AnyShape& b, const MotionLike& motion_b,
         double stop_before, Solid solid_a, Solid solid_b) {
        const RigidMotion of_a = motion_of(motion_a, "motion_a"), of_b = motion_of(motion_b, "motion_b");
        const SweepQuery query{solid_a, solid_b, stop_before};
        return without_lock([&, x = a.model, y = b.model] { return sweep(x, of_a, y, of_b, query); });
      },
      nb::arg("a"), nb::arg("motion_a"), nb::arg("b"), nb::arg("motion_b") = nb::none(), nb::kw_only(),
      nb::arg("stop_before") = 0.0, nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      R"(When two shapes that move and turn first meet, as a ShapeHit: times from 0 to 1. None where they do not, which is proved
for all of the way.

Motions are RigidMotions, or poses for what rests. stop_before: when they come as near as that, in the unit of the
coordinates; negative: when they are so deep in each other. By conservative advancement (B. Mirtich, "Impulse-based dynamic
simulation of rigid body systems", 1996) with bounds of each box of a tree (M. Tang, Y. J. Kim, D. Manocha, "C2A: controlled
conservative advancement", 2009). Raises Error like cast_shape.)");
  module.def(
      "sweep_each",
      [](const AnyShape& a, const nb::object& motions_a, const AnyShape& b, const MotionLike& motion_b,
         double stop_before, Solid solid_a, Solid solid_b, int threads) {
        const std::vector<RigidMotion> ways = motions_of(motions_a, "motions_a");
        const RigidMotion of_b = motion_of(motion_b, "motion_b");
        const SweepQuery query{solid_a, solid_b, stop_before};
        return structured(answer_each(ways.size(), 1, "motion", threads, [&, x = a.model, y = b.model](std::size_t i) {
          return sweep(x, ways[i], y, of_b, query);
        }));
      },
      nb::arg("a"), nb::arg("motions_a"), nb::arg("b"), nb::arg("motion_b") = nb::none(), nb::kw_only(),
      nb::arg("stop_before") = 0.0, nb::arg("solid_a") = Solid::automatic, nb::arg("solid_b") = Solid::automatic,
      nb::arg("threads") = all_threads,
      nb::sig(
          "def sweep_each(a: Shape, motions_a: collections.abc.Sequence[RigidMotion], b: Shape, motion_b: "
          "toccata._typing.MotionLike | None = None, *, stop_before: float = 0.0, solid_a: Solid = Solid.automatic, "
          "solid_b: Solid = Solid.automatic, threads: int = 0) -> toccata._typing.Answers"),
      "sweep of many motions of A, in the unit of the coordinates, on all cores: a structured array with the members "
      "of ShapeHit, and found. Raises Error naming the motion.");
  module.def(
      "swept_volume",
      [](const AnyShape& shape, const MotionLike& motion, double excess, std::size_t max_parts, Solid solid) {
        const RigidMotion way = motion_of(motion, "motion");
        const SweptVolume volume = without_lock([&, body = shape.model] {
          return swept_volume(body, way, {excess, max_parts, solid});
        });
        return nb::make_tuple(shape_object(volume.model), volume.excess);
      },
      nb::arg("shape"), nb::arg("motion"), nb::kw_only(), nb::arg("excess") = 0.0, nb::arg("max_parts") = 1024,
      nb::arg("solid") = Solid::automatic,
      nb::sig(
          "def swept_volume(shape: Shape, motion: toccata._typing.MotionLike, *, excess: float = 0.0, max_parts: int = "
          "1024, solid: Solid = Solid.automatic) -> tuple[Shape, float]"),
      "A shape, in the world, that contains all that a body passes, and how far outside of it it reaches at most; both "
      "proved. excess: how far it may reach, in the unit of the coordinates, 0: a 32nd of the body's diagonal. Raises "
      "Error for a negative excess, and for what has no end.");
}

/// Takes two arrays (N, 4, 3): where four points start and end.
template <class Pair, class Make>
std::vector<Pair> feature_pairs(const ArrayLike& starts, const ArrayLike& ends, const Make& make) {
  const Doubles from = doubles(starts, "starts"), to = doubles(ends, "ends");
  for (const Doubles* given : {&from, &to})
    if (!given->has_shape(3, {4, 3}) || given->rows() != from.rows())
      throw Error(
          fmt::format("starts, ends: two arrays of the shape (N, 4, 3) are needed, and what is given has the shapes "
                      "{} and {}",
                      shape_text(from.shape), shape_text(to.shape)));
  std::vector<Pair> pairs(from.rows());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    std::array<MovingPoint, 4> points;
    for (std::size_t k = 0; k < 4; ++k) {
      const double *start = from.data + 12 * i + 3 * k, *end = to.data + 12 * i + 3 * k;
      points[k] = {{start[0], start[1], start[2]}, {end[0], end[1], end[2]}};
    }
    pairs[i] = make(points);
  }
  return pairs;
}

template <class Pair>
Answers impacts_told(const std::vector<Pair>& pairs, int threads) {
  constexpr std::size_t in_row = 256;
  return structured(
      answer_each(pairs.size(), in_row, "pair", threads, [&](std::size_t i) { return time_of_impact(pairs[i]); }));
}

void bind_impacts(nb::module_& module) {
  module.def(
      "vertex_face_impacts",
      [](const ArrayLike& starts, const ArrayLike& ends, int threads) {
        const auto pairs = feature_pairs<VertexFace>(starts, ends, [](const std::array<MovingPoint, 4>& p) {
          return VertexFace{p[0], {p[1], p[2], p[3]}};
        });
        return impacts_told(pairs, threads);
      },
      nb::arg("starts"), nb::arg("ends"), nb::kw_only(), nb::arg("threads") = all_threads,
      "When a moving point first meets a moving triangle, exactly, for many: shapes (N, 4, 3), in each the point and "
      "the "
      "three corners, at the times 0 and 1, in one frame and any unit; they move straight on. A structured array of "
      "found, lower and upper, "
      "two neighbouring multiples of 2**-40 (the cubic: X. Provot, \"Collision and self-collision handling in cloth "
      "model "
      "dedicated to design garments\", 1997). Raises Error for other shapes, and when a number is not finite.");
  module.def(
      "edge_edge_impacts",
      [](const ArrayLike& starts, const ArrayLike& ends, int threads) {
        const auto pairs = feature_pairs<EdgeEdge>(starts, ends, [](const std::array<MovingPoint, 4>& p) {
          return EdgeEdge{{p[0], p[1]}, {p[2], p[3]}};
        });
        return impacts_told(pairs, threads);
      },
      nb::arg("starts"), nb::arg("ends"), nb::kw_only(), nb::arg("threads") = all_threads,
      "vertex_face_impacts of two moving segments: shapes (N, 4, 3), in each the ends of one and of the other, in any "
      "unit. Raises Error like it.");
}

}  // namespace

void bind_motions(nb::module_& module) {
  bind_motion(module);
  bind_sweep(module);
  bind_impacts(module);
}

}  // namespace toccata::python
