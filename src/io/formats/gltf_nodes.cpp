#include "io/formats/gltf_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "toccata/core/error.hpp"
#include "toccata/core/index.hpp"

namespace toccata::io {
namespace {

/// Extensions that a file may require without changing any shape, by the start of their names.
constexpr std::string_view harmless_extensions[] = {"KHR_materials_",      "KHR_texture_",          "EXT_texture_",
                                                    "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_xmp",
                                                    "KHR_technique"};

/// glTF writes matrices by columns.
Pose pose_of_matrix(const JsonValue& matrix) {
  const std::vector<double> m = matrix.numbers(16);
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    matrix.fail("the last row of the matrix is not 0 0 0 1", "export the file without a perspective");
  return Pose::from_numbers({m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10], m[12], m[13], m[14]});
}

}  // namespace

void check_gltf_header(const JsonValue& top) {
  const bool has_version = top.has("asset") && top.at("asset").has("version");
  if (!has_version || !top.at("asset").at("version").is_string() ||
      !top.at("asset").at("version").text().starts_with("2."))
    top.fail("this is not glTF 2", "export it as glTF 2.0");
  for (const JsonValue& required : top.elements("extensionsRequired")) {
    const std::string name = required.text();
    if (std::none_of(std::begin(harmless_extensions), std::end(harmless_extensions),
                     [&](std::string_view start) { return name.starts_with(start); }))
      required.fail(fmt::format("the file needs the extension {}, which Toccata does not read", name),
                    "export it without (compression off)");
  }
}

Pose pose_of_node(const JsonValue& node) {
  if (node.has("matrix")) return pose_of_matrix(node.at("matrix"));
  Quaternion rotation;
  if (node.has("rotation")) {
    const std::vector<double> q = node.at("rotation").numbers(4);
    rotation = {q[0], q[1], q[2], q[3]};
  }
  try {
    return pose_of(node.has("translation") ? node.at("translation").vector() : Vec3{}, rotation_of(rotation),
                   node.has("scale") ? node.at("scale").vector() : Vec3{1, 1, 1});
  } catch (const Error& error) {
    node.fail(error.what(), "correct the rotation");
  }
}

std::size_t index_of(const JsonValue& reference, std::size_t count, const char* what) {
  const std::size_t index = reference.whole(std::numeric_limits<Index>::max());
  if (index >= count) reference.fail(fmt::format("there is no {} {}", what, index), "export the file again");
  return index;
}

}  // namespace toccata::io
