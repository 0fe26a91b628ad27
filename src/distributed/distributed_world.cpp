#include "toccata/distributed/distributed_world.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "distributed/distributed_state.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

/// Yes and no of a pair do not depend on the order of its bodies; what else is told of it does, and comes afterwards.
WorldOptions without_details(WorldOptions options) {
  options.relation = options.distance = options.contacts = options.manifold = options.penetration = false;
  return options;
}

}  // namespace

DistributedWorld::State::State(MpiCommunicator communicator, const DistributedOptions& options)
    : options_(options),
      ranks_(communicator.fortran_handle, options.patience_seconds),
      world_(without_details(options.world)),
      queries_(world_),
      models_(ranks_.rank()),
      space_(ranks_.count()) {
  require_equal_options();
}

std::vector<GlobalId> DistributedWorld::State::bodies() const {
  std::vector<GlobalId> ids;
  for (const auto& [id, local] : local_)
    if (copy(local).lives_here) ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

bool DistributedWorld::State::lives_here(GlobalId id) const {
  const auto found = local_.find(id);
  return found != local_.end() && copy(found->second).lives_here;
}

DistributedWorld::DistributedWorld(MpiCommunicator communicator, const DistributedOptions& options)
    : state_(std::make_unique<State>(communicator, options)) {}
DistributedWorld::DistributedWorld(DistributedWorld&&) noexcept = default;
DistributedWorld& DistributedWorld::operator=(DistributedWorld&&) noexcept = default;
DistributedWorld::~DistributedWorld() = default;

void DistributedWorld::add(std::span<const GlobalBody> bodies) {
  state_->wanted.added.insert(state_->wanted.added.end(), bodies.begin(), bodies.end());
}

void DistributedWorld::move(std::span<const GlobalId> ids, std::span<const Pose> poses) {
  if (ids.size() != poses.size())
    throw Error(fmt::format("{} bodies are named and {} poses given; give one for each", ids.size(), poses.size()));
  std::vector<WantedPlace>& moved = state_->wanted.moved;
  const std::size_t before = moved.size();
  moved.resize(before + ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) moved[before + i] = {ids[i], poses[i]};
}

void DistributedWorld::move_along(std::span<const GlobalId> ids, std::span<const RigidMotion> motions) {
  if (ids.size() != motions.size())
    throw Error(fmt::format("{} bodies are named and {} motions given; give one for each", ids.size(), motions.size()));
  for (std::size_t i = 0; i < ids.size(); ++i) state_->wanted.moved.push_back({ids[i], {}, motions[i]});
}

void DistributedWorld::deform(GlobalId id, std::vector<Vec3> vertices) {
  state_->wanted.deformed.push_back({id, std::move(vertices)});
}

void DistributedWorld::set_rules(std::span<const GlobalPairRule> rules) {
  state_->wanted.rules.insert(state_->wanted.rules.end(), rules.begin(), rules.end());
}

void DistributedWorld::replace(std::span<const GlobalBody> bodies) {
  state_->wanted.replaced.insert(state_->wanted.replaced.end(), bodies.begin(), bodies.end());
}

void DistributedWorld::remove(std::span<const GlobalId> ids) {
  state_->wanted.removed.insert(state_->wanted.removed.end(), ids.begin(), ids.end());
}

void DistributedWorld::save(const std::filesystem::path& folder) { state_->save(folder); }

DistributedWorld DistributedWorld::load(MpiCommunicator communicator, const std::filesystem::path& folder,
                                        const DistributedOptions& options) {
  DistributedWorld world(communicator, options);
  world.state_->load(folder);
  return world;
}

const DistributedStep& DistributedWorld::step() { return state_->step(); }
const DistributedStep& DistributedWorld::last_step() const { return state_->last_step(); }
std::span<const GlobalPairReport> DistributedWorld::pairs() const { return state_->pairs(); }
std::vector<GlobalId> DistributedWorld::bodies() const { return state_->bodies(); }
bool DistributedWorld::lives_here(GlobalId id) const { return state_->lives_here(id); }
const Body& DistributedWorld::body(GlobalId id) const { return state_->body(id); }
int DistributedWorld::rank() const { return state_->ranks().rank(); }
int DistributedWorld::rank_count() const { return state_->ranks().count(); }
double DistributedWorld::seconds_waited() const { return state_->ranks().seconds_waited(); }

std::vector<std::optional<GlobalAnswer<RayHit>>> DistributedWorld::cast_ray_each(std::span<const Ray> rays) {
  return state_->cast_ray_each(rays);
}
std::vector<std::optional<GlobalAnswer<ShapeHit>>> DistributedWorld::cast_shape_each(
    std::span<const MovingShape> moving) {
  return state_->cast_shape_each(moving);
}
std::vector<std::vector<GlobalId>> DistributedWorld::overlapping_each(std::span<const SceneInstance> shapes) {
  return state_->within_each(shapes, 0);
}
std::vector<std::vector<GlobalId>> DistributedWorld::within_each(std::span<const SceneInstance> shapes,
                                                                 double max_distance) {
  return state_->within_each(shapes, max_distance);
}
std::vector<std::optional<GlobalAnswer<Distance>>> DistributedWorld::nearest_each(std::span<const SceneInstance> shapes,
                                                                                  double max_distance) {
  return state_->nearest_each(shapes, max_distance);
}

std::vector<std::vector<GlobalAnswer<Distance>>> DistributedWorld::nearest_bodies_each(
    std::span<const SceneInstance> shapes, std::size_t k, double max_distance) {
  return state_->nearest_bodies_each(shapes, k, max_distance);
}

}  // namespace toccata
