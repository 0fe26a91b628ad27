#pragma once

namespace toccata::test {

/// A tenth of the cases under the thread sanitizer: it takes many times as long, and is there for what threads do to
/// each other, not for the cases.
template <class Count>
constexpr Count fewer_under_tsan(Count cases) {
#ifdef __SANITIZE_THREAD__
  return (cases + 9) / 10;
#else
  return cases;
#endif
}

}  // namespace toccata::test
