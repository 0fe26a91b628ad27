#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "distributed/messages.hpp"
#include "toccata/query/model.hpp"

namespace toccata {

/// Shapes as bytes and back: the same numbers, so every answer about them is the same bits.
void put_shape(MessageWriter& writer, const Shape& shape);
[[nodiscard]] Shape get_shape(MessageReader& reader);

/// Models on their way between ranks. Those that are large, and that bodies share, are sent to a rank once and kept
/// there; after that their name is enough.
class ModelStore {
 public:
  explicit ModelStore(int rank) : rank_(rank) {}

  void put(MessageWriter& writer, const Model& model, int to);
  /// All of it, each time: of one that will be another soon.
  static void put_whole(MessageWriter& writer, const Model& model);
  [[nodiscard]] Model get(MessageReader& reader);

 private:
  /// A model is named by the rank on which it was given first, and by how many that rank had by then.
  struct Name {
    std::int32_t rank = -1;
    std::uint32_t number = 0;
    friend auto operator<=>(const Name&, const Name&) = default;
  };

  /// Where the parts of a large model are, which its copies share; null for a small one.
  [[nodiscard]] static const void* identity_of(const Shape& shape);
  static void put_name(MessageWriter& writer, const Name& name);
  [[nodiscard]] static Name get_name(MessageReader& reader);
  Name name_of(const Model& model, const void* identity);

  int rank_;
  std::uint32_t named_ = 0;
  std::map<const void*, Name> names_;
  std::map<Name, Model> models_;
  std::set<std::pair<int, Name>> sent_;  ///< to which ranks
};

}  // namespace toccata
