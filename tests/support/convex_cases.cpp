#include "support/convex_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "support/mesh_soups.hpp"

namespace toccata::test {
namespace {

/// A shape before it is made: the vertices of its core and its radius.
struct Blueprint {
  std::string kind;
  std::vector<Vec3> vertices;  ///< of a box the half extents and the centre
  double radius = 0;
};

bool is_rounded(const std::string& kind) {
  return kind == "sphere" || kind == "capsule" || kind.starts_with("rounded-");
}

std::string core_of(const std::string& kind) {
  if (kind == "sphere") return "point";
  if (kind == "capsule") return "segment";
  return kind.starts_with("rounded-") ? kind.substr(8) : kind;
}

std::vector<Vec3> corners_of(const Vec3& half_extents, const Vec3& centre) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    const auto along = [&](int axis) {
      return (i >> axis & 1) != 0 ? centre[axis] + half_extents[axis] : centre[axis] - half_extents[axis];
    };
    corners.push_back({along(0), along(1), along(2)});
  }
  return corners;
}

/// The vertices of the core in the shape's own frame.
std::vector<Vec3> core_vertices(const Blueprint& shape) {
  return core_of(shape.kind) == "box" ? corners_of(shape.vertices[0], shape.vertices[1]) : shape.vertices;
}

Rounded::Core made_core(const std::string& kind, const std::vector<Vec3>& v) {
  if (kind == "point") return Point(v[0]);
  if (kind == "segment") return Segment(v[0], v[1]);
  if (kind == "triangle") return Triangle{{v[0], v[1], v[2]}};
  if (kind == "box") return Box(v[0], v[1]);
  return ConvexHull(v);
}

ConvexShape made(const Blueprint& shape) {
  const std::vector<Vec3>& v = shape.vertices;
  if (shape.kind == "sphere") return Sphere(shape.radius, v[0]);
  if (shape.kind == "capsule") return Capsule(v[0], v[1], shape.radius);
  Rounded::Core core = made_core(core_of(shape.kind), v);
  if (is_rounded(shape.kind)) return Rounded(std::move(core), shape.radius);
  return std::visit([](auto& alone) -> ConvexShape { return std::move(alone); }, core);
}

Blueprint scaled(Blueprint shape, double factor) {
  for (Vec3& v : shape.vertices) v = factor * v;
  shape.radius *= factor;
  return shape;
}

// Every number is drawn in a statement of its own: the order in which arguments are evaluated is not specified.

Vec3 random_point(Random& random, double size) {
  const double x = random.between(-size, size);
  const double y = random.between(-size, size);
  const double z = random.between(-size, size);
  return {x, y, z};
}

Vec3 grid_point(Random& random, std::uint64_t size) {
  const auto x = static_cast<double>(random.below(size));
  const auto y = static_cast<double>(random.below(size));
  const auto z = static_cast<double>(random.below(size));
  return {x, y, z};
}

Vec3 random_direction(Random& random) {
  while (true) {
    const Vec3 v = random_point(random, 1);
    const double squared = dot(v, v);
    if (squared > 0.01 && squared <= 1) return (1 / std::sqrt(squared)) * v;
  }
}

std::vector<Vec3> random_points(Random& random, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(random, 1));
  return points;
}

std::size_t hull_size(Random& random) {
  const std::uint64_t rare = random.below(50);
  return rare == 0 ? 17 + random.below(48) : rare < 10 ? 9 + random.below(8) : 4 + random.below(5);
}

std::vector<Vec3> round_points(Random& random) {
  std::vector<Vec3> points;
  const std::size_t count = hull_size(random);
  for (std::size_t i = 0; i < count; ++i) points.push_back(random_direction(random));
  return points;
}

/// Coplanar in its own frame, in a coordinate plane or in x + y = z of whole sixteenths.
std::vector<Vec3> flat_points(Random& random) {
  std::vector<Vec3> points;
  const std::uint64_t plane = random.below(3);
  const std::size_t count = 3 + random.below(8);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = random_point(random, 1);
    const Vec3 snapped{std::round(16 * p.x) / 16, std::round(16 * p.y) / 16, 0};
    points.push_back(plane == 0   ? Vec3{p.x, p.y, 0.25}
                     : plane == 1 ? Vec3{0, p.x, p.y}
                                  : Vec3{snapped.x, snapped.y, snapped.x + snapped.y});
  }
  return points;
}

