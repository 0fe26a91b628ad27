// The questions of the lectures about whole models, each shown (docs/methods/questions.md lists them).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/query/contacts.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/signed_distance.hpp"

namespace toccata {
namespace {

Aabb box_of(const TriangleMesh& mesh, const Vec3& moved) {
  Aabb box;
  for (const Vec3& vertex : mesh.vertices()) box = merge(box, vertex + moved);
  return box;
}

bool is_among(Index triangle, const std::vector<FoundElement>& found) {
  return std::any_of(found.begin(), found.end(), [&](const FoundElement& f) { return f.element == triangle; });
}

TEST(LectureQuestion, OnlyTrianglesInTheRegionThatBothBoxesShareCanMeet) {
  const TriangleMesh mesh = icosphere_mesh(1, 4);
  const Model ball(mesh);
  const Vec3 moved{1.5, 0.75, 0.25};
  const Aabb a = box_of(mesh, {}), b = box_of(mesh, moved);
  const Aabb common{{std::max(a.lower.x, b.lower.x), std::max(a.lower.y, b.lower.y), std::max(a.lower.z, b.lower.z)},
                    {std::min(a.upper.x, b.upper.x), std::min(a.upper.y, b.upper.y), std::min(a.upper.z, b.upper.z)}};
  const Pose pose_b = Pose::translation(moved);
  const auto of_a = faces_in_region(common, ball), of_b = faces_in_region(common, ball, pose_b);
  const std::vector<Contact> all = contacts(ball, ball, {.pose_b = pose_b});
  EXPECT_GT(all.size(), 50U);
  for (const Contact& contact : all) {
    EXPECT_TRUE(is_among(contact.element_a, of_a));
    EXPECT_TRUE(is_among(contact.element_b, of_b));
  }
  // A list for a list: a sixteenth of all pairs, or less, is left.
  EXPECT_LT(16 * of_a.size() * of_b.size(), static_cast<std::size_t>(mesh.triangle_count()) * mesh.triangle_count());
}

TEST(LectureQuestion, ABallOfPolygonsIsNotTheBall) {
  // Over the middle of a triangle the polyhedron is lower than the sphere through its corners; what comes down there
  // meets the ball first. The finer the triangles the less, and never not at all.
  double lower_by = 1;
  for (const int subdivisions : {1, 2, 3}) {
    const TriangleMesh mesh = icosphere_mesh(1, subdivisions);
    const auto& corner = mesh.triangles()[0];
    const Vec3 sum = (mesh.vertices()[corner[0]] + mesh.vertices()[corner[1]]) + mesh.vertices()[corner[2]];
    const Vec3 up = (1 / std::sqrt(dot(sum, sum))) * sum, middle = (1.0 / 3) * sum;
    const double height = std::sqrt(dot(middle, middle)), needle = 0.01;
    const Pose above = Pose::translation((0.5 * (1 + height) + needle) * up);
    EXPECT_TRUE(overlap(Sphere(1), Sphere(needle), {.pose_b = above}));
    EXPECT_FALSE(overlap(Model(mesh), Model(Sphere(needle)), {.pose_b = above}));
    EXPECT_LT(1 - height, lower_by / 2);
    lower_by = 1 - height;
  }
}

/// Behind the planes of all faces.
bool is_behind_all_faces(const TriangleMesh& mesh, const Vec3& point) {
  return std::all_of(mesh.triangles().begin(), mesh.triangles().end(), [&](const std::array<Index, 3>& corner) {
    const auto at = [&](std::size_t i) { return mesh.vertices()[corner[i]]; };
    return dot(cross(at(1) - at(0), at(2) - at(0)), point - at(0)) <= 0;
  });
}

TEST(LectureQuestion, OnlyAConvexSolidIsWhatTheHalfSpacesOfItsFacesHaveInCommon) {
  const TriangleMesh block = extruded_mesh(std::vector<Vec2>{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 1);
  const TriangleMesh bracket = extruded_mesh(std::vector<Vec2>{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 1);
  const Model convex(block), concave(bracket);
  Random random(114);
  int inside_but_before_a_face = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 point{random.between(-1, 4), random.between(-1, 4), random.between(-0.5, 1.5)};
    EXPECT_EQ(is_behind_all_faces(block, point), locate(point, convex).side != Side::outside);
    const bool inside = locate(point, concave).side == Side::inside, behind = is_behind_all_faces(bracket, point);
    EXPECT_TRUE(inside || !behind);
    if (inside && !behind) ++inside_but_before_a_face;
  }
  EXPECT_GT(inside_but_before_a_face, 20);  // both arms of the bracket
}

}  // namespace
}  // namespace toccata
