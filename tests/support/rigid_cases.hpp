#pragma once

#include <optional>
#include <string>
#include <vector>

#include "oracle/rigid_motion.hpp"
#include "toccata/core/random.hpp"
#include "toccata/motion/rigid_motion.hpp"

namespace toccata::test {

/// A convex shape, where it is at the start, and how it moves from there.
struct MovingShape {
  Shape shape;
  Pose start;
  RigidMove move;

  [[nodiscard]] RigidMotion motion() const { return {start, move}; }
};

struct RigidCase {
  MovingShape a;
  MovingShape b;
};

/// Hard and ordinary pairs by name.
struct RigidFamily {
  std::string name;
  RigidCase (*draw)(Random&);
};

const std::vector<RigidFamily>& rigid_families();

[[nodiscard]] std::optional<ShapeHit> swept(const RigidCase& pair);

/// What is wrong with an answer, judged by the oracle; nothing where it is right.
std::optional<std::string> wrong_sweep(const RigidCase& pair, const std::optional<ShapeHit>& answer);

/// What must not change the answer and does: the order of the two and of their vertices, a mirror, the direction of
/// time, the unit.
std::optional<std::string> changed_sweep(const RigidCase& pair, const std::optional<ShapeHit>& answer);

oracle::FineBody fine_body(const MovingShape& body);

}  // namespace toccata::test
