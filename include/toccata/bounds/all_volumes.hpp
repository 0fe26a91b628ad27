#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "toccata/bounds/aabb.hpp"
#include "toccata/bounds/ball.hpp"
#include "toccata/bounds/cube.hpp"
#include "toccata/bounds/ellipsoid_bound.hpp"
#include "toccata/bounds/hull_bound.hpp"
#include "toccata/bounds/kdop.hpp"
#include "toccata/bounds/obb.hpp"
#include "toccata/bounds/swept_sphere.hpp"
#include "toccata/bounds/volume.hpp"

namespace toccata {

/// A volume of the list below also says what it is called, as the command writes it, and roughly how many microseconds
/// it takes to update one, by which long measurements are planned. One with a round surface has `round_volume`, and one
/// whose corners are not the farthest along a few directions `corner_points`: so it is drawn.
template <class V>
concept ListedVolume = BoundingVolume<V> && std::convertible_to<decltype(V::name), std::string_view> &&
    std::convertible_to<decltype(V::microseconds), double>;

/// Types in an order, to go over.
template <ListedVolume... Volumes>
struct VolumeList {
  static constexpr std::size_t size = sizeof...(Volumes);

  /// Where the volume stands in the list; `size` when it does not.
  template <class V>
  static constexpr std::size_t place_of() {
    constexpr std::array<bool, size> is_it{std::same_as<V, Volumes>...};
    return static_cast<std::size_t>(std::find(is_it.begin(), is_it.end(), true) - is_it.begin());
  }

  /// What `make(std::type_identity<V>{})` returns of each volume V, in the order of the list.
  template <class Make>
  static constexpr auto of_each(const Make& make) {
    return std::array{make(std::type_identity<Volumes>{})...};
  }

  /// Template<V, ...>: such as a list of types to test.
  template <template <class...> class Template>
  using put_into = Template<Volumes...>;
};

/// Every bounding volume of the library. `toccata cost`, the pictures of hierarchies and the tests go over this list,
/// so a new volume is added here and nowhere else.
using AllVolumes =
    VolumeList<Aabb, Ball, Cube, Obb, Kdop<6>, Kdop<14>, Kdop<18>, Kdop<26>, Pss, Lss, Rss, EllipsoidBound, HullBound>;

}  // namespace toccata