std::vector<Vec3> needle_points(Random& random) {
  const double thickness = std::pow(10.0, -random.between(3, 9));
  const std::size_t count = 4 + random.below(6);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = random_point(random, 1);
    points.push_back({p.x, thickness * p.y, thickness * p.z});
  }
  return points;
}

double random_size(Random& random) { return 0.1 + random.unit(); }

Vec3 random_extents(Random& random) {
  const double x = random_size(random);
  const double y = random_size(random);
  return {x, y, random_size(random)};
}

Blueprint random_blueprint(const std::string& kind, Random& random) {
  const std::string core = core_of(kind);
  Blueprint shape{kind, {}, 0};
  if (core == "point") shape.vertices = random_points(random, 1);
  if (core == "segment") shape.vertices = random_points(random, 2);
  if (core == "triangle") shape.vertices = random_points(random, 3);
  if (core == "hull") shape.vertices = round_points(random);
  if (core == "flat-hull") shape.vertices = flat_points(random);
  if (core == "needle-hull") shape.vertices = needle_points(random);
  if (core == "box") {
    const Vec3 extents = random_extents(random);
    shape.vertices = {extents, random_point(random, 0.5)};
  }
  if (is_rounded(kind)) shape.radius = random_size(random);
  return shape;
}

/// Whole numbers from 0 to 3; the radius is `unit` times some eighths.
Blueprint grid_blueprint(const std::string& kind, double unit, Random& random) {
  const std::string core = core_of(kind);
  Blueprint shape{kind, {}, 0};
  std::size_t count = core == "point" ? 1 : core == "segment" ? 2 : core == "triangle" ? 3 : 4 + random.below(6);
  const std::uint64_t constant = random.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 p = grid_point(random, 4);
    if (core == "flat-hull") p[static_cast<int>(constant)] = 1;
    if (core == "needle-hull") p = {p.x, p.y * 0x1p-20, p.z * 0x1p-20};
    shape.vertices.push_back(p);
  }
  if (core == "box") {
    const Vec3 extents = grid_point(random, 3);
    shape.vertices = {extents + Vec3{1, 1, 1}, grid_point(random, 3)};
  }
  if (is_rounded(kind)) shape.radius = unit * static_cast<double>(1 + random.below(16)) / 8;
  return shape;
}

