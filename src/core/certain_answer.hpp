#pragma once

#include <optional>

namespace toccata {

/// What numbers of limited length tell of something that there may be or not: nothing where they are not certain, else
/// what it is, or that there is none.
template <class Answer>
struct CertainAnswer {
  bool is_certain = false;
  std::optional<Answer> answer{};
};

}  // namespace toccata
