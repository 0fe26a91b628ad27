#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "support/convex_cases.hpp"
#include "support/mesh_soups.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/scene_index.hpp"

// Questions about many posed models, compared with asking every one of them.
namespace toccata::test {

/// Where a crowd of objects is, and how large.
struct CrowdPlace {
  double size = 1;
  Vec3 middle{};
};

/// near; lattice: at whole numbers and not turned, so that much touches and much is equally far; far; tiny; huge.
inline const std::vector<std::string>& crowd_families() {
  static const std::vector<std::string> all{"near", "lattice", "far", "tiny", "huge"};
  return all;
}

inline CrowdPlace crowd_place(const std::string& family) {
  if (family == "far") return {1, {1e7, -3e7, 12345.678}};
  if (family == "tiny") return {0x1p-200, {}};
  if (family == "huge") return {0x1p200, {}};
  return {};
}

/// Any bounded convex shape, of about size 1.
inline Shape convex_in_crowd(Random& random) {
  return std::visit([](const auto& shape) { return Shape(shape); },
                    random_convex(convex_kinds()[random.below(convex_kinds().size())], random));
}

inline Shape shape_in_crowd(Random& random) {
  const std::uint64_t kind = random.below(12);
  if (kind == 0) return HalfSpace({0, 0, -4}, {random.between(-1, 1), random.between(-1, 1), 1});
  if (kind == 1) return std::make_shared<const TriangleMesh>(box_between({-1, -1, -1}, {1, 0.5, 0.75}));
  if (kind == 2) return std::make_shared<const TriangleMesh>(random_soup(random, 8, 0.7, 0));
  if (kind == 3) {
    std::vector<double> heights(9);
    for (double& height : heights) height = random.between(-0.5, 0.5);
    return HeightField(3, 3, 1, 1, heights);
  }
  if (kind == 4) {
    const std::vector<CompoundPart> parts{{convex_in_crowd(random), Pose::translation(1, 0, 0)},
                                          {convex_in_crowd(random), Pose::translation(-1, 0, 0)}};
    return Compound(parts);
  }
  if (kind == 5) {
    const double r = random.between(0.25, 1), h = random.between(0.25, 1);
    if (random.below(3) == 0) return Ellipsoid({r, h, 0.5});
    return random.below(2) == 0 ? Shape(Cylinder(r, h)) : Shape(Cone(r, h));
  }
  return convex_in_crowd(random);
}

inline SceneInstance posed_in_crowd(const std::string& family, const Shape& shape, double spread, Random& random) {
  const CrowdPlace place = crowd_place(family);
  const bool on_lattice = family == "lattice";
  Vec3 at;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = random.between(-spread, spread);
    at[axis] = on_lattice ? std::round(x) : x;
  }
  const Mat3 turned = on_lattice ? Mat3{} : random_rotation(random);
  const Pose pose{turned, place.size * at + place.middle};
  if (keeps_its_form(shape)) return {Model(scaled_in_itself(shape, place.size)), pose};
  return {Model(shape), scaled(pose, place.size)};
}

inline Vec3 way_in_crowd(const std::string& family, double spread, Random& random) {
  Vec3 way;
  while (way == Vec3{})
    for (int axis = 0; axis < 3; ++axis) {
      const double x = random.below(4) == 0 ? 0 : random.between(-spread, spread);
      way[axis] = crowd_place(family).size * (family == "lattice" ? std::round(x) : x);
    }
  return way;
}

// What the answers have to be.

template <class Found>
std::optional<Found> first_of(const std::vector<Found>& all) {
  std::optional<Found> first;
  double lower = HUGE_VAL;
  for (const Found& found : all) {
    lower = std::min(lower, found.lower);
    if (!first || std::tie(found.upper, found.object) < std::tie(first->upper, first->object)) first = found;
  }
  if (first) first->lower = lower;
  return first;
}

/// Objects are asked one by one, those that the filter lets through.
class OneByOne {
 public:
  OneByOne(const std::vector<SceneInstance>& objects, ObjectFilter filter)
      : objects_(objects), filter_(std::move(filter)) {}