Mat3 quarter_turns(Random& random) {
  Mat3 m{{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
  const int first = static_cast<int>(random.below(3));
  const int way = 1 + static_cast<int>(random.below(2));
  for (int i = 0; i < 3; ++i) m[i][(first + i * way) % 3] = random.below(2) == 0 ? 1 : -1;
  return m;
}

struct Placed {
  Blueprint shape;
  Pose pose;
};

std::vector<Vec3> world_vertices(const Placed& placed) {
  std::vector<Vec3> result;
  for (const Vec3& v : core_vertices(placed.shape)) result.push_back(oracle::world_vertex(placed.pose, v));
  return result;
}

Vec3 centroid(const std::vector<Vec3>& points) {
  Vec3 sum{};
  for (const Vec3& p : points) sum = sum + p;
  return (1 / static_cast<double>(points.size())) * sum;
}

double size_of(const Placed& placed) {
  const std::vector<Vec3> world = world_vertices(placed);
  const Vec3 middle = centroid(world);
  double size = placed.shape.radius;
  for (const Vec3& v : world) size = std::max(size, length(v - middle) + placed.shape.radius);
  return size > 0 ? size : 1;
}

void centre_at(Placed& placed, const Vec3& place) {
  placed.pose.offset = placed.pose.offset + (place - centroid(world_vertices(placed)));
}

struct Pair {
  Placed a;
  Placed b;
};

Pose rotated_pose(Random& random) {
  const Mat3 linear = random_rotation(random);
  return {linear, random_point(random, 1)};
}

Pair random_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  const Blueprint a = random_blueprint(kind_a, random);
  const Blueprint b = random_blueprint(kind_b, random);
  const Pose pose_a = rotated_pose(random);
  return {{a, pose_a}, {b, rotated_pose(random)}};
}

double sum_of_sizes(const Pair& pair) { return size_of(pair.a) + size_of(pair.b); }

void move_apart(Pair& pair, double factor, Random& random) {
  const Vec3 away = factor * sum_of_sizes(pair) * random_direction(random);
  centre_at(pair.b, centroid(world_vertices(pair.a)) + away);
}

/// Moves B along the shortest way between the shapes until the gap is `gap`, up to rounding. They must be apart.
void leave_gap(Pair& pair, double gap) {
  const oracle::NearestPoints nearest =
      oracle::nearest_points(oracle::hull_set(world_vertices(pair.a)), oracle::hull_set(world_vertices(pair.b)));
  const oracle::RationalPoint exact_way = nearest.on_b - nearest.on_a;
  const Vec3 way{static_cast<double>(exact_way.x), static_cast<double>(exact_way.y), static_cast<double>(exact_way.z)};
  const double now = length(way);
  if (now == 0) return;
  const double change = gap + pair.a.shape.radius + pair.b.shape.radius - now;
  pair.b.pose.offset = pair.b.pose.offset + (change / now) * way;
}

Pair gapped_pair(const std::string& kind_a, const std::string& kind_b, double relative_gap, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  move_apart(pair, 1.1, random);
  const double smaller = std::min(size_of(pair.a), size_of(pair.b));
  leave_gap(pair, relative_gap * smaller);
  return pair;
}

double random_power(Random& random, double least, double most) { return std::pow(10.0, random.between(least, most)); }

Pair near_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  return gapped_pair(kind_a, kind_b, random_power(random, -2.5, -1.5), random);
}

Pair close_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  const double size = random_power(random, -16, -9);
  return gapped_pair(kind_a, kind_b, random.below(2) == 0 ? size : -size, random);
}

Pair deep_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  move_apart(pair, 0.3 * random.unit(), random);
  return pair;
}

Pair concentric_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  if (random.below(2) == 0) pair.b.pose.linear = pair.a.pose.linear;
  if (random.below(2) == 0) pair.b.shape = scaled(pair.b.shape, random_power(random, -3, 0));
  const Vec3 centre = random.below(2) == 0 ? Vec3{} : random_point(random, 1);
  centre_at(pair.a, centre);
  centre_at(pair.b, centre);
  return pair;
}

/// A shape of the corners of the box around the origin, as many as the kind has; so that shapes of several kinds share
/// much.
Blueprint block(const std::string& kind, const Vec3& half_extents, double radius) {
  std::vector<Vec3> corners = corners_of(half_extents, {});
  const std::string core = core_of(kind);
  Blueprint shape{kind, corners, is_rounded(kind) ? radius : 0};
  if (core == "box") shape.vertices = {half_extents, {}};
  if (core == "point") corners.resize(1);
  if (core == "segment") corners.resize(2);
  if (core == "triangle") corners.resize(3);
  if (core == "flat-hull") corners.resize(4);
  if (core == "needle-hull") corners = {corners[0], corners[1], corners[2], corners[4]};
  if (core != "box") shape.vertices = corners;
  return shape;
}

Pair identical_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  const Vec3 extents = random_extents(random);
  const double radius = random_size(random);
  Blueprint a = block(kind_a, extents, radius), b = block(kind_b, extents, radius);
  if (kind_a == kind_b && random.below(2) == 0) a = b = random_blueprint(kind_a, random);
  const Pose pose = rotated_pose(random);
  if (core_of(kind_a) != "box" && random.below(2) == 0) std::reverse(a.vertices.begin(), a.vertices.end());
  return {{a, pose}, {b, pose}};
}

