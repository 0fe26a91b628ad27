#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "toccata/trees/walk.hpp"
#include "trees/near_walk.hpp"

namespace toccata {

/// A question about what is nearest, for a front.
class FrontQuestion {
 public:
  /// As of NearQuestion.
  [[nodiscard]] virtual double limit() const = 0;
  /// Writes for every pair a lower bound of its distance.
  virtual void visit(std::span<const ItemPair> pairs, std::span<double> least) = 0;

 protected:
  ~FrontQuestion() = default;
};

/// Where a walk over two trees stopped, kept while they move: the pairs of boxes that it opened, with the least
/// distance of what it left closed behind each, and the pairs of items that it came to. A later question looks only at
/// those of them that may have come near since (T.-Y. Li, J.-S. Chen, "Incremental 3D collision detection with
/// hierarchical data structures", 1998).
///
/// Distances are counted with the way: how much nearer any two points, one of each tree, can have come since the
/// front was made, all in all. What was `least` apart at way w is at least least + w − v apart at way v.
class NearFront {
 public:
  void clear();
  [[nodiscard]] bool is_empty() const { return opened_.empty(); }

  /// Opens everything that may be below the question's limit, from the roots.
  void make(const NearWalk& walk, FrontQuestion& question);

  /// The same after the trees have moved. `likely` is near the answer. False when half of the front would be looked at,
  /// or it has doubled: then a new search is better, and what the question was shown is not all.
  bool move(const NearWalk& walk, double way, double likely, FrontQuestion& question);

  /// Of the last question.
  [[nodiscard]] const WalkCounts& counts() const { return counts_; }

 private:
  struct Opened {
    std::uint32_t first;   ///< block · 2 + which tree it is of
    std::uint32_t second;  ///< box of the other tree: block · 8 + lane
    std::uint32_t filed;   ///< a bit for every lane that has an entry of its own
  };
  struct Item {
    ItemPair pair;
    std::uint32_t question;  ///< the last that was shown it
  };

  [[nodiscard]] double reach(const FrontQuestion& question) const;
  [[nodiscard]] double key_of(double least) const;
  void open(const NearWalk& walk, std::size_t place, double reach);
  void file(const NearWalk& walk, const Opened& opened, std::uint32_t lane, double other_size, double key);
  void show_items(std::size_t first, double reach, FrontQuestion& question);
  void show(FrontQuestion& question);
  void open_all(const NearWalk& walk, std::size_t most, FrontQuestion& question);

  // Keys: least + way, one for each entry of the lists before them; beside these, because they are scanned.
  std::vector<Opened> opened_;
  std::vector<double> opened_keys_;
  std::vector<Item> items_;
  std::vector<double> item_keys_;

  // Items to be shown together.
  std::vector<std::uint32_t> places_;
  std::vector<ItemPair> pairs_;
  std::vector<double> least_;

  double way_ = 0;
  std::uint32_t question_ = 0;
  std::size_t opened_when_made_ = 0;
  WalkCounts counts_;
};

}  // namespace toccata
