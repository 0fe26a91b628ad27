#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/math/pose.hpp>

#include "arrays.hpp"
#include "calls.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {
namespace {

std::string pose_text(const Pose& pose) {
  const auto row = [](const Vec3& v) { return nb::cast<std::string>(nb::repr(tuple_of(v))); };
  return fmt::format("Pose(({}, {}, {}), {})", row(pose.linear[0]), row(pose.linear[1]), row(pose.linear[2]),
                     row(pose.offset));
}

Pose finite(const Pose& pose) {
  if (!is_finite(pose)) throw Error("the pose is not finite");
  return pose;
}

/// Takes one point or an array (N, 3).
Floats transformed(const Pose& pose, const ArrayLike& points) {
  const Doubles numbers = doubles(points, "points");
  if (numbers.has_shape(1, {3})) return array_of(transform(pose, vector_of(points, "points")));
  return nb::borrow<Floats>(array_over<double>(transform(pose, vectors_of(points, "points")), {3}));
}

Pose composed(const Pose& outer, const Pose& inner) { return outer * inner; }

nb::tuple pose_state(const Pose& pose) {
  return nb::make_tuple(nb::make_tuple(tuple_of(pose.linear[0]), tuple_of(pose.linear[1]), tuple_of(pose.linear[2])),
                        tuple_of(pose.offset));
}

using BoundPose = nb::class_<Pose>;

void bind_makers_of_poses(BoundPose& bound) {
  bound
      .def_static(
          "translation", [](double x, double y, double z) { return finite(Pose::translation(x, y, z)); }, nb::arg("x"),
          nb::arg("y"), nb::arg("z"),
          "Moves by (x, y, z), in the unit of the coordinates. Raises Error when a number is not finite.")
      .def_static(
          "rotation",
          [](const ArrayLike& axis, double degrees) { return Pose::rotation(vector_of(axis, "axis"), degrees); },
          nb::arg("axis"), nb::arg("degrees"),
          "Turns counter-clockwise, by an angle in degrees, about an axis through the origin, shape (3,), of any "
          "length but "
          "0. Quarter turns about coordinate axes are exact. Raises Error when a number is not finite or the axis is "
          "0.")
      .def_static(
          "from_quaternion",
          [](const ArrayLike& quaternion, const ArrayLike& translation) {
            const Doubles numbers = doubles(quaternion, "quaternion");
            if (!numbers.has_shape(1, {4}))
              throw Error(
                  fmt::format("quaternion: four numbers x, y, z, w are needed, and what is given has the shape {}",
                              shape_text(numbers.shape)));
            const double* q = numbers.data;
            return finite(Pose::rigid({q[0], q[1], q[2], q[3]}, vector_of(translation, "translation")));
          },
          nb::arg("quaternion"), nb::arg("translation") = nb::make_tuple(0.0, 0.0, 0.0),
          "Of a quaternion, shape (4,), in the order x, y, z, w, as scipy and ROS have it; trimesh's has w first. It "
          "need "
          "not have length 1. The translation has the shape (3,), in the unit of the coordinates. Raises Error when a "
          "number is not finite or all four are 0.")
      .def_static(
          "nearest_rigid",
          [](const PoseLike& given) {
            const Pose pose = pose_of(given, "given");
            return finite(Pose::nearest_rigid(pose.linear, pose.offset));
          },
          nb::arg("given"),
          "With the rotation that is nearest to the given linear part (N. J. Higham, 1986): what drifted or came from "
          "floats becomes a pose that every shape accepts. Raises Error where that mirrors or flattens.");
}

void bind_parts_of_poses(BoundPose& bound) {
  bound
      .def_prop_ro(
          "matrix", [](const Pose& pose) { return array_of(pose); }, "A new array of the shape (4, 4).")
      .def_prop_ro(
          "linear",
          [](const Pose& pose) {
            const Mat3& m = pose.linear;
            return nb::borrow<Floats>(array_over<double>(std::vector<Vec3>{m[0], m[1], m[2]}, {3}));
          },
          "A new array of the shape (3, 3).")
      .def_prop_ro(
          "offset", [](const Pose& pose) { return array_of(pose.offset); }, "A new array of the shape (3,).")
      .def("inverse", &inverse,
           "The pose that undoes it: each number of its linear part is the nearest double. Raises Error where it is "
           "singular.")
      .def("transform", &transformed, nb::arg("points"),
           "Where the pose brings a point, shape (3,), or points, shape (N, 3), in the unit of the coordinates. "
           "Rounded as "
           "the truth page says (docs/truth.md). Raises Error for other shapes.")
      .def("__mul__", &composed, nb::arg("inner"), nb::is_operator(), "The inner pose first, then this one; rounded.")
      .def("__matmul__", &composed, nb::arg("inner"), nb::is_operator(), "The same as *.");
}

void bind_manners_of_poses(BoundPose& bound) {
  bound
      .def(
          "__eq__",
          [](const Pose& pose, const nb::object& other) {
            const Pose* with = nullptr;
            return nb::try_cast(other, with, false) && with != nullptr && pose == *with;
          },
          nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__hash__", [](const Pose& pose) { return nb::hash(pose_state(pose)); })
      .def("__repr__", &pose_text)
      .def(
          "__array__",
          [](const Pose& pose, const nb::object& type, const nb::object&) -> Floats {
            const Floats matrix = array_of(pose);
            return type.is_none() ? matrix : nb::borrow<Floats>(matrix.attr("astype")(type));
          },
          nb::arg("dtype") = nb::none(), nb::arg("copy") = nb::none(), "What numpy.asarray makes of it: the matrix.");
  bind_pickling(bound, &pose_state);
}

}  // namespace

void bind_poses(nb::module_& module) {
  BoundPose bound(module, "Pose", R"(Where a shape is: world = linear @ local + offset.

Pose() is the identity. Pose(given) takes whatever a question takes for a pose: a matrix of 4×4 numbers (its last row
0 0 0 1) or of 3×4, a pair (R, t), three numbers for a translation, or what has as_matrix(), as scipy's Rotation and
RigidTransform. Pose(R, t) takes a 3×3 matrix, or a rotation of scipy, and a translation. The numbers are used as given,
and never corrected: they may scale, shear and mirror, but spheres, capsules, rounded shapes and half-spaces need a
rotation. Lengths are in the unit of the coordinates. Immutable. Raises Error for what is no pose.)");
  bound.def(nb::init<>())
      .def(
          "__init__", [](Pose* place, const PoseLike& given) { new (place) Pose(finite(pose_of(given, "the pose"))); },
          nb::arg("given"))
      .def(
          "__init__",
          [](Pose* place, const PoseLike& linear, const ArrayLike& offset) {
            new (place) Pose(finite(pose_of(nb::make_tuple(linear, offset), "the pose")));
          },
          nb::arg("linear"), nb::arg("offset"));
  bind_makers_of_poses(bound);
  bind_parts_of_poses(bound);
  bind_manners_of_poses(bound);
}

}  // namespace toccata::python
