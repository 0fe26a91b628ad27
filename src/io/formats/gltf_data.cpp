#include "io/formats/gltf_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/gltf_uri.hpp"
#include "toccata/core/error.hpp"

namespace toccata::io {
namespace {

constexpr std::size_t largest_size = std::size_t{1} << 50;  // sums and small multiples of such sizes cannot overflow
constexpr std::size_t largest_count = std::numeric_limits<Index>::max();

template <class Value>
Value little_endian(const char* bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(Value); ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  if constexpr (std::is_same_v<Value, float>)
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  else
    return static_cast<Value>(bits);
}

/// A component type of an accessor: its code in the file, size, and the greatest value when normalised.
struct ComponentType {
  std::size_t code;
  std::size_t size;
  double greatest;
  double (*read)(const char*);
};

template <class Value>
double widened(const char* bytes) {
  return static_cast<double>(little_endian<Value>(bytes));
}

constexpr ComponentType component_types[] = {
    {5120, 1, 127, widened<std::int8_t>},    {5121, 1, 255, widened<std::uint8_t>},
    {5122, 2, 32767, widened<std::int16_t>}, {5123, 2, 65535, widened<std::uint16_t>},
    {5125, 4, 0, widened<std::uint32_t>},    {5126, 4, 0, widened<float>},
};

const ComponentType& component_type(const JsonValue& place) {
  const std::size_t code = place.at("componentType").whole(10000);
  const auto* const found = std::find_if(std::begin(component_types), std::end(component_types),
                                         [&](const ComponentType& type) { return type.code == code; });
  if (found == std::end(component_types))
    place.at("componentType").fail("this is not a component type of glTF", "export the file again");
  return *found;
}

bool is_unsigned(const ComponentType& type) { return type.code == 5121 || type.code == 5123 || type.code == 5125; }

std::span<const char> chunk_at(const SceneBytes& source, std::size_t begin, std::uint32_t type) {
  const std::span<const char> bytes = source.bytes;
  if (bytes.size() < begin + 8) fail_at_byte(source.file, begin, {"the file ends within a chunk", "export it again"});
  const std::size_t size = little_endian<std::uint32_t>(bytes.data() + begin);
  if (little_endian<std::uint32_t>(bytes.data() + begin + 4) != type)
    fail_at_byte(source.file, begin, {"another kind of chunk is expected here", "export the file again"});
  if (size > bytes.size() - begin - 8)
    fail_at_byte(source.file, begin, {"the chunk is longer than the file", "the file is cut off; fetch it again"});
  return bytes.subspan(begin + 8, size);
}

}  // namespace

GltfChunks split_glb(const SceneBytes& source) {
  constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
  const std::span<const char> bytes = source.bytes;
  if (bytes.size() < 4 || std::string_view(bytes.data(), 4) != "glTF") return {bytes, std::nullopt};
  if (bytes.size() < 20) fail_in_file(source.file, {"the file ends within its header", "fetch or export it again"});
  const auto version = little_endian<std::uint32_t>(bytes.data() + 4);
  if (version != 2)
    fail_in_file(source.file, {fmt::format("this is version {} of GLB", version), "export it as version 2"});
  if (little_endian<std::uint32_t>(bytes.data() + 8) > bytes.size())
    fail_in_file(source.file, {"the file is shorter than its header says", "fetch or export it again"});
  GltfChunks chunks{chunk_at(source, 12, json_type), std::nullopt};
  const std::size_t after = (20 + chunks.text.size() + 3) / 4 * 4;
  if (bytes.size() >= after + 8) chunks.binary = chunk_at(source, after, binary_type);
  return chunks;
}

/// Where the elements of an accessor lie. Checked: the last byte of the last element is within the bytes.
struct GltfData::Layout {
  const ComponentType* type = nullptr;
  std::span<const char> bytes;  ///< empty: all elements are zero
  std::size_t count = 0;
  std::size_t components = 0;
  std::size_t stride = 0;
  bool normalised = false;

  [[nodiscard]] double value(std::size_t element, std::size_t component) const {
    const double raw = type->read(bytes.data() + element * stride + component * type->size);
    return normalised ? std::max(raw / type->greatest, -1.0) : raw;
  }

