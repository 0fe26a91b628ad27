#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/query/object_queries.hpp"
#include "toccata/world/body.hpp"
#include "toccata/world/world.hpp"

namespace toccata {

/// The processes of a program that runs on many machines, as what `MPI_Comm_c2f(communicator)` tells; mpi4py calls it
/// `communicator.py2f()`. So no header of MPI is needed here, and any MPI may be the program's that the library was
/// built with.
struct MpiCommunicator {
  int fortran_handle = 0;
};

/// Names a body on all ranks: given by the program, each once. Pairs and answers ascend by it.
using GlobalId = std::uint64_t;

struct GlobalBody {
  GlobalId id = 0;
  Body body;
};

/// Equal on all ranks, else Error.
struct DistributedOptions {
  WorldOptions world{};
  /// Bodies are divided anew when the rank that has most to do has more than this times the average. Above 1.
  double most_imbalance = 1.2;
  /// After so many seconds without an answer from the other ranks a call throws Error instead of waiting on.
  double patience_seconds = 1800;
};

/// As PairReport, for (a, b).
struct GlobalPairReport {
  GlobalId a = 0;  ///< a < b
  GlobalId b = 0;
  bool in_contact = false;
  std::shared_ptr<const PairDetails> details{};
};

/// What a step took on this rank, and on all.
struct DistributedCosts {
  std::size_t bodies = 0;        ///< that live here
  std::size_t ghosts = 0;        ///< that live elsewhere and reach into this rank's part of space
  std::size_t came = 0;          ///< that live here since this step
  std::uint64_t bytes_sent = 0;  ///< by this rank
  double imbalance = 1;          ///< what the busiest rank has to do over the average, counted in bodies and pairs
  bool was_divided = false;      ///< space was divided anew
};

/// What a step found, of the pairs that this rank tells. Each list is ascending by (a, b); a pair is in the lists of
/// one rank alone.
struct DistributedStep {
  std::vector<GlobalPairReport> begin;    ///< not there at the step before, on any rank
  std::vector<GlobalPairReport> persist;  ///< there at both, be it on another rank; told as it is now
  std::vector<GlobalPairReport> end;      ///< there at the step before only; told as it was then
  DistributedCosts costs;
};

/// What was found, and of which body.
template <class Answer>
struct GlobalAnswer : Answer {
  GlobalId body = 0;
  friend constexpr bool operator==(const GlobalAnswer&, const GlobalAnswer&) = default;
};

/// A World over the ranks of a communicator: each has the bodies of a part of space, and copies ("ghosts") of those of
/// others that reach into it.
///
/// The pairs of all ranks together are those of one World that has all bodies, whatever the number of ranks: the same
/// code decides, and which rank tells of a pair follows from the place of the two alone (docs/guide/distributed.md).
///
/// Calls that are not said to be collective are this rank's own and never wait; `add`, `move`, `replace` and `remove`
/// only note what is wanted. A collective call is made by all ranks, in the same order. What one rank finds wrong is
/// thrown as Error on all, with the name of the rank; the bodies are then as they were, and what was noted is
/// forgotten.
class DistributedWorld {
 public:
  /// Collective. MPI is initialised before, and finalised only after the DistributedWorld is gone; with threads, for
  /// MPI_THREAD_FUNNELED or more. Throws Error where options differ.
  explicit DistributedWorld(MpiCommunicator communicator, const DistributedOptions& options = {});
  DistributedWorld(DistributedWorld&&) noexcept;
  DistributedWorld& operator=(DistributedWorld&&) noexcept;
  ~DistributedWorld();

  /// For the next step. Any rank may give any body, wherever it is: it comes to live where it belongs.
  void add(std::span<const GlobalBody> bodies);
  /// For the next step: bodies that live here. Of several poses for one body the last counts; one that is replaced too
  /// has the pose that `replace` gives. The id of a body that is removed may be given to another in the same step.
  void move(std::span<const GlobalId> ids, std::span<const Pose> poses);
  void replace(std::span<const GlobalBody> bodies);
  void remove(std::span<const GlobalId> ids);

  /// Collective. Brings all bodies to where they belong and finds the pairs. Throws Error naming rank and body for what
  /// World throws for, and for an id that is given twice, or is of no body that lives on that rank.
  const DistributedStep& step();

  /// What the last step found.
  [[nodiscard]] const DistributedStep& last_step() const;
  /// All pairs of the last step that this rank tells, ascending.
  [[nodiscard]] std::span<const GlobalPairReport> pairs() const;

  /// The bodies that live here, ascending.
  [[nodiscard]] std::vector<GlobalId> bodies() const;
  [[nodiscard]] bool lives_here(GlobalId id) const;
  /// Throws Error naming the id when it is of no body that lives here.
  [[nodiscard]] const Body& body(GlobalId id) const;

  [[nodiscard]] int rank() const;
  [[nodiscard]] int rank_count() const;

  // Questions to the bodies of all ranks, as WorldQueries answer them about one World that has all, as they were in the
  // last step. Collective: each rank asks its own, also none. Answer i is about question i; where several bodies are as
  // near the least id is told. They throw like ObjectQueries, naming rank and question.

  [[nodiscard]] std::vector<std::optional<GlobalAnswer<RayHit>>> cast_ray_each(std::span<const Ray> rays);
  [[nodiscard]] std::vector<std::optional<GlobalAnswer<ShapeHit>>> cast_shape_each(std::span<const MovingShape> moving);
  [[nodiscard]] std::vector<std::vector<GlobalId>> overlapping_each(std::span<const SceneInstance> shapes);
  [[nodiscard]] std::vector<std::vector<GlobalId>> within_each(std::span<const SceneInstance> shapes, double distance);
  [[nodiscard]] std::vector<std::optional<GlobalAnswer<Distance>>> nearest_each(
      std::span<const SceneInstance> shapes, double max_distance = std::numeric_limits<double>::infinity());

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace toccata
