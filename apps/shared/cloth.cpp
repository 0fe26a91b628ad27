#include "cloth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

constexpr Vec3 gravity{0, 0, -9.81};
constexpr double ball_radius = 0.25, floor_height = -0.4, start_height = 0.8;
constexpr double kept_velocity = 0.995;  ///< of a step: air
constexpr double friction = 0.8;         ///< what of a step along each other contacts take away
constexpr int rounds = 2, iterations = 5;

/// It hangs above the ball, not quite flat and not quite over its middle, so that it falls in folds.
TriangleMesh cloth_pattern(int cells) {
  const TriangleMesh sheet =
      height_field_mesh({.cells_x = cells, .cells_y = cells, .cell = 1.0 / cells, .height = 0.02});
  std::vector<Vec3> vertices;
  for (const Vec3& v : sheet.vertices()) vertices.push_back({v.x + 0.1, v.z + 0.05, v.y + start_height});
  return sheet.with_vertices(std::move(vertices));
}

/// A ball and the floor below it.
TriangleMesh ball_and_floor() {
  const TriangleMesh ball = icosphere_mesh(ball_radius, 3);
  std::vector<Vec3> vertices(ball.vertices().begin(), ball.vertices().end());
  std::vector<std::array<Index, 3>> triangles(ball.triangles().begin(), ball.triangles().end());
  const auto first = static_cast<Index>(vertices.size());
  for (const double x : {-4.0, 4.0})
    for (const double y : {-4.0, 4.0}) vertices.push_back({x, y, floor_height});
  triangles.push_back({first, first + 2, first + 3});
  triangles.push_back({first, first + 3, first + 1});
  return {std::move(vertices), std::move(triangles)};
}

std::vector<Vec3> copy_of(std::span<const Vec3> positions) { return {positions.begin(), positions.end()}; }

/// About the fractions of two segments at which they are nearest (C. Ericson, "Real-time collision detection", 5.1.9).
std::pair<double, double> nearest_fractions(const std::array<Vec3, 2>& p, const std::array<Vec3, 2>& q) {
  const Vec3 u = p[1] - p[0], v = q[1] - q[0], w = p[0] - q[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), area = uu * vv - uv * uv;
  const double s = area > 1e-12 * uu * vv ? std::clamp((uv * dot(v, w) - vv * dot(u, w)) / area, 0.0, 1.0) : 0.5;
  const double t = std::clamp((dot(v, w) + s * uv) / vv, 0.0, 1.0);
  return {std::clamp((t * uv - dot(u, w)) / uu, 0.0, 1.0), t};
}

/// About the weights of the corners at the point of a triangle that is nearest to p.
std::array<double, 3> nearest_weights(const Vec3& p, const std::array<Vec3, 3>& q) {
  const Vec3 normal = cross(q[1] - q[0], q[2] - q[0]);
  std::array<double, 3> weight;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = q[(i + 1) % 3], &b = q[(i + 2) % 3];
    weight[i] = std::max(dot(cross(a - p, b - p), normal), 0.0);
    sum += weight[i];
  }
  for (double& w : weight) w = sum > 0 ? w / sum : 1.0 / 3;
  return weight;
}

/// A point of a feature, as a mean of its vertices.
struct Weight {
  Index vertex;
  double weight;
};
using Weights = std::vector<Weight>;

Vec3 point_at(const Weights& weights, const DeformingMesh& mesh) {
  Vec3 point;
  for (const auto& [vertex, weight] : weights) point += weight * mesh.start()[vertex];
  return point;
}

struct NearestPoints {
  Weights on_a;
  Weights on_b;
};

NearestPoints nearest_points(const DeformingMesh& of_vertex, Index vertex, const DeformingMesh& of_face, Index face) {
  const auto& [a, b, c] = of_face.triangles()[face];
  const auto start = of_face.start();
  const auto weights = nearest_weights(of_vertex.start()[vertex], {start[a], start[b], start[c]});
  return {{{vertex, 1}}, {{a, weights[0]}, {b, weights[1]}, {c, weights[2]}}};
}

/// At the start, about.
NearestPoints nearest_points(const MeshImpact& impact, const DeformingMesh& a, const DeformingMesh& b) {
  if (impact.a.kind == FeatureKind::vertex) return nearest_points(a, impact.a.number, b, impact.b.number);
  if (impact.b.kind == FeatureKind::vertex) {
    const NearestPoints turned = nearest_points(b, impact.b.number, a, impact.a.number);
    return {turned.on_b, turned.on_a};
  }
  const IndexPair p = a.edges()[impact.a.number], q = b.edges()[impact.b.number];
  const auto [s, t] =
      nearest_fractions({a.start()[p.first], a.start()[p.second]}, {b.start()[q.first], b.start()[q.second]});
  return {{{p.first, 1 - s}, {p.second, s}}, {{q.first, 1 - t}, {q.second, t}}};
}

}  // namespace

/// Two points that are near each other: where the first is along the direction, from the second.
struct Cloth::Contact {
  Vec3 direction;
  double fixed = 0;  ///< what obstacles add to it
  Weights weights;   ///< of the vertices of the cloth; those of the second point are negative
};

Cloth::Cloth(const ClothOptions& options)
    : options_(options),
      obstacles_(ball_and_floor()),
      at_rest_(obstacles_),
      pattern_(cloth_pattern(options.cells)),
      moving_(pattern_),
      velocities_(pattern_.vertices().size()) {
  const auto add = [&](Index a, Index b) {
    springs_.push_back({a, b, length(pattern_.vertices()[a] - pattern_.vertices()[b])});
  };
  for (const auto& [a, b] : moving_.edges()) add(a, b);
}

