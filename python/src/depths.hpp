#pragma once

#include <toccata/query/overlap.hpp>
#include <toccata/query/penetration.hpp>

#include "described.hpp"

namespace toccata::python {

template <>
struct Described<DepthBracket> {
  static constexpr const char* name = "DepthBracket";
  static constexpr const char* doc =
      "How deep two solids overlap, as narrow as asked, and why the bracket is no narrower.";
  static constexpr auto fields =
      std::tuple_cat(fields_within<DepthBracket, &DepthBracket::penetration>(Described<Penetration>::fields),
                     std::tuple{field<DepthBracket, &DepthBracket::end>("end", "Why it is no narrower.")});
};

template <>
struct Described<OverlapVolume> {
  static constexpr const char* name = "OverlapVolume";
  static constexpr const char* doc =
      "How much volume two solids have in common; the exact number lies in [lower, upper].";
  static constexpr std::tuple fields{
      field<OverlapVolume, &OverlapVolume::lower>("lower", "In the cubed unit of the coordinates."),
      field<OverlapVolume, &OverlapVolume::upper>("upper", "The same."),
      field<OverlapVolume, &OverlapVolume::status>("status", "not_converged: wider than 1e-9 of it.")};
};

}  // namespace toccata::python
