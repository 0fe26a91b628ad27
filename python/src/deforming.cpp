#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/motion/deforming_mesh.hpp>

#include "answers.hpp"
#include "calls.hpp"
#include "shapes.hpp"
#include "values.hpp"

namespace toccata::python {

template <>
struct Described<MeshImpact> {
  using Row = MeshImpact;
  static constexpr const char* name = "MeshImpact";
  static constexpr const char* doc =
      "Two features of meshes that deform, which meet, and when first: the exact time lies in [lower, upper], two "
      "neighbouring multiples of 2**-40, or is both.";
  static constexpr std::tuple fields{
      field<Row, &Row::a, &MeshFeature::kind>("kind_a", "Vertex, edge or face; of the first mesh, or the lesser."),
      field<Row, &Row::a, &MeshFeature::number>("number_a",
                                                "The vertex, the edge (DeformingMesh.edges) or the triangle."),
      field<Row, &Row::b, &MeshFeature::kind>("kind_b", "The same of the other."),
      field<Row, &Row::b, &MeshFeature::number>("number_b", ""),
      field<Row, &Row::time, &TimeOfImpact::lower>("lower", "They do not meet before; from 0 to 1."),
      field<Row, &Row::time, &TimeOfImpact::upper>("upper", "They have met by then; 0: at the start."),
      field<Row, &Row::status>("status", "exact without a separation.")};
};

namespace {

/// A DeformingMesh as Python holds it: one thread uses it at a time, and nobody waits for it with the interpreter's
/// lock.
class HeldDeforming {
 public:
  explicit HeldDeforming(DeformingMesh mesh) : mesh_(std::move(mesh)) {}

  /// `use(mesh)`, without the interpreter's lock.
  template <class Use>
  auto with(const Use& use) const {
    const nb::gil_scoped_release released;
    const std::lock_guard guard(*mutex_);
    return use(mesh_);
  }

  /// `ask(mesh)` of one, or `ask(mesh, other)` of two, by who has given the interpreter's lock away.
  template <class Ask>
  auto ask(const HeldDeforming* other, const Ask& ask) const {
    if (other == nullptr) {
      const std::lock_guard guard(*mutex_);
      return ask(std::as_const(mesh_));
    }
    if (other == this) throw Error("other: it is the same mesh; leave it out to ask how it intersects itself");
    const std::scoped_lock guard(*mutex_, *other->mutex_);
    return ask(std::as_const(mesh_), std::as_const(other->mesh_));
  }

