#include "reports/glb/glb_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
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

/// Chunks end at a multiple of four bytes: so many are missing.
std::size_t missing_bytes(std::size_t size) { return (4 - size % 4) % 4; }

void append_chunk_head(std::string& file, std::size_t size, std::string_view type) {
  append_number(file, static_cast<std::uint32_t>(size + missing_bytes(size)));
  file += type;
}

/// Bytes that wait in a file are given to it by so many.
constexpr std::size_t most_in_memory = std::size_t{1} << 20;

/// glTF's colours are linear. Rounded, so that every machine writes the same digits.
double linear_part(unsigned colour, unsigned shift) {
  const double c = static_cast<double>(colour >> shift & 255U) / 255;
  return std::round(1e4 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4))) / 1e4;
}

}  // namespace

std::size_t JsonList::add(const Json& value) {
  if (size_ > 0) text_ += ',';
  text_ += value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return size_++;
}

GlbWriter::GlbWriter(const std::filesystem::path& beside) : waiting_(beside) { waiting_->forget_name(); }

void GlbWriter::add_bytes(std::string_view bytes) {
  bytes_ += bytes;
  size_ += bytes.size();
  if (!waiting_ || bytes_.size() < most_in_memory) return;
  waiting_->append(bytes_);
  bytes_.clear();
}

template <class Number>
std::size_t GlbWriter::add_view(std::span<const Number> numbers, std::optional<int> target) {
  add_bytes(filling());
  Json view{{"buffer", 0}, {"byteOffset", size_}, {"byteLength", numbers.size_bytes()}};
  if (target) view["target"] = *target;
  const auto bytes = std::as_bytes(numbers);
  add_bytes({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return views_.add(view);
}

std::size_t GlbWriter::add_points(std::span<const std::array<float, 3>> points) {
  std::array<float, 3> least = points[0], greatest = points[0];
  for (const auto& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], point[axis]);
      greatest[axis] = std::max(greatest[axis], point[axis]);
    }
  return accessors_.add({{"bufferView", add_view(points, array_buffer)},
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
  return accessors_.add({{"bufferView", write()},
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
  return materials_.add(material);
}

std::size_t GlbWriter::add_mesh(const Json& mesh) { return meshes_.add(mesh); }

std::size_t GlbWriter::add_node(const Json& node) { return nodes_.add(node); }

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
  return accessors_.add(accessor);
}

void GlbWriter::add_animation(const Json& animation) { animations_.add(animation); }

std::string GlbWriter::filling() const { return std::string(missing_bytes(size_), '\0'); }

std::string GlbWriter::head(std::size_t root) const {
  const Json first = {{"asset", {{"version", "2.0"}, {"generator", fmt::format("Toccata {}", version)}}},
                      {"scene", 0},
                      {"scenes", {{{"nodes", {root}}}}}};
  std::string text = first.dump();
  text.pop_back();
  const auto add = [&](std::string_view name, const std::string& all) {
    if (!all.empty()) text += fmt::format(R"(,"{}":[{}])", name, all);  // an empty list is no glTF
  };
  add("nodes", nodes_.text());
  add("meshes", meshes_.text());
  add("materials", materials_.text());
  add("animations", animations_.text());
  add("accessors", accessors_.text());
  add("bufferViews", views_.text());
  if (size_ > 0) text += fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", size_);
  text += '}';
  constexpr std::size_t headers = 28, fillings = 6;
  const std::size_t most = text.size() + size_ + headers + fillings;
  if (most > std::numeric_limits<std::uint32_t>::max())
    throw Error(fmt::format("the GLB file would have {:.1f} GB, and 4.2 are the most: export fewer objects",
                            static_cast<double>(most) / 1e9));
  std::string chunks;
  append_chunk_head(chunks, text.size(), "JSON");
  chunks += text;
  chunks.append(missing_bytes(text.size()), ' ');
  if (size_ > 0) append_chunk_head(chunks, size_, std::string_view("BIN\0", 4));
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, static_cast<std::uint32_t>(12 + chunks.size() + size_ + missing_bytes(size_)));
  return file += chunks;
}

std::string GlbWriter::file(std::size_t root) const { return head(root) + bytes_ + filling(); }

void GlbWriter::write(std::size_t root, const std::filesystem::path& path) const {
  FileInMaking file(path);
  file.append(head(root));
  if (waiting_) file.append(*waiting_);
  file.append(bytes_ + filling());
  file.complete();
}

}  // namespace toccata::io
