#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace toccata {

/// Positions where a program keeps them: x, y and z in a row, the next ones `stride` bytes after. Refers to them.
struct PositionBuffer {
  PositionBuffer(const float* first_x, std::size_t how_many, std::size_t bytes = 3 * sizeof(float))
      : floats(first_x), count(how_many), stride(bytes) {}
  PositionBuffer(const double* first_x, std::size_t how_many, std::size_t bytes = 3 * sizeof(double))
      : doubles(first_x), count(how_many), stride(bytes) {}

  const float* floats = nullptr;  ///< one of the two
  const double* doubles = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;
};

/// Corners of triangles, three a triangle, counted from 0: `{indices}` of a vector or span, or
/// `{first, count}`. Refers to them.
struct IndexBuffer {
  IndexBuffer(std::span<const std::uint16_t> indices) : narrow(indices.data()), count(indices.size()) {}
  IndexBuffer(std::span<const std::uint32_t> indices) : wide(indices.data()), count(indices.size()) {}
  IndexBuffer(const std::uint16_t* first, std::size_t how_many) : narrow(first), count(how_many) {}
  IndexBuffer(const std::uint32_t* first, std::size_t how_many) : wide(first), count(how_many) {}

  const std::uint16_t* narrow = nullptr;  ///< one of the two
  const std::uint32_t* wide = nullptr;
  std::size_t count = 0;
};

}  // namespace toccata
