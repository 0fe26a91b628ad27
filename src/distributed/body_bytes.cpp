#include "distributed/body_bytes.hpp"

namespace toccata {

void put_body(MessageWriter& letter, const Body& body, ModelStore& models, int to, ModelGoes goes) {
  if (goes == ModelGoes::once)
    models.put(letter, body.model, to);
  else
    ModelStore::put_whole(letter, body.model);
  letter.put(body.pose);
  letter.put(body.type);
  letter.put(body.solid);
  letter.put(body.group);
  letter.put(body.mask);
  letter.put(body.margin);
  letter.put(body.max_acceleration);
  letter.put(body.max_speed);
  letter.put(body.user_data);
  letter.put_text(body.name);
}

Body get_body(MessageReader& reader, ModelStore& models) {
  Body body{models.get(reader)};
  body.pose = reader.get<Pose>();
  body.type = reader.get<BodyType>();
  body.solid = reader.get<Solid>();
  body.group = reader.get<std::uint64_t>();
  body.mask = reader.get<std::uint64_t>();
  body.margin = reader.get<double>();
  body.max_acceleration = reader.get<double>();
  body.max_speed = reader.get<double>();
  body.user_data = reader.get<std::uint64_t>();
  body.name = reader.get_text();
  return body;
}

}  // namespace toccata
