// Bullets, rays and moving shapes in a World: nothing is missed, however fast it flies.
#include <toccata/toccata.hpp>

#include <cstdio>
#include <optional>
#include <vector>

using namespace toccata;

int main() {
  constexpr std::uint64_t scenery = 1, players = 2;
  World world;
  Body wall{Box({0.01, 5, 5}), Pose::translation(10, 0, 0)};  // 2 cm thin
  wall.name = "wall", wall.category = scenery, wall.type = BodyType::static_body;
  const BodyId wall_id = world.add(wall);
  for (int i = 0; i < 5; ++i) {
    Body player{Capsule({0, 0, -0.5}, {0, 0, 0.5}, 0.3), Pose::translation(3 + i, 0.15 * i - 0.3, 0)};
    player.name = "player " + std::to_string(i), player.category = players;
    world.add(player);
  }
  WorldQueries queries(world);
  const auto name_of_body = [&](BodyId id) { return world.body(id).name.c_str(); };

  // A bullet that flies 900 m/s covers 15 m in a frame; it is a ball of 4 mm that moves.
  const MovingShape bullet{{.model = Sphere(0.004), .pose = Pose::translation(0, -2, 0)}, {15, 0, 0}};
  if (const std::optional<BodyAnswer<ShapeHit>> hit = queries.cast_shape(bullet))
    std::printf("the bullet meets the %s at x = %.3f; normal.x is %g\n", name_of_body(hit->body), hit->point.x,
                hit->normal.x);  // the normal points at the bullet

  // A ray for the line of sight, through everybody: sorted by where it meets them.
  const Ray sight{{0, 0, 0}, {15, 0, 0}};
  for (const BodyAnswer<RayHit>& hit : queries.cast_ray_through(sight))
    std::printf("line of sight: %s, after %.0f %% of the way\n", name_of_body(hit.body), 100 * hit.upper);

  // The same, asked of scenery alone.
  if (const auto hit = queries.cast_ray(sight, {.mask = scenery}))
    std::printf("behind them: the %s\n", name_of_body(hit->body));

  // A grenade: who is within 2 m of it, and who is nearest?
  const SceneInstance grenade{.model = Sphere(0.05), .pose = Pose::translation(4.5, 0, 0)};
  for (const BodyId id : queries.within(grenade, 2, {.mask = players}))
    std::printf("within 2 m: %s\n", name_of_body(id));
  if (const auto nearest = queries.nearest(grenade))
    std::printf("nearest: %s, %.3f away\n", name_of_body(nearest->body), nearest->upper);

  // Bodies that change: tell the queries before asking again.
  world.remove(wall_id);
  queries.update();
  std::printf("without the wall the bullet %s\n", queries.cast_shape(bullet) ? "hits" : "hits nothing");

  // Many at once, on all cores.
  std::vector<Ray> spray;
  for (int i = -50; i <= 50; ++i) spray.push_back({{0, 0, 0}, {15, 0.1 * i, 0}});
  int hits = 0;
  for (const auto& hit : queries.cast_ray_each(spray)) hits += hit ? 1 : 0;
  std::printf("%d of %zu rays hit a player\n", hits, spray.size());
}
