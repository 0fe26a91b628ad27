#include "io/formats/pose_text.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "io/formats/file_error.hpp"
#include "io/formats/number.hpp"
#include "toccata/core/error.hpp"
#include "toccata/io/query_files.hpp"

namespace toccata {
namespace io {
namespace {

constexpr const char* ways_to_write_a_pose =
    "write 12 numbers, R row by row and then t; 16, a 4 × 4 matrix row by row; 7, a translation and a quaternion x y z "
    "w; 3, a translation; or words such as translation=1,0,0 axis=0,0,1 degrees=90";

std::optional<double> number_of(std::string_view word) {
  const ParsedNumber parsed = parse_number(word.data(), word.data() + word.size());
  if (parsed.fault != NumberFault::none || parsed.end != word.data() + word.size()) return std::nullopt;
  return parsed.value;
}

/// Three letters, all small or all capital, no two neighbours alike.
bool is_order(std::string_view word) {
  const auto all_of = [&](std::string_view letters) {
    return word.find_first_not_of(letters) == std::string_view::npos;
  };
  return word.size() == 3 && (all_of("xyz") || all_of("XYZ")) && word[0] != word[1] && word[1] != word[2];
}

Mat3 rotation_of_euler(std::string_view order, const std::array<double, 3>& degrees) {
  const bool about_fixed_axes = order[0] >= 'x';
  Mat3 rotation;
  for (std::size_t i = 0; i < 3; ++i) {
    const char axis = order[i];
    const Mat3 turn = rotation_about({axis == 'x' || axis == 'X' ? 1.0 : 0.0, axis == 'y' || axis == 'Y' ? 1.0 : 0.0,
                                      axis == 'z' || axis == 'Z' ? 1.0 : 0.0},
                                     degrees[i]);
    rotation = about_fixed_axes ? turn * rotation : rotation * turn;
  }
  return rotation;
}

/// Reads a pose word by word.
class PoseWords {
 public:
  PoseWords(const std::vector<std::string_view>& words, const FailPose& fail) : words_(words), fail_(fail) {}

  WrittenPose read() {
    while (place_ < words_.size()) read_part(words_[place_++]);
    if (axis_.has_value() != degrees_.has_value())
      fail_(axis_ ? "the axis has no degrees" : "the degrees have no axis", "write axis=X,Y,Z degrees=D");
    std::optional<WrittenTurn> turn;
    if (!rotation_) turn = {axis_.value_or(Vec3{}), degrees_.value_or(0)};
    if (axis_) turn_by(rotation_about(*axis_, *degrees_));
    return {{rotation_.value_or(Mat3{}), translation_.value_or(Vec3{})}, turn};
  }

 private:
  void read_part(std::string_view name) {
    if (name == "translation") {
      keep(translation_, name, vector());
    } else if (name == "axis") {
      keep(axis_, name, vector());
      if (*axis_ == Vec3{}) fail_("the axis 0, 0, 0 has no direction", "write a direction of any length");
    } else if (name == "degrees") {
      keep(degrees_, name, numbers<1>()[0]);
    } else if (name == "quaternion") {
      const auto [x, y, z, w] = numbers<4>();
      if (x == 0 && y == 0 && z == 0 && w == 0) fail_("the quaternion is zero", "write x, y, z and then w");
      turn_by(rotation_of({x, y, z, w}));
    } else if (name == "euler") {
      const std::string_view order = place_ < words_.size() ? words_[place_++] : std::string_view();
      if (!is_order(order))
        fail_(in_quotes(order) + " is no order of three axes",
              "write euler=xyz:A,B,C, or XYZ for axes that turn along");
      turn_by(rotation_of_euler(order, numbers<3>()));
    } else {
      fail_(in_quotes(name) + " is not known in a pose", ways_to_write_a_pose);
    }
  }

  template <class T>
  void keep(std::optional<T>& part, std::string_view name, const T& value) {
    if (part) fail_("there are two of " + in_quotes(name), "leave one out");
    part = value;
  }

  void turn_by(const Mat3& rotation) {
    if (rotation_) fail_("the pose has two rotations", "leave one out");
    rotation_ = rotation;
  }

