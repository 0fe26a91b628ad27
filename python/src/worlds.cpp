#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <toccata/world/world.hpp>
#include <toccata/world/world_queries.hpp>

#include "characters.hpp"
#include "motions.hpp"
#include "object_questions.hpp"
#include "values.hpp"

namespace toccata::python {

template <>
struct Described<BodyId> {
  static constexpr const char* name = "BodyId";
  static constexpr const char* doc = "Names a body of a World for as long as it is there, and never another one.";
  static constexpr std::tuple fields{field<BodyId, &BodyId::index>("index", "Dense; given out again."),
                                     field<BodyId, &BodyId::generation>("generation", "From 1."),
                                     field<BodyId, &BodyId::world>("world", "From 1; a copy has its original's.")};
};

template <class Answer>
struct Described<BodyAnswer<Answer>> {
  using Found = BodyAnswer<Answer>;
  static constexpr auto letters = prefixed<Answer>("Body");
  static constexpr const char* name = letters.data();
  static constexpr const char* doc = Described<Answer>::doc;
  static constexpr auto fields = std::tuple_cat(std::tuple{field<Found, &Found::body>("body", "Of which body.")},
                                                fields_within<Found>(Described<Answer>::fields));
};

namespace {

struct BodyRow {
  Index query = 0;
  BodyId body{};
};

/// Two bodies that are a pair.
struct WorldPair {
  BodyId a{}, b{};
  bool in_contact = false;
};

}  // namespace

template <>
struct Described<BodyRow> {
  static constexpr const char* name = "row";
  static constexpr const char* doc = "";
  static constexpr std::tuple fields{field<BodyRow, &BodyRow::query>("query", ""),
                                     field<BodyRow, &BodyRow::body>("body", "")};
};

template <>
struct Described<WorldPair> {
  static constexpr const char* name = "WorldPair";
  static constexpr const char* doc = "Two bodies that are in contact, or as near as their margins.";
  static constexpr std::tuple fields{field<WorldPair, &WorldPair::a>("a", ""), field<WorldPair, &WorldPair::b>("b", ""),
                                     field<WorldPair, &WorldPair::in_contact>("in_contact", "")};
};

namespace {

/// A World as Python holds it: one thread uses it at a time, whatever threads of Python do, and nobody waits for it
/// with the interpreter's lock.
class HeldWorld {
 public:
  explicit HeldWorld(const WorldOptions& options) : world_(options) {}
  /// A snapshot.
  HeldWorld(const HeldWorld& other) : HeldWorld(other.snapshot()) {}

  /// `use(world)`, without the interpreter's lock.
  template <class Use>
  auto with(const Use& use) const {
    const nb::gil_scoped_release released;
    return alone(use);
  }

  /// `use(world)`, of who has given the interpreter's lock away.
  template <class Use>
  auto alone(const Use& use) const {
    const std::lock_guard guard(*mutex_);
    return use(world_);
  }

  /// `use(world)`, of what takes less time than to give the interpreter's lock away: that is done only where another
  /// thread has the world.
  template <class Use>
  auto briefly(const Use& use) const {
    if (const std::unique_lock guard(*mutex_, std::try_to_lock); guard.owns_lock()) return use(world_);
    return with(use);
  }

  /// `ask(queries)`, of who has given the interpreter's lock away.
  template <class Ask>
  auto ask(const Ask& ask) const {
    const std::lock_guard guard(*mutex_);
    if (!queries_) queries_.emplace(world_);
    queries_->update();
    return ask(std::as_const(*queries_));
  }

 private:
  explicit HeldWorld(World world) : world_(std::move(world)) {}

  [[nodiscard]] World snapshot() const {
    return with([](const World& world) { return World(world); });
  }

