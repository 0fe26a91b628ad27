#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/empty_list.hpp"
#include "distributed/model_bytes.hpp"
#include "distributed/ranks.hpp"
#include "distributed/space_of_ranks.hpp"
#include "toccata/distributed/distributed_world.hpp"
#include "toccata/world/world_queries.hpp"
#include "world/pair_rules.hpp"

namespace toccata {

/// Around a body: itself, and all within its margin, as a World has them.
struct BodyBoxes {
  Aabb own;
  Aabb reached;
};

/// Where a body goes in a step: it is there at once, or at the end of a motion.
struct WantedPlace {
  GlobalId id = 0;
  Pose pose{};
  std::optional<RigidMotion> motion{};
  BodyId local{};  ///< filled in
};

struct WantedShape {
  GlobalId id = 0;
  std::vector<Vec3> vertices;
};

/// What is said of a body and others.
using RulesOfBody = std::map<GlobalId, PairRules::Rule>;
[[nodiscard]] RulesOfBody get_rules(MessageReader& reader);

/// What is to be done in the next step.
struct WantedChanges {
  std::vector<GlobalBody> added;
  std::vector<BodyBoxes> boxes_of_added;  ///< filled in where they are found right
  std::vector<WantedPlace> moved;
  std::vector<WantedShape> deformed;
  std::vector<GlobalBody> bodies_deformed;  ///< filled in
  std::vector<GlobalBody> replaced;
  std::vector<GlobalId> removed;
  std::vector<GlobalPairRule> rules;
  std::vector<GlobalPairRule> rules_of_all;  ///< filled in: of all ranks, first those that end with a body

  /// Once they are in messages: many may be all that there is memory for.
  void free_bodies() {
    free_list(added);
    free_list(boxes_of_added);
    free_list(moved);
    free_list(bodies_deformed);
    free_list(replaced);
  }

