#include "arrays.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <toccata/core/error.hpp>

namespace toccata::python {
namespace {

// Never freed: the module is not either.
PyTypeObject* numpy_array = nullptr;
PyObject* array_struct = nullptr;

/// What an array of numpy tells of itself, by numpy's "array interface protocol": the same as by those of buffers and
/// of dlpack, in a fraction of their time.
class ToldArray {
 public:
  explicit ToldArray(nb::handle given) {
    if (Py_TYPE(given.ptr()) != numpy_array) return;
    capsule_ = nb::steal(PyObject_GetAttr(given.ptr(), array_struct));
    if (!capsule_.is_valid()) throw nb::python_error();
    told_ = static_cast<const Told*>(PyCapsule_GetPointer(capsule_.ptr(), nullptr));
  }

  /// They are doubles one after the other, in C order.
  [[nodiscard]] bool has_doubles() const {
    constexpr int in_c_order = 0x1, aligned = 0x100, not_swapped = 0x200, needed = in_c_order | aligned | not_swapped;
    return told_ != nullptr && told_->kind == 'f' && told_->item_size == sizeof(double) &&
           (told_->flags & needed) == needed;
  }
  [[nodiscard]] const double* data() const { return static_cast<const double*>(told_->data); }
  [[nodiscard]] std::vector<std::size_t> shape() const { return {told_->shape, told_->shape + told_->axes}; }
  [[nodiscard]] bool has_shape(Py_ssize_t rows, Py_ssize_t columns) const {
    return told_->axes == 2 && told_->shape[0] == rows && told_->shape[1] == columns;
  }

 private:
  /// PyArrayInterface, of numpy's documentation.
  struct Told {
    int two;
    int axes;
    char kind;
    int item_size;
    int flags;
    Py_ssize_t* shape;
    Py_ssize_t* strides;
    void* data;
    PyObject* description;
  };

