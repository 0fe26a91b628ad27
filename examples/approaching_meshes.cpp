// Two meshes approach each other: how far apart, when do they touch, and where?
#include <toccata/methods.hpp>
#include <toccata/toccata.hpp>

#include <cstdio>

using namespace toccata;

int main() {
  // A model is a mesh with its tree; make it once. For files: load_model("gear.stl").
  const Model knot(generate_mesh("torus-knot")), ball(icosphere_mesh(0.5, 4));

  // A pose belongs to the question. The ball comes along the x axis.
  const auto ball_at = [](double x) { return PairQuery{.pose_b = Pose::translation(x, 0, 0)}; };

  for (const double x : {4.0, 3.0, 2.5, 2.25, 2.0}) {
    const Distance gap = distance(knot, ball, ball_at(x));
    // within_distance is cheaper than the distance where only a threshold matters; it means "at most".
    std::printf("x = %.2f: %.4f apart, %s 0.5\n", x, gap.upper,
                within_distance(knot, ball, 0.5, ball_at(x)) ? "within" : "beyond");
  }

  // Not in steps, between which a contact could hide: the first time on the way, as an interval that contains it.
  const auto first = cast_shape(ball, {-4, 0, 0}, knot, {.pose_a = Pose::translation(4, 0, 0)});
  if (first)
    std::printf("first contact at x = %.6f, triangle %u against %u\n", 4 - 4 * first->upper, first->element_a,
                first->element_b);

  // Inside that, which triangles meet.
  const PairQuery inside = ball_at(1.25);
  const Relation relation_there = relation(knot, ball, inside);
  std::printf("at x = 1.25 they %s\n", relation_there.kind == RelationKind::overlapping ? "overlap" : "do not overlap");
  for (const ContactRegion& region : contact_regions(knot, ball, inside))
    std::printf("  a region of %zu pairs of triangles, %s\n", region.triangle_pairs, region.closed ? "closed" : "open");
}