/// Blocks turned alike, side by side, with a gap or an overlap of some power of ten, or up to rounding none.
Pair parallel_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  const Vec3 extents_a = random_extents(random), extents_b = random_extents(random);
  const double radius = random_size(random);
  const Mat3 linear = random.below(3) == 0 ? quarter_turns(random) : random_rotation(random);
  Pair pair{{block(kind_a, extents_a, radius), {linear, {}}}, {block(kind_b, extents_b, radius), {linear, {}}}};
  Vec3 along{0.5 * random.between(-1, 1), 0.5 * random.between(-1, 1), 0};
  along.z = extents_a.z + extents_b.z + pair.a.shape.radius + pair.b.shape.radius;
  const std::uint64_t way = random.below(3);
  const double gap = random_power(random, -16, -1);
  along.z += way == 0 ? 0 : way == 1 ? gap : -gap;
  pair.a.pose.offset = random_point(random, 1);
  pair.b.pose.offset = oracle::world_vertex(pair.a.pose, along);
  return pair;
}

// What touches exactly: a whole direction u such that the supports along u are exact, and so is the radius along u.

struct Direction {
  Vec3 u;
  double length = 1;  ///< where it is whole, and used only then
};

Direction whole_direction(const Pair& pair, Random& random) {
  static const std::array<Direction, 5> with_length{
      {{{1, 0, 0}, 1}, {{3, 4, 0}, 5}, {{1, 2, 2}, 3}, {{2, 3, 6}, 7}, {{1, 0, 0}, 1}}};
  const bool any = pair.a.shape.radius == 0 && pair.b.shape.radius == 0;
  const std::vector<Vec3> a = world_vertices(pair.a), b = world_vertices(pair.b);
  const auto edge = [&](const std::vector<Vec3>& of) {
    const std::size_t i = random.below(of.size());
    return of[random.below(of.size())] - of[i];
  };
  if (any && random.below(3) != 0) {
    // Across an edge of each, or two edges of one: the direction in which edges cross or a face looks.
    const Vec3 first = edge(a);
    const Vec3 second = random.below(2) == 0 ? edge(a) : edge(b);
    const Vec3 u = cross(first, second);
    if (!(u == Vec3{})) return {u, 1};
  }
  const Direction chosen = with_length[random.below(with_length.size())];
  return {oracle::world_vertex({quarter_turns(random), {}}, chosen.u), chosen.length};
}

/// A point of the face of the shape that lies farthest along u: a mean of its vertices with weights of quarters.
Vec3 point_of_support(const std::vector<Vec3>& vertices, const Vec3& u, Random& random) {
  double most = -INFINITY;
  for (const Vec3& v : vertices) most = std::max(most, dot(u, v));
  std::vector<Vec3> face;
  for (const Vec3& v : vertices)
    if (dot(u, v) == most) face.push_back(v);
  Vec3 sum{};
  for (int i = 0; i < 4; ++i) sum = sum + 0.25 * face[random.below(face.size())];
  return sum;
}

struct Touching {
  Pair pair;
  Direction direction;
};

/// The offset of B is chosen so that a point of A's support along u is one of B's against u.
void make_touch(Pair& pair, const Direction& direction, Random& random) {
  const Vec3 on_a = point_of_support(world_vertices(pair.a), direction.u, random);
  const Vec3 on_b = point_of_support(world_vertices(pair.b), -direction.u, random);
  const double radii = (pair.a.shape.radius + pair.b.shape.radius) / direction.length;
  pair.b.pose.offset = pair.b.pose.offset + (on_a - on_b) + radii * direction.u;
}

Touching touching_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  constexpr double unit = 105;  // a multiple of every length above
  const Blueprint a = grid_blueprint(kind_a, unit / 64, random);
  const Blueprint b = grid_blueprint(kind_b, unit / 64, random);
  const Mat3 linear_a = quarter_turns(random), linear_b = quarter_turns(random);
  Pair pair{{a, {linear_a, grid_point(random, 4)}}, {b, {linear_b, {}}}};
  const Direction direction = whole_direction(pair, random);
  make_touch(pair, direction, random);
  return {pair, direction};
}

double nudged(double x, Random& random) {
  const std::uint64_t way = random.below(3);
  return way == 0 ? x : std::nextafter(x, way == 1 ? INFINITY : -INFINITY);
}