  [[nodiscard]] std::vector<ObjectAnswer<RayHit>> ray_hits(const Ray& ray) const {
    std::vector<ObjectAnswer<RayHit>> all;
    each([&](Index i, const SceneInstance& object) {
      const std::optional<RayHit> hit = cast_ray(ray.origin, ray.motion, object.model, object.pose, object.solid);
      if (hit) all.push_back({*hit, i});
    });
    std::sort(all.begin(), all.end(), [](const ObjectAnswer<RayHit>& a, const ObjectAnswer<RayHit>& b) {
      return std::tie(a.upper, a.object) < std::tie(b.upper, b.object);
    });
    return all;
  }
  [[nodiscard]] std::optional<ObjectAnswer<ShapeHit>> cast(const MovingShape& moving) const {
    std::vector<ObjectAnswer<ShapeHit>> all;
    each([&](Index i, const SceneInstance& object) {
      const std::optional<ShapeHit> hit =
          cast_shape(moving.shape.model, moving.motion, object.model, query_of(moving.shape, object));
      if (hit) all.push_back({*hit, i});
    });
    return first_of(all);
  }
  [[nodiscard]] std::vector<ObjectAnswer<Relation>> relations(const SceneInstance& shape) const {
    std::vector<ObjectAnswer<Relation>> all;
    each([&](Index i, const SceneInstance& object) {
      const Relation found = relation(shape.model, object.model, query_of(shape, object));
      if (found.kind != RelationKind::apart) all.push_back({found, i});
    });
    return all;
  }
  [[nodiscard]] std::vector<Index> overlapping(const SceneInstance& shape) const {
    std::vector<Index> all;
    each([&](Index i, const SceneInstance& object) {
      if (overlap(shape.model, object.model, query_of(shape, object))) all.push_back(i);
    });
    return all;
  }
  [[nodiscard]] std::optional<ObjectAnswer<Distance>> nearest(const SceneInstance& shape, double limit) const {
    std::vector<ObjectAnswer<Distance>> all;
    each([&](Index i, const SceneInstance& object) {
      const PairQuery query = query_of(shape, object);
      if (within_distance(shape.model, object.model, limit, query))
        all.push_back({distance(shape.model, object.model, query), i});
    });
    return first_of(all);
  }
  [[nodiscard]] std::vector<Index> within(const SceneInstance& shape, double limit) const {
    std::vector<Index> all;
    each([&](Index i, const SceneInstance& object) {
      if (within_distance(shape.model, object.model, limit, query_of(shape, object))) all.push_back(i);
    });
    return all;
  }

 private:
  static PairQuery query_of(const SceneInstance& a, const SceneInstance& b) {
    return {a.pose, b.pose, a.solid, b.solid};
  }
  template <class See>
  void each(const See& see) const {
    for (Index i = 0; i < objects_.size(); ++i)
      if (!filter_ || filter_(i)) see(i, objects_[i]);
  }

  const std::vector<SceneInstance>& objects_;
  ObjectFilter filter_;
};

/// A crowd with an index over it. Some have objects that no shape is cast at.
struct QuestionedCrowd {
  QuestionedCrowd(const std::string& family_name, std::size_t count, bool convex, Random& random)
      : family(family_name), spread(1.5 * std::cbrt(static_cast<double>(count))) {
    for (std::size_t i = 0; i < count; ++i)
      objects.push_back(
          posed_in_crowd(family, convex ? convex_in_crowd(random) : shape_in_crowd(random), spread, random));
    index = SceneIndex(objects);
  }

  std::string family;
  double spread;
  std::vector<SceneInstance> objects;
  SceneIndex index;
};

/// What is wrong with the answers to one question of each kind; empty when nothing is.
inline std::string crowd_fault(const QuestionedCrowd& crowd, bool convex, Random& random) {
  ObjectFilter filter;
  if (random.below(3) == 0) filter = [](Index i) { return i % 3 != 1; };
  const OneByOne expected(crowd.objects, filter);
  const SceneInstance shape = posed_in_crowd(crowd.family, convex ? convex_in_crowd(random) : shape_in_crowd(random),
                                             1.5 * crowd.spread, random);
  const Ray ray{shape.pose.offset, way_in_crowd(crowd.family, 3 * crowd.spread, random)};
  const std::vector<ObjectAnswer<RayHit>> hits = expected.ray_hits(ray);
  if (crowd.index.cast_ray(ray, filter) != first_of(hits)) return "cast_ray";
  if (crowd.index.cast_ray_through(ray, filter) != hits) return "cast_ray_through";
  const MovingShape moving{shape, ray.motion};
  const bool is_bounded = kind_of(shape.model.shape()) != ShapeKind::half_space;  // two half-spaces are refused
  if (is_bounded && crowd.index.cast_shape(moving, filter) != expected.cast(moving)) return "cast_shape";
  if (crowd.index.overlapping(shape, filter) != expected.overlapping(shape)) return "overlapping";
  if (crowd.index.relations(shape, filter) != expected.relations(shape)) return "relations";
  for (const double limit : {HUGE_VAL, crowd_place(crowd.family).size, 0.0}) {
    if (crowd.index.nearest(shape, limit, filter) != expected.nearest(shape, limit)) return "nearest";
    if (crowd.index.within(shape, limit, filter) != expected.within(shape, limit)) return "within";
  }
  return "";
}

}  // namespace toccata::test
