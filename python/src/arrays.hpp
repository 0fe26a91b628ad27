#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <toccata/bounds/aabb.hpp>
#include <toccata/core/index.hpp>
#include <toccata/math/mat3.hpp>
#include <toccata/math/pose.hpp>
#include <toccata/math/vec3.hpp>
#include <toccata/shapes/primitives.hpp>

// Numbers from Python and back. What comes in is looked at, and converted where that changes no value; what cannot be a
// number is a toccata::Error that names the argument.
namespace toccata::python {

namespace nb = nanobind;

// What arguments and answers are called in the stubs (python/toccata/_typing.py). Everything is accepted here and
// looked at later, so that what is wrong is told in our words.
inline bool anything(PyObject*) { return true; }

struct ArrayLike : nb::object {
  NB_OBJECT_DEFAULT(ArrayLike, nb::object, "numpy.typing.ArrayLike", anything)
};
struct PoseLike : nb::object {
  NB_OBJECT_DEFAULT(PoseLike, nb::object, "toccata._typing.PoseLike", anything)
};
struct PosesLike : nb::object {
  NB_OBJECT_DEFAULT(PosesLike, nb::object, "toccata._typing.PosesLike", anything)
};
/// One shape or a list of them.
struct ShapesLike : nb::object {
  NB_OBJECT_DEFAULT(ShapesLike, nb::object, "toccata._typing.ShapesLike", anything)
};
/// Shapes at their places, each as a SceneInstance, a shape, or a pair (shape, pose).
struct ObjectsLike : nb::object {
  NB_OBJECT_DEFAULT(ObjectsLike, nb::object, "toccata._typing.ObjectsLike", anything)
};
/// A motion, or a pose at which something rests.
struct MotionLike : nb::object {
  NB_OBJECT_DEFAULT(MotionLike, nb::object, "toccata._typing.MotionLike", anything)
};
/// Names of bodies: one, a list, or an array as World.add_each returns it.
struct BodiesLike : nb::object {
  NB_OBJECT_DEFAULT(BodiesLike, nb::object, "toccata._typing.BodiesLike", anything)
};
/// An array of doubles.
struct Floats : nb::object {
  NB_OBJECT_DEFAULT(Floats, nb::object, "toccata._typing.Floats", anything)
};
struct Indices : nb::object {
  NB_OBJECT_DEFAULT(Indices, nb::object, "toccata._typing.Indices", anything)
};
struct Booleans : nb::object {
  NB_OBJECT_DEFAULT(Booleans, nb::object, "toccata._typing.Booleans", anything)
};
/// A structured array: a field for each member of the answer.
struct Answers : nb::object {
  NB_OBJECT_DEFAULT(Answers, nb::object, "toccata._typing.Answers", anything)
};

/// An array in C order. `owner` keeps it alive.
template <class Number>
struct NumbersOf {
  nb::object owner;
  const Number* data = nullptr;
  std::vector<std::size_t> shape;

  [[nodiscard]] std::size_t rows() const { return shape.empty() ? 1 : shape.front(); }
  /// It has so many axes, and the last ones are as long as told.
  [[nodiscard]] bool has_shape(std::size_t axes, std::initializer_list<std::size_t> last) const {
    return shape.size() == axes &&
           std::equal(last.begin(), last.end(), shape.end() - static_cast<std::ptrdiff_t>(last.size()));
  }
};
using Doubles = NumbersOf<double>;

/// Numbers of Python or of any array, as doubles: of C-ordered doubles without a copy. Throws Error, beginning with
/// `what`, when they are none: texts, complex numbers, objects, rows of unlike lengths.
[[nodiscard]] Doubles doubles(nb::handle given, std::string_view what);

/// "(3, 4)"
[[nodiscard]] std::string shape_text(const std::vector<std::size_t>& shape);

/// Finds what arrays of numpy are known by, once for the module.
void know_arrays();

/// One vector. Throws Error when there are not three numbers.
[[nodiscard]] Vec3 vector_of(nb::handle given, std::string_view what);

/// Takes an array (N, 3).
[[nodiscard]] std::vector<Vec3> vectors_of(nb::handle given, std::string_view what);

/// Whole numbers from 0 to 2³² − 2 of an array of any type of whole numbers, of `columns` in each row.
[[nodiscard]] std::vector<Index> indices_of(nb::handle given, std::size_t columns, std::string_view what);

/// A pose as Python tells it: docs/guide/python.md.
[[nodiscard]] Pose pose_of(nb::handle given, std::string_view what);

/// The pose of a matrix of 4×4 numbers, or of what says that it is one. Throws Error for any other shape.
[[nodiscard]] Pose pose_of_matrix(nb::handle given, std::string_view what);

/// Poses, or one for all. Those of an array are read where they lie, each when it is asked for: that needs no lock of
/// Python, and a million take no memory.
class Poses {
 public:
  explicit Poses(const Pose& for_all) : listed_{for_all}, is_single_(true) {}
  explicit Poses(std::vector<Pose> listed) : listed_(std::move(listed)), count_(listed_.size()) {}
  /// Takes matrices (N, 4, 4) or (N, 3, 4), rotations (N, 3, 3), or translations (N, 3). Throws Error where the last
  /// row of a matrix is not that of a pose.
  Poses(Doubles numbers, std::string_view what);

