#pragma once

#include <functional>
#include <memory>
#include <string>

#include "io/formats/json.hpp"
#include "io/formats/json_value.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::io {

/// Reads the mesh that an object, a part or a hull names by its "file" or "mesh".
using MeshReading = std::function<std::shared_ptr<const TriangleMesh>(const JsonValue& holder)>;

/// Keeps a mesh, and gives how an object names it: {"file": …} or {"mesh": …}.
using MeshWriting = std::function<Json(const std::shared_ptr<const TriangleMesh>& mesh)>;

/// Whether a pose has the bits of the identity: one that is only equal to it, with a −0, is written out.
[[nodiscard]] bool is_left_out(const Pose& pose);

/// Says an Error of the library at a place of the file; its own advice stays the last words.
[[noreturn]] void fail_at(const JsonValue& place, const Error& error);

/// Runs `action`; an Error in it is said to be at `place`.
template <class Action>
auto located(const JsonValue& place, const Action& action) {
  try {
    return action();
  } catch (const Error& error) {
    fail_at(place, error);
  }
}

/// A pose of a scene file, and the uniform scale that is in it.
struct ScaledPose {
  Pose pose;         ///< as docs/reference/scene-file.md says, the scale included
  Mat3 unscaled;     ///< its linear part without the uniform scale
  double scale = 1;  ///< the uniform scale
};
[[nodiscard]] ScaledPose pose_of(const JsonValue& value);

/// The "shape" of an object or of a part of a compound.
[[nodiscard]] Shape shape_of(const JsonValue& value, const MeshReading& read_mesh);

[[nodiscard]] Json json_of(const Vec3& v);

/// What `shape_of` reads as the same shape; of a mesh what `write_mesh` gives, which has no "type".
[[nodiscard]] Json json_of(const Shape& shape, const MeshWriting& write_mesh);

/// "sphere", "convex-hull" …: the "type" of a shape, and "mesh".
[[nodiscard]] std::string type_of(const Shape& shape);

}  // namespace toccata::io
