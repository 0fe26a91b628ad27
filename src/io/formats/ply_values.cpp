#include "io/formats/ply_values.hpp"

#include "io/formats/file_error.hpp"

namespace toccata::io {
namespace {

constexpr const char* truncated = "the file ends before its last element";
constexpr const char* too_long = "there is more in the file than its header announces";
constexpr const char* counts_advice = "correct the counts in the header or export the mesh again";

}  // namespace

void PlyTextValues::expect_end() {
  if (cursor_.next_line_with_words()) cursor_.fail(too_long, counts_advice);
}

void PlyBinaryValues::expect_end() const {
  const std::string_view rest(file_.data() + position_, file_.size() - position_);
  if (rest.find_first_not_of(" \r\n") != std::string_view::npos) fail(too_long, counts_advice);
}

void PlyTextValues::seek_word() {
  if (cursor_.at_line_end() && !cursor_.next_line_with_words()) cursor_.fail(truncated, counts_advice);
}

double PlyTextValues::number(PlyType /*type*/, std::string_view what) {
  seek_word();
  return cursor_.number(what);
}

std::int64_t PlyTextValues::integer(PlyType /*type*/, std::string_view what) {
  seek_word();
  return cursor_.integer(what);
}

void PlyTextValues::skip(PlyType /*type*/, std::size_t values) {
  for (std::size_t value = 0; value < values; ++value) {
    seek_word();
    static_cast<void>(cursor_.word());
  }
}

std::size_t PlyTextValues::most_elements_left(std::size_t values, std::size_t /*bytes*/) const {
  // A value takes one character and one before or behind it, but for the first or last of the file.
  return (cursor_.bytes_left() + 1) / (2 * values);
}

void PlyBinaryValues::fail_before(std::size_t bytes, std::string_view what) const {
  fail_at_byte(name_, position_ - bytes, {std::string(what) + " is not finite", "export the mesh again"});
}

void PlyBinaryValues::skip(PlyType type, std::size_t values) {
  // A count has at most 32 bits: no overflow.
  static_cast<void>(take(size_of(type) * values));
}

std::size_t PlyBinaryValues::most_elements_left(std::size_t /*values*/, std::size_t bytes) const {
  return (file_.size() - position_) / bytes;
}

void PlyBinaryValues::fail(const std::string& what, const std::string& advice) const {
  fail_at_byte(name_, position_, {what, advice});
}

void PlyBinaryValues::fail_truncated() const { fail(truncated, counts_advice); }

}  // namespace toccata::io