Vec3 nudged(const Vec3& v, Random& random) {
  const double x = nudged(v.x, random);
  const double y = nudged(v.y, random);
  return {x, y, nudged(v.z, random)};
}

Pair ulp_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = touching_pair(kind_a, kind_b, random).pair;
  if (random.below(2) == 0) {
    for (Vec3& v : pair.b.shape.vertices)
      if (core_of(kind_b) != "box") v = nudged(v, random);
  } else {
    pair.b.pose.offset = nudged(pair.b.pose.offset, random);
  }
  if (pair.a.shape.radius > 0) pair.a.shape.radius = nudged(pair.a.shape.radius, random);
  return pair;
}

Pair hair_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Touching touching = touching_pair(kind_a, kind_b, random);
  const double hair = (random.below(2) == 0 ? 1e-12 : -1e-12) / length(touching.direction.u);
  touching.pair.b.pose.offset = touching.pair.b.pose.offset + hair * touching.direction.u;
  return touching.pair;
}

Pair plain_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  const std::uint64_t which = random.below(5);
  if (which == 0) return near_pair(kind_a, kind_b, random);
  if (which == 1) return close_pair(kind_a, kind_b, random);
  if (which == 2) return deep_pair(kind_a, kind_b, random);
  if (which == 3) return parallel_pair(kind_a, kind_b, random);
  return touching_pair(kind_a, kind_b, random).pair;
}

/// One shape 1e12 times as large as the other, which lies at a random point of its core, or near it.
Pair ratio_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  pair.a.shape = scaled(pair.a.shape, 1e-6);
  pair.b.shape = scaled(pair.b.shape, 1e6);
  const std::vector<Vec3> large = world_vertices(pair.b);
  const Vec3& first = large[random.below(large.size())];
  const Vec3& second = large[random.below(large.size())];
  const double s = random.below(2) == 0 ? 0 : random.unit();
  const double way = pair.b.shape.radius + (random.below(2) == 0 ? 0 : random.between(-2e-6, 2e-6));
  centre_at(pair.a, first + s * (second - first) + way * random_direction(random));
  if (random.below(2) == 0) std::swap(pair.a.pose.linear, pair.b.pose.linear);
  return pair;
}

Pair resized_pair(const std::string& kind_a, const std::string& kind_b, double factor, Random& random) {
  Pair pair = plain_pair(kind_a, kind_b, random);
  for (Placed* placed : {&pair.a, &pair.b}) {
    placed->shape = scaled(placed->shape, factor);
    placed->pose.offset = factor * placed->pose.offset;
  }
  return pair;
}

Pair distant_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = plain_pair(kind_a, kind_b, random);
  const double distance = random_power(random, 4, 8);
  const Vec3 away = distance * random_direction(random);
  const Vec3 whole{std::round(away.x), std::round(away.y), std::round(away.z)};
  for (Placed* placed : {&pair.a, &pair.b}) placed->pose.offset = placed->pose.offset + whole;
  return pair;
}

Mat3 sheared(const Mat3& linear, Random& random) {
  Mat3 stretch;
  for (int i = 0; i < 3; ++i) {
    const double factor = random_size(random);
    stretch[i][i] = random.below(2) == 0 ? factor : -factor;
    stretch[i][(i + 1) % 3] = random.between(-0.5, 0.5);
  }
  const Pose product = Pose{linear, {}} * Pose{stretch, {}};
  return is_singular(product.linear) ? linear : product.linear;
}

Pair sheared_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  for (Placed* placed : {&pair.a, &pair.b})
    if (!is_rounded(placed->shape.kind)) placed->pose.linear = sheared(placed->pose.linear, random);
  move_apart(pair, random.between(0.2, 1.2), random);
  return pair;
}

Pair far_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  Pair pair = random_pair(kind_a, kind_b, random);
  move_apart(pair, random_power(random, 0.3, 2), random);
  return pair;
}

Pair touching_without_direction(const std::string& kind_a, const std::string& kind_b, Random& random) {
  return touching_pair(kind_a, kind_b, random).pair;
}

