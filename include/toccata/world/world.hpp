#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/broad/broad_phase.hpp"
#include "toccata/core/function_ref.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/casts.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/manifold.hpp"
#include "toccata/query/manifolds.hpp"
#include "toccata/query/penetration.hpp"
#include "toccata/query/relation.hpp"
#include "toccata/world/body.hpp"

namespace toccata {

/// What is reported of every pair, besides that it is one. Each costs what the question of that name costs.
struct WorldOptions {
  bool relation = false;
  bool distance = false;
  bool contacts = false;     ///< for pairs in contact: their elements that meet
  bool manifold = false;     ///< for pairs in contact: where they touch, as points and normals (manifolds.hpp)
  bool penetration = false;  ///< for two solids in contact, where it is defined
  /// Whether two kinematic bodies, and a kinematic and a static one, make pairs.
  bool kinematic_pairs = true;
  /// Pairs that cannot meet for some steps are not looked at in these
  /// (docs/methods/space-partitions.md#bounds-in-space-and-time): from how bodies moved last, and what they promise
  /// (Body::max_acceleration, max_speed), follows the first step at which two can meet. Whoever moves otherwise is
  /// looked at anew, so pairs and events are the same bits; and where it does not pay, steps go the plain way. Only
  /// `candidates` and, mostly, `asked` are fewer.
  bool space_time = false;
  BroadPhaseMethod broad_phase = BroadPhaseMethod::automatic;
  int threads = own_thread;
};

/// What was asked for in WorldOptions, of one pair; each as the question of that name answers it for (a, b).
struct PairDetails {
  /// The first contact of two bodies that met on the way, one of which went along a motion (World::move_along): as
  /// `sweep` answers it for a and b, where the other body stands or goes along a motion too.
  std::optional<ShapeHit> first_contact{};
  std::optional<Relation> relation{};
  std::optional<Distance> distance{};
  std::vector<Contact> contacts{};
  std::optional<Manifold> manifold{};  ///< for two convex shapes or one and a half-space
  /// What `manifolds` answers for the pair, whatever the shapes: filled for every pair in contact with
  /// WorldOptions::manifold.
  std::vector<ModelManifold> manifolds{};
  std::optional<Penetration> penetration{};

  friend bool operator==(const PairDetails&, const PairDetails&) = default;
};

/// Two bodies that are in contact or as near as their margin.
struct PairReport {
  BodyId a;  ///< a.index < b.index
  BodyId b;
  /// Whether they have a point in common; else they are only near, or have met on the way and are apart again.
  bool in_contact = false;
  std::shared_ptr<const PairDetails> details{};  ///< none where nothing was asked for and nothing met on the way
};

/// What a step found. Each list is ascending by (a, b).
struct WorldStep {
  std::vector<PairReport> begin;    ///< not there at the step before
  std::vector<PairReport> persist;  ///< there at both; reported as it is now
  std::vector<PairReport> end;      ///< there at the step before only; reported as it was then. Bodies removed since
                                    ///< are named by the ids that they had
  std::size_t candidates = 0;       ///< pairs to be decided: boxes overlap, and no rule leaves them out; with
                                    ///< `space_time` none that was known to be apart until later
  std::size_t asked = 0;            ///< those candidates that could not be taken over from the step before
};

/// What is said about two bodies in particular, in either order.
struct PairRule {
  BodyId a;
  BodyId b;
  bool excluded = false;           ///< they never make a pair
  std::optional<double> margin{};  ///< instead of the sum of theirs; 0 or more, also +∞
};

/// Bodies that move, and the pairs of them that are in contact or near.
///
/// Which two bodies are a pair is decided exactly, as docs/truth.md defines contact and distance: never by their boxes,
/// by a tolerance, or by what was known before. A
/// step gives the same bits on any number of threads, at every SIMD level, and whatever happened before; what it keeps
/// from step to step saves time only.
///
/// A World is a value: a copy is a snapshot, with the same bodies, ids, rules and pairs, and gives from there the same
/// bits as the original. To restore, assign it back. Models are shared, not copied. Ids that the original gave out
/// after the snapshot are to be forgotten with it: the copy gives out the same for what it is given, so that one of
/// them may name another body there.
///
/// Whatever throws Error has changed nothing; the message names the body. Const functions may be called from many
/// threads at once. What they refer to is valid until the bodies change or the next step; but what a step found stays
/// as it is until the next one, so bodies may be added, moved and removed while its pairs are gone through.
class World {
 public:
  explicit World(const WorldOptions& options = {});
  World(const World& other);
  World(World&&) noexcept;
  World& operator=(World other) noexcept;
  ~World();

  /// The ids given to the bodies, in their order. Throws Error naming the first of them that has a margin which is no
  /// length, a pose that is not finite or that its shape may not have, or a `solid` that its shape is not.
  std::vector<BodyId> add(std::span<const Body> bodies);
  std::vector<BodyId> add(std::initializer_list<Body> bodies);
  BodyId add(const Body& body);
  BodyId add(const Model& model, const Pose& pose, BodyType type = BodyType::dynamic_body);

