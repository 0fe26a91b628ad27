#include "toccata/world/world.hpp"

#include <utility>

#include "world/world_state.hpp"

namespace toccata {

World::World(const WorldOptions& options) : state_(std::make_unique<State>(options)) {}
World::World(const World& other) : state_(std::make_unique<State>(*other.state_)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World other) noexcept {
  state_ = std::move(other.state_);
  return *this;
}
World::~World() = default;

std::vector<BodyId> World::add(std::span<const Body> bodies) { return state_->add(bodies); }
std::vector<BodyId> World::add(std::initializer_list<Body> bodies) { return state_->add(bodies); }
BodyId World::add(const Model& model, const Pose& pose, BodyType type) { return add(Body{model, pose, type}); }
BodyId World::add(const Body& body) { return state_->add({&body, 1})[0]; }
void World::remove(std::span<const BodyId> ids) { state_->remove(ids); }
void World::remove(BodyId id) { state_->remove({&id, 1}); }
void World::move(std::span<const BodyId> ids, std::span<const Pose> poses) { state_->move(ids, poses); }
void World::move(BodyId id, const Pose& pose) { state_->move({&id, 1}, {&pose, 1}); }
void World::move_along(std::span<const BodyId> ids, std::span<const RigidMotion> motions) {
  state_->move_along(ids, motions);
}
void World::move_along(BodyId id, const RigidMotion& motion) { state_->move_along({&id, 1}, {&motion, 1}); }
void World::replace(std::span<const BodyId> ids, std::span<const Body> bodies) { state_->replace(ids, bodies); }
void World::replace(BodyId id, const Body& body) { state_->replace({&id, 1}, {&body, 1}); }
Refit World::deform(BodyId id, std::vector<Vec3> vertices) { return state_->deform(id, std::move(vertices)); }
void World::set_rules(std::span<const PairRule> rules) { state_->set_rules(rules); }
void World::set_rule(const PairRule& rule) { state_->set_rules({&rule, 1}); }
void World::prepare() const { state_->prepare(); }
const WorldStep& World::step() { return state_->step({}); }
const WorldStep& World::step(const Progress& progress) { return state_->step({.progress = &progress}); }
const WorldStep& World::step(FunctionRef<bool(BodyId, BodyId)> is_wanted) {
  return state_->step({.are_wanted = &is_wanted});
}
const WorldStep& World::step(FunctionRef<bool(BodyId, BodyId)> is_wanted, FunctionRef<void(const PairReport&)> see) {
  return state_->step({.are_wanted = &is_wanted, .see = &see});
}

const WorldStep& World::last_step() const { return state_->last_step(); }
std::span<const PairReport> World::pairs() const { return state_->pairs(); }
std::size_t World::size() const { return state_->size(); }
bool World::contains(BodyId id) const { return state_->contains(id); }
const Body& World::body(BodyId id) const { return state_->body(state_->require(id)); }
std::optional<double> World::pair_margin(BodyId a, BodyId b) const { return state_->pair_margin(a, b); }
const Aabb& World::box(BodyId id) const { return state_->boxes()[state_->require(id)]; }
std::span<const Aabb> World::boxes() const { return state_->boxes(); }
std::uint64_t World::revision() const { return state_->revision(); }
const WorldOptions& World::options() const { return state_->options(); }
const BroadPhase& World::broad_phase() const { return state_->broad_phase(); }

std::optional<BodyId> World::body_at(Index index) const {
  if (!state_->is_used(index)) return std::nullopt;
  return state_->id_of(index);
}

std::vector<BodyId> World::bodies() const {
  std::vector<BodyId> ids;
  ids.reserve(size());
  for (std::size_t i = 0; i < state_->index_count(); ++i)
    if (state_->is_used(static_cast<Index>(i))) ids.push_back(state_->id_of(static_cast<Index>(i)));
  return ids;
}

}  // namespace toccata
