#include "scenes.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include <toccata/query/scene_index.hpp>
#include <toccata/query/self_contacts.hpp>

#include "characters.hpp"
#include "depths.hpp"
#include "object_questions.hpp"
#include "values.hpp"

namespace toccata::python {

template <class Answer>
struct Described<ObjectAnswer<Answer>> {
  using Found = ObjectAnswer<Answer>;
  static constexpr auto letters = prefixed<Answer>("Scene");
  static constexpr const char* name = letters.data();
  static constexpr const char* doc = Described<Answer>::doc;
  static constexpr auto fields =
      std::tuple_cat(std::tuple{field<Found, &Found::object>("object", "Of which of the objects: its index.")},
                     fields_within<Found>(Described<Answer>::fields));
};

namespace {

/// A SceneIndex as Python holds it.
struct HeldIndex {
  SceneIndex index;

  template <class Ask>
  auto ask(const Ask& ask) const {
    return ask(static_cast<const ObjectQueries<SceneObjects>&>(index));
  }
};

struct IndexRow {
  Index query = 0;
  Index object = 0;
};

}  // namespace

template <>
struct Described<IndexRow> {
  static constexpr const char* name = "row";
  static constexpr const char* doc = "";
  static constexpr std::tuple fields{field<IndexRow, &IndexRow::query>("query", ""),
                                     field<IndexRow, &IndexRow::object>("object", "")};
};

template <>
struct ObjectsTold<SceneObjects> {
  static ObjectFilter filter_of(const HeldIndex& held, const nb::object& only) {
    if (only.is_none()) return {};
    return [kept = bools_of(only, held.index.models().size(), "only")](Index object) { return kept[object]; };
  }
  static Indices ids(std::vector<Index> found) { return nb::borrow<Indices>(array_over<Index>(std::move(found), {})); }
  static Answers rows(const std::vector<std::vector<Index>>& found) {
    std::vector<IndexRow> rows;
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Index object : found[i]) rows.push_back({static_cast<Index>(i), object});
    return structured(std::move(rows));
  }
};

namespace {

/// A pair of check_all without its lists.
struct CheckedPair {
  Index a = 0, b = 0;
  Relation relation{};
  PairAnswer::Kind clash{};
  PairAnswer::Tolerance tolerance{};
  PairAnswer::Piercing piercing{};
};

}  // namespace

template <>
struct Described<CheckedPair> {
  static constexpr const char* name = "CheckedPair";
  static constexpr const char* doc = "Two objects that are not apart, or are nearer than their clearance.";
  static constexpr auto fields = std::tuple_cat(
      std::tuple{field<CheckedPair, &CheckedPair::a>("a", "The index of the first."),
                 field<CheckedPair, &CheckedPair::b>("b", "That of the second, which is greater.")},
      fields_within<CheckedPair, &CheckedPair::relation>(Described<Relation>::fields),
      std::tuple{
          field<CheckedPair, &CheckedPair::clash>("clash", "What it is called (ClashKind)."),
          field<CheckedPair, &CheckedPair::tolerance>("tolerance",
                                                      "How an overlap stands to the tolerance (ClashTolerance)."),
          field<CheckedPair, &CheckedPair::piercing>("piercing", "Which passes through the other (ClashPiercing).")});
};

template <>
struct Described<ContactRegion::Depth> {
  using Depth = ContactRegion::Depth;
  static constexpr const char* name = "LocalDepth";
  static constexpr const char* doc = "How deep two meshes are in each other where they are deepest.";
  static constexpr std::tuple fields{field<Depth, &Depth::lower>("lower", "In the unit of the coordinates."),
                                     field<Depth, &Depth::upper>("upper", "The same; infinite where not looked for.")};
};

