#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "library.hpp"
#include "toccata/robots.hpp"

namespace toccata::bench {

/// A robot among obstacles, asked configuration by configuration; or a peer that is told where the links are.
class RobotLibrary {
 public:
  virtual ~RobotLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Not measured.
  virtual void build(const RobotScene& scene) = 0;
  /// Measured: whether anything meets at each of the configurations, from their numbers on.
  [[nodiscard]] virtual std::vector<std::uint8_t> meets(std::span<const double> configurations) = 0;
};

using RobotLibraries = std::vector<std::unique_ptr<RobotLibrary>>;

RobotLibraries fcl_robots();

}  // namespace toccata::bench
