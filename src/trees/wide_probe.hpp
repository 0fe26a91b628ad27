#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "toccata/core/function_ref.hpp"
#include "toccata/core/index.hpp"
#include "toccata/trees/wide_bvh.hpp"

namespace toccata {

/// own · q, and what half sizes add up to along it.
struct SlantedForm {
  SlantedForm() = default;
  explicit SlantedForm(const std::array<float, 3>& form)
      : own(form), size{std::fabs(form[0]), std::fabs(form[1]), std::fabs(form[2])} {}
  std::array<float, 3> own{};
  std::array<float, 3> size{};
};

/// A region of the world that items of one tree are compared with: along every axis, own · q lies within at ± reach for
/// every point of the region. The pads are in `reach`.
struct WideProbe {
  struct Axis {
    SlantedForm form;
    float at = 0;
    float reach = 0;
  };
  static constexpr std::size_t most = 6;
  std::array<Axis, most> axes{};
  std::size_t count = 0;
};

/// Calls `visit(item)` until it returns false: with all items whose boxes may meet the region, each
/// once.
void walk_probe(const WideBvh& tree, const WideProbe& probe, FunctionRef<bool(Index)> visit);

/// The same of what is below one block, with the items' places in the tree's order; returns how many boxes were
/// compared.
std::size_t walk_probe_below(const WideBvh& tree, std::uint32_t block, const WideProbe& probe,
                             FunctionRef<bool(Index)> visit);

}  // namespace toccata