  std::unique_ptr<Turns> mutex_ = std::make_unique<Turns>();
  mutable World world_;
  mutable std::optional<WorldQueries> queries_{};
};

/// Up to so many bodies are asked without a tree: of 200 balls that touch nothing that takes a quarter of the time, of
/// these half, and beyond them it grows faster than with the tree.
constexpr std::size_t few_bodies = 2000;

bool any_overlap_in(const HeldWorld& held) {
  const auto of_few = held.with([](const World& world) -> std::optional<bool> {
    if (world.size() > few_bodies) return {};
    return any_overlap(world);
  });
  return of_few ? *of_few : without_lock([&] {
    return held.ask([](const WorldQueries& queries) { return queries.any_overlap(); });
  });
}

/// Which bodies are asked.
struct AskedBodies {
  std::uint64_t mask = ~std::uint64_t{0};
  std::uint64_t category = 0;
  std::vector<BodyId> except{};
};

/// What BodiesLike says.
std::vector<BodyId> bodies_of(nb::handle given, std::string_view what) {
  if (nb::isinstance<BodyId>(given)) return {nb::cast<BodyId>(given)};
  std::vector<BodyId> ids;
  if (is_list(given)) {
    for (const nb::handle id : given) {
      if (!nb::isinstance<BodyId>(id)) throw Error(fmt::format("{}: entry {} is no BodyId", what, ids.size()));
      ids.push_back(nb::cast<BodyId>(id));
    }
    return ids;
  }
  if (!nb::ndarray_check(given) || !nb::hasattr(given, "dtype") || !given.attr("dtype").equal(dtype_of<BodyId>()))
    throw Error(fmt::format("{}: a BodyId is needed, a list of them, or an array as add_each returns it", what));
  const nb::object numpy = nb::module_::import_("numpy");
  const nb::object flat = numpy.attr("ascontiguousarray")(given).attr("view")("u4").attr("reshape")(-1, 3);
  const auto rows = nb::cast<nb::ndarray<const std::uint32_t, nb::ro, nb::c_contig, nb::device::cpu>>(flat);
  for (std::size_t i = 0; i < rows.shape(0); ++i)
    ids.push_back({rows.data()[3 * i], rows.data()[3 * i + 1], rows.data()[3 * i + 2]});
  return ids;
}

}  // namespace

template <>
struct ObjectsTold<WorldBodies> {
  static BodyFilter filter_of(const HeldWorld&, const nb::object& only) {
    if (only.is_none()) return {};
    if (!nb::isinstance<AskedBodies>(only)) throw Error("only: toccata.BodyFilter is needed, or None");
    const AskedBodies& asked = nb::cast<const AskedBodies&>(only);
    BodyFilter filter{asked.mask, asked.category, {}};
    if (!asked.except.empty())
      filter.accepts = [except = asked.except](BodyId id) { return std::ranges::find(except, id) == except.end(); };
    return filter;
  }
  static Answers ids(std::vector<BodyId> found) { return structured(std::move(found)); }
  static Answers rows(const std::vector<std::vector<BodyId>>& found) {
    std::vector<BodyRow> rows;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const BodyId body : found[i]) rows.push_back({static_cast<Index>(i), body});
    return structured(std::move(rows));
  }
};

