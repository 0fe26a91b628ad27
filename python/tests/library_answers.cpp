// What the C++ library answers to the questions of test_bits.py, which compiles this: `library_answers POSES` reads
// lines of 12 numbers (R row by row, then t), and prints a line for each row of an answer: the question, its number,
// and the numbers of the answer as hexadecimal doubles; a tab after the question.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <toccata/generate/meshes.hpp>
#include <toccata/motion/rigid_motion.hpp>
#include <toccata/query/casts.hpp>
#include <toccata/query/contacts.hpp>
#include <toccata/query/nearest.hpp>
#include <toccata/query/overlap.hpp>
#include <toccata/query/scene_index.hpp>
#include <toccata/query/self_contacts.hpp>
#include <toccata/query/signed_distance.hpp>
#include <toccata/world/world.hpp>

using namespace toccata;

namespace {

std::vector<Pose> read_poses(const char* path) {
  std::ifstream file(path);
  std::vector<Pose> poses;
  double numbers[12];
  for (std::size_t i = 0; file >> numbers[i % 12]; ++i) {
    if (i % 12 != 11) continue;
    Pose pose;
    for (int k = 0; k < 3; ++k) {
      pose.linear[k] = {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
      pose.offset[k] = numbers[9 + k];
    }
    poses.push_back(pose);
  }
  return poses;
}

void tell(double number) { std::printf(" %a", number); }
void tell(const Vec3& vector) {
  tell(vector.x);
  tell(vector.y);
  tell(vector.z);
}
template <class Whole>
requires(std::is_integral_v<Whole> || std::is_enum_v<Whole>) void tell(Whole number) {
  tell(static_cast<double>(number));
}

/// A row of an answer.
template <class... Numbers>
void row(const char* question, std::size_t query, const Numbers&... numbers) {
  std::printf("%s\t%zu", question, query);
  (tell(numbers), ...);
  std::printf("\n");
}

void tell_contacts(const char* question, std::size_t query, std::span<const Contact> contacts) {
  for (const Contact& c : contacts)
    row(question, query, c.element_a, c.element_b, c.face_a, c.face_b, c.intersection.kind, c.intersection.coplanar,
        c.intersection.crossing, c.intersection.count);
}

void tell_hit(const char* question, std::size_t query, const std::optional<ShapeHit>& h) {
  if (h)
    row(question, query, h->lower, h->upper, h->point, h->normal, h->status, h->element_a, h->element_b, h->face_a,
        h->face_b);
}

void ask_about_pairs(const Model& a, const Model& b, const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const PairQuery query{.pose_b = poses[i]};
    const std::vector<Contact> found = contacts(a, b, query);
    tell_contacts("contacts", i, found);
    for (const Contact& contact : found) {
      const auto points = intersection_points(contact.intersection, world_triangle(a, query.pose_a, contact.element_a),
                                              world_triangle(b, query.pose_b, contact.element_b));
      row("points", i, points.points[0], points.points[1], points.points[2], points.points[3], points.points[4],
          points.points[5]);
    }
    for (const ContactRegion& r : contact_regions(a, b, query))
      row("regions", i, r.triangle_pairs, r.face_pairs, r.box.lower, r.box.upper, r.point_count, r.closed,
          r.curve_count, r.area, r.normal, r.depth ? r.depth->lower : 0.0, r.depth ? r.depth->upper : 0.0, r.deepest);
    const Pose& next = poses[(i + 1) % poses.size()];
    tell_hit("casts", i, cast_shape(a, poses[i].offset, b, {.pose_b = next}));
    tell_hit("sweeps", i, sweep(a, RigidMotion(poses[i]), b, RigidMotion::between(next, poses[i])));
  }
}

void ask_about_points(const Model& closed, const Model& open, const std::vector<Pose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3& point = poses[i].offset;
    const Pose& pose = poses[(i + 1) % poses.size()];
    const SurfacePoint near = *nearest_point(point, closed, {.pose = pose});
    row("nearest", i, near.lower, near.upper, near.point, near.element, near.face, near.status);
    const PointLocation at = locate(point, closed, pose);
    row("located", i, at.side, at.winding_number);
    const WindingNumber wound = generalized_winding_number(point, open, pose);
    row("winding", i, wound.value, wound.lower, wound.upper, wound.status);
  }
}

