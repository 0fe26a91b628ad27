#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "narrow/triangles/triangle_gaps.hpp"
#include "narrow/triangles/triangle_pair_block.hpp"
#include "query/inside/winding_entry.hpp"
#include "query/meshes/found_pairs.hpp"
#include "query/nearest/nearest_elements.hpp"
#include "query/part_tree.hpp"
#include "query/posed_shape.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "trees/near_walk.hpp"
#include "trees/swept_walk.hpp"
#include "trees/wide_point.hpp"
#include "trees/wide_walk.hpp"

namespace toccata {

class WholeBodies;

/// What one thread of a search works with.
struct SearchPart {
  WideFrontier frontier;
  std::array<TrianglePairBlock, 8> blocks{};  ///< as many as stay in the nearest cache
  FoundPairs found;
};

/// The pairs whose numbers are at least `first` and less than `end`, and what is needed to sort them.
struct PairRange {
  std::uint64_t first = 0;
  std::uint64_t end = 0;
  std::vector<FoundPair> pairs;
  std::vector<FoundPair> spare;

  [[nodiscard]] bool contains(std::uint64_t number) const { return first <= number && number < end; }
};

/// Two elements whose distance is known to lie between these.
struct NearCandidate {
  double lower;
  double upper;
  ItemPair pair;
  TriangleGaps::Points points{};
};

/// Two elements of which one moves: they do not meet before a time. The earliest is the greatest, as a heap has it.
struct WaitingCast {
  double time;
  ItemPair items;
  friend bool operator<(const WaitingCast& x, const WaitingCast& y) {
    return std::tie(y.time, y.items.first, y.items.second) < std::tie(x.time, x.items.first, x.items.second);
  }
};

/// Two parts of two models, or two nodes of the trees over their parts. What has the least bound is the greatest, as a
/// heap has it; of one bound nodes come first, so that of the parts the first can.
struct PartPair {
  double bound;
  bool are_nodes;
  ItemPair items;
  friend bool operator<(const PartPair& x, const PartPair& y) {
    return std::tie(y.bound, x.are_nodes, y.items.first, y.items.second) <
           std::tie(x.bound, y.are_nodes, x.items.first, x.items.second);
  }
};

/// What is made where it is first used, and kept: memory that would take a question about two plain shapes longer to
/// make than the question takes.
template <class Value>
class MadeWhereUsed {
 public:
  Value& operator*() {
    if (!value_) value_ = std::make_unique<Value>();
    return *value_;
  }
  Value* operator->() { return &**this; }

 private:
  std::unique_ptr<Value> value_;
};

/// Memory that searches need and keep: see Workspace.
struct SearchScratch {
  MadeWhereUsed<SearchPart> main;
  std::vector<std::unique_ptr<SearchPart>> others;  ///< of a search that is spread over threads
  std::vector<std::uint64_t> sample;                ///< of the pairs' numbers
  std::vector<PairRange> ranges;
  std::vector<Contact> contacts;

  std::array<std::vector<PosedPart>, 2> posed;  ///< of two models: the shapes that they are the union of
  std::array<std::vector<Aabb>, 2> part_boxes;  ///< around them
  std::array<PartTree, 2> part_trees;           ///< over these
  std::vector<PartPair> part_pairs;             ///< still to be asked: a heap
  std::vector<Contact> part_contacts;           ///< of two of them
  std::vector<Contact> all_contacts;            ///< of all parts of two models
  std::vector<Index> triangles;                 ///< that meet a shape
  std::vector<std::pair<Index, Index>> faces;   ///< that meet
  MadeWhereUsed<NearFrontier> near;
  SweptFrontier swept;
  std::vector<WaitingCast> casts;         ///< of quadrics, still to be asked: a heap
  std::vector<NearCandidate> candidates;  ///< for the nearest pair
  WalkCounts counts;
  SimplexCache convex;                       ///< of the last pair of convex shapes
  std::vector<FoundElement> found_elements;  ///< that meet a region
  WindingEntries winding;
  std::vector<SurfacePoint> surface_points;  ///< the nearest so far
  std::vector<SurfacePoint> inner_points;    ///< the same of one part, from within
  NearestCandidates::Memory near_elements;
  std::array<NearTriangles::Memory, points_abreast> near_triangles;
  std::shared_ptr<WholeBodies> whole_bodies;  ///< of the solids whose depth was asked
  /// Whether somebody wants an end, if anybody can: a search whose answer holds at any moment asks it, and then gives
  /// what it has.
  const std::function<bool()>* stop = nullptr;

  [[nodiscard]] bool is_stopped() const { return stop != nullptr && *stop && (*stop)(); }
};

}  // namespace toccata
