#pragma once

#include <optional>
#include <string>
#include <vector>

#include "toccata/world/world.hpp"
#include "world/bodies_on_the_way.hpp"
#include "world/narrow_phase.hpp"
#include "world/pair_rules.hpp"
#include "world/space_time_schedule.hpp"

namespace toccata {

class World::State {
 public:
  explicit State(const WorldOptions& options)
      : options_(options),
        number_(number_of_new_world()),
        phase_({options.broad_phase, options.threads}),
        narrow_(options) {
    if (options.space_time) schedule_.emplace(options.threads);
  }

  std::vector<BodyId> add(std::span<const Body> bodies);
  void remove(std::span<const BodyId> ids);
  void move(std::span<const BodyId> ids, std::span<const Pose> poses);
  void move_along(std::span<const BodyId> ids, std::span<const RigidMotion> motions);
  void replace(std::span<const BodyId> ids, std::span<const Body> bodies);
  Refit deform(BodyId id, std::vector<Vec3> vertices);
  void set_rules(std::span<const PairRule> rules);
  void prepare() const;
  using WantedPairs = FunctionRef<bool(BodyId, BodyId)>;
  /// How a step is asked for.
  struct Asking {
    const WantedPairs* are_wanted = nullptr;                    ///< null: all pairs are wanted
    const FunctionRef<void(const PairReport&)>* see = nullptr;  ///< null: they are listed
    const Progress* progress = nullptr;                         ///< null: nobody is told
  };
  const WorldStep& step(const Asking& asking);

  [[nodiscard]] bool contains(BodyId id) const {
    return id.world == number_ && id.index < slots_.size() && slots_[id.index].is_used &&
           slots_[id.index].generation == id.generation;
  }
  /// Throws Error naming the id when it is of no body.
  [[nodiscard]] Index require(BodyId id) const;

  [[nodiscard]] std::optional<double> pair_margin(BodyId a, BodyId b) const;

  [[nodiscard]] const WorldOptions& options() const { return options_; }
  [[nodiscard]] const BroadPhase& broad_phase() const { return phase_; }
  [[nodiscard]] const WorldStep& last_step() const { return last_; }
  [[nodiscard]] std::span<const PairReport> pairs() const { return pairs_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t index_count() const { return slots_.size(); }
  [[nodiscard]] bool is_used(Index index) const { return index < slots_.size() && slots_[index].is_used; }
  [[nodiscard]] BodyId id_of(Index index) const { return {index, slots_[index].generation, number_}; }
  [[nodiscard]] const Body& body(Index index) const { return bodies_[index]; }
  [[nodiscard]] std::span<const Aabb> boxes() const { return boxes_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  /// What decides about pairs before any shape is looked at.
  struct Slot {
    std::uint64_t category = 0;
    std::uint64_t mask = 0;
    double margin = 0;
    double rule_margin = 0;  ///< the largest of its rules
    std::uint32_t generation = 1;
    BodyType type = BodyType::dynamic_body;
    bool is_used = false;
    bool has_rules = false;
    bool has_changed = false;  ///< it is among those that did
  };

  [[nodiscard]] static std::uint32_t number_of_new_world();
  /// What messages call the body.
  [[nodiscard]] std::string name_of_body(Index index) const;
  /// Throws Error naming the body when its motion has no pose there.
  [[nodiscard]] Pose end_of(const RigidMotion& motion, Index index) const;
  [[nodiscard]] std::vector<Index> required(std::span<const BodyId> ids) const;
  /// How far around its own box another body's may be for the two to be a pair.
  [[nodiscard]] double reach(Index index, double margin) const;
  /// Where it is, or was on its way.
  [[nodiscard]] const Aabb& box_on_the_way(Index index) const;
  /// The bodies that went along a motion have arrived.
  void arrive();
  /// Tells the broad phase where the bodies are, as far as they reach.
  void place(std::span<const Index> indices);
  void put(Index index, Body&& body, const Aabb& box);
  void mark_changed(Index index);
  void apply(const PairRule& rule);
  /// Takes over what the rules say about these bodies, each of which may be named several times.
  void follow_rules(std::vector<Index>& indices);

  [[nodiscard]] bool may_meet(const Slot& a, const Slot& b) const;
  /// How near the two have to be; none where they are not compared.
  [[nodiscard]] std::optional<double> margin_of(const IndexPair& pair) const;
  /// Out of all pairs.
  [[nodiscard]] std::span<const IndexPair> pairs_to_look_at();
  /// Whose boxes overlap, as far as the pair's margin says.
  [[nodiscard]] bool may_be_near(const IndexPair& pair, double margin) const;
  [[nodiscard]] std::vector<DecidedPair> candidates(std::span<const IndexPair> looked, const WantedPairs* are_wanted,
                                                    UndecidedPairs& undecided);
  /// With space_time: how long the answer about a pair lasts is asked for too, as far as that may save time.
  [[nodiscard]] WantedLasting lasting_of(const IndexPair& pair, double margin) const;
  /// How deep at most two bodies overlap, by their boxes.
  [[nodiscard]] double greatest_depth(const IndexPair& pair) const;
  /// With space_time: when the pairs that were decided are looked at again.
  void end_scheduled_step(std::size_t looked, const UndecidedPairs& undecided);
  [[nodiscard]] Aabb reached_box(Index index) const;
  void let_fly();
  /// Moves them to `reached_boxes_` there.
  void give_to_phase(std::span<const Index> indices);
  /// Calls `visit(report)` for each pair that was found, ascending.
  template <class Visit>
  void visit_reports(const Visit& visit) const;
  [[nodiscard]] std::vector<PairReport> reports() const;
  void tell(std::vector<PairReport> now);
  void forget_pairs();

  WorldOptions options_;
  std::uint32_t number_;  ///< of this World and its copies, in the ids that it gives out
  std::vector<Body> bodies_;
  std::vector<Slot> slots_;
  std::vector<Aabb> boxes_;
  BodiesOnTheWay on_the_way_;   ///< until the next step
  std::vector<Index> changed_;  ///< since the last step
  PairRules rules_;
  BroadPhase phase_;
  NarrowPhase narrow_;
  std::vector<DecidedPair> decided_;  ///< by the last step, ascending
  std::vector<PairReport> pairs_;
  WorldStep last_;
  std::optional<SpaceTimeSchedule> schedule_;  ///< with space_time
  StepWork work_;                              ///< since the last step
  std::size_t count_ = 0;
  std::uint64_t revision_ = 0;
  // Memory to work in.
  std::vector<Aabb> new_boxes_;
  std::vector<Aabb> reached_boxes_;
  std::vector<std::uint8_t> differs_;
  std::vector<Index> not_flying_;
};

}  // namespace toccata
