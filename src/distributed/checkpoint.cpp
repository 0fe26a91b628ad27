#include <array>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "distributed/body_bytes.hpp"
#include "distributed/distributed_state.hpp"
#include "toccata/core/error.hpp"

// A folder with a file of bodies for each rank that wrote it, and an index that tells how many there are and what they
// hold. The index is written last: without it a folder is no checkpoint.
namespace toccata {
namespace {

namespace fs = std::filesystem;

/// In front of each file. The number tells that the machine that reads has its numbers as that which wrote.
struct FileHead {
  std::array<char, 24> words{'T', 'o', 'c', 'c', 'a', 't', 'a', ' ', 'c', 'h', 'e',
                             'c', 'k', 'p', 'o', 'i', 'n', 't', ' ', '2', '\n'};
  double number = 0x1.23456789abcdep-3;
  std::uint64_t size = 0;
  std::uint64_t sum = 0;
};

/// (G. Fowler, L. C. Noll, K.-P. Vo, the hash FNV-1a.)
std::uint64_t sum_of(const Bytes& bytes) {
  std::uint64_t sum = 0xcbf29ce484222325;
  for (const std::byte byte : bytes) sum = (sum ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
  return sum;
}

fs::path index_of(const fs::path& folder) { return folder / "index.toccata"; }
fs::path part_of(const fs::path& folder, std::uint64_t rank) {
  return folder / fmt::format("bodies-{:05}.toccata", rank);
}

/// It is complete or not there.
void write_file(const fs::path& path, const Bytes& bytes) {
  const fs::path unfinished = path.string() + ".unfinished";
  FileHead head;
  head.size = bytes.size();
  head.sum = sum_of(bytes);
  std::ofstream file(unfinished, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&head), sizeof(head));
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code trouble;
  if (file) fs::rename(unfinished, path, trouble);
  if (!file || trouble)
    throw Error(
        fmt::format("{}: it cannot be written; is there room, and may the folder be written to?", path.string()));
}

Bytes read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(fmt::format("{}: there is no such file that can be read", path.string()));
  FileHead head;
  const FileHead expected;
  if (!file.read(reinterpret_cast<char*>(&head), sizeof(head)) || head.words != expected.words)
    throw Error(fmt::format("{}: this is no checkpoint of this version of Toccata", path.string()));
  if (head.number != expected.number)
    throw Error(fmt::format("{}: it was written on another kind of machine", path.string()));
  std::error_code trouble;
  if (fs::file_size(path, trouble) != sizeof(head) + head.size || trouble)
    throw Error(fmt::format("{}: it ends too early, or has more than was written", path.string()));
  Bytes bytes(head.size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file || sum_of(bytes) != head.sum) throw Error(fmt::format("{}: it is damaged", path.string()));
  return bytes;
}

void require_new(const fs::path& folder) {
  std::error_code trouble;
  if (fs::exists(folder, trouble) && !(fs::is_directory(folder, trouble) && fs::is_empty(folder, trouble)))
    throw Error(fmt::format("{}: there is something already; give a folder that is new or empty", folder.string()));
  fs::create_directories(folder, trouble);
  if (trouble) throw Error(fmt::format("{}: {}", folder.string(), trouble.message()));
}

}  // namespace

Bytes DistributedWorld::State::bytes_of_bodies() const {
  constexpr int reader = 1;
  ModelStore models(0);  // each shared model is written once
  MessageWriter writer;
  const std::vector<GlobalId> ids = bodies();
  writer.put_number(ids.size());
  for (const GlobalId id : ids) {
    writer.put_number(id);
    put_body(writer, body(id), models, reader, ModelGoes::once);
    put_rules(writer, id);
  }
  return writer.take();
}

void DistributedWorld::State::save(const std::filesystem::path& folder) {
  Bytes own;
  ranks_.all_do([&] {
    require_whole();
    if (!wanted.is_empty()) throw Error("changes are noted that no step has made yet: call step before save");
    if (ranks_.rank() == 0) require_new(folder);
    own = bytes_of_bodies();
    return false;
  });
  ranks_.all_do([&] {
    write_file(part_of(folder, static_cast<std::uint64_t>(ranks_.rank())), own);
    return false;
  });
  MessageWriter sum;
  sum.put(sum_of(own));
  const std::vector<Bytes> sums = ranks_.of_all(sum.take());
  ranks_.all_do([&] {
    if (ranks_.rank() != 0) return false;
    MessageWriter index;
    index.put(std::uint64_t{sums.size()});
    for (const Bytes& one : sums) index.put(MessageReader(one).get<std::uint64_t>());
    write_file(index_of(folder), index.take());
    return false;
  });
}

void DistributedWorld::State::want_bodies_of(std::span<const std::byte> bytes) {
  ModelStore models(1);
  MessageReader reader(bytes);
  for (std::uint64_t count = reader.get_number(); count > 0; --count) {
    const GlobalId id = reader.get_number();
    wanted.added.push_back({id, get_body(reader, models)});
    // Both bodies have a rule: that of the lesser counts.
    for (const auto& [other, rule] : get_rules(reader))
      if (id < other) wanted.rules.push_back({id, other, rule.excluded, rule.margin});
  }
}

void DistributedWorld::State::load(const std::filesystem::path& folder) {
  ranks_.all_do([&] {
    const Bytes index = read_file(index_of(folder));
    MessageReader reader(index);
    const auto parts = reader.get<std::uint64_t>();
    const auto ranks = static_cast<std::uint64_t>(ranks_.count());
    for (std::uint64_t part = 0; part < parts; ++part) {
      const auto sum = reader.get<std::uint64_t>();
      if (part % ranks != static_cast<std::uint64_t>(ranks_.rank())) continue;
      const fs::path path = part_of(folder, part);
      const Bytes bytes = read_file(path);
      if (sum_of(bytes) != sum)
        throw Error(fmt::format("{}: it belongs to another checkpoint than the index", path.string()));
      want_bodies_of(bytes);
    }
    return false;
  });
  static_cast<void>(step());
  last_.persist = std::exchange(last_.begin, {});
}

}  // namespace toccata
