#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>

namespace toccata {

/// Types in an order, to go over: what is said of each of them in many places is listed once.
template <class... Types>
struct TypeList {
  static constexpr std::size_t size = sizeof...(Types);

  /// Where the type stands in the list; `size` when it does not.
  template <class T>
  static constexpr std::size_t place_of() {
    constexpr std::array<bool, size> is_it{std::same_as<T, Types>...};
    return static_cast<std::size_t>(std::find(is_it.begin(), is_it.end(), true) - is_it.begin());
  }

  template <class T>
  static constexpr bool has = place_of<T>() < size;

  template <std::size_t place>
  using At = std::tuple_element_t<place, std::tuple<Types...>>;

  /// What `make(std::type_identity<T>{})` returns of each type T, in the order of the list.
  template <class Make>
  static constexpr auto of_each(const Make& make) {
    return std::array{make(std::type_identity<Types>{})...};
  }

  /// Calls `use(std::type_identity<T>{})` with each type T, in the order of the list.
  template <class Use>
  static constexpr void for_each(const Use& use) {
    (use(std::type_identity<Types>{}), ...);
  }

  /// Template<T, ...>: such as a variant of them.
  template <template <class...> class Template>
  using put_into = Template<Types...>;
};

}  // namespace toccata