  template <std::size_t Count>
  std::array<double, Count> numbers() {
    const std::string_view name = words_[place_ - 1];
    std::array<double, Count> found{};
    for (double& number : found) {
      const std::string wanted = "write " + std::to_string(Count);
      if (place_ == words_.size()) fail_("after " + in_quotes(name) + " not so many numbers follow", wanted);
      const std::string_view word = words_[place_++];
      const std::optional<double> next = number_of(word);
      if (!next) fail_(in_quotes(word) + " after " + in_quotes(name) + " is no number", wanted);
      number = *next;
    }
    return found;
  }

  Vec3 vector() {
    const auto [x, y, z] = numbers<3>();
    return {x, y, z};
  }

  const std::vector<std::string_view>& words_;
  const FailPose& fail_;
  std::size_t place_ = 0;
  std::optional<Vec3> translation_, axis_;
  std::optional<double> degrees_;
  std::optional<Mat3> rotation_;
};

WrittenPose written_pose_of_numbers(const std::vector<std::string_view>& words, const FailPose& fail) {
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const std::optional<double> number = number_of(word);
    if (!number) fail(in_quotes(word) + " is no number", ways_to_write_a_pose);
    numbers.push_back(*number);
  }
  if (numbers.size() == 3) return {Pose::translation(numbers[0], numbers[1], numbers[2]), WrittenTurn{}};
  return {pose_of_numbers(numbers, fail), {}};
}

/// The pose of a 4 × 4 matrix, row by row: R and t as they stand.
Pose pose_of_matrix(std::span<const double> m, const FailPose& fail) {
  const bool is_last_row = m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1;
  const bool is_column_major = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
  if (!is_last_row)
    fail("the last row of the 4 × 4 matrix is not 0 0 0 1",
         is_column_major ? "it seems to be written column by column; write it row by row" : "write a rigid placement");
  return Pose::from_numbers({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10], m[3], m[7], m[11]});
}

}  // namespace

bool is_count_of_pose(std::size_t numbers) { return numbers == 12 || numbers == 16 || numbers == 7; }

Pose pose_of_numbers(std::span<const double> numbers, const FailPose& fail) {
  if (!is_count_of_pose(numbers.size()))
    fail("a pose of " + std::to_string(numbers.size()) + " numbers", ways_to_write_a_pose);
  if (numbers.size() == 16) return pose_of_matrix(numbers, fail);
  if (numbers.size() == 7) {
    if (numbers[3] == 0 && numbers[4] == 0 && numbers[5] == 0 && numbers[6] == 0)
      fail("the quaternion is zero", "write x, y, z and then w");
    return {rotation_of({numbers[3], numbers[4], numbers[5], numbers[6]}), {numbers[0], numbers[1], numbers[2]}};
  }
  std::array<double, 12> twelve{};
  std::copy(numbers.begin(), numbers.end(), twelve.begin());
  return Pose::from_numbers(twelve);
}

std::optional<double> degrees_between(const WrittenTurn& from, const WrittenTurn& to) {
  if (from.degrees == 0 || to.degrees == 0) return to.degrees - from.degrees;
  // As written: (0.1, 0.2, 0.3) and (1, 2, 3) are one axis.
  if (length(cross(normalized(from.axis), normalized(to.axis))) > 1e-12) return {};
  return to.degrees - (dot(from.axis, to.axis) > 0 ? from.degrees : -from.degrees);
}

WrittenPose pose_of_words(const std::vector<std::string_view>& words, const FailPose& fail) {
  if (words.empty()) fail("there is no pose", ways_to_write_a_pose);
  if (number_of(words[0])) return written_pose_of_numbers(words, fail);
  return PoseWords(words, fail).read();
}

}  // namespace io

Pose pose_from_text(std::string_view text) {
  std::vector<std::string_view> words;
  const auto is_blank = [](char c) {
    return c == ' ' || (c >= '\t' && c <= '\r') || io::blanks_in_poses.find(c) != std::string_view::npos;
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t first = i;
    while (i < text.size() && !is_blank(text[i])) ++i;
    if (i > first) words.push_back(text.substr(first, i - first));
    while (i < text.size() && is_blank(text[i])) ++i;
  }
  const io::FailPose fail = [&](const std::string& what, const std::string& advice) {
    throw Error("the pose " + io::in_quotes(text) + ": " + what + "; " + advice);
  };
  return io::pose_of_words(words, fail).pose;
}

}  // namespace toccata
