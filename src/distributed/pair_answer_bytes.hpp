#pragma once

#include "distributed/messages.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// What is told of a pair as bytes and back: the same bits.
void put_pair_answer(MessageWriter& writer, const PairAnswer& answer);
[[nodiscard]] PairAnswer get_pair_answer(MessageReader& reader);

}  // namespace toccata
