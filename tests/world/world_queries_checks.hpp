#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "query/scene_index_checks.hpp"
#include "toccata/world/world_queries.hpp"

// Questions to a World whose bodies come, move and go, compared with asking every body by itself.
namespace toccata::test {

class QuestionedWorld {
 public:
  /// Bodies are up to `spread` of their sizes from the middle, along each axis.
  QuestionedWorld(const std::string& family, bool convex, double spread = few_spread)
      : family_(family), convex_(convex), spread_(spread), queries_(world_) {}

  void add(std::uint64_t count, Random& random) {
    for (; count > 0; --count) {
      const SceneInstance posed = random_posed(spread_, random);
      Body body{posed.model, posed.pose};
      body.category = 1 + random.below(7);
      body.mask = 1 + random.below(7);
      bodies_.emplace(world_.add(body), body);
    }
  }

  /// Some bodies are added, others move or go.
  void live(Random& random) {
    add(random.below(12), random);
    std::vector<BodyId> gone;
    for (auto& [id, body] : bodies_) {
      if (random.below(4) == 0) {
        body.pose.offset = random_posed(spread_, random).pose.offset;
        world_.move(id, body.pose);
      } else if (random.below(8) == 0) {
        gone.push_back(id);
      }
    }
    world_.remove(gone);
    for (const BodyId& id : gone) bodies_.erase(id);
    if (random.below(2) == 0) world_.step();
    queries_.update();
  }

  /// What is wrong with the answers to one question of each kind; empty when nothing is.
  [[nodiscard]] std::string fault(Random& random) const {
    const BodyFilter filter = random_filter(random);
    std::vector<BodyId> ids;
    std::vector<SceneInstance> objects;
    for (const auto& [id, body] : bodies_)
      if (is_let_through(filter, id, body)) {
        ids.push_back(id);
        objects.push_back({body.model, body.pose, body.solid});
      }
    return fault(OneByOne(objects, {}), ids, filter, random);
  }

  [[nodiscard]] const World& world() const { return world_; }

 private:
  static constexpr double few_spread = 4;

  /// Among many there are no half-spaces: all would be within them.
  [[nodiscard]] Shape random_shape(Random& random) const {
    for (;;) {
      Shape shape = convex_ ? convex_in_crowd(random) : shape_in_crowd(random);
      if (spread_ <= few_spread || kind_of(shape) != ShapeKind::half_space) return shape;
    }
  }
  [[nodiscard]] SceneInstance random_posed(double within, Random& random) const {
    return posed_in_crowd(family_, random_shape(random), within, random);
  }

  static BodyFilter random_filter(Random& random) {
    BodyFilter filter;
    if (random.below(2) == 0) filter.mask = 1 + random.below(7);
    if (random.below(2) == 0) filter.category = 1 + random.below(7);
    if (random.below(2) == 0) filter.accepts = [](BodyId id) { return id.index % 4 != 2; };
    return filter;
  }
  static bool is_let_through(const BodyFilter& filter, BodyId id, const Body& body) {
    const bool by_mask = filter.category == 0 || (body.mask & filter.category) != 0;
    return (body.category & filter.mask) != 0 && by_mask && (!filter.accepts || filter.accepts(id));
  }

  [[nodiscard]] std::string fault(const OneByOne& expected, const std::vector<BodyId>& ids, const BodyFilter& filter,
                                  Random& random) const {
    const auto same = [&](const auto& found, const auto& wanted) {
      if (!found || !wanted) return !found && !wanted;
      return found->body == ids[wanted->object] && answer_of(*found) == answer_of(*wanted);
    };
    const auto same_ids = [&](const std::vector<BodyId>& found, const std::vector<Index>& wanted) {
      std::vector<BodyId> named;
      for (const Index object : wanted) named.push_back(ids[object]);
      return found == named;
    };
    const SceneInstance shape = random_posed(1.5 * spread_, random);
    const Ray ray{shape.pose.offset, way_in_crowd(family_, 3 * spread_, random)};
    const std::vector<ObjectAnswer<RayHit>> hits = expected.ray_hits(ray);
    if (!same(queries_.cast_ray(ray, filter), first_of(hits))) return "cast_ray";
    const std::vector<BodyAnswer<RayHit>> through = queries_.cast_ray_through(ray, filter);
    if (through.size() != hits.size()) return "cast_ray_through";
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (!same(std::optional(through[i]), std::optional(hits[i]))) return "cast_ray_through";
    const MovingShape moving{shape, ray.motion};
    const bool is_bounded = kind_of(shape.model.shape()) != ShapeKind::half_space;  // two half-spaces are refused
    if (is_bounded && !same(queries_.cast_shape(moving, filter), expected.cast(moving))) return "cast_shape";
    if (!same_ids(queries_.overlapping(shape, filter), expected.overlapping(shape))) return "overlapping";
    const std::vector<ObjectAnswer<Relation>> relations = expected.relations(shape);
    const std::vector<BodyAnswer<Relation>> related = queries_.relations(shape, filter);
    if (related.size() != relations.size()) return "relations";
    for (std::size_t i = 0; i < related.size(); ++i)
      if (!(related[i] == BodyAnswer<Relation>{relations[i], ids[relations[i].object]})) return "relations";
    for (const double limit : {HUGE_VAL, crowd_place(family_).size}) {
      if (!same(queries_.nearest(shape, limit, filter), expected.nearest(shape, limit))) return "nearest";
      if (!same_ids(queries_.within(shape, limit, filter), expected.within(shape, limit))) return "within";
    }
    return "";
  }

  static const RayHit& answer_of(const RayHit& found) { return found; }
  static const ShapeHit& answer_of(const ShapeHit& found) { return found; }
  static const Distance& answer_of(const Distance& found) { return found; }

  std::string family_;
  bool convex_;
  double spread_;
  World world_;
  std::map<BodyId, Body> bodies_;
  WorldQueries queries_;
};

}  // namespace toccata::test
