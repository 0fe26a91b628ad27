#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "distributed/model_bytes.hpp"
#include "distributed/ranks.hpp"
#include "distributed/space_of_ranks.hpp"
#include "toccata/distributed/distributed_world.hpp"
#include "toccata/world/world_queries.hpp"

namespace toccata {

/// Around a body: itself, and all within its margin, as a World has them.
struct BodyBoxes {
  Aabb own;
  Aabb reached;
};

/// What is to be done in the next step.
struct WantedChanges {
  std::vector<GlobalBody> added;
  std::vector<BodyBoxes> boxes_of_added;  ///< filled in where they are found right
  std::vector<std::pair<GlobalId, Pose>> moved;
  std::vector<GlobalBody> replaced;
  std::vector<GlobalId> removed;
};

/// What another rank is told of a body that it has, or comes to have.
enum class BodyMessage : std::uint8_t {
  put,     ///< all of it: it comes there, or is another now
  move,    ///< its pose
  leave,   ///< its pose, and that the rank gives it up after the step
  remove,  ///< it is there no more
};

/// A pair that the World of this rank tells, whichever rank is to tell it.
struct LocalPair {
  GlobalPairReport report;
  int teller = 0;
};

class DistributedWorld::State {
 public:
  State(MpiCommunicator communicator, const DistributedOptions& options);

  WantedChanges wanted;

  const DistributedStep& step();

  [[nodiscard]] const DistributedStep& last_step() const { return last_; }
  [[nodiscard]] std::span<const GlobalPairReport> pairs() const { return told_; }
  [[nodiscard]] std::vector<GlobalId> bodies() const;
  [[nodiscard]] bool lives_here(GlobalId id) const;
  [[nodiscard]] const Body& body(GlobalId id) const { return world_.body(require(id)); }
  [[nodiscard]] const Ranks& ranks() const { return ranks_; }

  std::vector<std::optional<GlobalAnswer<RayHit>>> cast_ray_each(std::span<const Ray> rays);
  std::vector<std::optional<GlobalAnswer<ShapeHit>>> cast_shape_each(std::span<const MovingShape> moving);
  std::vector<std::vector<GlobalId>> within_each(std::span<const SceneInstance> shapes, double distance);
  std::vector<std::optional<GlobalAnswer<Distance>>> nearest_each(std::span<const SceneInstance> shapes,
                                                                  double max_distance);

 private:
  enum class Change : std::uint8_t { none, moved, replaced };

  /// A body in the World of this rank, by its index there.
  struct Copy {
    GlobalId id = 0;
    bool lives_here = false;
    Change change = Change::none;
    std::uint64_t cost = 1;
    std::vector<int> holders;  ///< of one that lives here: the other ranks that have it, ascending
  };
  using Letters = std::map<int, MessageWriter>;

  /// Throws Error naming the id when it is of no body that lives here.
  [[nodiscard]] BodyId require(GlobalId id) const;
  [[nodiscard]] Copy& copy(BodyId id) { return copies_[id.index]; }
  [[nodiscard]] const Copy& copy(BodyId id) const { return copies_[id.index]; }

  // Is what is wanted right? (wanted_changes.cpp)
  void require_equal_options();
  void check(WantedChanges& changes);
  [[nodiscard]] bool check_here(WantedChanges& changes) const;
  /// Each id is known to one rank, which sees that it is given once.
  void register_ids(const WantedChanges& changes);
  [[nodiscard]] int registrar_of(GlobalId id) const;

  // Bodies go where they belong (body_exchange.cpp).
  void apply(const WantedChanges& changes, Letters& letters);
  /// Divides space anew where that is worth it.
  void divide(const WantedChanges& changes);
  [[nodiscard]] double imbalance_of(const WantedChanges& changes);
  void send_where_they_belong(const WantedChanges& changes, Letters& letters);
  void send(BodyId local, Letters& letters);
  void send_new(const GlobalBody& added, const BodyBoxes& boxes, Letters& letters);
  void put_home(MessageWriter& letter, int to, int home, std::span<const int> holders) const;
  void put_body(MessageWriter& letter, const Body& body, int to);
  [[nodiscard]] Body get_body(MessageReader& reader);
  void receive(std::span<const Received> letters);
  void come_to_live_here(BodyId local, std::span<const int> holders);
  void give_up_what_left();
  [[nodiscard]] std::vector<int> ranks_reached_by(const Aabb& reached, int home) const;

  // Pairs are told by one rank each (pair_tellers.cpp).
  void tell();
  [[nodiscard]] std::vector<LocalPair> found_pairs() const;
  [[nodiscard]] int teller_of(BodyId a, BodyId b) const;
  void add_details(std::span<GlobalPairReport> pairs) const;
  void count_costs();

  // Questions (global_queries.cpp).
  /// Each is answered by this rank, and then by those that `may_know(question, box of the rank's bodies, what is
  /// answered here)`; `merge(answer, other)` puts the answers together. `answer(question)` is asked of the bodies that
  /// live on a rank.
  template <class Answer, class Question, class MayKnow, class AnswerOne, class Merge>
  std::vector<Answer> ask_ranks(std::span<const Question> questions, const MayKnow& may_know, const AnswerOne& answer,
                                const Merge& merge);
  [[nodiscard]] std::vector<Aabb> boxes_of_ranks();
  /// Of the bodies that live here the first by (upper, id), by `ask(filter, how far)`.
  template <class Found, class Ask>
  [[nodiscard]] std::optional<GlobalAnswer<Found>> first_here(const Ask& ask) const;

  DistributedOptions options_;
  Ranks ranks_;
  World world_;
  WorldQueries queries_;
  ModelStore models_;
  SpaceOfRanks space_;
  std::vector<Copy> copies_;
  std::unordered_map<GlobalId, BodyId> local_;
  std::unordered_map<GlobalId, int> registered_;  ///< on which ranks those ids were given
  std::unordered_set<GlobalId> removed_;  ///< in this step, of bodies that were here: who has the id now is another
  std::vector<BodyId> leaving_;
  std::vector<GlobalPairReport> told_;
  DistributedStep last_;
  double imbalance_left_ = 1;  ///< when space was divided last
  std::string broken_;         ///< why no more steps are possible
};

/// What messages call it.
[[nodiscard]] std::string name_of_body(const GlobalBody& body);
[[nodiscard]] std::string name_of_body(GlobalId id);

/// A point of the box, by which the body has its home: about the middle.
[[nodiscard]] Vec3 place_of(const Aabb& box);

}  // namespace toccata