  [[nodiscard]] bool is_empty() const {
    return added.empty() && moved.empty() && deformed.empty() && replaced.empty() && removed.empty() && rules.empty();
  }
};

/// A body that goes along a motion in the step.
struct GlobalWay {
  RigidMotion motion;
  Aabb box;      ///< around all of its way
  Aabb reached;  ///< within its margins of that
};

/// What another rank is told of a body that it has, or comes to have.
enum class BodyMessage : std::uint8_t {
  put,     ///< all of it: it comes there, or is another now
  move,    ///< its place
  leave,   ///< its place, and that the rank gives it up after the step
  remove,  ///< it is there no more
};

/// What a rank that has a body has to be told of its place.
enum class PlaceMessage : std::uint8_t { none, offset, pose, way };

/// What a message about a body begins with, before its id.
struct BodyHead {
  BodyMessage message = BodyMessage::move;
  PlaceMessage place = PlaceMessage::none;  ///< of `put`, which has the pose, none or a way
  bool is_new_home = false;                 ///< it lives there from now on
  bool is_deformed = false;                 ///< its mesh is its own
  bool has_rules = false;
};

/// Tells the seconds since it was made, or since it told them last.
class LapClock {
 public:
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(begin_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

/// A pair that this rank told in the step before, and that another tells now.
struct HandedPair {
  GlobalId a = 0;  ///< a < b
  GlobalId b = 0;
  int teller = 0;
};

/// What the World of this rank found, each list ascending by (a, b).
struct PairsFoundHere {
  std::vector<GlobalPairReport> told;  ///< that this rank tells
  std::vector<HandedPair> handed;
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
  std::vector<std::vector<GlobalId>> within_each(std::span<const SceneInstance> shapes, double max_distance);
  std::vector<std::optional<GlobalAnswer<Distance>>> nearest_each(std::span<const SceneInstance> shapes,
                                                                  double max_distance);
  std::vector<std::vector<GlobalAnswer<Distance>>> nearest_bodies_each(std::span<const SceneInstance> shapes,
                                                                       std::size_t k, double max_distance);

  void save(const std::filesystem::path& folder);
  void load(const std::filesystem::path& folder);

 private:
  /// Each means those before it too.
  enum class Change : std::uint8_t {
    none,
    reach,     ///< it may reach other ranks
    shifted,   ///< its offset is another
    moved,     ///< its pose is another
    replaced,  ///< all of it is
  };

  /// A body in the World of this rank, by its index there.
  struct Copy {
    GlobalId id = 0;
    bool lives_here = false;
    bool is_deformed = false;  ///< its mesh is its own
    Change change = Change::none;
    std::uint64_t cost = 1;
    std::vector<int> holders;  ///< of one that lives here: the other ranks that have it, ascending
  };
  using Letters = std::map<int, MessageWriter>;
  struct PutBody {
    GlobalBody given;
    bool is_deformed = false;
    RulesOfBody rules{};
  };
  /// What this rank is told in a step, sorted out.
  struct News {
    std::vector<PutBody> put;          ///< the next few: they are put here before others are read
    std::vector<GlobalId> with_rules;  ///< of all that are put
    std::vector<WantedPlace> places;
    std::vector<GlobalId> leaving;
    std::vector<std::pair<GlobalId, std::vector<int>>> homes;  ///< what lives here from now on, and who else has it
  };

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
  void check_places(WantedChanges& changes) const;
  void check_deformed(WantedChanges& changes) const;
  static void check_rules(const WantedChanges& changes);

  // Rules (rules_of_ranks.cpp).
  /// All ranks get to know all that is said, and what ends since bodies are removed. Throws Error for a body that there
  /// is not, or two rules for the same two.
  void share_rules(WantedChanges& changes);
  void require_rules_right(const WantedChanges& changes);
  /// What is said about bodies that are here, or come from here.
  void follow(const WantedChanges& changes);
  void put_rules(MessageWriter& letter, GlobalId id) const;
  /// The World is told of rules for two that are both here now.
  void tell_rules(const WantedChanges& changes, const News& news);
  void forget_rules(GlobalId id) { rules_.erase(id); }
  /// How far its rules make a body's box reach, as a World has it.
  [[nodiscard]] double rule_reach(GlobalId id) const;

  // Bodies go where they belong (body_exchange.cpp).
  void apply(const WantedChanges& changes, Letters& letters);
  /// Notes what changed of a body that lives here.
  void note(BodyId local, Change change);
  /// Divides space anew where that is worth it.
  void divide(const WantedChanges& changes);
  [[nodiscard]] double imbalance_of(const WantedChanges& changes);
  void send_where_they_belong(const WantedChanges& changes, Letters& letters);
  void send(BodyId local, Letters& letters);
  /// It reaches no other rank's part of space.
  [[nodiscard]] bool is_inside(const Aabb& reached) const;
  void send_new(const GlobalBody& added, const BodyBoxes& boxes, Letters& letters);
  [[nodiscard]] PlaceMessage place_message_of(BodyId local) const;
  void put_place(MessageWriter& letter, PlaceMessage place, BodyId local) const;
  void put_whole(MessageWriter& letter, BodyId local, int to, int home, std::span<const int> holders);
  [[nodiscard]] WantedPlace get_place(MessageReader& reader, PlaceMessage place, GlobalId id) const;
  void read_removed(MessageReader& reader);
  void read_next(MessageReader& reader, News& news);
  void read(std::span<MessageReader> readers, News& news);
  void receive(const WantedChanges& changes, std::span<const Received> letters);
  void remove_here(GlobalId id);
  void put_here(std::vector<PutBody>& put);
  void go(std::span<const WantedPlace> places);
  void go_there(std::span<const WantedPlace> places);
  void go_along(std::span<const WantedPlace> places);
  void come_to_live_here(BodyId local, std::span<const int> holders);
  void give_up_what_left();
  void arrive();
  /// Contains the body in this step, on its way, and all within its margin and those of its rules.
  [[nodiscard]] Aabb reached_box(BodyId local) const;
  [[nodiscard]] std::vector<int> ranks_reached_by(const Aabb& reached, int home) const;

  /// Throws Error where a step has failed: what it has done and what not, nobody knows.
  void require_whole() const;

  // Pairs are told by one rank each (pair_tellers.cpp).
  void make_step(WantedChanges& changes, LapClock& clock);
  [[nodiscard]] PairsFoundHere find_pairs();
  /// Which of them begin, persist and end.
  void tell(PairsFoundHere found);
  /// The pairs that others told in the step before and this rank tells now, ascending.
  std::vector<std::pair<GlobalId, GlobalId>> hand_over(std::span<const HandedPair> handed);
  /// One of the two was another body in the step before.
  [[nodiscard]] bool is_of_removed(GlobalId a, GlobalId b) const;
  [[nodiscard]] bool was_told(BodyId a, BodyId b) const;
  /// A body that lives here and that no other rank has.
  [[nodiscard]] bool is_here_alone(BodyId local) const;
  [[nodiscard]] int teller_of(BodyId a, BodyId b) const;
  void add_details(std::span<GlobalPairReport> pairs) const;
  /// What each body costs, and what there is here.
  void count_costs();

  // Questions (global_queries.cpp).
  /// Each is answered by this rank, and then by those that `may_know(question, box of the rank's bodies, what is
  /// answered here)`; `merge(answer, other)` puts the answers together. `answer(question)` is asked of the bodies that
  /// live on a rank.
  template <class Answer, class Question, class MayKnow, class AnswerOne, class Merge>
  std::vector<Answer> ask_ranks(std::span<const Question> questions, const MayKnow& may_know, const AnswerOne& answer,
                                const Merge& merge);
  [[nodiscard]] std::vector<Aabb> boxes_of_ranks();
  [[nodiscard]] std::vector<GlobalAnswer<Distance>> nearest_here(const SceneInstance& shape, std::size_t count,
                                                                 double max_distance) const;
  /// The first answer by (upper, id) among the bodies that live here, by `ask(filter, how far)`.
  template <class Found, class Ask>
  [[nodiscard]] std::optional<GlobalAnswer<Found>> first_here(const Ask& ask) const;

  // The bodies that live here, as a file has them (checkpoint.cpp).
  [[nodiscard]] Bytes bytes_of_bodies() const;
  void want_bodies_of(std::span<const std::byte> bytes);

  DistributedOptions options_;
  Ranks ranks_;
  World world_;
  WorldQueries queries_;
  ModelStore models_;
  SpaceOfRanks space_;
  std::vector<Copy> copies_;
  std::optional<Aabb> box_of_here_;  ///< around the bodies that live here, from the first question to the next step
  std::unordered_map<GlobalId, BodyId> local_;
  std::unordered_map<GlobalId, int> registered_;  ///< on which ranks those ids were given
  std::map<GlobalId, RulesOfBody> rules_;         ///< of bodies that are here, also with others that are not
  std::map<GlobalId, GlobalWay> ways_;            ///< of bodies that are here, in the step that is being made
  std::unordered_set<GlobalId> removed_;  ///< in this step, of bodies that were here: who has the id now is another
  std::vector<BodyId> leaving_;
  std::vector<BodyId> changed_;     ///< live here and are not as they were in the last step, or have been removed
  std::uint64_t cost_of_here_ = 0;  ///< of all that live here, as they were in the last step
  std::vector<GlobalPairReport> told_;
  std::vector<GlobalPairReport> spare_;  ///< memory for those of the next step
  DistributedStep last_;
  double imbalance_left_ = 1;  ///< when space was divided last
  std::string broken_;         ///< why nothing more can be asked
};

/// What messages call it.
[[nodiscard]] std::string name_of_body(const GlobalBody& body);
[[nodiscard]] std::string name_of_body(GlobalId id);

}  // namespace toccata
