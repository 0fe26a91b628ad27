#pragma once

#include "distributed/model_bytes.hpp"
#include "toccata/world/body.hpp"

namespace toccata {

/// A body as bytes and back. Its model goes as `models` has it, for the rank `to`; or whole, each time.
enum class ModelGoes { once, each_time };
void put_body(MessageWriter& letter, const Body& body, ModelStore& models, int to, ModelGoes goes);
[[nodiscard]] Body get_body(MessageReader& reader, ModelStore& models);

}  // namespace toccata