std::vector<SceneInstance> instances_of(nb::handle given, std::string_view what) {
  if (!nb::hasattr(given, "__iter__") || PyUnicode_Check(given.ptr()))
    throw Error(fmt::format("{}: a list of shapes is needed, of pairs (shape, pose), or of SceneInstances", what));
  std::vector<SceneInstance> instances;
  for (const nb::handle each : given) {
    if (nb::isinstance<SceneInstance>(each)) {
      instances.push_back(nb::cast<const SceneInstance&>(each));
      continue;
    }
    const bool is_pair = PyTuple_Check(each.ptr()) && nb::len(each) == 2;
    const nb::object shape = is_pair ? nb::object(each[0]) : nb::borrow(each);
    if (!nb::isinstance<AnyShape>(shape))
      throw Error(fmt::format("{}: entry {} is no shape, no pair (shape, pose), and no SceneInstance{}", what,
                              instances.size(), how_made(shape)));
    const Pose pose =
        is_pair ? pose_of(nb::object(each[1]), fmt::format("{}, entry {}", what, instances.size())) : Pose{};
    instances.push_back({nb::cast<const AnyShape&>(shape).model, pose});
  }
  return instances;
}

std::vector<SceneInstance> instances_of(const ShapesLike& shapes, const PosesLike& poses, Solid solid) {
  const Models models = models_of(shapes, "shapes");
  const Poses at = poses_of(poses, "poses");
  if (!models.single && !at.is_single() && models.each.size() != at.size())
    throw Error(fmt::format("there are {} shapes and {} poses; give as many, or one of one of them", models.each.size(),
                            at.size()));
  const std::size_t count = models.single ? at.size() : models.each.size();
  std::vector<SceneInstance> instances;
  instances.reserve(count);
  for (std::size_t i = 0; i < count; ++i) instances.push_back({models[i], at[i], solid});
  return instances;
}