TriangleMesh Cloth::mesh() const { return pattern_.with_vertices(copy_of(moving_.start())); }

/// Where the vertices would go if there were nothing but their weight.
std::vector<Vec3> Cloth::wanted() const {
  std::vector<Vec3> positions = copy_of(moving_.start());
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] += options_.step * (velocities_[v] + options_.step * gravity);
  return positions;
}

/// Springs at their lengths (M. Müller and others, "Position based dynamics", 2007).
void Cloth::pull_together(std::vector<Vec3>& positions) const {
  for (const auto& [a, b, wanted_length] : springs_) {
    const Vec3 way = positions[b] - positions[a];
    const double now = std::sqrt(dot(way, way));
    if (!(now > 0)) continue;
    const Vec3 half = (0.5 * (now - wanted_length) / now) * way;
    positions[a] += half;
    positions[b] -= half;
  }
}

/// `a` is of the cloth, `other` what b is of.
Cloth::Contact Cloth::contact_of(const MeshImpact& impact, const DeformingMesh& other) const {
  const NearestPoints nearest = nearest_points(impact, moving_, other);
  Contact contact{normalized(point_at(nearest.on_a, moving_) - point_at(nearest.on_b, other)), 0, nearest.on_a};
  for (const auto& [vertex, weight] : nearest.on_b) {
    if (&other == &moving_)
      contact.weights.push_back({vertex, -weight});
    else
      contact.fixed -= weight * dot(contact.direction, other.start()[vertex]);
  }
  return contact;
}

/// All that comes within the thickness on the way that is tried. No edge pierces a face at the start, which is the end
/// of the step before.
std::vector<Cloth::Contact> Cloth::contacts_on_the_way() const {
  const ImpactOptions near{.separation = options_.thickness, .starts_free = true, .threads = options_.threads};
  std::vector<Contact> contacts;
  for (const MeshImpact& impact : impacts(moving_, near)) contacts.push_back(contact_of(impact, moving_));
  for (const MeshImpact& impact : impacts(moving_, at_rest_, near)) contacts.push_back(contact_of(impact, at_rest_));
  return contacts;
}

/// Moves the points of a contact apart along its direction to the thickness, each vertex by its weight, and back along
/// each other by a part of how far they have slid.
void Cloth::keep_apart(std::span<const Contact> contacts, std::vector<Vec3>& positions) const {
  for (const Contact& contact : contacts) {
    double gap = contact.fixed, squares = 0;
    Vec3 slid;
    for (const auto& [vertex, weight] : contact.weights) {
      gap += weight * dot(contact.direction, positions[vertex]);
      slid += weight * (positions[vertex] - moving_.start()[vertex]);
      squares += weight * weight;
    }
    if (gap >= options_.thickness) continue;
    slid -= dot(slid, contact.direction) * contact.direction;
    const Vec3 push = ((options_.thickness - gap) / squares) * contact.direction - (friction / squares) * slid;
    for (const auto& [vertex, weight] : contact.weights) positions[vertex] += weight * push;
  }
}

/// How much of its way each vertex may go, whatever the others do.
std::vector<double> Cloth::free_parts() const {
  const ImpactOptions options{.separation = options_.least_gap, .starts_free = true, .threads = options_.threads};
  std::vector<double> parts = free_steps(moving_, options);
  const std::vector<double> beside = free_steps(moving_, at_rest_, options).of_a;
  for (std::size_t v = 0; v < parts.size(); ++v) parts[v] = std::min(parts[v], beside[v]);
  return parts;
}

/// Goes these parts of the ways, if what is rounded of it is free too, and less until it is.
std::size_t Cloth::accept(const std::vector<double>& parts) {
  const std::vector<Vec3> from = copy_of(moving_.start()), to = copy_of(moving_.end());
  std::size_t halved = 0;
  for (double part = 1;; part = halved < 20 ? 0.5 * part : 0) {
    std::vector<Vec3> tried = from;
    for (std::size_t v = 0; v < tried.size(); ++v) tried[v] += (part * parts[v]) * (to[v] - from[v]);
    static_cast<void>(moving_.move_to(tried, options_.threads));
    const ImpactOptions exact{.threads = options_.threads};
    if (part == 0 || !(meets(moving_, exact) || meets(moving_, at_rest_, exact))) return halved;
    ++halved;
  }
}

ClothStep Cloth::step() {
  ClothStep done;
  std::vector<Vec3> positions = wanted();
  for (int round = 0; round < rounds; ++round) {
    static_cast<void>(moving_.move_to(positions, options_.threads));
    const std::vector<Contact> contacts = contacts_on_the_way();
    done.near = std::max(done.near, contacts.size());
    for (int i = 0; i < iterations; ++i) {
      pull_together(positions);
      keep_apart(contacts, positions);
    }
  }
  static_cast<void>(moving_.move_to(positions, options_.threads));
  const std::vector<double> parts = free_parts();
  done.stopped = static_cast<std::size_t>(std::count_if(parts.begin(), parts.end(), [](double p) { return p < 1; }));
  done.shortened = accept(parts);
  for (std::size_t v = 0; v < velocities_.size(); ++v)
    velocities_[v] = (kept_velocity / options_.step) * (moving_.end()[v] - moving_.start()[v]);
  static_cast<void>(moving_.advance(copy_of(moving_.end()), options_.threads));
  return done;
}

}  // namespace toccata
