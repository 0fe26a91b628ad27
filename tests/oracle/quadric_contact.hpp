#pragma once

#include "oracle/quadrics.hpp"

// What the points of a contact of quadrics have to be, from the sets alone.
namespace toccata::oracle {

/// The point is no farther from the set than this: as far as from some point of the set that is near; from the nearest
/// that a search finds, where that is more than `enough`.
Fine at_most_from(const FineSet& set, const FinePoint& point, const Fine& enough);

/// How far A reaches beyond where B begins, along a direction of any length.
Fine depth_along(const FineSet& a, const FineSet& b, const FinePoint& direction);

/// The area of what A and B have in common seen along the normal, where lines along it leave A as much deeper than they
/// enter B as anywhere, but for `slack`; counted on a grid of cells, and the size of a cell. Hulls have no radius here.
struct ContactArea {
  double area = 0;
  double cell = 0;
};
ContactArea contact_area(const FineSet& a, const FineSet& b, const FinePoint& normal, double slack);

}  // namespace toccata::oracle
