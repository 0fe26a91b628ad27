// Triggers, filters, and saving a World: who is in the zone, who is not asked, and the same again from a snapshot.
#include <toccata/toccata.hpp>

#include <cstdint>
#include <cstdio>
#include <vector>

using namespace toccata;

namespace {

// A bit for each category.
constexpr std::uint64_t players = 1, bullets = 2, zones = 4;

Body make(Model model, std::uint64_t category, std::uint64_t mask, const char* name) {
  Body body{std::move(model)};
  body.category = category, body.mask = mask, body.name = name;
  return body;
}

/// A number that says everything about what a step found.
std::uint64_t digest(const WorldStep& step, std::uint64_t before) {
  const auto mix = [&](std::uint64_t value) { before = (before ^ value) * 0x100000001b3; };
  for (const auto* list : {&step.begin, &step.persist, &step.end})
    for (const PairReport& pair : *list) mix(pair.a.index), mix(pair.b.index), mix(pair.in_contact);
  return before;
}

}  // namespace

int main() {
  World world;
  // Both masks have to allow a pair: a zone is compared with players only, and bullets with players only.
  Body zone = make(Box({2, 2, 2}), zones, players, "zone");
  zone.type = BodyType::static_body;
  world.add(zone);
  const BodyId runner = world.add(make(Sphere(0.5), players, zones | bullets | players, "runner"));
  const BodyId friend_of = world.add(make(Sphere(0.5), players, zones | bullets | players, "friend"));
  const BodyId bullet = world.add(make(Sphere(0.1), bullets, players, "bullet"));
  world.move(friend_of, Pose::translation(0, 8, 0));
  world.move(bullet, Pose::translation(0, 0, 0.5));  // in the zone, and nobody is told

  const auto name_of_body = [&](BodyId id) { return world.body(id).name.c_str(); };
  const auto play = [&](int first, int last, bool aloud) {
    std::uint64_t sum = 0xcbf29ce484222325;
    for (int frame = first; frame < last; ++frame) {
      world.move(runner, Pose::translation(0.5 * frame - 4, 0, 0));
      const WorldStep& step = world.step();
      sum = digest(step, sum);
      if (!aloud) continue;
      for (const PairReport& pair : step.begin)
        std::printf("frame %d: %s meets %s\n", frame, name_of_body(pair.b), name_of_body(pair.a));
      for (const PairReport& pair : step.end)
        std::printf("frame %d: %s leaves %s\n", frame, name_of_body(pair.b), name_of_body(pair.a));
    }
    return sum;
  };

  play(0, 6, true);
  const World saved = world;  // a World is a value: a copy is a snapshot
  const std::uint64_t once = play(6, 20, true);
  world = saved;
  const std::uint64_t again = play(6, 20, false);
  std::printf("played again from the snapshot: %s\n", once == again ? "the same" : "something else");

  // Two bodies in particular: a rule.
  world = saved;
  world.set_rule({.a = runner, .b = bullet, .excluded = true});
  std::printf("with a rule for the bullet: %s\n", play(6, 20, false) == once ? "the same" : "something else");

  // An id names its body as long as that is there, and never another.
  world.remove(bullet);
  const BodyId next = world.add(make(Sphere(0.1), bullets, players, "another bullet"));
  std::printf("the old id: %s; the new one: %s\n", world.contains(bullet) ? "there" : "gone",
              world.contains(next) ? "there" : "gone");
}
