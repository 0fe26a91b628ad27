#include "world/world_state.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/require_length.hpp"
#include "math/constants.hpp"
#include "query/posed_shape.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "world/body_box.hpp"
#include "world/swept_box.hpp"

namespace toccata {
namespace {

/// A number that no World has had. Counted for all of them: a World to which an earlier copy of it was assigned must
/// not come by the same number with other bodies.
std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

std::string name_in_brackets(const std::string& name) { return name.empty() ? "" : fmt::format(" (\"{}\")", name); }

std::string name_of_id(const BodyId& id) { return fmt::format("body {} (generation {})", id.index, id.generation); }

void require_length_of(const FunctionRef<std::string()>& who, const char* name, double length) {
  if (!(length >= 0)) require_length(length, fmt::format("{}: its {}", who(), name));
}

void require_lengths(const Body& body, const FunctionRef<std::string()>& who) {
  require_length_of(who, "margin", body.margin);
  require_length_of(who, "max_acceleration", body.max_acceleration);
  require_length_of(who, "max_speed", body.max_speed);
}

void require_as_many(std::size_t ids, std::size_t others, const char* noun) {
  if (ids != others)
    throw Error(fmt::format("{} bodies are named and {} {} given; give one for each", ids, others, noun));
}

/// Two boxes grown by this each overlap wherever the bodies are as near as the sum of two such margins, rounded.
double reach_of_margin(double margin) {
  if (margin >= 0.5 * greatest_double) return infinity;  // with another as large the sum is
  return margin > 0 ? std::nextafter(margin, infinity) : 0;
}

/// Calls `work(i)` for each i, rows of them on several threads.
template <class Work>
void for_each(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t at_once = 256;
  parallel_for((count + at_once - 1) / at_once, threads, [&](std::size_t row) {
    const std::size_t end = std::min(count, (row + 1) * at_once);
    for (std::size_t i = row * at_once; i < end; ++i) work(i);
  });
}

/// boxes[i] becomes `make(i)`.
template <class Make>
void make_boxes(std::size_t count, int threads, std::vector<Aabb>& boxes, const Make& make) {
  boxes.resize(count);
  for_each(count, threads, [&](std::size_t i) { boxes[i] = make(i); });
}

}  // namespace

std::string World::State::name_of_body(Index index) const {
  return name_of_id(id_of(index)) + name_in_brackets(bodies_[index].name);
}

std::uint32_t World::State::number_of_new_world() {
  static std::atomic<std::uint32_t> last = 0;
  return ++last;
}

Index World::State::require(BodyId id) const {
  if (contains(id)) return id.index;
  if (id.world != 0 && id.world != number_)
    throw Error(
        fmt::format("{} is of another World: ask the World that gave out its id, or a copy of it", name_of_id(id)));
  const bool was_there = id.generation > 0 && id.index < slots_.size() && id.generation < slots_[id.index].generation;
  throw Error(fmt::format("{} {}", name_of_id(id),
                          was_there ? "was removed: its id names no body any more"
                                    : "is not in this World: its id was not given out by it"));
}

std::vector<Index> World::State::required(std::span<const BodyId> ids) const {
  std::vector<Index> indices;
  indices.reserve(ids.size());
  for (const BodyId id : ids) indices.push_back(require(id));
  return indices;
}

double World::State::reach(Index index, double margin) const {
  const double own = reach_of_margin(margin);
  return std::max(own, half_rounded_up(slots_[index].rule_margin));
}

const Aabb& World::State::box_on_the_way(Index index) const {
  const auto found = on_the_way_.find(index);
  return found == on_the_way_.end() ? boxes_[index] : found->second.box;
}

Aabb World::State::reached_box(Index index) const {
  const double by = reach(index, slots_[index].margin);
  const Aabb& box = box_on_the_way(index);
  return by > 0 ? offset_outward(box, by) : box;
}

void World::State::place(std::span<const Index> indices) {
  if (schedule_ && schedule_->count_flying() > 0) {
    not_flying_.clear();
    std::copy_if(indices.begin(), indices.end(), std::back_inserter(not_flying_),
                 [&](Index index) { return !schedule_->is_flying(index); });
    indices = not_flying_;
  }
  reached_boxes_.clear();
  for (const Index index : indices) reached_boxes_.push_back(reached_box(index));
  give_to_phase(indices);
}

void World::State::mark_changed(Index index) {
  if (!std::exchange(slots_[index].has_changed, true)) changed_.push_back(index);
}

void World::State::put(Index index, Body&& body, const Aabb& box) {
  Slot& slot = slots_[index];
  slot.category = body.category;
  slot.mask = body.mask;
  slot.margin = body.margin;
  slot.type = body.type;
  slot.is_used = true;
  boxes_[index] = box;
  on_the_way_.erase(index);
  bodies_[index] = std::move(body);
  mark_changed(index);
  if (schedule_) schedule_->put(index, bodies_[index]);
}

std::vector<BodyId> World::State::add(std::span<const Body> bodies) {
  make_boxes(bodies.size(), options_.threads, new_boxes_, [&](std::size_t i) {
    const auto who = [&] {
      return fmt::format("body {} of the {} to add{}", i, bodies.size(), name_in_brackets(bodies[i].name));
    };
    require_lengths(bodies[i], who);
    return body_box(bodies[i], bodies[i].pose, who);
  });
  std::vector<Body> copies(bodies.begin(), bodies.end());
  reached_boxes_ = new_boxes_;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const double by = reach_of_margin(bodies[i].margin); by > 0)
      reached_boxes_[i] = offset_outward(new_boxes_[i], by);
  const std::vector<Index> indices = phase_.add(reached_boxes_);
  bodies_.resize(phase_.size(), Body{Point{}});
  slots_.resize(phase_.size());
  boxes_.resize(phase_.size());
  std::vector<BodyId> ids;
  ids.reserve(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    put(indices[i], std::move(copies[i]), new_boxes_[i]);
    ids.push_back(id_of(indices[i]));
  }
  count_ += ids.size();
  revision_ = next_revision();
  return ids;
}