namespace {

/// Pairs of a step; what is told of them is shared with the World.
struct HeldPairs {
  std::vector<PairReport> reports;
};

/// What some of the pairs have, as rows: `value(details)` is an optional.
template <class Row, class Value>
Answers rows_of_details(const HeldPairs& pairs, const Value& value) {
  std::vector<Numbered<Row, OfPair>> rows;
  for (std::size_t i = 0; i < pairs.reports.size(); ++i) {
    const auto& details = pairs.reports[i].details;
    if (details == nullptr) continue;
    if (const std::optional<Row> row = value(*details)) rows.push_back({static_cast<Index>(i), *row});
  }
  return structured(std::move(rows));
}

Answers pair_contacts(const HeldPairs& pairs) {
  std::vector<std::vector<Contact>> lists;
  for (const PairReport& report : pairs.reports)
    lists.push_back(report.details == nullptr ? std::vector<Contact>{} : report.details->contacts);
  return structured(numbered<OfPair>(lists));
}

Answers pair_list(const HeldPairs& pairs) {
  std::vector<WorldPair> rows;
  for (const PairReport& report : pairs.reports) rows.push_back({report.a, report.b, report.in_contact});
  return structured(std::move(rows));
}
Answers pair_relations(const HeldPairs& pairs) {
  return rows_of_details<Relation>(pairs, [](const PairDetails& d) { return d.relation; });
}
Answers pair_distances(const HeldPairs& pairs) {
  return rows_of_details<Distance>(pairs, [](const PairDetails& d) { return d.distance; });
}
Answers pair_penetrations(const HeldPairs& pairs) {
  return rows_of_details<Penetration>(pairs, [](const PairDetails& d) { return d.penetration; });
}
Answers pair_first_contacts(const HeldPairs& pairs) {
  return rows_of_details<ShapeHit>(pairs, [](const PairDetails& d) { return d.first_contact; });
}

std::optional<Manifold> pair_manifold(const HeldPairs& pairs, std::size_t pair) {
  if (pair >= pairs.reports.size())
    throw Error(fmt::format("there are {} pairs, and none of number {}", pairs.reports.size(), pair));
  const auto& details = pairs.reports[pair].details;
  return details == nullptr ? std::nullopt : details->manifold;
}

/// All that Python is told; manifolds as pairs (number, Manifold).
nb::tuple state_of_pairs(const HeldPairs& pairs) {
  nb::list manifolds;
  for (std::size_t i = 0; i < pairs.reports.size(); ++i)
    if (const auto manifold = pair_manifold(pairs, i)) manifolds.append(nb::make_tuple(i, *manifold));
  return nb::make_tuple(pair_list(pairs), pair_relations(pairs), pair_distances(pairs), pair_penetrations(pairs),
                        pair_first_contacts(pairs), pair_contacts(pairs), manifolds);
}

HeldPairs pairs_of_state(const nb::tuple& state) {
  constexpr const char* what = "a pickled WorldPairs";
  if (state.size() != 7) throw Error("a pickled WorldPairs of another version");
  HeldPairs pairs;
  for (const WorldPair& pair : answers_of<WorldPair>(state[0], what))
    pairs.reports.push_back({pair.a, pair.b, pair.in_contact, {}});
  const std::size_t count = pairs.reports.size();
  std::vector<std::optional<PairDetails>> details(count);
  const auto of = [&](std::size_t i) -> PairDetails& { return details[i] ? *details[i] : details[i].emplace(); };
  for_rows<Relation, OfPair>(state[1], count, what, [&](Index i, const Relation& row) { of(i).relation = row; });
  for_rows<Distance, OfPair>(state[2], count, what, [&](Index i, const Distance& row) { of(i).distance = row; });
  for_rows<Penetration, OfPair>(state[3], count, what,
                                [&](Index i, const Penetration& row) { of(i).penetration = row; });
  for_rows<ShapeHit, OfPair>(state[4], count, what, [&](Index i, const ShapeHit& row) { of(i).first_contact = row; });
  for_rows<Contact, OfPair>(state[5], count, what, [&](Index i, const Contact& row) { of(i).contacts.push_back(row); });
  for (const nb::handle manifold : nb::cast<nb::list>(state[6])) {
    const auto number = nb::cast<std::size_t>(manifold[0]);
    if (number >= count) throw Error(fmt::format("{}: there is no pair {}", what, number));
    of(number).manifold = nb::cast<const Manifold&>(manifold[1]);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (details[i]) pairs.reports[i].details = std::make_shared<const PairDetails>(std::move(*details[i]));
  return pairs;
}

void bind_pairs(nb::module_& module) {
  nb::class_<HeldPairs> bound(
      module, "WorldPairs",
      "Pairs of bodies that a step found, ascending, and what was asked to be told of them. Where an array "
      "has a field pair, that counts the rows of pairs. Lengths are in the unit of the coordinates.");
  bound.def("__len__", [](const HeldPairs& pairs) { return pairs.reports.size(); })
      .def_prop_ro("pairs", &pair_list, "A structured array: a, b (each with index, generation, world), in_contact.")
      .def_prop_ro("relations", &pair_relations, "pair and the members of Relation, if asked for.")
      .def_prop_ro("distances", &pair_distances, "pair and the members of Distance, if asked for.")
      .def_prop_ro("penetrations", &pair_penetrations, "pair and the members of Penetration, if asked for.")
      .def_prop_ro("first_contacts", &pair_first_contacts,
                   "pair and the members of ShapeHit, of those that met on the way of a body (World.move_along).")
      .def_prop_ro("contacts", &pair_contacts, "pair and the fields of contacts, if asked for.")
      .def("manifold", &pair_manifold, nb::arg("pair"),
           "Its manifold, if asked for and defined, in the world. Raises Error for a number that no pair has.")
      .def("__repr__",
           [](const HeldPairs& pairs) { return fmt::format("<toccata.WorldPairs: {}>", pairs.reports.size()); });
  bind_answer_value(
      bound, [](const HeldPairs& pairs) { return state_of_pairs(pairs); }, &pairs_of_state);
}

/// What a step found, kept as it was.
struct HeldStep {
  HeldPairs begin, persist, end;
  std::size_t candidates = 0, asked = 0;
};

HeldStep step_of(const HeldWorld& held) {
  return Interruptible(own_thread).ask([&](const BatchOptions& options) {
    return held.alone([&](World& world) -> HeldStep {
      const WorldStep& step = world.step(options.progress);
      return {{step.begin}, {step.persist}, {step.end}, step.candidates, step.asked};
    });
  });
}

nb::tuple state_of_step(const HeldStep& step) {
  return nb::make_tuple(step.begin, step.persist, step.end, step.candidates, step.asked);
}

HeldStep step_of_state(const nb::tuple& state) {
  if (state.size() != 5) throw Error("a pickled WorldStep of another version");
  const auto pairs = [&](std::size_t i) { return nb::cast<const HeldPairs&>(state[i]); };
  return {pairs(0), pairs(1), pairs(2), nb::cast<std::size_t>(state[3]), nb::cast<std::size_t>(state[4])};
}

void bind_step(nb::module_& module) {
  nb::class_<HeldStep> bound(module, "WorldStep", "What a step of a World found; it stays as it is.");
  bound.def_ro("begin", &HeldStep::begin, "Pairs that were not there at the step before.")
      .def_ro("persist", &HeldStep::persist, "Pairs that were there at both, told as they are now.")
      .def_ro("end", &HeldStep::end, "Pairs that were there at the step before only, told as they were then.")
      .def_ro("candidates", &HeldStep::candidates, "How many pairs had to be decided.")
      .def_ro("asked", &HeldStep::asked, "How many of them could not be taken over from the step before.")
      .def("__repr__", [](const HeldStep& step) {
        return fmt::format("<toccata.WorldStep: {} begin, {} persist, {} end>", step.begin.reports.size(),
                           step.persist.reports.size(), step.end.reports.size());
      });
  bind_answer_value(
      bound, [](const HeldStep& step) { return state_of_step(step); }, &step_of_state);
}

Body body_of(const AnyShape& shape, const PoseLike& pose, BodyType type, Solid solid, std::uint64_t category,
             std::uint64_t mask, double margin, std::uint64_t user_data, const std::string& name) {
  Body body{shape.model, pose_of(pose, "pose")};
  body.type = type;
  body.solid = solid;
  body.category = category;
  body.mask = mask;
  body.margin = margin;
  body.user_data = user_data;
  body.name = name;
  return body;
}

Making making_of_body(const Body& body) {
  nb::dict named;
  named["type"] = body.type;
  named["solid"] = body.solid;
  named["category"] = body.category;
  named["mask"] = body.mask;
  named["margin"] = body.margin;
  named["user_data"] = body.user_data;
  named["name"] = body.name;
  return {nb::make_tuple(shape_object(body.model), body.pose), named};
}

void bind_body_id(nb::module_& module) {
  nb::enum_<BodyType>(module, "BodyType", "Which pairs of bodies are of interest.")
      .value("static_body", BodyType::static_body, "Part of the surroundings: two such never make a pair.")
      .value("kinematic_body", BodyType::kinematic_body, "Goes where its owner says, whatever it meets.")
      .value("dynamic_body", BodyType::dynamic_body, "Reacts to what it meets.");
  bind_answer<BodyId>(module);
  nb::object hash = nb::cpp_function([](const BodyId& id) { return std::hash<BodyId>()(id); }, nb::is_method(),
                                     nb::name("__hash__"), nb::sig("def __hash__(self) -> int"));
  nb::type<BodyId>().attr("__hash__") = hash;
}

void bind_body(nb::module_& module) {
  nb::class_<Body> bound(module, "Body", R"(A shape at its place in a World, and what is to be told of it.

Two bodies make a pair only if each is in a category of the other's mask (a bit each), and are one when they are at most the
sum of their margins apart: lengths in the unit of the coordinates. The pose is in the world. Raises Error for what is no
pose; the rest is looked at by World.add.)");
  bound
      .def(
          "__init__",
          [](Body* place, const AnyShape& shape, const PoseLike& pose, BodyType type, Solid solid,
             std::uint64_t category, std::uint64_t mask, double margin, std::uint64_t user_data,
             const std::string& name) {
            new (place) Body(body_of(shape, pose, type, solid, category, mask, margin, user_data, name));
          },
          nb::arg("shape"), nb::arg("pose") = nb::none(), nb::kw_only(), nb::arg("type") = BodyType::dynamic_body,
          nb::arg("solid") = Solid::automatic, nb::arg("category") = 1, nb::arg("mask") = ~std::uint64_t{0},
          nb::arg("margin") = 0.0, nb::arg("user_data") = 0, nb::arg("name") = "")
      .def_prop_ro(
          "shape", [](const Body& body) { return shape_object(body.model); }, nb::sig("def shape(self) -> Shape"))
      .def_ro("pose", &Body::pose)
      .def_ro("type", &Body::type)
      .def_ro("solid", &Body::solid)
      .def_ro("category", &Body::category)
      .def_ro("mask", &Body::mask)
      .def_ro("margin", &Body::margin)
      .def_ro("user_data", &Body::user_data)
      .def_ro("name", &Body::name)
      .def("__repr__", [](const Body& body) {
        return fmt::format("<toccata.Body: {}{}{}>", name_of(body.model.shape()), body.name.empty() ? "" : " ",
                           body.name);
      });
  bind_value(bound, &making_of_body);
}

Making making_of_filter(const AskedBodies& asked) {
  nb::dict named;
  named["mask"] = asked.mask;
  named["category"] = asked.category;
  nb::list except;
  for (const BodyId id : asked.except) except.append(id);
  named["except_bodies"] = except;
  return {nb::tuple(), named};
}

void bind_filter(nb::module_& module) {
  nb::class_<AskedBodies> bound(module, "BodyFilter",
                                "Which bodies of a World are asked. Raises Error for what is no BodyId.");
  bound
      .def(
          "__init__",
          [](AskedBodies* place, std::uint64_t mask, std::uint64_t category, const nb::object& except) {
            new (place) AskedBodies{mask, category,
                                    except.is_none() ? std::vector<BodyId>{} : bodies_of(except, "except_bodies")};
          },
          nb::kw_only(), nb::arg("mask") = ~std::uint64_t{0}, nb::arg("category") = 0,
          nb::arg("except_bodies") = nb::none(),
          nb::sig("def __init__(self, *, mask: int = 18446744073709551615, category: int = 0, except_bodies: "
                  "toccata._typing.BodiesLike | None = None) -> None"),
          "Those that are in one of the categories of the mask (a bit each); with a category, of them those whose own "
          "mask "
          "has "
          "it; and none of except_bodies.")
      .def("__repr__", [](const AskedBodies& asked) {
        return fmt::format("<toccata.BodyFilter: mask {:#x}, category {:#x}, without {} bodies>", asked.mask,
                           asked.category, asked.except.size());
      });
  bind_value(bound, &making_of_filter);
}

/// As many as bodies.
std::vector<Pose> poses_for(const std::vector<BodyId>& ids, const PosesLike& poses) {
  const Poses given = poses_of(poses, "poses");
  std::vector<Pose> at(given.is_single() ? ids.size() : given.size());
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = given[i];
  return at;
}

using BoundWorld = nb::class_<HeldWorld>;

void bind_adding(BoundWorld& bound) {
  bound
      .def(
          "add",
          [](const HeldWorld& held, const Body& body) {
            return held.with([&, copy = body](World& world) { return world.add(copy); });
          },
          nb::arg("body"))
      .def(
          "add",
          [](const HeldWorld& held, const AnyShape& shape, const PoseLike& pose, BodyType type, Solid solid,
             std::uint64_t category, std::uint64_t mask, double margin, std::uint64_t user_data,
             const std::string& name) {
            const Body body = body_of(shape, pose, type, solid, category, mask, margin, user_data, name);
            return held.with([&](World& world) { return world.add(body); });
          },
          nb::arg("shape"), nb::arg("pose") = nb::none(), nb::kw_only(), nb::arg("type") = BodyType::dynamic_body,
          nb::arg("solid") = Solid::automatic, nb::arg("category") = 1, nb::arg("mask") = ~std::uint64_t{0},
          nb::arg("margin") = 0.0, nb::arg("user_data") = 0, nb::arg("name") = "",
          "The id given to a body: one made before, or of a shape at a pose. Raises Error for a margin that is no "
          "length and for a pose that its shape may not have. The pose is in the world, the margin in the unit of the "
          "coordinates.")
      .def(
          "add_each",
          [](const HeldWorld& held, const ShapesLike& shapes, const PosesLike& poses, const ArrayLike& margins,
             BodyType type, Solid solid, std::uint64_t category, std::uint64_t mask) {
            const std::vector<SceneInstance> instances = instances_of(shapes, poses, solid);
            const std::vector<double> margin = numbers_for(margins, instances.size(), "margins");
            std::vector<Body> bodies;
            for (std::size_t i = 0; i < instances.size(); ++i) {
              Body body{instances[i].model, instances[i].pose, type, solid, category, mask, margin[i]};
              bodies.push_back(std::move(body));
            }
            return structured(held.with([&](World& world) { return world.add(bodies); }));
          },
          nb::arg("shapes"), nb::arg("poses") = nb::none(), nb::arg("margins") = 0.0, nb::kw_only(),
          nb::arg("type") = BodyType::dynamic_body, nb::arg("solid") = Solid::automatic, nb::arg("category") = 1,
          nb::arg("mask") = ~std::uint64_t{0},
          "Adds one shape at many poses, or as many shapes, with one margin or as many, shape (N,), in the unit of the "
          "coordinates; the array of their ids (index, generation, world), in order. Raises Error like add.")
      .def(
          "remove",
          [](const HeldWorld& held, const BodiesLike& bodies) {
            const std::vector<BodyId> ids = bodies_of(bodies, "bodies");
            held.with([&](World& world) { world.remove(ids); });
          },
          nb::arg("bodies"), "Removes bodies, with their rules. Raises Error naming an id that is of no body here.")
      .def(
          "replace",
          [](const HeldWorld& held, const BodyId& id, const Body& body) {
            held.with([&, copy = body](World& world) { world.replace(id, copy); });
          },
          nb::arg("id"), nb::arg("body"),
          "Makes a body into another one, all of it; its id and rules stay. Raises Error like "
          "add, and naming an id that is of no body here.");
}

void bind_moving(BoundWorld& bound) {
  bound
      .def(
          "move",
          [](const HeldWorld& held, const BodiesLike& bodies, const PosesLike& poses) {
            const std::vector<BodyId> ids = bodies_of(bodies, "bodies");
            const std::vector<Pose> at = poses_for(ids, poses);
            held.with([&](World& world) { world.move(ids, at); });
          },
          nb::arg("bodies"), nb::arg("poses"),
          "Gives bodies other poses in the world, however far: as many poses as bodies, or one. Raises Error as add "
          "does, and "
          "naming an id that is of no body here.")
      .def(
          "place",
          [](const HeldWorld& held, const BodyId& body, const PoseLike& matrix) {
            const Pose pose = pose_of_matrix(matrix, "matrix");
            held.briefly([&](World& world) { world.move(body, pose); });
          },
          nb::arg("body"), nb::arg("matrix").none(),
          "move of one body to a pose that is told as a matrix, shape (4, 4): the quickest way for who moves them one "
          "by "
          "one. Raises Error like move, and for another shape.")
      .def(
          "move_along",
          [](const HeldWorld& held, const BodiesLike& bodies, const nb::object& motions) {
            const std::vector<BodyId> ids = bodies_of(bodies, "bodies");
            const std::vector<RigidMotion> ways = motions_of(motions, "motions");
            held.with([&](World& world) { world.move_along(ids, ways); });
          },
          nb::arg("bodies"), nb::arg("motions"),
          nb::sig("def move_along(self, bodies: toccata._typing.BodiesLike, motions: RigidMotion | "
                  "collections.abc.Sequence[RigidMotion]) -> None"),
          "Lets bodies go along motions in the time of the next step, which also finds every pair that meets on the "
          "way: nothing tunnels. A body goes from where its motion begins, wherever it was before: what lies between "
          "these two is passed over. Raises Error like move.");
}

void bind_rules(BoundWorld& bound) {
  bound
      .def(
          "set_rule",
          [](const HeldWorld& held, const BodyId& a, const BodyId& b, bool excluded, std::optional<double> margin) {
            held.with([&](World& world) { world.set_rule({a, b, excluded, margin}); });
          },
          nb::arg("a"), nb::arg("b"), nb::kw_only(), nb::arg("excluded") = false, nb::arg("margin") = nb::none(),
          "What is said about two bodies in particular: that they never make a pair, or another margin than the sum of "
          "theirs, in the unit of the coordinates. A rule that says nothing ends an earlier one. Raises Error naming "
          "an id "
          "that is of no body here, and for a margin that is no length.")
      .def(
          "exclude",
          [](const HeldWorld& held, const BodiesLike& a, const BodiesLike& b) {
            const std::vector<BodyId> of_a = bodies_of(a, "a"), of_b = bodies_of(b, "b");
            if (of_a.size() != of_b.size())
              throw Error(fmt::format("there are {} bodies a and {} bodies b; give as many", of_a.size(), of_b.size()));
            std::vector<PairRule> rules;
            for (std::size_t i = 0; i < of_a.size(); ++i) rules.push_back({of_a[i], of_b[i], true, {}});
            held.with([&](World& world) { world.set_rules(rules); });
          },
          nb::arg("a"), nb::arg("b"),
          "Pairs (a[i], b[i]) that are never told: an allowed-collision list, as arrays of ids, "
          "shape (N,). Raises Error naming an id that is of no body here.");
}

nb::object pair_told(const std::optional<BodyPair>& pair) {
  return pair ? nb::object(nb::make_tuple(pair->a, pair->b)) : nb::none();
}

void bind_pair_questions_of_world(BoundWorld& bound) {
  bound
      .def("step", &step_of,
           "Finds the pairs of the bodies as they are now: which begin, persist and end. Exact, without the lock. "
           "Ctrl-C "
           "ends it between two pairs, and the World is then as if it had not begun.")
      .def_prop_ro(
          "pairs",
          [](const HeldWorld& held) {
            return held.with([](const World& world) {
              const auto pairs = world.pairs();
              return HeldPairs{{pairs.begin(), pairs.end()}};
            });
          },
          "All pairs of the last step.")
      .def("any_overlap", &any_overlap_in,
           "Whether any two bodies have a point in common where they are now, whatever their types, categories, "
           "margins and "
           "rules. Exact; needs no step, and stops at the first two that it finds.")
      .def(
          "any_contact",
          [](const HeldWorld& held) {
            return pair_told(without_lock(
                [&] { return held.ask([](const WorldQueries& queries) { return queries.any_contact(); }); }));
          },
          nb::sig("def any_contact(self) -> tuple[BodyId, BodyId] | None"),
          "The least pair of bodies that have a point in common where they are now, by their indices, of those that "
          "make "
          "pairs; None is proved. Margins do not matter. Needs no step.")
      .def(
          "any_within",
          [](const HeldWorld& held, double max_distance) {
            return pair_told(without_lock([&] {
              return held.ask([&](const WorldQueries& queries) { return queries.any_within(max_distance); });
            }));
          },
          nb::arg("max_distance"), nb::sig("def any_within(self, max_distance: float) -> tuple[BodyId, BodyId] | None"),
          "any_contact of pairs that are at most so far apart, in the unit of the coordinates, decided exactly. Raises "
          "Error "
          "for what is no length.")
      .def(
          "least_distance",
          [](const HeldWorld& held, double max_distance) -> nb::object {
            const auto found = without_lock([&] {
              return held.ask([&](const WorldQueries& queries) { return queries.least_distance({}, max_distance); });
            });
            if (!found) return nb::none();
            return nb::make_tuple(found->bodies.a, found->bodies.b, static_cast<const Distance&>(*found));
          },
          nb::arg("max_distance") = unlimited,
          nb::sig("def least_distance(self, max_distance: float = float('inf')) -> tuple[BodyId, BodyId, Distance] | "
                  "None"),
          "The nearest two of the bodies that make pairs, and their distance as of A and B in this order, in the unit "
          "of the "
          "coordinates; None where none is within the greatest distance. Raises Error for one that is no length.");
}

using Matrix = std::array<double, 16>;

std::vector<Matrix> matrices_of(const World& world) {
  Matrix nowhere;
  nowhere.fill(std::numeric_limits<double>::quiet_NaN());
  std::vector<Matrix> matrices(world.boxes().size(), nowhere);
  for (const BodyId id : world.bodies()) matrices[id.index] = matrix_of(world.body(id).pose);
  return matrices;
}

void bind_listing(BoundWorld& bound) {
  bound.def("__len__", [](const HeldWorld& held) { return held.with([](const World& w) { return w.size(); }); })
      .def_prop_ro(
          "bodies",
          [](const HeldWorld& held) { return structured(held.with([](const World& w) { return w.bodies(); })); },
          "The ids of all, ascending: a structured array.")
      .def(
          "__contains__",
          [](const HeldWorld& held, const nb::object& id) {
            if (!nb::isinstance<BodyId>(id)) return false;
            const BodyId asked = nb::cast<BodyId>(id);
            return held.with([&](const World& world) { return world.contains(asked); });
          },
          nb::sig("def __contains__(self, id: object, /) -> bool"))
      .def(
          "__getitem__",
          [](const HeldWorld& held, const BodyId& id) {
            return held.with([&](const World& world) { return world.body(id); });
          },
          nb::arg("id"), "The body as it is now.")
      .def_prop_ro(
          "boxes",
          [](const HeldWorld& held) {
            static_assert(sizeof(Aabb) == 6 * sizeof(double));
            std::vector<Aabb> boxes = held.with([](const World& world) {
              const auto all = world.boxes();
              return std::vector<Aabb>(all.begin(), all.end());
            });
            return nb::borrow<Floats>(array_over<double>(std::move(boxes), {2, 3}));
          },
          "By index, the boxes around all bodies without their margins, shape (N, 2, 3): a new array. Where no body "
          "has "
          "that index, the lower corner is +inf and the upper one -inf.")
      .def_prop_ro(
          "poses",
          [](const HeldWorld& held) {
            return nb::borrow<Floats>(array_over<double>(held.with(&matrices_of), {4, 4}));
          },
          "By index, where the bodies are in the world, shape (N, 4, 4): a new array. Where no body has that index, "
          "all "
          "numbers are NaN.");
}

void bind_manners(BoundWorld& bound) {
  bind_copying(bound);
  bound.def("__repr__", [](const HeldWorld& held) {
    return fmt::format("<toccata.World of {} bodies>", held.with([](const World& w) { return w.size(); }));
  });
  bind_refusal(bound,
               "copy.copy makes a snapshot in this process; for another one pickle its bodies, [world[id] for id in "
               "world.bodies], and add them to a new World, which gives them other ids");
}

}  // namespace

void bind_worlds(nb::module_& module) {
  bind_body_id(module);
  bind_body(module);
  bind_filter(module);
  bind_pairs(module);
  bind_step(module);
  bind_object_answers<WorldBodies>(module);
  BoundWorld bound(module, "World",
                   R"(Bodies that move, and the pairs of them that are in contact or near, step by step.

The options say what is told of every pair, besides that it is one; each costs what the question of that name costs.
kinematic_pairs: whether two kinematic bodies, and a kinematic and a static one, make pairs. space_time: pairs that cannot
meet for some steps are not looked at in these. Which pairs is exact, and the same on any number of threads. Questions
about the bodies where they are now need no step; `only` is a BodyFilter. Lengths are in the unit of the coordinates. A World
may be used from many threads, one after the other. Raises Error for a broad phase that there is not.)");
  bound.def(
      "__init__",
      [](HeldWorld* place, bool relation, bool distance, bool contacts, bool manifold, bool penetration,
         bool kinematic_pairs, bool space_time, const std::string& broad_phase, int threads) {
        WorldOptions options{relation, distance, contacts, manifold, penetration, kinematic_pairs, space_time};
        options.broad_phase = broad_phase_method(broad_phase);
        options.threads = threads;
        new (place) HeldWorld(options);
      },
      nb::kw_only(), nb::arg("relation") = false, nb::arg("distance") = false, nb::arg("contacts") = false,
      nb::arg("manifold") = false, nb::arg("penetration") = false, nb::arg("kinematic_pairs") = true,
      nb::arg("space_time") = false, nb::arg("broad_phase") = "auto", nb::arg("threads") = own_thread);
  bind_adding(bound);
  bind_moving(bound);
  bind_rules(bound);
  bind_pair_questions_of_world(bound);
  bind_listing(bound);
  bind_manners(bound);
  ObjectQuestions<WorldBodies, HeldWorld>(bound).bind();
  CharacterQuestions<WorldBodies, HeldWorld>(module, bound, "Body").bind();
}

}  // namespace toccata::python
