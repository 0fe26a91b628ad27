#include "io/formats/tree_bytes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

#include <fmt/format.h>

#include "io/formats/binary_values.hpp"
#include "io/formats/file_error.hpp"

namespace toccata::io {
namespace {

// A byte above 127 and both kinds of line ends, as PNG has them: a transfer as text damages these first.
constexpr std::string_view magic{"\x89TCT\r\n\x1a\n", 8};
constexpr std::uint64_t tree_format_version = 1;

constexpr std::size_t tree_header_size = 136;
constexpr std::size_t words_of_block = 6 * WideBlock::width + WideBlock::width + 1;
constexpr std::size_t block_size = 4 * words_of_block;

/// FNV-1a (G. Fowler, L. C. Noll, K.-P. Vo) over words of 64 bits, turned after each, so that high bits reach low ones.
/// A step is one to one in the word and in what was before: a single changed word always changes the result.
class Checksum {
 public:
  void add(std::uint64_t word) { value_ = std::rotl((value_ ^ word) * 0x100000001b3, 29); }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

template <typename T>
void append(std::string& bytes, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

/// Reads one value after another.
class ByteReader {
 public:
  explicit ByteReader(std::span<const char> bytes) : rest_(bytes) {}

  template <typename T>
  T next() {
    const T value = stored_value<T>(rest_, std::endian::little);
    rest_ = rest_.subspan(sizeof(T));
    return value;
  }
  std::span<const char> take(std::size_t bytes) {
    const auto taken = rest_.first(bytes);
    rest_ = rest_.subspan(bytes);
    return taken;
  }
  Vec3 next_vector() {
    const double x = next<double>(), y = next<double>(), z = next<double>();
    return {x, y, z};
  }

 private:
  std::span<const char> rest_;
};

void append(std::string& bytes, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, v[axis]);
}

// A block's values lie in memory as they do in a file, but for their bytes' order.
static_assert(std::is_standard_layout_v<WideBlock> && offsetof(WideBlock, count) == block_size - 4);

void append(std::string& bytes, const WideBlock& block) {
  if constexpr (std::endian::native == std::endian::little) {
    bytes.append(reinterpret_cast<const char*>(&block), block_size);
    return;
  }
  for (const auto* values : {&block.centre, &block.extent})
    for (const auto& axis : *values)
      for (const float value : axis) append(bytes, value);
  for (const std::int32_t child : block.child) append(bytes, child);
  append(bytes, block.count);
}

WideBlock next_block(ByteReader& reader) {
  WideBlock block{};
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(&block, reader.take(block_size).data(), block_size);
    return block;
  }
  for (auto* values : {&block.centre, &block.extent})
    for (auto& axis : *values)
      for (float& value : axis) value = reader.next<float>();
  for (std::int32_t& child : block.child) child = reader.next<std::int32_t>();
  block.count = reader.next<std::uint32_t>();
  return block;
}

/// What comes first in a file.
struct Header {
  std::uint64_t version;
  std::uint64_t checksum;
  std::uint64_t digest;
  std::uint64_t triangles;
  std::uint64_t blocks;
};

/// The reader is at the origin then.
Header next_header(ByteReader& reader) {
  Header header{};
  static_cast<void>(reader.next<std::uint64_t>());  // the magic
  header.version = reader.next<std::uint64_t>();
  header.checksum = reader.next<std::uint64_t>();
  header.digest = reader.next<std::uint64_t>();
  header.triangles = reader.next<std::uint64_t>();
  header.blocks = reader.next<std::uint64_t>();
  return header;
}

void require_known(std::span<const char> bytes, std::string_view name) {
  if (!begins_as_tree({bytes.data(), bytes.size()}))
    fail_in_file(name, {"this is no tree file", "write one with save_tree or `toccata tree MESH --save FILE`"});
  if (bytes.size() < tree_header_size) fail_in_file(name, {"the tree file is cut short", "write it again"});
}

void require_whole(std::span<const char> bytes, const Header& header, std::string_view name) {
  if (header.version != tree_format_version)
    fail_in_file(name, {fmt::format("this is a tree file of version {}, and version {} is read", header.version,
                                    tree_format_version),
                        "write it again with this version of Toccata"});
  // Also keeps the product in range.
  const bool countable = header.triangles <= WideBuildOptions::greatest_item_count &&
                         header.blocks <= 2 * std::uint64_t{WideBuildOptions::greatest_item_count};
  const std::uint64_t size = tree_header_size + header.blocks * block_size + header.triangles * sizeof(Index);
  if (!countable || size != bytes.size())
    fail_in_file(
        name, {fmt::format("the tree file is cut short or damaged: it has {} bytes", bytes.size()), "write it again"});
  if (checksum_of(bytes.subspan(tree_checksum_at + 8)) != header.checksum)
    fail_in_file(name, {"the tree file is damaged: its checksum is another", "write it again"});
}

void require_same_mesh(const Header& header, const TriangleMesh& mesh, std::string_view name) {
  const std::uint64_t digest = digest_of(mesh);
  if (header.triangles == mesh.triangle_count() && header.digest == digest) return;
  fail_in_file(name, {fmt::format("the tree is of another mesh: of one of {} triangles and digest {:016x}, and the "
                                  "mesh given has {} and {:016x}",
                                  header.triangles, header.digest, mesh.triangle_count(), digest),
                      "give the mesh it was saved for, or save a tree of this one"});
}

}  // namespace

bool begins_as_tree(std::string_view bytes) { return bytes.substr(0, magic.size()) == magic; }

std::uint64_t checksum_of(std::span<const char> bytes) {
  Checksum checksum;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8))
    checksum.add(stored_value<std::uint64_t>(bytes, std::endian::little));
  std::uint64_t last = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) last = last << 8 | static_cast<unsigned char>(bytes[i]);
  checksum.add(last);
  return checksum.value();
}