  /// Removes the bodies with their rules. Throws Error naming an id that is of no body here, or given twice.
  void remove(std::span<const BodyId> ids);
  void remove(BodyId id);

  /// Gives body ids[i] the pose poses[i], however far it is; of several for one body the last counts. Throws Error as
  /// `add` does, for an id of no body here, and where the spans differ in length.
  void move(std::span<const BodyId> ids, std::span<const Pose> poses);
  void move(BodyId id, const Pose& pose);

  /// Lets body ids[i] go along motions[i], from where that begins to where it ends, in the time of the next step. The
  /// body is at its end now; but the step also finds every pair that meets on the way, if only for a moment, and says
  /// when first (PairDetails::first_contact): nothing tunnels. A body that is moved, replaced or removed before the
  /// step has gone nowhere. Throws Error as `move` does, and as RigidMotion::at; the step throws what `sweep` throws.
  void move_along(std::span<const BodyId> ids, std::span<const RigidMotion> motions);
  void move_along(BodyId id, const RigidMotion& motion);

  /// Makes body ids[i] into bodies[i], all of it: another shape, other margins or groups. Ids, rules, and pairs that
  /// are still pairs stay. Throws Error as `move` does.
  void replace(std::span<const BodyId> ids, std::span<const Body> bodies);
  void replace(BodyId id, const Body& body);

  /// Gives the mesh of a body other vertices, as Model::deform does: the tree keeps its shape, which takes a part of
  /// the time that `replace` needs. Other bodies, and copies of the World, that share its model stay as they are; a
  /// model that is this body's alone gives its tree up instead of copying it. Throws Error as Model::deform and `add`
  /// do, and for an id of no body here.
  Refit deform(BodyId id, std::vector<Vec3> vertices);

  /// Each takes the place of an earlier rule for the same two bodies; one that says nothing ends it. Throws Error for
  /// an id of no body here, a body with itself, and a margin that is no length.
  void set_rules(std::span<const PairRule> rules);
  void set_rule(const PairRule& rule);

  /// Makes what the next steps need of the bodies' models (Model::prepare), on the threads of the World's options: else
  /// the first step that needs it waits for that. No answer depends on it.
  void prepare() const;

  /// Finds the pairs of the bodies as they are now. `progress` is told how many of the pairs that have to be asked
  /// about are done; what it throws ends the step, which is then as if it had not begun.
  const WorldStep& step();
  const WorldStep& step(const Progress& progress);
  /// The same of those pairs alone that are wanted. It is asked, ascending, of two whose boxes overlap and that no rule
  /// leaves out, a.index < b.index; where it says no they are not looked at and are no pair in this step. Throws Error
  /// in a World with space_time, which has to know of all.
  const WorldStep& step(FunctionRef<bool(BodyId a, BodyId b)> is_wanted);
  /// The same without lists, for who keeps pairs of their own: calls `see` for each pair. No pair is known afterwards,
  /// so `pairs` and the lists of `last_step` are empty, and the next step tells all of its pairs as begun.
  const WorldStep& step(FunctionRef<bool(BodyId a, BodyId b)> is_wanted, FunctionRef<void(const PairReport& pair)> see);

  /// What the last step found.
  [[nodiscard]] const WorldStep& last_step() const;
  /// All pairs of the last step, `begin` and `persist`, ascending.
  [[nodiscard]] std::span<const PairReport> pairs() const;

  /// How many bodies there are.
  [[nodiscard]] std::size_t size() const;
  /// All of them, ascending.
  [[nodiscard]] std::vector<BodyId> bodies() const;
  [[nodiscard]] bool contains(BodyId id) const;
  /// The body as it was given last. Throws Error naming the id when it is of no body here.
  [[nodiscard]] const Body& body(BodyId id) const;
  /// How near two bodies have to be to be a pair, by their margins and rules; none where the two are never compared.
  /// Throws Error like `body`, and for one body twice.
  [[nodiscard]] std::optional<double> pair_margin(BodyId a, BodyId b) const;
  /// Contains the body where it is now, without its margin; a half-space's has infinite sides. Throws Error like
  /// `body`.
  [[nodiscard]] const Aabb& box(BodyId id) const;

  /// The boxes of all bodies where they are now, by index. Empty where no body has that index.
  [[nodiscard]] std::span<const Aabb> boxes() const;
  /// The body that has this index now, if any.
  [[nodiscard]] std::optional<BodyId> body_at(Index index) const;
  /// Another number after each call that may change bodies or rules, in no other World but a copy: where it is the same
  /// so are the bodies. For indices over them.
  [[nodiscard]] std::uint64_t revision() const;

  [[nodiscard]] const WorldOptions& options() const;
  /// The broad phase of the last step: which method, and why (BroadPhase).
  [[nodiscard]] const BroadPhase& broad_phase() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace toccata
