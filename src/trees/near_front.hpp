#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "math/constants.hpp"
#include "toccata/trees/walk.hpp"
#include "trees/gap_planes.hpp"
#include "trees/near_walk.hpp"

namespace toccata {

/// How far apart two items are along a direction.
struct FrontGap {
  Vec3 direction;          ///< from the first to the second, in the first tree's frame, of length 1 but for rounding
  double gap = -infinity;  ///< not above it, in the units of the limit
};

/// A question about what is nearest, for a front.
class FrontQuestion {
 public:
  /// The limit, as that of NearQuestion.
  [[nodiscard]] virtual double limit() const = 0;
  /// Writes for every pair along which direction it is apart; nothing is known of those that are left as they are.
  virtual void visit(std::span<const ItemPair> pairs, std::span<FrontGap> gaps) = 0;

 protected:
  ~FrontQuestion() = default;
};

/// Where a walk over two trees stopped, kept while they move: pairs of boxes that need not be opened, and the pairs of
/// items that it came to, each with a direction along which the two are apart (T.-Y. Li, J.-S. Chen, "Incremental 3D
/// collision detection with hierarchical data structures", 1998, and kinetic separation, J. Basch et al., 1999). From
/// where the trees are now follows, for many at once, how far apart they still are along these. A later question looks
/// only at those of them that may have come near: at items again, for boxes at another direction, and opens them if
/// there is none.
class NearFront {
 public:
  /// Whether a front is kept for this walk: not under poses that shear, and not for sizes that floats do not hold.
  [[nodiscard]] static bool serves(const NearWalk& walk);

  void clear();
  [[nodiscard]] bool is_empty() const { return items_.empty(); }

  /// Opens everything that may be below the question's limit, from the roots. The limit is near the answer.
  void make(const NearWalk& walk, FrontQuestion& question);

  /// The same after the trees have moved. False when so much of the front would have to be looked at that a new search
  /// is better: then what the question was shown is not all.
  bool move(const NearWalk& walk, FrontQuestion& question);

  /// It is three times what it was when it was made: time to make it anew.
  [[nodiscard]] bool has_grown() const { return size() > 3 * size_when_made_ + 32; }

  /// The counts of the last question.
  [[nodiscard]] const WalkCounts& counts() const { return counts_; }

 private:
  /// A walk, and what of it is needed often.
  struct Step {
    const NearWalk& walk;
    FrontQuestion& question;
    double limit = 0;  ///< in the first tree's units, for lengths along directions that are rounded

    void read_limit();
    [[nodiscard]] bool is_over() const { return limit < 0; }
  };

  [[nodiscard]] std::size_t size() const { return boxes_.size() + items_.size(); }

  void show_items_again(Step& step);
  void show_near(Step& step, std::span<const GapPlanes::Near> items);
  void part_boxes_again(Step& step);
  void open_pending(Step& step);
  void open(const Step& step, const BoxPair& pair);
  void file(const Step& step, const BoxPair& pair, std::size_t lane);
  void leave_open(const Step& step, const BoxPair& pair);
  void show(Step& step, std::span<const std::uint32_t> places);

  std::vector<BoxPair> boxes_;  ///< that are far enough apart
  GapPlanes box_planes_;
  std::vector<std::uint32_t> unused_;  ///< places of these

  std::vector<BoxPair> items_;  ///< boxes that are leaves
  GapPlanes item_planes_;

  std::vector<BoxPair> pending_;              ///< to be opened
  std::vector<std::uint32_t> pending_items_;  ///< places, to be shown
  GapPlaneLanes parted_{};
  std::vector<GapPlanes::Near> near_;
  std::vector<std::uint32_t> places_;
  std::vector<ItemPair> pairs_;
  std::vector<FrontGap> gaps_;

  std::uint32_t nearest_item_ = 0;  ///< of the last question, as far as directions tell
  double nearest_gap_ = infinity;
  std::uint32_t first_shown_ = 0;

  std::size_t size_when_made_ = 0;
  WalkCounts counts_;
};

}  // namespace toccata
