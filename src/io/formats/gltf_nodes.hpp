#pragma once

#include "io/formats/json_value.hpp"
#include "toccata/math/pose.hpp"

namespace toccata::io {

/// Throws Error unless this is glTF 2 and needs nothing of a reader that changes shapes.
void check_gltf_header(const JsonValue& top);

/// Where a node is in its parent.
[[nodiscard]] Pose pose_of_node(const JsonValue& node);

/// What a file refers to by its place in a list of `count`; Error that calls it `what` when there is none.
[[nodiscard]] std::size_t index_of(const JsonValue& reference, std::size_t count, const char* what);

}  // namespace toccata::io