 private:
  std::unique_ptr<Turns> mutex_ = std::make_unique<Turns>();
  mutable DeformingMesh mesh_;
};

HeldDeforming made(const AnyShape& mesh, const nb::object& end, int threads) {
  if (!mesh.model.has_mesh() || !mesh.model.parts().empty()) throw Error("mesh: a Mesh is needed");
  std::optional<std::vector<Vec3>> vertices;
  if (!end.is_none()) vertices = vectors_of(end, "end");
  return HeldDeforming(without_lock([&, copy = mesh.model] {
    return vertices ? DeformingMesh(copy.mesh(), std::move(*vertices), threads) : DeformingMesh(copy.mesh(), threads);
  }));
}

Floats vertices_told(std::span<const Vec3> vertices) {
  return nb::borrow<Floats>(array_over<double>(std::vector<Vec3>(vertices.begin(), vertices.end()), {3}));
}

/// The mesh as it is at the start, and its end.
nb::tuple arguments_of_deforming(const HeldDeforming& held) {
  auto [mesh, end] = held.with([](const DeformingMesh& mesh) {
    const std::span<const Vec3> start = mesh.start();
    const auto triangles = mesh.triangles();
    return std::pair(Model(TriangleMesh({start.begin(), start.end()}, {triangles.begin(), triangles.end()})),
                     std::vector<Vec3>(mesh.end().begin(), mesh.end().end()));
  });
  return nb::make_tuple(shape_object(mesh), vertices_told(end));
}

void bind_ways(nb::class_<HeldDeforming>& bound) {
  bound
      .def(
          "__init__",
          [](HeldDeforming* place, const AnyShape& mesh, const ArrayLike& end, int threads) {
            new (place) HeldDeforming(made(mesh, end, threads));
          },
          nb::arg("mesh"), nb::arg("end") = nb::none(), nb::kw_only(), nb::arg("threads") = own_thread,
          nb::sig("def __init__(self, mesh: Mesh, end: numpy.typing.ArrayLike | None = None, *, threads: int = 1) -> "
                  "None"))
      .def(
          "move_to",
          [](const HeldDeforming& held, const ArrayLike& end, int threads) {
            std::vector<Vec3> vertices = vectors_of(end, "end");
            held.with([&](DeformingMesh& mesh) { mesh.move_to(std::move(vertices), threads); });
          },
          nb::arg("end"), nb::kw_only(), nb::arg("threads") = own_thread,
          "Another end of the same step, shape (N, 3), as when a solver tries a shorter one. No question sees an old "
          "box "
          "after it. Raises Error for another number of vertices and for one that is not finite; the mesh then stays "
          "as "
          "it was.")
      .def(
          "advance",
          [](const HeldDeforming& held, const ArrayLike& end, int threads) {
            std::vector<Vec3> vertices = vectors_of(end, "end");
            held.with([&](DeformingMesh& mesh) { mesh.advance(std::move(vertices), threads); });
          },
          nb::arg("end"), nb::kw_only(), nb::arg("threads") = own_thread,
          "The next step to an end of the shape (N, 3): what was the end is the start. Raises Error like move_to.")
      .def_prop_ro(
          "start",
          [](const HeldDeforming& held) {
            return vertices_told(held.with(
                [](const DeformingMesh& mesh) { return std::vector<Vec3>(mesh.start().begin(), mesh.start().end()); }));
          },
          "Where the vertices are at the time 0, shape (N, 3): a new array.")
      .def_prop_ro(
          "end",
          [](const HeldDeforming& held) {
            return vertices_told(held.with(
                [](const DeformingMesh& mesh) { return std::vector<Vec3>(mesh.end().begin(), mesh.end().end()); }));
          },
          "And at the time 1.")
      .def_prop_ro(
          "edges",
          [](const HeldDeforming& held) {
            static_assert(sizeof(IndexPair) == 2 * sizeof(Index));
            return nb::borrow<Indices>(array_over<Index>(held.with([](const DeformingMesh& mesh) {
              return std::vector<IndexPair>(mesh.edges().begin(), mesh.edges().end());
            }),
                                                         {2}));
          },
          "Every edge of a triangle once, by its vertices, ascending, shape (E, 2): an edge's number is its row.")
      .def("__repr__", [](const HeldDeforming& held) {
        return held.with([](const DeformingMesh& mesh) {
          return fmt::format("<toccata.DeformingMesh of {} vertices and {} triangles>", mesh.start().size(),
                             mesh.triangles().size());
        });
      });
}

/// A question of one mesh with itself, or of two, which Ctrl-C ends: `tell(ask(options, meshes…))`.
template <class Ask, class Tell = std::identity>
void bind_impacts(nb::class_<HeldDeforming>& bound, const char* name, const char* signature, const char* doc,
                  const Ask& ask, const Tell& tell = {}) {
  bound.def(
      name,
      [ask, tell](const HeldDeforming& held, const HeldDeforming* other, double separation, bool starts_free,
                  int threads) {
        return tell(Interruptible(threads).ask([&](const BatchOptions& batch) {
          const ImpactOptions options{separation, starts_free, batch.threads, batch.progress};
          return held.ask(other, [&](const auto&... meshes) { return ask(options, meshes...); });
        }));
      },
      nb::arg("other") = nb::none(), nb::kw_only(), nb::arg("separation") = 0.0, nb::arg("starts_free") = false,
      nb::arg("threads") = own_thread, nb::sig(signature), doc);
}

#define TOCCATA_IMPACT_SIGNATURE(name, answer)                                                         \
  "def " name                                                                                          \
  "(self, other: DeformingMesh | None = None, *, separation: float = 0.0, starts_free: bool = False, " \
  "threads: int = 1) -> " answer

/// What is told of the other mesh, where there is one.
struct StepsTold {
  std::vector<double> of_mesh;
  std::optional<std::vector<double>> of_other;
};

StepsTold steps_told(const ImpactOptions& options, const DeformingMesh& mesh) {
  return {free_steps(mesh, options), std::nullopt};
}

StepsTold steps_told(const ImpactOptions& options, const DeformingMesh& mesh, const DeformingMesh& other) {
  FreeSteps steps = free_steps(mesh, other, options);
  return {std::move(steps.of_a), std::move(steps.of_b)};
}

void bind_impacts_of(nb::class_<HeldDeforming>& bound) {
  bind_impacts(bound, "meets", TOCCATA_IMPACT_SIGNATURE("meets", "bool"), "Whether any two features meet in the step.",
               [](const ImpactOptions& options, const auto&... meshes) { return meets(meshes..., options); });
  bind_impacts(bound, "first_impact", TOCCATA_IMPACT_SIGNATURE("first_impact", "MeshImpact | None"),
               "The first two to meet: the least by (lower, upper, a, b); None is proved.",
               [](const ImpactOptions& options, const auto&... meshes) { return first_impact(meshes..., options); });
  bind_impacts(
      bound, "impacts", TOCCATA_IMPACT_SIGNATURE("impacts", "toccata._typing.Answers"),
      "All that meet, each two once, in the same order: a structured array with the members of MeshImpact.",
      [](const ImpactOptions& options, const auto&... meshes) { return impacts(meshes..., options); },
      [](std::vector<MeshImpact> found) { return structured(std::move(found)); });
  bind_impacts(
      bound, "free_step", TOCCATA_IMPACT_SIGNATURE("free_step", "tuple[float, MeshImpact | None]"),
      "The part of the step in which nothing meets, and what ends it: 1 and None where all of it is free. "
      "Where the start is not free it is 0 and means nothing.",
      [](const ImpactOptions& options, const auto&... meshes) { return free_step(meshes..., options); },
      [](const FreeStep& step) { return std::pair(step.fraction, step.limited_by); });
  bind_impacts(
      bound, "free_steps",
      TOCCATA_IMPACT_SIGNATURE("free_steps", "tuple[toccata._typing.Floats, toccata._typing.Floats | None]"),
      "For each vertex a fraction of its own way: however fast each goes, and wherever up to that it stops, "
      "nothing meets. Shapes (N,), of this mesh and of the other, or None.",
      [](const ImpactOptions& options, const auto&... meshes) { return steps_told(options, meshes...); },
      [](StepsTold steps) {
        const nb::object of_other = steps.of_other ? nb::object(array_of(std::move(*steps.of_other))) : nb::none();
        return nb::make_tuple(array_of(std::move(steps.of_mesh)), of_other);
      });
}

#undef TOCCATA_IMPACT_SIGNATURE

}  // namespace

void bind_deforming(nb::module_& module) {
  nb::enum_<FeatureKind>(module, "FeatureKind", nb::is_arithmetic(), "A part of a triangle.")
      .value("vertex", FeatureKind::vertex)
      .value("edge", FeatureKind::edge)
      .value("face", FeatureKind::face);
  bind_answer<MeshImpact>(module);
  nb::class_<HeldDeforming> bound(
      module, "DeformingMesh",
      R"(A mesh over one step, in which every vertex moves straight on: continuous collision of meshes that deform.

At the time t from 0 to 1 a vertex is at (1 - t) * start + t * end; left out, `end`, shape (N, 3), is where it starts. Questions are asked
of the mesh with itself, or with `other`; features that have a vertex in common are not asked about. What counts as meeting
is contact, exactly, or to be at most `separation` apart, in the unit of the coordinates. `starts_free` promises that nothing
meets at the start, as where a free step ended: then what pierces something there is not looked for, and stays unseen where
the promise is broken. Answers do not depend on threads. Raises Error for another number of ends than of vertices and for what
is not finite; questions of times, asked without a separation, also where they find the promise broken, which meets and
free_steps never do.)");
  bind_ways(bound);
  bind_impacts_of(bound);
  bind_pickling(bound, &arguments_of_deforming);
}

}  // namespace toccata::python