  /// Leaves out the first `offset` bytes, and throws Error unless all elements fit into the rest.
  void place_in(const JsonValue& place, std::span<const char> view, std::size_t offset) {
    const std::size_t needed = offset + stride * (count - 1) + components * type->size;
    if (needed > view.size())
      place.fail(fmt::format("its {} elements need {} bytes, and its view has {}", count, needed, view.size()),
                 "the file is broken; export it again");
    bytes = view.subspan(offset);
  }
};

GltfData::GltfData(const JsonValue& top, const SceneBytes& source, const GltfChunks& chunks)
    : source_(source),
      binary_(chunks.binary),
      buffers_(top.elements("buffers")),
      views_(top.elements("bufferViews")),
      accessors_(top.elements("accessors")),
      budget_((std::size_t{1} << 20) + 8 * source.bytes.size()) {}

std::span<const char> GltfData::external_buffer(const JsonValue& uri) {
  const std::string text = uri.text();
  if (text.starts_with("data:")) return loaded_.emplace_back(decode_data_uri(uri, text));
  const std::filesystem::path file = file_of_uri(uri, text, source_.folder);
  if (const auto known = files_.find(file); known != files_.end()) return known->second;
  try {
    const FileBytes bytes = read_file(file);
    budget_ += 8 * bytes.size;
    const std::vector<char>& loaded = loaded_.emplace_back(bytes.span().begin(), bytes.span().end());
    return files_.emplace(file, loaded).first->second;
  } catch (const Error& error) {
    uri.fail(error.what(), "put the buffer beside this file");
  }
}

std::span<const char> GltfData::buffer(std::size_t index) {
  const JsonValue& place = buffers_[index];
  const std::size_t size = place.at("byteLength").whole(largest_size);
  auto found = resolved_.find(index);
  if (found == resolved_.end()) {
    if (!place.has("uri") && (index != 0 || !binary_)) place.fail("the buffer has no data", "export the file again");
    found = resolved_.emplace(index, place.has("uri") ? external_buffer(place.at("uri")) : *binary_).first;
  }
  if (size > found->second.size())
    place.fail(fmt::format("the buffer has {} bytes, and should have {}", found->second.size(), size),
               "the file is cut off; fetch or export it again");
  return found->second.first(size);
}

std::span<const char> GltfData::view(const JsonValue& place, std::size_t index) {
  if (index >= views_.size()) place.fail(fmt::format("there is no buffer view {}", index), "export the file again");
  const JsonValue& view = views_[index];
  const std::size_t which = view.at("buffer").whole(largest_count);
  if (which >= buffers_.size()) view.fail(fmt::format("there is no buffer {}", which), "export the file again");
  const std::span<const char> bytes = buffer(which);
  const std::size_t offset = view.whole_or("byteOffset", largest_size, 0);
  const std::size_t size = view.at("byteLength").whole(largest_size);
  if (offset + size > bytes.size())
    view.fail(fmt::format("the view ends at byte {} of a buffer of {}", offset + size, bytes.size()),
              "the file is broken; export it again");
  return bytes.subspan(offset, size);
}

GltfData::Layout GltfData::layout_of(const JsonValue& accessor, std::size_t components) {
  Layout layout;
  layout.type = &component_type(accessor);
  layout.components = components;
  layout.count = accessor.at("count").whole(largest_count);
  if (layout.count == 0) accessor.at("count").fail("the accessor has no elements", "export the file again");
  layout.normalised = accessor.flag_or("normalized", false) && layout.type->greatest > 0;
  layout.stride = components * layout.type->size;
  if (!accessor.has("bufferView")) return layout;
  const std::size_t index = accessor.at("bufferView").whole(largest_count);
  const std::span<const char> bytes = view(accessor, index);
  const std::size_t stride = views_[index].whole_or("byteStride", 252, layout.stride);
  if (stride < layout.stride) views_[index].at("byteStride").fail("elements overlap", "export the file again");
  layout.stride = stride;
  layout.place_in(accessor, bytes, accessor.whole_or("byteOffset", largest_size, 0));
  return layout;
}

void GltfData::spend(const JsonValue& place, std::size_t elements) {
  if (elements > budget_)
    place.fail("the file asks for far more numbers than it has", "it is broken, or made to fill the memory");
  budget_ -= elements;
}

std::vector<double> GltfData::read(std::size_t index, std::size_t components) {
  const JsonValue& accessor = accessors_[index];
  const Layout layout = layout_of(accessor, components);
  spend(accessor, layout.count);
  std::vector<double> values(layout.count * components, 0);
  if (!layout.bytes.empty())
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = layout.value(i / components, i % components);
  if (accessor.has("sparse")) apply_sparse(accessor, layout, values);
  return values;
}

void GltfData::apply_sparse(const JsonValue& accessor, const Layout& layout, std::vector<double>& values) {
  const JsonValue sparse = accessor.at("sparse");
  const JsonValue where = sparse.at("indices"), what = sparse.at("values");
  Layout indices, replacements = layout;
  indices.type = &component_type(where);
  if (!is_unsigned(*indices.type)) where.fail("these are not unsigned whole numbers", "export the file again");
  indices.components = 1;
  indices.stride = indices.type->size;
  indices.count = replacements.count = sparse.at("count").whole(layout.count);
  if (indices.count == 0) return;
  replacements.stride = layout.components * layout.type->size;
  indices.place_in(where, view(where, where.at("bufferView").whole(largest_count)),
                   where.whole_or("byteOffset", largest_size, 0));
  replacements.place_in(what, view(what, what.at("bufferView").whole(largest_count)),
                        what.whole_or("byteOffset", largest_size, 0));
  for (std::size_t i = 0; i < indices.count; ++i) {
    const auto element = static_cast<std::size_t>(indices.value(i, 0));
    if (element >= layout.count) where.fail(fmt::format("there is no element {}", element), "export the file again");
    for (std::size_t c = 0; c < layout.components; ++c)
      values[element * layout.components + c] = replacements.value(i, c);
  }
}

std::vector<double> GltfData::numbers(std::size_t accessor, std::string_view type) {
  const JsonValue told = accessors_[accessor].at("type");
  if (told.text() != type) told.fail(fmt::format("this must be of type {}", type), "export the file again");
  return read(accessor, type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4);
}

std::vector<Vec3> GltfData::vectors(std::size_t accessor) {
  const std::vector<double> values = numbers(accessor, "VEC3");
  std::vector<Vec3> result;
  result.reserve(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); i += 3) result.push_back({values[i], values[i + 1], values[i + 2]});
  return result;
}

std::vector<Index> GltfData::indices(std::size_t accessor) {
  const JsonValue& place = accessors_[accessor];
  if (place.at("type").text() != "SCALAR" || !is_unsigned(component_type(place)))
    place.fail("indices must be unsigned whole numbers of type SCALAR", "export the file again");
  const std::vector<double> values = read(accessor, 1);
  std::vector<Index> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(static_cast<Index>(value));
  return result;
}

}  // namespace toccata::io
