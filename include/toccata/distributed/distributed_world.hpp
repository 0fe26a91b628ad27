#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "toccata/math/pose.hpp"
#include "toccata/motion/rigid_motion.hpp"
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

/// As PairRule, of bodies that live on any rank.
struct GlobalPairRule {
  GlobalId a = 0;
  GlobalId b = 0;
  bool excluded = false;
  std::optional<double> margin{};
};

/// Equal on all ranks, else Error; but for `world.threads`, `world.broad_phase` and `patience_seconds`, on which no
/// answer depends.
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

/// How long a step took on this rank, in seconds: the first six together all of it.
struct DistributedSeconds {
  double changes = 0;    ///< to see whether what is wanted is right on all ranks, and to do it to the bodies of here
  double division = 0;   ///< to count how even the ranks' work is, and to divide space anew
  double sending = 0;    ///< to find which ranks each body reaches, and to write and exchange the messages
  double receiving = 0;  ///< to take up what came: other places, ghosts, and bodies that live here from now on
  double pairs = 0;      ///< to find and decide the pairs
  double telling = 0;    ///< to tell which begin, persist and end, and to give up what has left
  double waiting = 0;    ///< in all of these: for messages, and for ranks that are not as far
};

/// What a step took on this rank, and on all.
struct DistributedCosts {
  std::size_t bodies = 0;            ///< that live here
  std::size_t ghosts = 0;            ///< that live elsewhere and reach into this rank's part of space
  std::size_t ghosts_elsewhere = 0;  ///< of the bodies that live here, on all other ranks
  std::size_t neighbours = 0;        ///< ranks that have these
  std::size_t came = 0;              ///< that live here since this step
  std::size_t candidates = 0;    ///< pairs looked at here: those that this rank tells if they are told, and told before
  std::uint64_t bytes_sent = 0;  ///< by this rank
  std::uint64_t collectives = 0;  ///< reductions and barriers that all ranks waited for
  double imbalance = 1;           ///< what the busiest rank has to do over the average, counted in bodies and pairs
  bool was_divided = false;       ///< space was divided anew
  DistributedSeconds seconds{};
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
/// Calls that are not said to be collective are this rank's own and never wait; what changes bodies or rules is only
/// noted. A collective call is made by all ranks, in the same order. What one rank finds wrong is
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
  /// For the next step: bodies that live here. Of several poses and motions for one body the last counts; one that is
  /// replaced too has the pose that `replace` gives. The id of a body that is removed may be given to another in the
  /// same step.
  void move(std::span<const GlobalId> ids, std::span<const Pose> poses);
  /// As World::move_along, for motions of one piece: a rest, a move, `straight`, `between` or `screw`. One through
  /// several poses is given a piece for each step, and one that is told by a function cannot be sent to another rank.
  void move_along(std::span<const GlobalId> ids, std::span<const RigidMotion> motions);
  void replace(std::span<const GlobalBody> bodies);
  /// As World::deform, before what else is wanted of the body in the step. Other ranks that have it are sent the mesh.
  void deform(GlobalId id, std::vector<Vec3> vertices);
  void remove(std::span<const GlobalId> ids);

  /// For the next step, once its bodies have come and gone: of any bodies, wherever they live, by one rank for each
  /// two. As World::set_rules: it takes the place of an earlier rule for the two, and ends with either body. Whatever
  /// rank has one of the two knows its rules, so they are for what few bodies need: groups and masks cost nothing.
  void set_rules(std::span<const GlobalPairRule> rules);

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

  /// Collective. Writes all bodies, as they were in the last step, and their rules, a file for each rank and an index
  /// that is written last, when all are complete. Throws Error on all ranks where the folder is there and not empty,
  /// where a file cannot be written, and where changes are noted that no step has made.
  void save(const std::filesystem::path& folder);
  /// Collective. What `save` wrote, on any number of ranks, with any options: all bodies have come to where they
  /// belong, and `pairs` are all that there are. So the next step tells what it would have told without the way through
  /// the folder; of what only met on its way in the last step before, an end is not told. Throws Error on all ranks
  /// naming a file that is missing, incomplete, damaged or of another version.
  [[nodiscard]] static DistributedWorld load(MpiCommunicator communicator, const std::filesystem::path& folder,
                                             const DistributedOptions& options = {});

  [[nodiscard]] int rank() const;
  [[nodiscard]] int rank_count() const;
  /// How long this rank has waited for messages and other ranks, in all collective calls since it was made.
  [[nodiscard]] double seconds_waited() const;

  // Questions to the bodies of all ranks, as WorldQueries answer them about one World that has all, as they were in the
  // last step. Collective: each rank asks its own, also none. Answer i is about question i; where several bodies are as
  // near the least id is told. They throw like ObjectQueries, naming rank and question.

  [[nodiscard]] std::vector<std::optional<GlobalAnswer<RayHit>>> cast_ray_each(std::span<const Ray> rays);
  [[nodiscard]] std::vector<std::optional<GlobalAnswer<ShapeHit>>> cast_shape_each(std::span<const MovingShape> moving);
  [[nodiscard]] std::vector<std::vector<GlobalId>> overlapping_each(std::span<const SceneInstance> shapes);
  [[nodiscard]] std::vector<std::vector<GlobalId>> within_each(std::span<const SceneInstance> shapes,
                                                               double max_distance);
  [[nodiscard]] std::vector<std::optional<GlobalAnswer<Distance>>> nearest_each(
      std::span<const SceneInstance> shapes, double max_distance = std::numeric_limits<double>::infinity());
  /// The k nearest bodies to each shape, by the `distance` of the shape and each of them: the least by (upper, id),
  /// ascending; fewer where fewer are within the greatest distance, decided exactly.
  [[nodiscard]] std::vector<std::vector<GlobalAnswer<Distance>>> nearest_bodies_each(
      std::span<const SceneInstance> shapes, std::size_t k,
      double max_distance = std::numeric_limits<double>::infinity());

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace toccata