void World::State::remove(std::span<const BodyId> ids) {
  const std::vector<Index> indices = required(ids);
  std::vector<Index> sorted = indices;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw Error(fmt::format("{} is to be removed twice", name_of_body(*twice)));
  // An index whose generations are used up is never given out again.
  constexpr std::uint32_t last_generation = std::numeric_limits<std::uint32_t>::max();
  const auto end = std::stable_partition(sorted.begin(), sorted.end(),
                                         [&](Index index) { return slots_[index].generation != last_generation; });
  phase_.move({end, sorted.end()}, std::vector<Aabb>(static_cast<std::size_t>(sorted.end() - end)));
  phase_.remove({sorted.begin(), end});
  std::vector<Index> partners;
  for (const Index index : indices) {
    if (slots_[index].has_rules) rules_.forget(index, [&](Index partner) { partners.push_back(partner); });
    const std::uint32_t generation = slots_[index].generation;
    const bool has_changed = slots_[index].has_changed;
    slots_[index] = {};
    slots_[index].generation = generation + (generation != last_generation ? 1 : 0);
    slots_[index].has_changed = has_changed;
    bodies_[index] = Body{Point{}};
    boxes_[index] = {};
    if (schedule_) schedule_->put(index, bodies_[index]);
    on_the_way_.erase(index);
    mark_changed(index);
  }
  std::erase_if(partners, [&](Index partner) { return !is_used(partner); });
  follow_rules(partners);
  count_ -= ids.size();
  revision_ = next_revision();
}

void World::State::move(std::span<const BodyId> ids, std::span<const Pose> poses) {
  require_as_many(ids.size(), poses.size(), "poses");
  const std::vector<Index> indices = required(ids);
  make_boxes(ids.size(), options_.threads, new_boxes_, [&](std::size_t i) {
    return body_box(bodies_[indices[i]], poses[i], [&] { return name_of_body(indices[i]); });
  });
  // Ascending without the same twice, as they mostly are, several threads may write.
  const bool are_distinct = std::adjacent_find(indices.begin(), indices.end(), std::greater_equal<>()) == indices.end();
  differs_.resize(ids.size());
  for_each(ids.size(), are_distinct ? options_.threads : 1, [&](std::size_t i) {
    Pose& pose = bodies_[indices[i]].pose;
    differs_[i] = pose == poses[i] ? 0 : 1;
    pose = poses[i];
    boxes_[indices[i]] = new_boxes_[i];
  });
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (on_the_way_.erase(indices[i]) != 0 || differs_[i] != 0) mark_changed(indices[i]);
  place(indices);
  revision_ = next_revision();
}

Pose World::State::end_of(const RigidMotion& motion, Index index) const {
  try {
    return motion.at(1);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", name_of_body(index), error.what()));
  }
}

void World::State::move_along(std::span<const BodyId> ids, std::span<const RigidMotion> motions) {
  require_as_many(ids.size(), motions.size(), "motions");
  const std::vector<Index> indices = required(ids);
  std::vector<Pose> ends;
  for (std::size_t i = 0; i < ids.size(); ++i) ends.push_back(end_of(motions[i], indices[i]));
  make_boxes(ids.size(), options_.threads, new_boxes_, [&](std::size_t i) {
    return swept_box(bodies_[indices[i]], motions[i], [&] { return name_of_body(indices[i]); });
  });
  std::vector<Aabb> swept = new_boxes_;
  move(ids, ends);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (schedule_) schedule_->land(indices[i]);
    on_the_way_.insert_or_assign(indices[i], BodyOnTheWay{motions[i], swept[i]});
    mark_changed(indices[i]);
  }
  place(indices);
}