  nb::object capsule_;
  const Told* told_ = nullptr;
};

nb::module_ numpy() { return nb::module_::import_("numpy"); }

std::string text_of(nb::handle object) { return nb::cast<std::string>(nb::str(object)); }

template <class Array>
Doubles in_place(Array array) {
  Doubles numbers{nb::object(), array.data(), {}};
  for (std::size_t i = 0; i < array.ndim(); ++i) numbers.shape.push_back(array.shape(i));
  return numbers;
}

/// What numpy makes of it, as numbers of one kind.
nb::object as_array(nb::handle given, std::string_view what, std::string_view kinds) {
  nb::object array;
  try {
    array = numpy().attr("asarray")(given);
  } catch (const nb::python_error& error) {
    if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
    throw Error(fmt::format("{}: these are no numbers of an array: {}", what, text_of(error.value())));
  }
  const auto kind = text_of(array.attr("dtype").attr("kind"));
  // numpy makes an array of floats of an empty list.
  const bool empty = nb::cast<std::size_t>(array.attr("size")) == 0 && kind == "f";
  if (!empty && kinds.find(kind) == std::string_view::npos)
    throw Error(fmt::format("{}: {} numbers are needed, and these are of type {}", what,
                            kinds.find('f') == std::string_view::npos ? "whole" : "real",
                            text_of(array.attr("dtype"))));
  return array;
}

template <class Number>
NumbersOf<Number> converted(const nb::object& array, const char* type) {
  using Array = nb::ndarray<const Number, nb::ro, nb::c_contig, nb::device::cpu>;
  nb::dict options;
  options["dtype"] = type;
  options["order"] = "C";
  nb::object made = numpy().attr("asarray")(array, **options);
  const auto view = nb::cast<Array>(made, false);
  NumbersOf<Number> numbers{made, view.data(), {}};
  for (std::size_t i = 0; i < view.ndim(); ++i) numbers.shape.push_back(view.shape(i));
  return numbers;
}

Vec3 vector_at(const double* at) { return {at[0], at[1], at[2]}; }

std::vector<Vec3> vectors_in(const Doubles& numbers) {
  std::vector<Vec3> vectors(numbers.rows());
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = vector_at(numbers.data + 3 * i);
  return vectors;
}

Mat3 linear_at(const double* at) { return {{vector_at(at), vector_at(at + 3), vector_at(at + 6)}}; }

/// Of a matrix, of which three rows say all.
Pose pose_at(const double* matrix) {
  Pose pose;
  for (int i = 0; i < 3; ++i) {
    const double* row = matrix + 4 * i;
    pose.linear[i] = vector_at(row);
    pose.offset[i] = row[3];
  }
  return pose;
}

bool is_last_row(const double* row) { return row[0] == 0 && row[1] == 0 && row[2] == 0 && row[3] == 1; }

[[noreturn]] void refuse_last_row(std::string_view what, const double* last) {
  throw Error(
      fmt::format("{}: the last row of a 4×4 matrix must be 0 0 0 1, and is {} {} {} {}; a pose is no projection", what,
                  last[0], last[1], last[2], last[3]));
}

Pose pose_of_rows(const double* matrix, std::size_t rows, std::string_view what) {
  if (rows == 4 && !is_last_row(matrix + 12)) refuse_last_row(what, matrix + 12);
  return pose_at(matrix);
}

/// What scipy's and other rotations hand over: a matrix, or an array of them.
nb::object told_matrix(nb::handle given) { return given.attr("as_matrix")(); }

bool tells_a_matrix(nb::handle given) { return nb::hasattr(given, "as_matrix"); }

Mat3 rotation_of(nb::handle given, std::string_view what) {
  const Doubles numbers = doubles(tells_a_matrix(given) ? told_matrix(given) : nb::borrow(given), what);
  if (!numbers.has_shape(2, {3, 3}))
    throw Error(fmt::format("{}: the linear part is a 3×3 matrix, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return linear_at(numbers.data);
}

bool is_row(nb::handle given) {
  if (PySequence_Check(given.ptr()) == 0) return false;
  const Py_ssize_t count = PySequence_Size(given.ptr());
  if (count < 0) PyErr_Clear();  // an array without axes
  return count > 0;
}

bool is_tuple_or_list(nb::handle given) { return PyTuple_Check(given.ptr()) || PyList_Check(given.ptr()); }

/// (R, t), and no list of two translations, poses or matrices.
bool is_pair(nb::handle given) {
  if (!is_tuple_or_list(given) || nb::len(given) != 2) return false;
  const nb::object linear = given[0], offset = given[1];
  if (nb::isinstance<Pose>(offset)) return false;
  if (tells_a_matrix(linear)) return !tells_a_matrix(offset);
  if (nb::isinstance<Pose>(linear) || !is_row(linear)) return false;
  return is_row(nb::object(linear[0])) && !(is_row(offset) && is_row(nb::object(offset[0])));
}

[[noreturn]] void refuse_pose(std::string_view what, const Doubles& numbers, std::string_view more) {
  throw Error(fmt::format(
      "{}: a pose is a toccata.Pose, a matrix of 4×4 or 3×4 numbers, a pair (R, t), three numbers for a translation{}, "
      "and what is given has the shape {}",
      what, more, shape_text(numbers.shape)));
}

}  // namespace

std::string shape_text(const std::vector<std::size_t>& shape) {
  return shape.size() == 1 ? fmt::format("({},)", shape.front()) : fmt::format("({})", fmt::join(shape, ", "));
}

void know_arrays() {
  numpy_array = reinterpret_cast<PyTypeObject*>(nb::object(numpy().attr("ndarray")).release().ptr());
  array_struct = nb::str("__array_struct__").release().ptr();
}

Doubles doubles(nb::handle given, std::string_view what) {
  if (const ToldArray told(given); told.has_doubles()) return {nb::borrow(given), told.data(), told.shape()};
  using Array = nb::ndarray<const double, nb::ro, nb::c_contig, nb::device::cpu>;
  if (Array array; nb::try_cast(given, array, false)) {
    Doubles numbers = in_place(array);
    numbers.owner = nb::borrow(given);
    return numbers;
  }
  return converted<double>(as_array(given, what, "fiub"), "float64");
}

Vec3 vector_of(nb::handle given, std::string_view what) {
  // The usual ones without an array.
  if (PyTuple_Check(given.ptr()) && PyTuple_Size(given.ptr()) == 3) {
    Vec3 vector;
    for (int i = 0; i < 3; ++i) {
      PyObject* number = PyTuple_GetItem(given.ptr(), i);
      if (!PyFloat_Check(number) && !PyLong_Check(number)) break;
      vector[i] = PyFloat_AsDouble(number);
      if (vector[i] == -1 && PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        throw Error(fmt::format("{}: a number is too large for a double", what));
      }
      if (i == 2) return vector;
    }
  }
  const Doubles numbers = doubles(given, what);
  if (!numbers.has_shape(1, {3}))
    throw Error(fmt::format("{}: three numbers are needed, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return vector_at(numbers.data);
}

std::vector<Vec3> vectors_of(nb::handle given, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (numbers.has_shape(1, {0})) return {};
  if (!numbers.has_shape(2, {3}))
    throw Error(fmt::format("{}: an array of the shape (N, 3) is needed, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return vectors_in(numbers);
}

std::vector<Index> indices_of(nb::handle given, std::size_t columns, std::string_view what) {
  const nb::object array = as_array(given, what, "iu");
  const bool is_signed = text_of(array.attr("dtype").attr("kind")) != "u";
  const auto read = [&]<class Number>(Number, const char* type) {
    const NumbersOf<Number> numbers = converted<Number>(array, type);
    const std::size_t axes = columns == 1 ? 1 : 2;
    if (!numbers.has_shape(1, {0}) && (numbers.shape.size() != axes || (axes == 2 && numbers.shape.back() != columns)))
      throw Error(fmt::format("{}: an array of the shape ({}) is needed, and what is given has the shape {}", what,
                              axes == 1 ? "N," : fmt::format("N, {}", columns), shape_text(numbers.shape)));
    std::vector<Index> indices(numbers.rows() * columns);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const Number number = numbers.data[i];
      if (number < Number{0} || number >= Number{std::numeric_limits<Index>::max()})
        throw Error(fmt::format("{}: the index {} in row {} is none of 0 … 4294967294", what, number, i / columns));
      indices[i] = static_cast<Index>(number);
    }
    return indices;
  };
  return is_signed ? read(std::int64_t{}, "int64") : read(std::uint64_t{}, "uint64");
}

Pose pose_of(nb::handle given, std::string_view what) {
  if (given.is_none()) return {};
  if (const Pose* pose = nullptr; nb::try_cast(given, pose, false) && pose != nullptr) return *pose;
  // The usual one first.
  if (const ToldArray told(given); told.has_doubles() && (told.has_shape(4, 4) || told.has_shape(3, 4)))
    return pose_of_rows(told.data(), told.has_shape(4, 4) ? 4 : 3, what);
  if (is_pair(given)) return {rotation_of(given[0], what), vector_of(given[1], what)};
  const bool of_scipy = !nb::ndarray_check(given) && tells_a_matrix(given);
  const Doubles numbers = doubles(of_scipy ? told_matrix(given) : nb::borrow(given), what);
  if (numbers.has_shape(2, {4, 4}) || numbers.has_shape(2, {3, 4}))
    return pose_of_rows(numbers.data, numbers.rows(), what);
  if (numbers.has_shape(1, {3})) return Pose::translation(vector_at(numbers.data));
  if (of_scipy && numbers.has_shape(2, {3, 3})) return {rotation_of(given, what), {}};
  refuse_pose(what, numbers, "");
}

Pose pose_of_matrix(nb::handle given, std::string_view what) {
  if (const ToldArray told(given); told.has_doubles() && told.has_shape(4, 4))
    return pose_of_rows(told.data(), 4, what);
  if (given.is_none() || nb::isinstance<Pose>(given)) return pose_of(given, what);
  const Doubles numbers = doubles(given, what);
  if (!numbers.has_shape(2, {4, 4}))
    throw Error(fmt::format("{}: a matrix of the shape (4, 4) is needed, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return pose_of_rows(numbers.data, 4, what);
}

Poses::Poses(Doubles numbers, std::string_view what) : numbers_(std::move(numbers)), count_(numbers_.rows()) {
  numbers_of_each_ = 1;
  for (std::size_t axis = 1; axis < numbers_.shape.size(); ++axis) numbers_of_each_ *= numbers_.shape[axis];
  if (numbers_of_each_ != 16) return;
  for (std::size_t i = 0; i < count_; ++i)
    if (const double* last = numbers_.data + 16 * i + 12; !is_last_row(last))
      refuse_last_row(fmt::format("{}, pose {}", what, i), last);
}

Pose Poses::operator[](std::size_t i) const {
  if (!listed_.empty()) return listed_[is_single_ ? 0 : i];
  const double* at = numbers_.data + i * numbers_of_each_;
  if (numbers_of_each_ == 3) return Pose::translation(vector_at(at));
  if (numbers_of_each_ == 9) return {linear_at(at), {}};
  return pose_at(at);
}

namespace {

/// Of a list: numbers alone, which are one array, make none of its entries such.
bool is_posed(nb::handle given) {
  return given.is_none() || nb::isinstance<Pose>(given) || tells_a_matrix(given) || is_pair(given);
}

bool is_list_of_poses(nb::handle given) {
  if (!is_tuple_or_list(given)) return false;
  for (const nb::handle entry : given)
    if (is_posed(entry)) return true;
  return false;
}

/// A rotation that is an array of many, as scipy's may be.
bool tells_many(nb::handle linear) {
  const bool is_array = tells_a_matrix(linear) || nb::ndarray_check(linear);
  return is_array && doubles(tells_a_matrix(linear) ? told_matrix(linear) : nb::borrow(linear), "").shape.size() == 3;
}

/// (R, t) of many rotations, (N, 3, 3), and as many translations or one for all.
Poses poses_of_parts(nb::handle rotations, nb::handle offsets, std::string_view what) {
  const Doubles linear = doubles(tells_a_matrix(rotations) ? told_matrix(rotations) : nb::borrow(rotations), what);
  const Doubles offset = doubles(offsets, what);
  const bool single = offset.has_shape(1, {3});
  if (!linear.has_shape(3, {3, 3}) || (!single && !offset.has_shape(2, {3})) ||
      (!single && offset.rows() != linear.rows()))
    throw Error(
        fmt::format("{}: of many rotations (N, 3, 3) and translations (N, 3), as many are needed, or one translation, "
                    "and what is given has the shapes {} and {}",
                    what, shape_text(linear.shape), shape_text(offset.shape)));
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < linear.rows(); ++i)
    poses.push_back({linear_at(linear.data + 9 * i), vector_at(offset.data + (single ? 0 : 3 * i))});
  return Poses(std::move(poses));
}

Poses poses_of_list(nb::handle given, std::string_view what) {
  std::vector<Pose> poses;
  for (const nb::handle pose : given) {
    const Pose* known = nullptr;
    const bool is_pose = nb::try_cast(pose, known, false) && known != nullptr;
    poses.push_back(is_pose ? *known : pose_of(pose, fmt::format("{}, pose {}", what, poses.size())));
  }
  return Poses(std::move(poses));
}

}  // namespace

Poses poses_of(nb::handle given, std::string_view what) {
  if (is_tuple_or_list(given) && nb::len(given) == 2 && tells_many(given[0]) && !tells_a_matrix(given[1]))
    return poses_of_parts(given[0], given[1], what);
  if (given.is_none() || is_pair(given) || nb::isinstance<Pose>(given)) return Poses(pose_of(given, what));
  if (is_list_of_poses(given)) return poses_of_list(given, what);
  const bool of_scipy = tells_a_matrix(given);
  Doubles numbers = doubles(of_scipy ? told_matrix(given) : nb::borrow(given), what);
  if (numbers.has_shape(2, {4, 4}) || numbers.has_shape(2, {3, 4}) || numbers.has_shape(1, {3}) ||
      (of_scipy && numbers.shape.size() == 2))
    return Poses(pose_of(given, what));
  if (numbers.has_shape(1, {0})) return Poses(std::vector<Pose>{});
  const bool rotations = of_scipy && numbers.has_shape(3, {3, 3});
  const bool matrices = numbers.has_shape(3, {4, 4}) || numbers.has_shape(3, {3, 4});
  if (!rotations && !matrices && !numbers.has_shape(2, {3})) refuse_pose(what, numbers, ", or an array of N of these");
  return Poses(std::move(numbers), what);
}

Triangle triangle_of(nb::handle given, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (!numbers.has_shape(2, {3, 3}))
    throw Error(fmt::format("{}: three vertices of three numbers are needed, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return {{vector_at(numbers.data), vector_at(numbers.data + 3), vector_at(numbers.data + 6)}};
}

std::vector<Aabb> boxes_of(nb::handle given, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (numbers.has_shape(1, {0})) return {};
  if (!numbers.has_shape(3, {2, 3}))
    throw Error(
        fmt::format("{}: an array of the shape (N, 2, 3) is needed, the least corner and the greatest of each "
                    "box, and what is given has the shape {}",
                    what, shape_text(numbers.shape)));
  std::vector<Aabb> boxes(numbers.rows());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    boxes[i] = {vector_at(numbers.data + 6 * i), vector_at(numbers.data + 6 * i + 3)};
  return boxes;
}

std::vector<bool> bools_of(nb::handle given, std::size_t count, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (!numbers.has_shape(1, {count}))
    throw Error(fmt::format("{}: an array of {} truths is needed, one for each, and what is given has the shape {}",
                            what, count, shape_text(numbers.shape)));
  std::vector<bool> truths(count);
  for (std::size_t i = 0; i < count; ++i) truths[i] = numbers.data[i] != 0;
  return truths;
}

std::vector<double> numbers_of(nb::handle given, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (numbers.shape.size() != 1)
    throw Error(fmt::format("{}: a list of numbers is needed, and what is given has the shape {}", what,
                            shape_text(numbers.shape)));
  return {numbers.data, numbers.data + numbers.rows()};
}

std::vector<double> numbers_for(nb::handle given, std::size_t count, std::string_view what) {
  const Doubles numbers = doubles(given, what);
  if (numbers.shape.empty()) return std::vector<double>(count, numbers.data[0]);
  if (!numbers.has_shape(1, {count}))
    throw Error(fmt::format("{}: one number is needed, or {}, and what is given has the shape {}", what, count,
                            shape_text(numbers.shape)));
  return {numbers.data, numbers.data + count};
}

bool is_list(nb::handle given) {
  return PySequence_Check(given.ptr()) != 0 && !PyUnicode_Check(given.ptr()) && !PyBytes_Check(given.ptr()) &&
         !nb::ndarray_check(given);
}

Floats array_of(const Vec3& vector) {
  return nb::borrow<Floats>(array_over<double>(std::vector<double>{vector.x, vector.y, vector.z}, {}));
}

std::array<double, 16> matrix_of(const Pose& pose) {
  std::array<double, 16> numbers{};
  for (int i = 0; i < 3; ++i) {
    const Vec3& row = pose.linear[i];
    const double told[] = {row.x, row.y, row.z, pose.offset[i]};
    std::ranges::copy(told, numbers.begin() + 4 * i);
  }
  numbers[15] = 1;
  return numbers;
}

Floats array_of(const Pose& pose) {
  const std::array<double, 16> numbers = matrix_of(pose);
  std::vector<std::array<double, 4>> rows(4);
  for (std::size_t i = 0; i < 4; ++i) std::copy_n(numbers.begin() + 4 * i, 4, rows[i].begin());
  return nb::borrow<Floats>(array_over<double>(std::move(rows), {4}));
}

Floats array_of(std::vector<double> numbers) { return nb::borrow<Floats>(array_over<double>(std::move(numbers), {})); }

nb::tuple tuple_of(const Vec3& vector) { return nb::make_tuple(vector.x, vector.y, vector.z); }

nb::tuple tuple_of(const std::vector<double>& numbers) {
  nb::list told;
  for (const double number : numbers) told.append(number);
  return nb::tuple(told);
}

}  // namespace toccata::python