Pair small_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  return resized_pair(kind_a, kind_b, 1e-6, random);
}

Pair large_pair(const std::string& kind_a, const std::string& kind_b, Random& random) {
  return resized_pair(kind_a, kind_b, 1e6, random);
}

struct Regime {
  std::string name;
  Pair (*pair)(const std::string& kind_a, const std::string& kind_b, Random& random);
};

const std::vector<Regime>& regimes() {
  static const std::vector<Regime> all{{"far", far_pair},
                                       {"near", near_pair},
                                       {"touching", touching_without_direction},
                                       {"ulp", ulp_pair},
                                       {"hair", hair_pair},
                                       {"close", close_pair},
                                       {"deep", deep_pair},
                                       {"concentric", concentric_pair},
                                       {"identical", identical_pair},
                                       {"parallel", parallel_pair},
                                       {"ratio", ratio_pair},
                                       {"small", small_pair},
                                       {"large", large_pair},
                                       {"distant", distant_pair},
                                       {"sheared", sheared_pair}};
  return all;
}

PlacedPolytope made(const Placed& placed) { return {made(placed.shape), placed.pose}; }

std::vector<Vec3> local_vertices(const Rounded::Core& core) {
  struct Vertices {
    std::vector<Vec3> operator()(const Point& shape) const { return {shape.position()}; }
    std::vector<Vec3> operator()(const Segment& shape) const { return {shape.start(), shape.end()}; }
    std::vector<Vec3> operator()(const Triangle& shape) const { return {shape[0], shape[1], shape[2]}; }
    std::vector<Vec3> operator()(const Box& shape) const { return corners_of(shape.half_extents(), shape.centre()); }
    std::vector<Vec3> operator()(const ConvexHull& shape) const {
      std::vector<Vec3> vertices;
      for (Index i = 0; i < shape.vertex_count(); ++i) vertices.push_back(shape.vertex(i));
      return vertices;
    }
  };
  return std::visit(Vertices{}, core);
}

struct CoreAndRadius {
  std::vector<Vec3> vertices;
  double radius = 0;
};

CoreAndRadius parts_of(const ConvexShape& shape) {
  struct Parts {
    CoreAndRadius operator()(const Sphere& sphere) const { return {{sphere.centre()}, sphere.radius()}; }
    CoreAndRadius operator()(const Capsule& capsule) const {
      return {{capsule.start(), capsule.end()}, capsule.radius()};
    }
    CoreAndRadius operator()(const Rounded& rounded) const {
      return {local_vertices(rounded.core()), rounded.radius()};
    }
    CoreAndRadius operator()(const Point& plain) const { return {local_vertices(plain), 0}; }
    CoreAndRadius operator()(const Segment& plain) const { return {local_vertices(plain), 0}; }
    CoreAndRadius operator()(const Triangle& plain) const { return {local_vertices(plain), 0}; }
    CoreAndRadius operator()(const Box& plain) const { return {local_vertices(plain), 0}; }
    CoreAndRadius operator()(const ConvexHull& plain) const { return {local_vertices(plain), 0}; }
  };
  return std::visit(Parts{}, shape);
}

std::string to_text(const Vec3& v) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "{%.17g, %.17g, %.17g}", v.x, v.y, v.z);
  return text.data();
}

std::string to_text(const PlacedPolytope& placed) {
  const CoreAndRadius parts = parts_of(placed.shape);
  std::array<char, 40> radius{};
  std::snprintf(radius.data(), radius.size(), "%.17g", parts.radius);
  std::string text = is_solid(placed) ? "solid of radius " : "surface of radius ";
  text += radius.data();
  for (const Vec3& v : parts.vertices) text += " " + to_text(oracle::world_vertex(placed.pose, v));
  return text;
}

}  // namespace

const std::vector<std::string>& convex_kinds() {
  static const std::vector<std::string> kinds{"point",
                                              "segment",
                                              "triangle",
                                              "sphere",
                                              "box",
                                              "capsule",
                                              "hull",
                                              "flat-hull",
                                              "needle-hull",
                                              "rounded-point",
                                              "rounded-segment",
                                              "rounded-triangle",
                                              "rounded-box",
                                              "rounded-hull"};
  return kinds;
}