void World::State::arrive() {
  std::vector<Index> indices;
  for (const auto& [index, body] : on_the_way_) indices.push_back(index);
  if (indices.empty()) return;
  on_the_way_.clear();
  // What met on the way and is apart again is no pair at the next step.
  for (const Index index : indices) mark_changed(index);
  place(indices);
}

void World::State::replace(std::span<const BodyId> ids, std::span<const Body> bodies) {
  require_as_many(ids.size(), bodies.size(), "bodies");
  const std::vector<Index> indices = required(ids);
  make_boxes(ids.size(), options_.threads, new_boxes_, [&](std::size_t i) {
    const auto who = [&] { return name_of_id(ids[i]) + name_in_brackets(bodies[i].name); };
    require_lengths(bodies[i], who);
    return body_box(bodies[i], bodies[i].pose, who);
  });
  std::vector<Body> copies(bodies.begin(), bodies.end());
  for (std::size_t i = 0; i < ids.size(); ++i) put(indices[i], std::move(copies[i]), new_boxes_[i]);
  place(indices);
  revision_ = next_revision();
}

Refit World::State::deform(BodyId id, std::vector<Vec3> vertices) {
  const Index index = require(id);
  Body& body = bodies_[index];
  const auto who = [&] { return name_of_body(index); };
  const auto deformed = [&](std::vector<Vec3> to) {
    try {
      return body.model.deform(std::move(to), options_.threads);
    } catch (const Error& error) {
      throw Error(who() + ": " + error.what());
    }
  };
  std::vector<Vec3> before;
  if (body.model.has_mesh()) before.assign(body.model.mesh().vertices().begin(), body.model.mesh().vertices().end());
  const Refit done = deformed(std::move(vertices));
  try {
    boxes_[index] = body_box(body, body.pose, who);
  } catch (const Error&) {
    // It may no longer be posed so, or not as a solid.
    static_cast<void>(deformed(std::move(before)));
    throw;
  }
  if (on_the_way_.erase(index) != 0 && schedule_) schedule_->land(index);
  mark_changed(index);
  if (schedule_) schedule_->put(index, body);
  place({&index, 1});
  revision_ = next_revision();
  return done;
}

void World::State::prepare() const {
  std::vector<ModelPart> wanted{ModelPart::solidity, ModelPart::leaf_triangles};
  const bool has_margins = std::ranges::any_of(
      slots_, [](const Slot& slot) { return slot.is_used && (slot.margin > 0 || slot.rule_margin > 0); });
  if (options_.distance || options_.space_time || has_margins) wanted.push_back(ModelPart::turned_boxes);
  if (options_.manifold) wanted.push_back(ModelPart::neighbours);
  for (Index i = 0; i < slots_.size(); ++i)
    if (slots_[i].is_used) bodies_[i].model.prepare(wanted, options_.threads);
}

std::optional<double> World::State::pair_margin(BodyId a, BodyId b) const {
  const Index first = require(a), second = require(b);
  if (first == second) throw Error(fmt::format("{} is asked about with itself", name_of_body(first)));
  return margin_of({std::min(first, second), std::max(first, second)});
}

void World::State::apply(const PairRule& rule) {
  const Index a = rule.a.index, b = rule.b.index;
  rules_.set(a, b, {rule.excluded, rule.margin});
  mark_changed(a);
  mark_changed(b);
}

void World::State::follow_rules(std::vector<Index>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  for (const Index index : indices) {
    slots_[index].has_rules = rules_.has_any(index);
    slots_[index].rule_margin = rules_.largest_margin(index);
    if (schedule_) schedule_->land(index);
  }
  place(indices);
}

void World::State::set_rules(std::span<const PairRule> rules) {
  std::vector<Index> indices;
  for (const PairRule& rule : rules) {
    indices.push_back(require(rule.a));
    indices.push_back(require(rule.b));
    if (rule.a == rule.b) throw Error(fmt::format("a rule is given for {} with itself", name_of_body(rule.a.index)));
    require_length_of(
        [&] { return "the rule for " + name_of_body(rule.a.index) + " and " + name_of_body(rule.b.index); }, "margin",
        rule.margin.value_or(0));
  }
  for (const PairRule& rule : rules) apply(rule);
  follow_rules(indices);
  revision_ = next_revision();
}

}  // namespace toccata