std::uint64_t digest_of(const TriangleMesh& mesh) {
  Checksum checksum;
  checksum.add(mesh.vertices().size());
  for (const Vec3& vertex : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis) checksum.add(std::bit_cast<std::uint64_t>(vertex[axis] + 0.0));  // −0 + 0 = 0
  for (const auto& corners : mesh.triangles())
    for (const Index corner : corners) checksum.add(corner);
  return checksum.value();
}

std::string tree_bytes(const WideBvh& tree, const TriangleMesh& mesh) {
  std::string bytes;
  bytes.reserve(tree_header_size + tree.blocks.size() * block_size + tree.items.size() * sizeof(Index));
  bytes += magic;
  append(bytes, tree_format_version);
  append(bytes, std::uint64_t{0});  // the checksum's place
  append(bytes, digest_of(mesh));
  append(bytes, std::uint64_t{tree.items.size()});
  append(bytes, std::uint64_t{tree.blocks.size()});
  append(bytes, tree.origin);
  append(bytes, tree.unit);
  append(bytes, tree.box.lower);
  append(bytes, tree.box.upper);
  append(bytes, tree.built_size);
  for (const WideBlock& block : tree.blocks) append(bytes, block);
  for (const Index item : tree.items) append(bytes, item);
  std::string checksum;
  append(checksum, checksum_of(std::span<const char>(bytes).subspan(tree_checksum_at + 8)));
  return bytes.replace(tree_checksum_at, checksum.size(), checksum);
}

WideBvh parse_tree(std::span<const char> bytes, const TriangleMesh& mesh, std::string_view name) {
  require_known(bytes, name);
  ByteReader reader(bytes);
  const Header header = next_header(reader);
  require_whole(bytes, header, name);
  require_same_mesh(header, mesh, name);
  WideBvh tree;
  tree.origin = reader.next_vector();
  tree.unit = reader.next<double>();
  tree.box.lower = reader.next_vector();
  tree.box.upper = reader.next_vector();
  tree.built_size = reader.next<double>();
  tree.blocks.reserve(header.blocks);
  for (std::uint64_t i = 0; i < header.blocks; ++i) tree.blocks.push_back(next_block(reader));
  tree.items.reserve(header.triangles);
  for (std::uint64_t i = 0; i < header.triangles; ++i) tree.items.push_back(reader.next<Index>());
  return tree;
}

}  // namespace toccata::io
