#include "distributed/space_of_ranks.hpp"

#include <algorithm>
#include <cmath>

#include "math/constants.hpp"

namespace toccata {

SpaceOfRanks::SpaceOfRanks(int parts)
    : parts_(parts), planes_(static_cast<std::size_t>(parts - 1), Plane{0, infinity}) {}

int SpaceOfRanks::part_of(const Vec3& place) const {
  int first = 0, end = parts_;
  std::size_t plane = 0;
  while (end - first > 1) {
    const int low = below(first, end);
    const bool is_below = place[planes_[plane].axis] < planes_[plane].at;
    plane += is_below ? 1 : static_cast<std::size_t>(low);
    (is_below ? end : first) = first + low;
  }
  return first;
}

/// Where the planes of all pieces of one level are to be, found together: so a partition takes as many messages as it
/// has levels, whatever the number of ranks.
struct SpaceOfRanks::Bisection {
  static constexpr int bins = 256, rounds = 4;

  Ranks& ranks;
  std::span<const Vec3> places;
  std::span<const std::uint64_t> costs;
  std::span<const Piece> pieces;
  std::span<const std::size_t> piece_of;  ///< of each place
  std::vector<Plane>& planes;

  /// Between which a plane lies, and what costs as much as the lower side is to have.
  struct Search {
    double low = 0, high = 0;
    double below = 0;   ///< costs below `low`
    double wanted = 0;  ///< on the lower side
    double inside = 0;  ///< costs between the two
  };

  [[nodiscard]] std::vector<Aabb> boxes_of_pieces() const {
    std::vector<double> ends(6 * pieces.size(), infinity);
    for (std::size_t i = 0; i < places.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        double* end = &ends[6 * piece_of[i] + 2 * static_cast<std::size_t>(axis)];
        end[0] = std::min(end[0], places[i][axis]);
        end[1] = std::min(end[1], -places[i][axis]);
      }
    ranks.find_least(ends);
    std::vector<Aabb> boxes(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        boxes[i].lower[axis] = ends[6 * i + 2 * static_cast<std::size_t>(axis)];
        boxes[i].upper[axis] = -ends[6 * i + 2 * static_cast<std::size_t>(axis) + 1];
      }
    return boxes;
  }

  [[nodiscard]] static int longest_axis(const Aabb& box) {
    const Vec3 size = box.upper - box.lower;
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  static std::size_t bin_of(const Search& search, double at) {
    const double part = (at - search.low) / (search.high - search.low) * bins;
    return part >= bins - 1 ? bins - 1 : part > 0 ? static_cast<std::size_t>(part) : 0;
  }

  /// Costs in each bin of each piece, of all ranks.
  [[nodiscard]] std::vector<std::uint64_t> histograms(std::span<const Search> searches) const {
    std::vector<std::uint64_t> counts(pieces.size() * bins);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::size_t piece = piece_of[i];
      if (!is_open(pieces[piece])) continue;
      const double at = places[i][planes[pieces[piece].plane].axis];
      if (searches[piece].low < searches[piece].high && at >= searches[piece].low && at <= searches[piece].high)
        counts[piece * bins + bin_of(searches[piece], at)] += costs[i];
    }
    ranks.add_up(counts);
    return counts;
  }

  /// Goes on in the bin in which the wanted cost is reached.
  static void narrow(Search& search, std::span<const std::uint64_t> counts) {
    std::size_t bin = 0;
    while (bin + 1 < bins && search.below + static_cast<double>(counts[bin]) <= search.wanted)
      search.below += static_cast<double>(counts[bin++]);
    search.inside = static_cast<double>(counts[bin]);
    const double width = (search.high - search.low) / bins;
    const double low = search.low + static_cast<double>(bin) * width;
    search.high = std::min(search.high, low + width);
    search.low = low;
  }

  void find_planes() {
    const std::vector<Aabb> boxes = boxes_of_pieces();
    std::vector<Search> searches(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (!is_open(pieces[i])) continue;
      const int axis = is_empty(boxes[i]) ? 0 : longest_axis(boxes[i]);
      planes[pieces[i].plane].axis = axis;
      if (!is_empty(boxes[i])) searches[i] = {boxes[i].lower[axis], boxes[i].upper[axis]};
    }
    for (int round = 0; round < rounds; ++round) {
      const std::vector<std::uint64_t> counts = histograms(searches);
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::span own = std::span(counts).subspan(i * bins, bins);
        if (round == 0) {
          double total = 0;
          for (const std::uint64_t count : own) total += static_cast<double>(count);
          const int low = below(pieces[i].first, pieces[i].end);
          searches[i].wanted = total * low / (pieces[i].end - pieces[i].first);
        }
        narrow(searches[i], own);
      }
    }
    // Many may have one coordinate: they go to the side that comes nearer to what it is to have.
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (const Search& found = searches[i]; is_open(pieces[i]))
        planes[pieces[i].plane].at = 2 * (found.wanted - found.below) < found.inside ? found.low : found.high;
  }
};

SpaceOfRanks::SpaceOfRanks(Ranks& ranks, std::span<const Vec3> places, std::span<const std::uint64_t> costs)
    : SpaceOfRanks(ranks.count()) {
  std::vector<Piece> pieces{{0, parts_, 0}};
  std::vector<std::size_t> piece_of_part(static_cast<std::size_t>(parts_), 0), piece_of(places.size(), 0);
  while (std::any_of(pieces.begin(), pieces.end(), is_open)) {
    for (std::size_t i = 0; i < places.size(); ++i)
      piece_of[i] = piece_of_part[static_cast<std::size_t>(part_of(places[i]))];
    Bisection{ranks, places, costs, pieces, piece_of, planes_}.find_planes();
    pieces = halves(pieces);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (int part = pieces[i].first; part < pieces[i].end; ++part) piece_of_part[static_cast<std::size_t>(part)] = i;
  }
}

std::vector<SpaceOfRanks::Piece> SpaceOfRanks::halves(std::span<const Piece> pieces) {
  std::vector<Piece> next;
  for (const Piece& piece : pieces) {
    if (!is_open(piece)) {
      next.push_back(piece);
      continue;
    }
    const int low = below(piece.first, piece.end);
    next.push_back({piece.first, piece.first + low, piece.plane + 1});
    next.push_back({piece.first + low, piece.end, piece.plane + static_cast<std::size_t>(low)});
  }
  return next;
}

}  // namespace toccata