namespace {

nb::tuple arguments_of(const SceneInstance& instance) {
  return nb::make_tuple(shape_object(instance.model), instance.pose, instance.solid, instance.name, instance.group);
}

void bind_instance(nb::module_& module) {
  nb::class_<SceneInstance> bound(module, "SceneInstance",
                                  R"(A shape at its place, as one of many.

The pose is in the world. What it is called is for messages; two of one group that is not empty are not checked against each
other (check_all). Raises Error for what is no pose.)");
  bound
      .def(
          "__init__",
          [](SceneInstance* place, const AnyShape& shape, const PoseLike& pose, Solid solid, const std::string& name,
             const std::string& group) {
            new (place) SceneInstance{shape.model, pose_of(pose, "pose"), solid, name, group};
          },
          nb::arg("shape"), nb::arg("pose") = nb::none(), nb::arg("solid") = Solid::automatic, nb::arg("name") = "",
          nb::arg("group") = "")
      .def_prop_ro(
          "shape", [](const SceneInstance& instance) { return shape_object(instance.model); },
          nb::sig("def shape(self) -> Shape"))
      .def_ro("pose", &SceneInstance::pose)
      .def_ro("solid", &SceneInstance::solid)
      .def_ro("name", &SceneInstance::name)
      .def_ro("group", &SceneInstance::group)
      .def("__repr__", [](const SceneInstance& instance) {
        return fmt::format("SceneInstance{}", nb::cast<std::string>(nb::repr(arguments_of(instance))));
      });
  bind_value(bound, [](const SceneInstance& instance) { return arguments_of(instance); });
}

nb::list objects_of(const HeldIndex& held) {
  nb::list objects;
  for (const SceneInstance& instance : held.index.models()) objects.append(nb::cast(instance));
  return objects;
}

void bind_index(nb::module_& module) {
  bind_object_answers<SceneObjects>(module);
  nb::class_<HeldIndex> bound(module, "SceneIndex",
                              R"(Posed shapes that stay where they are, in a tree over their boxes.

Made of a list of shapes, pairs (shape, pose) and SceneInstances. Each answer is what the question of that name gives for
every one of them by itself. Objects are told by their index in the list; `only`, an array of as many truths, says which
are asked, and what is asked is in the world. Lengths are in the unit of the coordinates. Questions may be asked from many
threads at once. Raises Error naming the object that cannot be posed so.)");
  bound
      .def(
          "__init__",
          [](HeldIndex* place, const ObjectsLike& objects) {
            const std::vector<SceneInstance> instances = instances_of(objects, "objects");
            SceneIndex index = without_lock([&] { return SceneIndex(instances); });
            new (place) HeldIndex{std::move(index)};
          },
          nb::arg("objects"))
      .def("__len__", [](const HeldIndex& held) { return held.index.models().size(); })
      .def_prop_ro("objects", &objects_of, nb::sig("def objects(self) -> list[SceneInstance]"))
      .def("__repr__", [](const HeldIndex& held) {
        return fmt::format("<toccata.SceneIndex of {} objects>", held.index.models().size());
      });
  bind_pickling(bound, [](const HeldIndex& held) { return nb::make_tuple(objects_of(held)); });
  ObjectQuestions<SceneObjects, HeldIndex>(bound).bind();
  CharacterQuestions<SceneObjects, HeldIndex>(module, bound, "Scene").bind();
}

// check_all.

constexpr double most_index = std::numeric_limits<Index>::max();

std::vector<CheckedPair> pairs_of(const CheckAnswer& answer) {
  std::vector<CheckedPair> pairs;
  for (const PairAnswer& pair : answer.pairs)
    pairs.push_back({pair.a, pair.b, pair.relation, pair.kind, pair.tolerance, pair.piercing});
  return pairs;
}

/// What some of the pairs have, as rows: `value(pair)` leads to it, or to null.
template <class Row, class Value>
Answers rows_of_pairs(const CheckAnswer& answer, const Value& value) {
  std::vector<Numbered<Row, OfPair>> rows;
  for (std::size_t i = 0; i < answer.pairs.size(); ++i)
    if (const std::optional<Row> row = value(answer.pairs[i])) rows.push_back({static_cast<Index>(i), *row});
  return structured(std::move(rows));
}

Answers contacts_told(const CheckAnswer& answer) {
  std::vector<std::vector<Contact>> lists;
  for (const PairAnswer& pair : answer.pairs) lists.push_back(pair.contacts);
  return structured(numbered<OfPair>(lists));
}

Answers regions_told(const CheckAnswer& answer) {
  std::vector<std::vector<Region>> lists;
  for (const PairAnswer& pair : answer.pairs) lists.push_back(flat(pair.regions));
  return structured(numbered<OfPair>(lists));
}

Answers checked_distances(const CheckAnswer& answer) {
  return rows_of_pairs<Distance>(answer, [](const PairAnswer& pair) { return pair.distance; });
}

Answers checked_penetrations(const CheckAnswer& answer) {
  return rows_of_pairs<DepthBracket>(answer, [](const PairAnswer& pair) -> std::optional<DepthBracket> {
    if (!pair.penetration) return {};
    return DepthBracket{*pair.penetration, pair.depth_end};
  });
}

Answers checked_local_depths(const CheckAnswer& answer) {
  return rows_of_pairs<ContactRegion::Depth>(answer, [](const PairAnswer& pair) { return pair.local_depth; });
}

Answers checked_volumes(const CheckAnswer& answer) {
  return rows_of_pairs<OverlapVolume>(answer, [](const PairAnswer& pair) { return pair.volume; });
}

/// All that Python is told.
nb::tuple state_of_check(const CheckAnswer& answer) {
  return nb::make_tuple(structured(pairs_of(answer)), contacts_told(answer), regions_told(answer),
                        checked_distances(answer), checked_penetrations(answer), checked_volumes(answer),
                        checked_local_depths(answer), answer.candidate_pairs);
}

CheckAnswer check_of_state(const nb::tuple& state) {
  constexpr const char* what = "a pickled CheckAnswer";
  if (state.size() != 8) throw Error("a pickled CheckAnswer of another version");
  CheckAnswer answer;
  answer.candidate_pairs = nb::cast<std::size_t>(state[7]);
  for (const CheckedPair& checked : answers_of<CheckedPair>(state[0], what)) {
    PairAnswer pair;
    pair.a = checked.a;
    pair.b = checked.b;
    pair.relation = checked.relation;
    pair.kind = checked.clash;
    pair.tolerance = checked.tolerance;
    pair.piercing = checked.piercing;
    answer.pairs.push_back(std::move(pair));
  }
  std::vector<PairAnswer>& pairs = answer.pairs;
  for_rows<Contact, OfPair>(state[1], pairs.size(), what,
                            [&](Index i, const Contact& contact) { pairs[i].contacts.push_back(contact); });
  for_rows<Region, OfPair>(state[2], pairs.size(), what,
                           [&](Index i, const Region& row) { pairs[i].regions.push_back(region_of(row)); });
  for_rows<Distance, OfPair>(state[3], pairs.size(), what,
                             [&](Index i, const Distance& distance) { pairs[i].distance = distance; });
  for_rows<DepthBracket, OfPair>(state[4], pairs.size(), what, [&](Index i, const DepthBracket& depth) {
    pairs[i].penetration = depth.penetration;
    pairs[i].depth_end = depth.end;
  });
  for_rows<OverlapVolume, OfPair>(state[5], pairs.size(), what,
                                  [&](Index i, const OverlapVolume& volume) { pairs[i].volume = volume; });
  for_rows<ContactRegion::Depth, OfPair>(
      state[6], pairs.size(), what, [&](Index i, const ContactRegion::Depth& depth) { pairs[i].local_depth = depth; });
  return answer;
}

CheckOptions options_of(const nb::object& clearance, const nb::object& pair_clearances) {
  CheckOptions options;
  if (!clearance.is_none()) options.clearance = numbers_for(clearance, 1, "clearance").front();
  if (pair_clearances.is_none()) return options;
  const Doubles rows = doubles(pair_clearances, "pair_clearances");
  if (!rows.has_shape(1, {0}) && !rows.has_shape(2, {3}))
    throw Error(fmt::format("pair_clearances: triples (a, b, length) are needed, and what is given has the shape {}",
                            shape_text(rows.shape)));
  for (std::size_t i = 0; i < rows.shape[0]; ++i) {
    const double* row = rows.data + 3 * i;
    for (int k = 0; k < 2; ++k)
      if (!(row[k] >= 0) || row[k] > most_index || row[k] != std::floor(row[k]))
        throw Error(fmt::format("pair_clearances: {} in row {} is no index", row[k], i));
    options.pair_clearances.push_back({static_cast<Index>(row[0]), static_cast<Index>(row[1]), row[2]});
  }
  return options;
}

void bind_clashes(nb::module_& module) {
  using Kind = PairAnswer::Kind;
  nb::enum_<Kind>(module, "ClashKind", nb::is_arithmetic(), "What a clash is in the field's words.")
      .value("clearance", Kind::clearance, "Near, and not in contact.")
      .value("touching", Kind::touching)
      .value("crossing", Kind::crossing, "A surface takes part.")
      .value("overlap", Kind::overlap, "Of two solids; whether one passes through the other was not asked.")
      .value("protrude", Kind::protrude, "One goes into the other, and not through it.")
      .value("pierce", Kind::pierce, "One goes into the other at one place and out at another.")
      .value("contains", Kind::contains, "One lies wholly inside the other.")
      .value("equal", Kind::equal);
  using Tolerance = PairAnswer::Tolerance;
  nb::enum_<Tolerance>(module, "ClashTolerance", nb::is_arithmetic(), "How an overlap stands to the tolerance.")
      .value("none", Tolerance::none, "None was asked for, or the two do not overlap.")
      .value("within", Tolerance::within, "Certainly no deeper.")
      .value("beyond", Tolerance::beyond, "Certainly deeper.")
      .value("undecided", Tolerance::undecided, "Its bracket holds the tolerance, or there is no depth.");
  using Piercing = PairAnswer::Piercing;
  nb::enum_<Piercing>(module, "ClashPiercing", nb::is_arithmetic(), "Which of two passes through the other.")
      .value("none", Piercing::none, "Neither, or the volume was not asked for.")
      .value("unknown", Piercing::unknown, "One does, and which could not be told.")
      .value("a_through_b", Piercing::a_through_b)
      .value("b_through_a", Piercing::b_through_a);
}

void bind_check_answer(nb::module_& module) {
  nb::enum_<DepthEnd>(module, "DepthEnd", nb::is_arithmetic(), "Why the search for a depth ended.")
      .value("precise", DepthEnd::precise)
      .value("exhausted", DepthEnd::exhausted)
      .value("out_of_time", DepthEnd::out_of_time);
  nb::class_<CheckAnswer> bound(module, "CheckAnswer", R"(What check_all found. Its length is the number of pairs.

Everything is told in structured arrays; where one has a field pair, that counts the rows of pairs.)");
  bound.def("__len__", [](const CheckAnswer& answer) { return answer.pairs.size(); })
      .def_prop_ro(
          "pairs", [](const CheckAnswer& answer) { return structured(pairs_of(answer)); },
          "a, b, the members of Relation, clash (ClashKind), tolerance (ClashTolerance) and piercing (ClashPiercing), "
          "ascending by (a, b): a new array.")
      .def_prop_ro(
          "contacts", [](const CheckAnswer& answer) { return contacts_told(answer); },
          "pair and the fields of contacts.")
      .def_prop_ro("regions", &regions_told, "pair and the fields of contact_regions, of two meshes, with penetration.")
      .def_prop_ro("distances", &checked_distances,
                   "pair and the members of Distance, where a clearance was asked for.")
      .def_prop_ro("penetrations", &checked_penetrations, "pair, the members of Penetration, and end (DepthEnd).")
      .def_prop_ro("local_depths", &checked_local_depths,
                   "pair, lower and upper: how deep two meshes are in each other where they are deepest, where that "
                   "decided how they stand to the tolerance; upper is infinite where it was not needed.")
      .def_prop_ro("volumes", &checked_volumes,
                   "pair and the members of OverlapVolume, where the volume was asked for.")
      .def_ro("candidate_pairs", &CheckAnswer::candidate_pairs, "How many pairs were looked at.")
      .def("__repr__", [](const CheckAnswer& answer) {
        return fmt::format("<toccata.CheckAnswer of {} pairs>", answer.pairs.size());
      });
  bind_answer_value(bound, &state_of_check, &check_of_state);
}

void bind_check_all(nb::module_& module) {
  module.def(
      "check_all",
      [](const ObjectsLike& objects, bool contacts, bool penetration, const nb::object& clearance,
         const nb::object& pair_clearances, double precision, bool volume, std::optional<double> tolerance,
         int threads) {
        const std::vector<SceneInstance> instances = instances_of(objects, "objects");
        CheckOptions options = options_of(clearance, pair_clearances);
        options.contacts = contacts;
        options.penetration = penetration;
        options.depth.precision = precision;
        options.volume = volume;
        options.tolerance = tolerance;
        const Interruptible call(threads);
        options.threads = threads;
        options.progress = call.options().progress;
        return call.ask([&](const BatchOptions&) { return check_all(instances, options); });
      },
      nb::arg("objects"), nb::kw_only(), nb::arg("contacts") = false, nb::arg("penetration") = false,
      nb::arg("clearance") = nb::none(), nb::arg("pair_clearances") = nb::none(),
      nb::arg("precision") = CheckOptions{}.depth.precision, nb::arg("volume") = false,
      nb::arg("tolerance") = nb::none(), nb::arg("threads") = all_threads,
      nb::sig(
          "def check_all(objects: toccata._typing.ObjectsLike, *, contacts: bool = False, penetration: bool = False, "
          "clearance: float | None = None, pair_clearances: collections.abc.Sequence[tuple[int, int, float]] | None "
          "= None, precision: float = 0.1, volume: bool = False, tolerance: float | None = None, threads: int = 0) -> "
          "CheckAnswer"),
      R"(Every two of many posed shapes that are not apart, or nearer than the clearance, and how they lie.

The objects are shapes, pairs (shape, pose), or SceneInstances. On request the contacts of each pair, how deep they overlap
(brackets as narrow as the precision, a fraction), and with a clearance how far apart they are. pair_clearances, a list of
(a, b, length), says others for some. volume asks how much they have in common; overlaps that are certainly no deeper than
the tolerance are told to be within it. Lengths are in the unit of the coordinates. Which pairs is exact. On all cores,
without the lock; Ctrl-C ends it. Raises Error naming the object that is asked about wrongly.)");
}

void bind_self_contacts_each(nb::module_& module) {
  module.def(
      "self_contacts_each",
      [](const ObjectsLike& objects, int threads) {
        const std::vector<SceneInstance> instances = instances_of(objects, "objects");
        const Interruptible call(threads);
        return structured(numbered<OfObject>(
            call.ask([&](const BatchOptions& options) { return self_contacts_each(instances, options); })));
      },
      nb::arg("objects"), nb::kw_only(), nb::arg("threads") = all_threads,
      "Where each of many posed meshes intersects itself, on all cores: a structured array as that of self_contacts, "
      "and "
      "object, which says whose contact a row is. In any unit. Raises Error like self_contacts, naming the object.");
}

}  // namespace

void bind_scenes(nb::module_& module) {
  bind_instance(module);
  bind_index(module);
  bind_clashes(module);
  bind_check_answer(module);
  bind_check_all(module);
  bind_self_contacts_each(module);
}

}  // namespace toccata::python
