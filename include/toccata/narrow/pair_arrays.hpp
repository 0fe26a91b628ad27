#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "toccata/narrow/primitives.hpp"

// Many pairs of simple shapes at once: pair i is the i-th of both arrays. The same answers as one by one, exact, with
// vector instructions (core/simd.hpp).
namespace toccata {

/// Rows of numbers, kept column by column.
template <std::size_t Width>
class Columns {
 public:
  [[nodiscard]] std::size_t size() const { return column_[0].size(); }
  [[nodiscard]] const double* column(std::size_t i) const { return column_[i].data(); }

 protected:
  void append_row(const std::array<double, Width>& row) {
    for (std::size_t i = 0; i < Width; ++i) column_[i].push_back(row[i]);
  }

 private:
  std::array<std::vector<double>, Width> column_;
};

class SphereArray : public Columns<4> {
 public:
  void append(const PosedSphere& s) { append_row({s.centre.x, s.centre.y, s.centre.z, s.radius}); }
  [[nodiscard]] PosedSphere operator[](std::size_t i) const {
    return {{column(0)[i], column(1)[i], column(2)[i]}, column(3)[i]};
  }
};

/// In world coordinates.
class TriangleArray : public Columns<9> {
 public:
  void append(const Triangle& t) {
    append_row({t[0].x, t[0].y, t[0].z, t[1].x, t[1].y, t[1].z, t[2].x, t[2].y, t[2].z});
  }
  [[nodiscard]] Triangle operator[](std::size_t i) const {
    const auto corner = [&](std::size_t k) { return Vec3{column(k)[i], column(k + 1)[i], column(k + 2)[i]}; };
    return {{corner(0), corner(3), corner(6)}};
  }
};

class CapsuleArray : public Columns<7> {
 public:
  void append(const PosedCapsule& c) {
    append_row({c.start.x, c.start.y, c.start.z, c.end.x, c.end.y, c.end.z, c.radius});
  }
  [[nodiscard]] PosedCapsule operator[](std::size_t i) const {
    return {{column(0)[i], column(1)[i], column(2)[i]}, {column(3)[i], column(4)[i], column(5)[i]}, column(6)[i]};
  }
};

/// Oriented boxes: the parallelepiped of the formulas, and the eight world corners.
class BoxArray : public Columns<41> {
 public:
  void append(const PosedBox& box);
  [[nodiscard]] const PosedBox& operator[](std::size_t i) const { return box_[i]; }

 private:
  std::vector<PosedBox> box_;
};

/// Boxes along the world's axes, by their corners of least and of greatest coordinates.
class AlignedBoxArray : public Columns<6> {
 public:
  void append(const Vec3& lower, const Vec3& upper) {
    append_row({lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
  }
};

// What is asked of arrays throws Error when they are not of the same length.

/// For each pair 1 if it has a common point, else 0.
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const SphereArray& a, const SphereArray& b);
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const SphereArray& a, const TriangleArray& b);
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const SphereArray& a, const BoxArray& b);
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const CapsuleArray& a, const CapsuleArray& b);
[[nodiscard]] std::vector<std::uint8_t> overlap_each(const AlignedBoxArray& a, const AlignedBoxArray& b);

/// For each pair the same distance, bit by bit, as alone.
[[nodiscard]] std::vector<Distance> distance_each(const SphereArray& a, const SphereArray& b);
[[nodiscard]] std::vector<Distance> distance_each(const SphereArray& a, const TriangleArray& b);
[[nodiscard]] std::vector<Distance> distance_each(const SphereArray& a, const BoxArray& b);
[[nodiscard]] std::vector<Distance> distance_each(const CapsuleArray& a, const CapsuleArray& b);

}  // namespace toccata
