#include "distributed/body_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>

#include "distributed/pose_bytes.hpp"

namespace toccata {
namespace {

/// What most bodies have as it is if nothing is said.
constexpr std::tuple fields_of_body{&Body::type,      &Body::solid,    &Body::category,
                                    &Body::mask,      &Body::margin,   &Body::max_acceleration,
                                    &Body::max_speed, &Body::user_data};

template <class T>
bool is_same_field(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// What is not as in most bodies, behind a byte that tells which that is.
void put_fields(MessageWriter& letter, const Body& body) {
  static_assert(std::tuple_size_v<decltype(fields_of_body)> == 8);
  const Body usual{Model(Shape(Point{}))};
  std::uint8_t told = 0;
  int number = 0;
  const auto compare = [&](auto field) {
    if (!is_same_field(body.*field, usual.*field)) told = static_cast<std::uint8_t>(told | 1U << number);
    ++number;
  };
  std::apply([&](auto... field) { (compare(field), ...); }, fields_of_body);
  letter.put(told);
  number = 0;
  const auto put = [&](auto field) {
    if ((told >> number++ & 1) != 0) letter.put(body.*field);
  };
  std::apply([&](auto... field) { (put(field), ...); }, fields_of_body);
}

void get_fields(MessageReader& reader, Body& body) {
  const auto told = reader.get<std::uint8_t>();
  int number = 0;
  const auto get = [&](auto field) {
    if ((told >> number++ & 1) != 0) body.*field = reader.get<std::decay_t<decltype(body.*field)>>();
  };
  std::apply([&](auto... field) { (get(field), ...); }, fields_of_body);
}

}  // namespace

void put_body(MessageWriter& letter, const Body& body, ModelStore& models, int to, ModelGoes goes) {
  if (goes == ModelGoes::once)
    models.put(letter, body.model, to);
  else
    ModelStore::put_whole(letter, body.model);
  put_pose(letter, body.pose);
  put_fields(letter, body);
  letter.put_text(body.name);
}

Body get_body(MessageReader& reader, ModelStore& models) {
  Body body{models.get(reader)};
  body.pose = get_pose(reader);
  get_fields(reader, body);
  body.name = reader.get_text();
  return body;
}

}  // namespace toccata