const std::vector<std::string>& convex_regimes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Regime& regime : regimes()) list.push_back(regime.name);
    return list;
  }();
  return names;
}

ConvexCase convex_case(const std::string& kind_a, const std::string& kind_b, const std::string& regime,
                       Random& random) {
  const auto found = std::ranges::find(regimes(), regime, &Regime::name);
  const Pair pair = found->pair(kind_a, kind_b, random);
  return {made(pair.a), made(pair.b)};
}

ConvexCase numbered_case(const std::string& kind_a, std::uint64_t number, Random& random) {
  const std::string& kind_b = convex_kinds()[number % convex_kinds().size()];
  const std::string& regime = convex_regimes()[number % convex_regimes().size()];
  return convex_case(kind_a, kind_b, regime, random);
}

// The plane of the half-space goes where a pair of the regime has a point of B that is nearest to A, and looks from
// there to A; for whole numbers it goes through a support.
HalfSpaceCase half_space_case(const std::string& kind, const std::string& regime, Random& random) {
  const bool whole = regime == "touching" || regime == "ulp" || regime == "hair";
  const auto found = std::ranges::find(regimes(), regime, &Regime::name);
  Touching touching;
  if (whole)
    touching = touching_pair(kind, "point", random);
  else
    touching = {found->pair(kind, "point", random), {random_direction(random), 1}};
  const Placed& b = touching.pair.b;
  Vec3 point = oracle::world_vertex(b.pose, b.shape.vertices[0]);
  if (regime == "ulp") point = nudged(point, random);
  const double hair = (random.below(2) == 0 ? 1e-12 : -1e-12) / length(touching.direction.u);
  if (regime == "hair") point = point + hair * touching.direction.u;
  const double sign = whole || random.below(2) == 0 ? -1 : 1;
  if (whole || regime == "distant") return {made(touching.pair.a), {HalfSpace(point, sign * touching.direction.u), {}}};
  const Pose pose{random_rotation(random), point};
  const double normal_length = random_size(random);
  return {made(touching.pair.a), {HalfSpace({}, normal_length * random_direction(random)), pose}};
}

ConvexShape random_convex(const std::string& kind, Random& random) { return made(random_blueprint(kind, random)); }

PosedPolytope posed(const PlacedPolytope& placed) {
  return std::visit([&](const auto& shape) { return PosedPolytope(shape, placed.pose); }, placed.shape);
}

oracle::ConvexSet set_of(const PlacedPolytope& placed) {
  const CoreAndRadius parts = parts_of(placed.shape);
  oracle::ConvexSet set;
  for (const Vec3& v : parts.vertices) set.vertices.push_back(oracle::exact(oracle::world_vertex(placed.pose, v)));
  set.radius = oracle::exact(parts.radius);
  return set;
}

oracle::HalfSpace set_of(const PlacedHalfSpace& placed) {
  const Pose turned{placed.pose.linear, {}};
  return oracle::half_space_set(oracle::world_vertex(placed.pose, placed.shape.point()),
                                oracle::world_vertex(turned, placed.shape.normal()));
}

bool is_solid(const PlacedPolytope& placed) {
  const ConvexHull* hull = std::get_if<ConvexHull>(&placed.shape);
  if (hull != nullptr) return hull->dimension() == 3;
  return std::holds_alternative<Box>(placed.shape) || parts_of(placed.shape).radius > 0;
}

std::string to_text(const ConvexCase& pair) { return "a: " + to_text(pair.a) + "; b: " + to_text(pair.b); }

std::string to_text(const HalfSpaceCase& pair) {
  const Pose turned{pair.b.pose.linear, {}};
  return "a: " + to_text(pair.a) + "; b: half-space at " +
         to_text(oracle::world_vertex(pair.b.pose, pair.b.shape.point())) + ", normal " +
         to_text(oracle::world_vertex(turned, pair.b.shape.normal()));
}

}  // namespace toccata::test
