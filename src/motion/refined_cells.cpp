#include "motion/refined_cells.hpp"

#include <algorithm>
#include <queue>

namespace toccata {
namespace {

class Refinement {
 public:
  Refinement(const RigidMotion& motion, const CellsWanted& wanted) : motion_(motion), wanted_(wanted) {}

  void add_part(const MovingPart& part) {
    const SharedCluster cluster = whole_cluster(part);
    if (motion_.pieces().empty()) add({cluster, {0, 1}, nullptr});
    for (const RigidMotion::Piece& piece : motion_.pieces()) add({cluster, {piece.begin, piece.end}, &piece});
  }

  /// In the order in which they were made.
  [[nodiscard]] std::vector<SweptCell> refined() {
    while (!waiting_.empty() && done_.size() + waiting_.size() < wanted_.most &&
           waiting_.top().cell.excess() > wanted_.excess) {
      const Entry next = waiting_.top();
      waiting_.pop();
      if (!divide(next)) done_.push_back(next);
    }
    for (; !waiting_.empty(); waiting_.pop()) done_.push_back(waiting_.top());
    std::sort(done_.begin(), done_.end(), [](const Entry& a, const Entry& b) { return a.number < b.number; });
    std::vector<SweptCell> cells;
    for (const Entry& entry : done_) cells.push_back(entry.cell);
    return cells;
  }

 private:
  struct Entry {
    SweptCell cell;
    const RigidMotion::Piece* piece;
    std::size_t number;
    /// The one that is divided first comes last.
    friend bool operator<(const Entry& a, const Entry& b) {
      const double of_a = a.cell.excess(), of_b = b.cell.excess();
      return of_a != of_b ? of_a < of_b : a.number > b.number;
    }
  };
  struct Added {
    SharedCluster cluster;
    TimeStretch stretch;
    const RigidMotion::Piece* piece;
  };

  void add(const Added& added) {
    waiting_.push({swept_cell(added.cluster, added.stretch, added.piece), added.piece, count_++});
  }

  /// In time or in space, as either has the greater share, if that can be.
  bool divide(const Entry& entry) {
    const SweptCell& cell = entry.cell;
    const bool is_due_to_time = cell.excess_in_time() > cell.cluster->excess;
    return is_due_to_time ? divide_in_time(entry) || divide_in_space(entry)
                          : divide_in_space(entry) || divide_in_time(entry);
  }

  /// Not where no more than rounding would be left to win.
  bool divide_in_time(const Entry& entry) {
    const SweptCell& cell = entry.cell;
    const auto [begin, end] = cell.stretch;
    const double middle = begin + 0.5 * (end - begin);
    if (cell.translation || 2 * cell.bow + cell.shear <= cell.pad || !(begin < middle && middle < end)) return false;
    add({cell.cluster, {begin, middle}, entry.piece});
    add({cell.cluster, {middle, end}, entry.piece});
    return true;
  }

  bool divide_in_space(const Entry& entry) {
    const std::vector<SharedCluster> finer = finer_clusters(*entry.cell.cluster);
    for (const SharedCluster& cluster : finer) add({cluster, entry.cell.stretch, entry.piece});
    return !finer.empty();
  }

  const RigidMotion& motion_;
  const CellsWanted& wanted_;
  std::size_t count_ = 0;
  std::priority_queue<Entry> waiting_;
  std::vector<Entry> done_;
};

}  // namespace

std::vector<SweptCell> refined_cells(std::span<const MovingPart> parts, const RigidMotion& motion,
                                     const CellsWanted& wanted) {
  Refinement refinement(motion, wanted);
  for (const MovingPart& part : parts) refinement.add_part(part);
  return refinement.refined();
}

}  // namespace toccata
