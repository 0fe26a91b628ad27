#include "reports/glb/glb_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"

namespace toccata::io {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int of_shorts = 5123, of_integers = 5125, of_floats = 5126;

void append_number(std::string& bytes, std::uint32_t number) {
  for (const unsigned shift : {0U, 8U, 16U, 24U}) bytes += static_cast<char>(number >> shift & 255U);
}

/// Chunks end at a multiple of four bytes.
void append_chunk(std::string& file, std::string_view type, std::string_view content, char filling) {
  const std::size_t missing = (4 - content.size() % 4) % 4;
  append_number(file, static_cast<std::uint32_t>(content.size() + missing));
  file += type;
  file += content;
  file.append(missing, filling);
}

/// glTF's colours are linear. Rounded, so that every machine writes the same digits.
double linear_part(unsigned colour, unsigned shift) {
  const double c = static_cast<double>(colour >> shift & 255U) / 255;
  return std::round(1e4 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4))) / 1e4;
}

}  // namespace

template <class Number>
std::size_t GlbWriter::add_view(std::span<const Number> numbers, std::optional<int> target) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const std::size_t at = bytes_.size();
  bytes_.resize(at + numbers.size_bytes());
  std::memcpy(bytes_.data() + at, numbers.data(), numbers.size_bytes());
  Json& view = views_.emplace_back(Json{{"buffer", 0}, {"byteOffset", at}, {"byteLength", numbers.size_bytes()}});
  if (target) view["target"] = *target;
  return views_.size() - 1;
}

std::size_t GlbWriter::add_accessor(Json accessor) {
  accessors_.push_back(std::move(accessor));
  return accessors_.size() - 1;
}

std::size_t GlbWriter::add_points(std::span<const std::array<float, 3>> points) {
  std::array<float, 3> least = points[0], greatest = points[0];
  for (const auto& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], point[axis]);
      greatest[axis] = std::max(greatest[axis], point[axis]);
    }
  return add_accessor({{"bufferView", add_view(points, array_buffer)},
                       {"componentType", of_floats},
                       {"count", points.size()},
                       {"type", "VEC3"},
                       {"min", least},
                       {"max", greatest}});
}

std::size_t GlbWriter::add_corners(std::span<const Index> corners, std::size_t points) {
  // The greatest number of a type is no vertex: it means that a strip begins anew.
  const bool is_short = points <= std::numeric_limits<std::uint16_t>::max();
  const auto write = [&] {
    if (!is_short) return add_view(corners, element_array_buffer);
    std::vector<std::uint16_t> shorts;
    shorts.reserve(corners.size());
    for (const Index corner : corners) shorts.push_back(static_cast<std::uint16_t>(corner));
    return add_view(std::span<const std::uint16_t>(shorts), element_array_buffer);
  };
  return add_accessor({{"bufferView", write()},
                       {"componentType", is_short ? of_shorts : of_integers},
                       {"count", corners.size()},
                       {"type", "SCALAR"}});
}

Json GlbWriter::add_part(const GlbPart& part, GlbMode mode) {
  Json primitive = {{"attributes", {{"POSITION", add_points(part.points)}}}};
  if (!part.corners.empty()) primitive["indices"] = add_corners(part.corners, part.points.size());
  primitive["mode"] = static_cast<int>(mode);
  return primitive;
}

std::size_t GlbWriter::add_material(const std::string& name, unsigned colour, double cover) {
  Json material = {
      {"name", name},
      {"pbrMetallicRoughness",
       {{"baseColorFactor", {linear_part(colour, 16), linear_part(colour, 8), linear_part(colour, 0), cover}},
        {"metallicFactor", 0},
        {"roughnessFactor", 0.8}}},
      {"doubleSided", true}};
  if (cover < 1) material["alphaMode"] = "BLEND";
  materials_.push_back(std::move(material));
  return materials_.size() - 1;
}

std::size_t GlbWriter::add_mesh(Json mesh) {
  meshes_.push_back(std::move(mesh));
  return meshes_.size() - 1;
}

std::size_t GlbWriter::add_node(Json node) {
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

std::size_t GlbWriter::add_keys(std::span<const float> numbers, std::size_t width) {
  const char* type = width == 1 ? "SCALAR" : width == 3 ? "VEC3" : "VEC4";
  Json accessor = {{"bufferView", add_view(numbers, std::nullopt)},
                   {"componentType", of_floats},
                   {"count", numbers.size() / width},
                   {"type", type}};
  if (width == 1) {  // moments of time, ascending
    accessor["min"] = {numbers.front()};
    accessor["max"] = {numbers.back()};
  }
  return add_accessor(std::move(accessor));
}

void GlbWriter::add_animation(Json animation) { animations_.push_back(std::move(animation)); }

std::string GlbWriter::file(std::size_t root) const {
  Json top = {{"asset", {{"version", "2.0"}, {"generator", fmt::format("Toccata {}", version)}}},
              {"scene", 0},
              {"scenes", {{{"nodes", {root}}}}},
              {"nodes", nodes_}};
  const auto add = [&](const char* name, const Json& all) {
    if (!all.empty()) top[name] = all;  // an empty list is no glTF
  };
  add("meshes", meshes_);
  add("materials", materials_);
  add("animations", animations_);
  add("accessors", accessors_);
  add("bufferViews", views_);
  if (!bytes_.empty()) top["buffers"] = {{{"byteLength", bytes_.size()}}};
  const std::string text = top.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t headers = 28, fillings = 6;
  const std::size_t most = text.size() + bytes_.size() + headers + fillings;
  if (most > std::numeric_limits<std::uint32_t>::max())
    throw Error(fmt::format("the GLB file would have {:.1f} GB, and 4.2 are the most: export fewer objects",
                            static_cast<double>(most) / 1e9));
  std::string chunks;
  append_chunk(chunks, "JSON", text, ' ');
  if (!bytes_.empty()) append_chunk(chunks, std::string_view("BIN\0", 4), bytes_, '\0');
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, static_cast<std::uint32_t>(12 + chunks.size()));
  return file += chunks;
}

}  // namespace toccata::io