  [[nodiscard]] bool is_single() const { return is_single_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] Pose operator[](std::size_t i) const;

 private:
  std::vector<Pose> listed_;
  Doubles numbers_{};
  std::size_t count_ = 1, numbers_of_each_ = 0;
  bool is_single_ = false;
};
[[nodiscard]] Poses poses_of(nb::handle given, std::string_view what);

[[nodiscard]] Triangle triangle_of(nb::handle given, std::string_view what);

/// Takes an array (N, 2, 3): the least corner and the greatest.
[[nodiscard]] std::vector<Aabb> boxes_of(nb::handle given, std::string_view what);

/// Truths, `count` of them, in an array of any type of numbers or of bools.
[[nodiscard]] std::vector<bool> bools_of(nb::handle given, std::size_t count, std::string_view what);

/// Any number of them, of an array (N,).
[[nodiscard]] std::vector<double> numbers_of(nb::handle given, std::string_view what);

/// One number for each of `count`, or one for all.
[[nodiscard]] std::vector<double> numbers_for(nb::handle given, std::size_t count, std::string_view what);

/// It is a list, a tuple or another sequence that is no array and no text.
[[nodiscard]] bool is_list(nb::handle given);

// To Python.

[[nodiscard]] Floats array_of(const Vec3& vector);
[[nodiscard]] Floats array_of(const Pose& pose);
/// The numbers of a matrix of the shape (4, 4), row by row.
[[nodiscard]] std::array<double, 16> matrix_of(const Pose& pose);
[[nodiscard]] Floats array_of(std::vector<double> numbers);
[[nodiscard]] nb::tuple tuple_of(const Vec3& vector);
[[nodiscard]] nb::tuple tuple_of(const std::vector<double>& numbers);

/// Makes the array of `shape` over what `owner` holds, which cannot be written to.
template <class Number>
[[nodiscard]] nb::object read_only_view(const Number* data, std::initializer_list<std::size_t> shape,
                                        nb::handle owner) {
  return nb::cast(nb::ndarray<nb::numpy, const Number>(data, shape, owner), nb::rv_policy::reference);
}

/// An object of Python that holds a value and ends it.
template <class Value>
[[nodiscard]] nb::capsule capsule_of(Value value) {
  auto* kept = new Value(std::move(value));
  return {kept, [](void* data) noexcept { delete static_cast<Value*>(data); }};
}

/// The values themselves, not copied, as an array (rows, columns …).
template <class Number, class Value>
[[nodiscard]] nb::object array_over(std::vector<Value> values, std::initializer_list<std::size_t> of_each) {
  std::vector<std::size_t> shape{values.size()};
  shape.insert(shape.end(), of_each);
  const nb::capsule owner = capsule_of(std::move(values));
  auto* data = static_cast<std::vector<Value>*>(owner.data())->data();
  return nb::cast(nb::ndarray<nb::numpy, Number>(data, shape.size(), shape.data(), owner), nb::rv_policy::reference);
}

}  // namespace toccata::python
