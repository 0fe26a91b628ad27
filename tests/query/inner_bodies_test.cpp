// What the search for a depth keeps and leaves out: bodies of whole meshes are made once, and triangles that faces of a
// body tell from it are not looked at closely.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "query/penetration/outside_faces.hpp"
#include "query/penetration/whole_bodies.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/narrow/convex_convex.hpp"

namespace toccata {
namespace {

Vec3 any_point(Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

ConvexHull any_body(Random& random, const Vec3& at) {
  std::vector<Vec3> points;
  for (int i = 0; i < 24; ++i) points.push_back(at + any_point(random, 1));
  return ConvexHull{points};
}

/// A point of a face, rounded: up to its last places on either side.
Vec3 point_on(const ConvexHull& body, Random& random) {
  const HullTopology topology = body.topology();
  const auto face = static_cast<Index>(random.between(0, topology.face_count() - 0.01));
  const Index first = topology.face_start[face];
  const double s = random.between(0, 0.5), t = random.between(0, 0.5);
  const Vec3 a = body.vertex(topology.origin[first]), b = body.vertex(topology.origin[first + 1]),
             c = body.vertex(topology.origin[first + 2]);
  return a + s * (b - a) + t * (c - a);
}

Vec3 middle_of(const ConvexHull& body) {
  Vec3 sum;
  for (Index i = 0; i < body.vertex_count(); ++i) sum = sum + body.vertex(i);
  return (1.0 / body.vertex_count()) * sum;
}

/// One that reaches outwards from a point of the surface.
Triangle triangle_at(const ConvexHull& body, Random& random) {
  const Vec3 at = point_on(body, random), out = at - middle_of(body);
  return {{at, at + out + any_point(random, 0.05), at + out + any_point(random, 0.05)}};
}

TEST(OutsideFaces, WhatTheyTellApartDoesNotMeetTheBody) {
  Random random(7);
  int told = 0, apart = 0;
  for (int i = 0; i < 300; ++i) {
    const double far = i % 3 == 0 ? 0 : std::ldexp(1.0, i % 30);
    const ConvexHull body = any_body(random, {far, -far, 0.5 * far});
    OutsideFaces faces(body);
    for (int k = 0; k < 20; ++k) {
      Triangle triangle = triangle_at(body, random);
      if (k % 2 == 0)
        for (Vec3& corner : triangle.vertex) corner = corner + any_point(random, 0.5);
      const bool is_told = faces.tell_apart(triangle), meets = overlap(PosedPolytope(triangle), PosedPolytope(body));
      EXPECT_FALSE(is_told && meets) << "body " << i << ", triangle " << k;
      told += is_told ? 1 : 0;
      apart += meets ? 0 : 1;
    }
  }
  EXPECT_GT(told, apart / 3) << "of " << apart << " that are apart";
}

TEST(OutsideFaces, ATriangleJustBeforeAFaceIsTold) {
  const ConvexHull cube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  OutsideFaces faces(cube);
  EXPECT_TRUE(faces.tell_apart({{{{0, 0, 1 + 1e-12}, {1, 0, 1 + 1e-12}, {0, 1, 1 + 1e-12}}}}));
  EXPECT_FALSE(faces.tell_apart({{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}})) << "it touches";
  EXPECT_FALSE(faces.tell_apart({{{{-2, 0.5, 0.5}, {0.5, -2, 0.5}, {0.5, 0.5, 2}}}})) << "it is before none";
}

TEST(ProofConstants, ATriangleThatOnlyRoundingTakesFromAFaceIsNotToldApart) {
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    const ConvexHull body = any_body(random, any_point(random, 3));
    OutsideFaces faces(body);
    for (int k = 0; k < 20; ++k) {
      const Triangle triangle = triangle_at(body, random);
      const bool meets = overlap(PosedPolytope(triangle), PosedPolytope(body));
      EXPECT_FALSE(meets && faces.tell_apart(triangle)) << "body " << i << ", triangle " << k;
    }
  }
}

TEST(WholeBodies, AreMadeOnceForAMeshAtAPose) {
  const Model ball(icosphere_mesh(1, 2)), other(icosphere_mesh(1, 2));
  const Pose turned = Pose::translation(0, 0, 1);
  WholeBodies bodies;
  const auto first = bodies.of(PosedMesh(ball, {}));
  EXPECT_TRUE(first->is_convex);
  EXPECT_EQ(bodies.of(PosedMesh(ball, {})), first);
  const auto moved = bodies.of(PosedMesh(ball, turned));
  EXPECT_NE(moved, first);
  EXPECT_EQ(moved->hull.vertex(0).z, first->hull.vertex(0).z + 1);
  EXPECT_NE(bodies.of(PosedMesh(other, {})), first) << "another mesh of the same numbers";
  EXPECT_EQ(bodies.of(PosedMesh(ball, {})), first);
  EXPECT_EQ(bodies.of(PosedMesh(ball, turned)), moved);
}

TEST(WholeBodies, ThoseThatWereAskedLongAgoAreGivenUp) {
  const Model ball(icosphere_mesh(1, 1));
  WholeBodies bodies;
  const std::weak_ptr<const WholeBody> first = bodies.of(PosedMesh(ball, {}));
  for (int i = 1; i <= 300; ++i) static_cast<void>(bodies.of(PosedMesh(ball, Pose::translation(i, 0, 0))));
  EXPECT_TRUE(first.expired());
}

TEST(WholeBodies, DoNotHoldTheirMeshes) {
  WholeBodies bodies;
  std::weak_ptr<const TriangleMesh> mesh;
  std::weak_ptr<const WholeBody> body;
  {
    const Model ball(icosphere_mesh(1, 1));
    mesh = mesh_of(ball.shape());
    body = bodies.of(PosedMesh(ball, {}));
    EXPECT_FALSE(mesh.expired() || body.expired());
  }
  EXPECT_TRUE(mesh.expired());
  static_cast<void>(bodies.of(PosedMesh(Model(icosphere_mesh(1, 1)), {})));
  EXPECT_TRUE(body.expired()) << "nobody can ask for it again";
}

TEST(WholeBodies, OfAMeshThatIsNotConvexTheHullIsNotTheSolid) {
  const Model torus(generate_mesh("torus", {}));
  const WholeBody body = whole_body_of(PosedMesh(torus, {}));
  EXPECT_FALSE(body.is_convex);
  EXPECT_FALSE(body.drawn.has_value()) << "the hull has a hole less";
}

}  // namespace
}  // namespace toccata