/// The objects of a scene: the shapes in turn, at the poses.
std::vector<SceneInstance> objects_of(std::span<const Model> shapes, const std::vector<Pose>& poses) {
  std::vector<SceneInstance> objects;
  for (std::size_t i = 0; i < poses.size(); ++i) objects.push_back({shapes[i % shapes.size()], poses[i]});
  return objects;
}

void ask_about_scene(std::span<const Model> shapes, const std::vector<Pose>& poses) {
  const SceneIndex index(objects_of(shapes, poses));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 &from = poses[i].offset, way = poses[(i + 1) % poses.size()].offset - from;
    if (const auto hit = index.cast_ray({from, way}))
      row("scene rays", i, hit->object, hit->lower, hit->upper, hit->point, hit->normal, hit->element, hit->face);
    const SceneInstance asked{shapes[i % shapes.size()], Pose::translation(from)};
    for (const Index object : index.overlapping(asked)) row("scene overlaps", i, object);
    const Pose aside = Pose::translation(from + Vec3{4, 0, 0});
    if (const auto found = index.nearest({shapes[i % shapes.size()], aside}))
      row("scene nearest", i, found->object, found->lower, found->upper, found->on_a, found->on_b, found->element_a,
          found->element_b);
  }
}

void tell_pairs(const char* question, std::size_t step, const std::vector<PairReport>& pairs) {
  for (const PairReport& pair : pairs) {
    row(question, step, pair.a.index, pair.b.index, pair.in_contact);
    const PairDetails& details = *pair.details;
    row("world distances", step, details.distance->lower, details.distance->upper, details.distance->on_a,
        details.distance->on_b);
    row("world relations", step, details.relation->kind, details.relation->containment);
    tell_contacts("world contacts", step, details.contacts);
  }
}

/// Every body goes to the pose of the next at every step.
void ask_about_world(std::span<const Model> shapes, const std::vector<Pose>& poses) {
  WorldOptions options;
  options.relation = options.distance = options.contacts = true;
  World world(options);
  std::vector<Body> bodies;
  for (const SceneInstance& object : objects_of(shapes, poses)) {
    Body body{object.model, object.pose};
    body.margin = 0.25;
    bodies.push_back(std::move(body));
  }
  const std::vector<BodyId> ids = world.add(bodies);
  for (std::size_t step = 0; step < 6; ++step) {
    const WorldStep& found = world.step();
    row("world", step, found.candidates);
    tell_pairs("world begin", step, found.begin);
    tell_pairs("world persist", step, found.persist);
    tell_pairs("world end", step, found.end);
    std::vector<Pose> next;
    for (std::size_t i = 0; i < poses.size(); ++i) next.push_back(poses[(i + step / 2 + 1) % poses.size()]);
    world.move(ids, next);
  }
}

/// Without its first triangle.
TriangleMesh opened(const TriangleMesh& mesh) {
  const auto triangles = mesh.triangles();
  return {{mesh.vertices().begin(), mesh.vertices().end()}, {triangles.begin() + 1, triangles.end()}};
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  const std::vector<Pose> poses = read_poses(words[1]);
  const Model knot(generate_mesh("torus-knot")), gear(generate_mesh("gear")),
      ball(generate_mesh("icosphere", {{"subdivisions", 2}})), open(opened(generate_mesh("icosphere")));
  const Model bumpy(generate_mesh("noise-sphere"));
  ask_about_pairs(knot, bumpy, poses);
  ask_about_points(knot, open, poses);
  const Model shapes[] = {ball, gear, Model(Box({0.5, 0.6, 0.7})), Model(Sphere(0.7)),
                          Model(Capsule({0, 0, 0}, {0, 0, 1}, 0.3))};
  ask_about_scene(shapes, poses);
  ask_about_world(shapes, poses);
  // Triangles of two knots in one another.
  std::vector<Vec3> vertices(knot.mesh().vertices().begin(), knot.mesh().vertices().end());
  std::vector<std::array<Index, 3>> triangles(knot.mesh().triangles().begin(), knot.mesh().triangles().end());
  const auto once = static_cast<Index>(vertices.size());
  for (const Vec3& vertex : knot.mesh().vertices()) vertices.push_back({vertex.x + 0.25, vertex.y, vertex.z});
  for (const auto& t : knot.mesh().triangles()) triangles.push_back({t[0] + once, t[1] + once, t[2] + once});
  const std::vector<Contact> found = self_contacts(Model(TriangleMesh(std::move(vertices), std::move(triangles))));
  tell_contacts("self contacts", 0, found);
}
