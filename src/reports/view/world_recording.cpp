#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/reports/pages.hpp"

namespace toccata {
namespace {

Vec3 centre_of_box(const Aabb& box) { return 0.5 * box.lower + 0.5 * box.upper; }

std::size_t bytes_of(const WorldRecording::Frame& frame) {
  return 24 * (frame.placed.size() + frame.gone.size()) + 150 * frame.pairs.size() + 36 * frame.touched.size();
}

}  // namespace

/// All of a frame, before any of it is kept.
struct WorldRecording::Next {
  std::vector<BodyId> there;  ///< ascending
  std::vector<Seen> seen;     ///< of each of these
  std::vector<Body> objects;  ///< the new ones
  Frame frame;
};

void WorldRecording::add_bodies(const World& world, Next& next) const {
  next.there = world.bodies();
  for (const BodyId id : next.there) {
    const Body& body = world.body(id);
    const auto before = seen_.find(id);
    const bool is_new = before == seen_.end();
    const Index object = is_new ? static_cast<Index>(objects_.size() + next.objects.size()) : before->second.object;
    if (is_new) next.objects.push_back(body);
    if (is_new || before->second.pose != body.pose) next.frame.placed.push_back({object, body.pose});
    next.seen.push_back({object, body.pose, centre_of_box(world.box(id))});
  }
  for (const BodyId id : there_)
    if (!world.contains(id)) next.frame.gone.push_back(seen_.at(id).object);
}

void WorldRecording::add_pairs(std::span<const PairReport> pairs, Change change, Next& next) const {
  const auto seen = [&](BodyId id) -> const Seen* {
    const auto place = std::lower_bound(next.there.begin(), next.there.end(), id);
    if (place != next.there.end() && *place == id)
      return &next.seen[static_cast<std::size_t>(place - next.there.begin())];
    const auto before = seen_.find(id);
    return before == seen_.end() ? nullptr : &before->second;
  };
  for (const PairReport& pair : pairs) {
    const Seen *a = seen(pair.a), *b = seen(pair.b);
    if (a == nullptr || b == nullptr) continue;  // it has ended, and a body is gone that was never recorded
    next.frame.pairs.push_back({a->object, b->object, change, pair.in_contact, a->middle, b->middle, pair.details});
  }
}

void WorldRecording::add(const World& world, const std::string& label, std::vector<Touched> touched) {
  Next next;
  next.frame.label = label;
  next.frame.touched = std::move(touched);
  add_bodies(world, next);
  const WorldStep& step = world.last_step();
  add_pairs(step.begin, Change::begin, next);
  add_pairs(step.persist, Change::persist, next);
  add_pairs(step.end, Change::end, next);
  const std::size_t bytes = bytes_ + bytes_of(next.frame);
  if (bytes > most_bytes)
    throw Error(fmt::format("{} frames of {} bodies are more than the {:.0f} MB that a page may hold: record fewer",
                            frames_.size() + 1, next.there.size(), static_cast<double>(most_bytes) / 1e6));
  objects_.reserve(objects_.size() + next.objects.size());
  frames_.reserve(frames_.size() + 1);
  for (std::size_t i = 0; i < next.there.size(); ++i) seen_.insert_or_assign(next.there[i], next.seen[i]);
  for (Body& body : next.objects) objects_.push_back(std::move(body));
  frames_.push_back(std::move(next.frame));
  there_ = std::move(next.there);
  bytes_ = bytes;
}

void WorldRecording::add(Surface surface) {
  const std::size_t bytes = bytes_ + 12 * surface.corners.size();
  if (bytes > most_bytes)
    throw Error(fmt::format("the {} triangles of '{}' are more than a page of {:.0f} MB has room for",
                            surface.corners.size() / 3, surface.name, static_cast<double>(most_bytes) / 1e6));
  surfaces_.push_back(std::move(surface));
  bytes_ = bytes;
}

void WorldRecording::add(Path path) {
  const std::size_t bytes = bytes_ + 24 * path.points.size();
  if (bytes > most_bytes)
    throw Error(fmt::format("the {} points of '{}' are more than a page of {:.0f} MB has room for", path.points.size(),
                            path.name, static_cast<double>(most_bytes) / 1e6));
  paths_.push_back(std::move(path));
  bytes_ = bytes;
}

}  // namespace toccata
