#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "toccata/distributed/distributed_world.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

struct CheckPairRules;  // of the library's own programs
struct WantedAnswer;

/// Reads a part of a scene, as a file: its models at their places. Called once to look at the part, and
/// again by each rank that needs it; it returns the same each time. What it throws is thrown on all ranks.
using ReadPart = std::function<std::vector<SceneInstance>(std::size_t part)>;

/// What the last check took one rank.
struct DistributedCheckCosts {
  std::size_t parts = 0;         ///< that it had in memory
  std::uint64_t elements = 0;    ///< of their models
  std::size_t candidates = 0;    ///< pairs that it looked at
  std::uint64_t bytes_sent = 0;  ///< since the scene was made
};

/// A scene in parts, of which no rank has all: each has the parts that its pairs are of, and of all others the names
/// and boxes of their models. Models are numbered through, one part after the other.
///
/// Every call is collective, by all ranks in the same order and with the same arguments. What one rank finds wrong is
/// thrown as Error on all, with the name of the rank.
class DistributedScene {
 public:
  /// Reads each part on one rank, keeps what is said above, and divides space so that all have about as many elements
  /// of models. MPI as for DistributedWorld; after so many seconds without an answer a call throws Error.
  DistributedScene(MpiCommunicator communicator, std::size_t part_count, ReadPart read, double patience_seconds = 1800);
  DistributedScene(DistributedScene&&) noexcept;
  DistributedScene& operator=(DistributedScene&&) noexcept;
  ~DistributedScene();

  /// On rank 0 what `check_all` answers of the models of all parts, to the last bit; on the others no pairs. Each pair
  /// is decided once, on the rank in whose part of space the larger of the two parts has its middle.
  [[nodiscard]] CheckAnswer check(const CheckOptions& options = {});

  [[nodiscard]] std::size_t model_count() const;
  /// The number of the first model of a part; for one past the last part how many models there are.
  [[nodiscard]] std::size_t first_model(std::size_t part) const;
  [[nodiscard]] const std::string& name(std::size_t model) const;
  [[nodiscard]] const DistributedCheckCosts& costs() const;
  [[nodiscard]] int rank() const;

 private:
  friend WantedAnswer check_wanted(DistributedScene& scene, const CheckOptions& options, const CheckPairRules& rules);

  class State;
  std::unique_ptr<State> state_;
};

}  // namespace toccata
