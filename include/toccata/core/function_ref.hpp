#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace toccata {

/// Something to be called by the function that it is given to, and not kept: it is not copied, and nothing is allocated
/// for it.
template <class Signature>
class FunctionRef;

template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class F>
  requires(!std::same_as<std::remove_cv_t<F>, FunctionRef> && std::is_invocable_r_v<Result, const F&, Arguments...>)
      FunctionRef(const F& function)
      : function_(std::addressof(function)), call_([](const void* it, Arguments... arguments) -> Result {
          return (*static_cast<const F*>(it))(std::forward<Arguments>(arguments)...);
        }) {}

  Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

 private:
  const void* function_;
  Result (*call_)(const void*, Arguments...);
};

}  // namespace toccata
