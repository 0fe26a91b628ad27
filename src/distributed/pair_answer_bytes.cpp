#include "distributed/pair_answer_bytes.hpp"

namespace toccata {
namespace {

/// Its members, in their order. Whoever adds one to the struct adds it here: the binding names all of them.
template <class Answer, class Visit>
void visit_members(Answer& answer, const Visit& visit) {
  auto& [a, b, relation, contacts, penetration, depth_end, manifold, manifolds, regions, distance, clearance, kind,
         piercing, tolerance, local_depth, volume, common_point, common_box] = answer;
  visit(a);
  visit(b);
  visit(relation);
  visit(contacts);
  visit(penetration);
  visit(depth_end);
  visit(manifold);
  visit(manifolds);
  visit(regions);
  visit(distance);
  visit(clearance);
  visit(kind);
  visit(piercing);
  visit(tolerance);
  visit(local_depth);
  visit(volume);
  visit(common_point);
  visit(common_box);
}

struct Put {
  template <class T>
  void operator()(const T& value) const {
    writer.put(value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) const {
    writer.put_all(std::span<const T>(values));
  }
  template <class T>
  void operator()(const std::optional<T>& value) const {
    writer.put(value.has_value());
    if (value) writer.put(*value);
  }
  MessageWriter& writer;
};

struct Get {
  template <class T>
  void operator()(T& value) const {
    value = reader.get<T>();
  }
  template <class T>
  void operator()(std::vector<T>& values) const {
    values = reader.get_all<T>();
  }
  template <class T>
  void operator()(std::optional<T>& value) const {
    if (reader.get<bool>()) value = reader.get<T>();
  }
  MessageReader& reader;
};

}  // namespace

void put_pair_answer(MessageWriter& writer, const PairAnswer& answer) { visit_members(answer, Put{writer}); }

PairAnswer get_pair_answer(MessageReader& reader) {
  PairAnswer answer;
  visit_members(answer, Get{reader});
  return answer;
}

}  // namespace toccata
