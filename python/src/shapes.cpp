#include "shapes.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/generate/meshes.hpp>
#include <toccata/io/model_file.hpp>
#include <toccata/shapes/mesh_health.hpp>

#include "answers.hpp"
#include "arrays.hpp"
#include "calls.hpp"
#include "values.hpp"

namespace toccata::python {

template <>
struct Described<MeshHealth> {
  static constexpr const char* name = "MeshHealth";
  static constexpr const char* doc = "What a mesh is, counted exactly; vertices of equal coordinates are taken as one.";
  static constexpr std::tuple fields{
      field<MeshHealth, &MeshHealth::vertices>("vertices", "As stored."),
      field<MeshHealth, &MeshHealth::distinct_vertices>("distinct_vertices", "Equal coordinates taken as one."),
      field<MeshHealth, &MeshHealth::unused_vertices>("unused_vertices", "Stored, but in no triangle."),
      field<MeshHealth, &MeshHealth::triangles>("triangles", ""),
      field<MeshHealth, &MeshHealth::faces>("faces", ""),
      field<MeshHealth, &MeshHealth::components>("components", "Parts that are connected through vertices."),
      field<MeshHealth, &MeshHealth::unbalanced_edges>("unbalanced_edges",
                                                       "Used unequally often in both directions; 0 means closed."),
      field<MeshHealth, &MeshHealth::boundary_edges>("boundary_edges", "Used by one triangle."),
      field<MeshHealth, &MeshHealth::non_manifold_edges>("non_manifold_edges", "Used by more than two triangles."),
      field<MeshHealth, &MeshHealth::flipped_edges>("flipped_edges", "Used by two triangles in the same direction."),
      field<MeshHealth, &MeshHealth::degenerate_triangles>("degenerate_triangles", "Without area, exactly."),
      field<MeshHealth, &MeshHealth::duplicate_triangles>("duplicate_triangles",
                                                          "The same vertices as an earlier one."),
      field<MeshHealth, &MeshHealth::closed>("closed", "It may be a solid."),
      field<MeshHealth, &MeshHealth::signed_volume>("signed_volume",
                                                    "Of a closed mesh; negative when it is inside out."),
      field<MeshHealth, &MeshHealth::lower>("lower", "The least corner of the box around it."),
      field<MeshHealth, &MeshHealth::upper>("upper", "The greatest corner.")};
};

namespace {

using MeshPointer = std::shared_ptr<const TriangleMesh>;
using Mesh = ShapeOf<MeshPointer>;

template <class S>
const S& shape_of(const AnyShape& any) {
  return std::get<S>(any.model.shape());
}

// What describes itself: its numbers are the arguments, the properties, and what is compared.

template <class S>
inline constexpr std::size_t parameter_count = std::tuple_size_v<std::remove_cvref_t<decltype(S::parameters)>>;

template <class S, std::size_t i>
using ParameterOf = std::remove_cvref_t<decltype((std::declval<const S&>().*std::get<i>(S::parameters).value)())>;

template <class Value>
using Taken = std::conditional_t<std::is_same_v<Value, double>, double, ArrayLike>;

double told(double given, const char*) { return given; }
Vec3 told(const ArrayLike& given, const char* name) { return vector_of(given, name); }

nb::object plain(double value) { return nb::float_(value); }
nb::object plain(const Vec3& value) { return tuple_of(value); }

/// It may be left out, and so may all after it.
template <class S, std::size_t i>
constexpr bool may_be_left_out() {
  if constexpr (i == parameter_count<S>)
    return true;
  else
    return std::get<i>(S::parameters).when_left_out == WhenLeftOut::zero && may_be_left_out<S, i + 1>();
}

template <class S, std::size_t i>
auto argument() {
  const nb::arg named(std::get<i>(S::parameters).name);
  if constexpr (may_be_left_out<S, i>())
    return named = nb::make_tuple(0.0, 0.0, 0.0);
  else
    return named;
}

template <DescribedShape S>
nb::tuple arguments_of(const S& shape) {
  return std::apply([&](const auto&... each) { return nb::make_tuple(plain((shape.*each.value)())...); },
                    S::parameters);
}

template <class S>
std::string class_name() {
  return nb::cast<std::string>(nb::type<ShapeOf<S>>().attr("__name__"));
}

template <DescribedShape S>
std::string text_of(const S& shape) {
  std::string text;
  std::apply(
      [&](const auto&... each) {
        ((text += fmt::format("{}{}={}", text.empty() ? "" : ", ", each.name,
                              nb::cast<std::string>(nb::repr(plain((shape.*each.value)()))))),
         ...);
      },
      S::parameters);
  return fmt::format("{}({})", class_name<S>(), text);
}

template <class S, std::size_t... i>
void bind_described(nb::module_& module, const char* name, const char* doc, std::index_sequence<i...>) {
  using Bound = ShapeOf<S>;
  nb::class_<Bound, AnyShape> bound(module, name, doc);
  bound.def(
      "__init__",
      [](Bound* place, const Taken<ParameterOf<S, i>>&... given) {
        new (place) Bound{AnyShape{Model(S(told(given, std::get<i>(S::parameters).name)...))}};
      },
      argument<S, i>()...);
  const auto property = [&]<std::size_t at>(std::integral_constant<std::size_t, at>) {
    constexpr auto value = std::get<at>(S::parameters).value;
    if constexpr (std::is_same_v<ParameterOf<S, at>, double>)
      bound.def_prop_ro(std::get<at>(S::parameters).name,
                        [](const Bound& shape) { return (shape_of<S>(shape).*value)(); });
    else
      bound.def_prop_ro(std::get<at>(S::parameters).name,
                        [](const Bound& shape) { return array_of((shape_of<S>(shape).*value)()); });
  };
  (property(std::integral_constant<std::size_t, i>{}), ...);
  bound.def("__repr__", [](const Bound& shape) { return text_of(shape_of<S>(shape)); })
      .def("__hash__", [](const Bound& shape) { return nb::hash(arguments_of(shape_of<S>(shape))); });
  bind_pickling(bound, [](const Bound& shape) { return arguments_of(shape_of<S>(shape)); });
}

template <class S>
void bind_described(nb::module_& module, const char* name, const char* doc) {
  bind_described<S>(module, name, doc, std::make_index_sequence<parameter_count<S>>());
}

// Equality: of the same kind, and made of the same numbers.

bool equal(const Shape& a, const Shape& b);

std::vector<Vec3> vertices_of(const ConvexHull& hull) {
  std::vector<Vec3> vertices;
  for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
  return vertices;
}

template <DescribedShape S>
bool same(const S& a, const S& b) {
  return std::apply([&](const auto&... each) { return (((a.*each.value)() == (b.*each.value)()) && ...); },
                    S::parameters);
}
bool same(const Triangle& a, const Triangle& b) { return a == b; }
bool same(const ConvexHull& a, const ConvexHull& b) { return vertices_of(a) == vertices_of(b); }
bool same(const Rounded& a, const Rounded& b) {
  return a.radius() == b.radius() && a.core().index() == b.core().index() &&
         std::visit(
             [&](const auto& core) { return same(core, std::get<std::remove_cvref_t<decltype(core)>>(b.core())); },
             a.core());
}
bool same(const MeshPointer& a, const MeshPointer& b) {
  if (a == b) return true;
  if (!std::ranges::equal(a->vertices(), b->vertices()) || !std::ranges::equal(a->triangles(), b->triangles()))
    return false;
  for (Index i = 0; i < a->triangle_count(); ++i)
    if (a->face_of(i) != b->face_of(i)) return false;
  return true;
}
bool same(const HeightField& a, const HeightField& b) { return a.columns() == b.columns() && same(a.mesh(), b.mesh()); }
bool same(const Compound& a, const Compound& b) {
  return std::ranges::equal(a.parts(), b.parts(), [](const CompoundPart& x, const CompoundPart& y) {
    return x.pose == y.pose && equal(x.shape, y.shape);
  });
}

bool equal(const Shape& a, const Shape& b) {
  return a.index() == b.index() &&
         std::visit([&](const auto& shape) { return same(shape, std::get<std::remove_cvref_t<decltype(shape)>>(b)); },
                    a);
}

// Meshes.

nb::object vertices_of(const MeshPointer& mesh) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  const auto vertices = mesh->vertices();
  return read_only_view(&vertices.data()->x, {vertices.size(), 3}, capsule_of(mesh));
}

nb::object triangles_of(const MeshPointer& mesh) {
  const auto triangles = mesh->triangles();
  return read_only_view(triangles.data()->data(), {triangles.size(), 3}, capsule_of(mesh));
}

std::vector<Index> faces_of_triangles(const TriangleMesh& mesh) {
  std::vector<Index> faces(mesh.triangle_count());
  for (Index i = 0; i < mesh.triangle_count(); ++i) faces[i] = mesh.face_of(i);
  return faces;
}

void make_mesh(Mesh* place, nb::handle vertices, nb::handle faces, nb::handle face_of_triangle) {
  std::vector<Vec3> positions = vectors_of(vertices, "vertices");
  const std::vector<Index> corners = indices_of(faces, 3, "faces");
  std::vector<Index> numbers;
  if (!face_of_triangle.is_none()) numbers = indices_of(face_of_triangle, 1, "face_of_triangle");
  std::vector<std::array<Index, 3>> triangles(corners.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    triangles[i] = {corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]};
  Model model =
      without_lock([&] { return Model(TriangleMesh(std::move(positions), std::move(triangles), std::move(numbers))); });
  new (place) Mesh{AnyShape{std::move(model)}};
}

nb::tuple mesh_arguments(const Mesh& mesh) {
  const auto& pointer = shape_of<MeshPointer>(mesh);
  nb::object faces = nb::none();
  if (pointer->face_count() != pointer->triangle_count()) faces = array_over<Index>(faces_of_triangles(*pointer), {});
  return nb::make_tuple(vertices_of(pointer), triangles_of(pointer), faces);
}

Mesh mesh_of_file(const std::filesystem::path& path) {
  return {{without_lock([&] { return load_model(path.string()); })}};
}

/// A parameter is named as Python names are: tube_radius is the generator's tube-radius.
Mesh generated(const std::string& name, const nb::kwargs& parameters) {
  GeneratorParameters given;
  for (const auto& [key, value] : parameters) {
    auto parameter = nb::cast<std::string>(key);
    std::replace(parameter.begin(), parameter.end(), '_', '-');
    double number = 0;
    if (!nb::try_cast(value, number))
      throw Error(
          fmt::format("{}: a number is needed, and not {}", nb::cast<std::string>(key), nb::repr(value).c_str()));
    given[parameter] = number;
  }
  return {{without_lock([&] { return Model(generate_mesh(name, given)); })}};
}

using BoundMesh = nb::class_<Mesh, AnyShape>;

void bind_arrays_of_meshes(BoundMesh& bound) {
  bound
      .def_prop_ro(
          "vertices", [](const Mesh& mesh) { return nb::borrow<Floats>(vertices_of(shape_of<MeshPointer>(mesh))); },
          "Shape (N, 3): its own memory, which cannot be written to. Stays as it is when the mesh is updated.")
      .def_prop_ro(
          "faces", [](const Mesh& mesh) { return nb::borrow<Indices>(triangles_of(shape_of<MeshPointer>(mesh))); },
          "The corners of its triangles, shape (M, 3): its own memory, which cannot be written to.")
      .def_prop_ro(
          "face_of_triangle",
          [](const Mesh& mesh) {
            return nb::borrow<Indices>(array_over<Index>(faces_of_triangles(mesh.model.mesh()), {}));
          },
          "The face that each triangle belongs to, shape (M,): a new array.")
      .def_prop_ro(
          "triangle_count", [](const Mesh& mesh) { return mesh.model.mesh().triangle_count(); }, "M.")
      .def_prop_ro(
          "closed", [](const Mesh& mesh) { return mesh.model.closed(); },
          "Every edge is used equally often in both directions: it may be taken as a solid.")
      .def_prop_ro(
          "bounds",
          [](const Mesh& mesh) {
            const Aabb& box = mesh.model.bounds();
            return nb::borrow<Floats>(array_over<double>(std::vector<Vec3>{box.lower, box.upper}, {3}));
          },
          "The least and the greatest corner of the box around all vertices, shape (2, 3).");
}

void bind_manners_of_meshes(BoundMesh& bound) {
  bound
      .def(
          "health", [](const Mesh& mesh) { return inspect(mesh.model.mesh()); },
          "What the mesh is: holes, flipped faces, triangles without area. Repairs nothing.")
      .def(
          "update", [](Mesh& mesh, const ArrayLike& vertices) { mesh.model.deform(vectors_of(vertices, "vertices")); },
          nb::arg("vertices"),
          "Gives the mesh other vertices, as many as before, shape (N, 3), in its own frame and unit: the boxes of its "
          "tree "
          "are put around them, and no question sees old ones. Copies, and scenes and worlds that hold the mesh, keep "
          "what they have. Raises "
          "Error "
          "for another number of vertices and where one is not finite; the mesh then stays as it was.")
      .def(
          "write",
          [](const Mesh& mesh, const std::filesystem::path& path) { write_mesh(mesh.model.mesh(), path.string()); },
          nb::arg("path"),
          "Writes OBJ, OFF, STL or PLY by the extension, so that the same numbers are read back. Raises Error naming "
          "the "
          "file that cannot be written.")
      .def("__repr__",
           [](const Mesh& mesh) {
             const TriangleMesh& triangles = mesh.model.mesh();
             return fmt::format("<toccata.Mesh of {} vertices and {} triangles>", triangles.vertices().size(),
                                triangles.triangle_count());
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound, &mesh_arguments);
}

void bind_found_meshes(nb::module_& module) {
  module.def(
      "load_mesh", &mesh_of_file, nb::arg("path"),
      "Reads a mesh from an OBJ, STL, PLY or OFF file: every number as its nearest double, in the unit of the file, "
      "nothing repaired. Raises Error naming file and line.");
  module.def(
      "generate_mesh", &generated, nb::arg("name"), nb::arg("parameters"),
      "A mesh by the name of its generator, such as 'torus-knot', 'gear' or 'noise-sphere', with its parameters "
      "(docs/guide/generated-meshes.md), tube_radius for tube-radius: the same bits everywhere. Raises Error for an "
      "unknown name.",
      nb::sig("def generate_mesh(name: str, **parameters: float) -> Mesh"));
}

void bind_mesh(nb::module_& module) {
  BoundMesh bound(module, "Mesh", R"(A triangle mesh: solid when it is closed, else a surface.

Mesh(vertices, faces) copies an array (N, 3) of real numbers, in any unit, and an array (M, 3) of whole numbers counted
from 0, and builds a tree over the triangles. `face_of_triangle`, shape (M,) and ascending, says to which face of a file
each triangle belongs, for the answers; left out, every triangle is a face. Mesh(mesh) takes what has `vertices` and
`faces`, as a trimesh.Trimesh. Nothing is merged or repaired. Raises Error naming the element when a coordinate is not
finite, an index out of range, or there is no triangle.)");
  bound
      .def(
          "__init__",
          [](Mesh* place, const ArrayLike& vertices, const ArrayLike& faces, const nb::object& face_of_triangle) {
            make_mesh(place, vertices, faces, face_of_triangle);
          },
          nb::arg("vertices"), nb::arg("faces"), nb::arg("face_of_triangle") = nb::none(),
          nb::sig("def __init__(self, vertices: numpy.typing.ArrayLike, faces: numpy.typing.ArrayLike, "
                  "face_of_triangle: numpy.typing.ArrayLike | None = None) -> None"))
      .def(
          "__init__",
          [](Mesh* place, const nb::object& mesh) {
            if (!nb::hasattr(mesh, "vertices") || !nb::hasattr(mesh, "faces"))
              throw Error(
                  "a mesh is made of vertices and faces, or of an object that has both; load_mesh reads a file");
            make_mesh(place, mesh.attr("vertices"), mesh.attr("faces"), nb::none());
          },
          nb::arg("mesh"), nb::sig("def __init__(self, mesh: toccata._typing.HasVerticesAndFaces) -> None"));
  bind_arrays_of_meshes(bound);
  bind_manners_of_meshes(bound);
  bind_found_meshes(module);
}

// Shapes made of others.

using Hull = ShapeOf<ConvexHull>;
using Field = ShapeOf<HeightField>;
using Round = ShapeOf<Rounded>;
using Parts = ShapeOf<Compound>;
using Triple = ShapeOf<Triangle>;

Rounded::Core core_of(const Shape& shape) {
  return std::visit(
      []<class S>(const S& core) -> Rounded::Core {
        if constexpr (std::is_constructible_v<Rounded::Core, const S&>)
          return core;
        else
          throw Error("core: a point, segment, triangle, box or convex hull is needed");
      },
      shape);
}

CompoundPart part_of(nb::handle given, std::size_t i) {
  nb::handle shape = given;
  Pose pose;
  if (PyTuple_Check(given.ptr()) && nb::len(given) == 2) {
    shape = given[0];
    pose = pose_of(given[1], fmt::format("part {}", i));
  }
  if (!nb::isinstance<AnyShape>(shape))
    throw Error(fmt::format("part {}: a shape is needed, or a pair (shape, pose)", i));
  return {nb::cast<const AnyShape&>(shape).model.shape(), pose};
}

Compound compound_of(nb::handle given) {
  std::vector<CompoundPart> parts;
  for (const nb::handle part : given) parts.push_back(part_of(part, parts.size()));
  return Compound(parts);
}

nb::list parts_of(const Parts& compound) {
  nb::list parts;
  const auto posed = shape_of<Compound>(compound).parts();
  for (std::size_t i = 0; i < posed.size(); ++i)
    parts.append(nb::make_tuple(shape_object(compound.model.parts()[i]), posed[i].pose));
  return parts;
}

HeightField height_field_of(nb::handle heights, nb::handle spacing) {
  const Doubles numbers = doubles(heights, "heights");
  const Doubles steps = doubles(spacing, "spacing");
  if (numbers.shape.size() != 2)
    throw Error(
        fmt::format("heights: an array of the shape (rows, columns) is needed, and what is given has the shape {}",
                    shape_text(numbers.shape)));
  if (!steps.has_shape(1, {2})) throw Error("spacing: two numbers are needed, along x and along y");
  const std::size_t rows = numbers.shape[0], columns = numbers.shape[1];
  return {static_cast<Index>(columns), static_cast<Index>(rows), steps.data[0], steps.data[1],
          std::span(numbers.data, rows * columns)};
}

nb::object heights_of(const HeightField& field) {
  std::vector<double> heights;
  for (Index row = 0; row < field.rows(); ++row)
    for (Index column = 0; column < field.columns(); ++column) heights.push_back(field.vertex(column, row).z);
  nb::object flat = array_over<double>(std::move(heights), {});
  return flat.attr("reshape")(field.rows(), field.columns());
}

nb::object vertex_array(const ConvexHull& hull) { return array_over<double>(vertices_of(hull), {3}); }

nb::object vertex_array(const Triangle& triangle) {
  return array_over<double>(std::vector<Vec3>(triangle.vertex.begin(), triangle.vertex.end()), {3});
}

void bind_triangle(nb::module_& module) {
  nb::class_<Triple, AnyShape> bound(
      module, "Triangle",
      "A triangle, which may be a segment or a point: a surface. Vertices of the shape (3, 3), "
      "in its own frame and any unit. Raises Error when a number is not finite.");
  bound
      .def(
          "__init__",
          [](Triple* place, const ArrayLike& vertices) {
            const Triangle triangle = triangle_of(vertices, "vertices");
            for (const Vec3& vertex : triangle.vertex)
              if (!is_finite(vertex)) throw Error("a vertex of a triangle is not finite");
            new (place) Triple{AnyShape{Model(triangle)}};
          },
          nb::arg("vertices"))
      .def_prop_ro("vertices", [](const Triple& t) { return nb::borrow<Floats>(vertex_array(shape_of<Triangle>(t))); })
      .def("__repr__",
           [](const Triple& t) {
             const Triangle& triangle = shape_of<Triangle>(t);
             return fmt::format("Triangle({})",
                                nb::cast<std::string>(nb::repr(nb::make_tuple(
                                    tuple_of(triangle[0]), tuple_of(triangle[1]), tuple_of(triangle[2])))));
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound, [](const Triple& t) { return nb::make_tuple(vertex_array(shape_of<Triangle>(t))); });
}

void bind_hull(nb::module_& module) {
  nb::class_<Hull, AnyShape> bound(
      module, "ConvexHull",
      "The convex hull of points of the shape (N, 3), in its own frame and any unit; exact (C. B. Barber, D. P. "
      "Dobkin, H. Huhdanpaa, \"The "
      "quickhull algorithm for convex hulls\", 1996). It may be flat, and is a surface then. It is made in one go: "
      "Ctrl-C is "
      "taken when it is done. "
      "Raises Error when there is no "
      "point, or one is not finite.");
  bound
      .def(
          "__init__",
          [](Hull* place, const ArrayLike& points) {
            const std::vector<Vec3> given = vectors_of(points, "points");
            Model model = without_lock([&] { return Model(ConvexHull(given)); });
            new (place) Hull{AnyShape{std::move(model)}};
          },
          nb::arg("points"))
      .def_prop_ro(
          "vertices", [](const Hull& hull) { return nb::borrow<Floats>(vertex_array(shape_of<ConvexHull>(hull))); },
          "Those of the points that are extreme, in their order, shape (N, 3): a new array.")
      .def_prop_ro(
          "dimension", [](const Hull& hull) { return shape_of<ConvexHull>(hull).dimension(); },
          "0: a point, 1: a segment, 2: a flat polygon, 3: a solid.")
      .def("__repr__",
           [](const Hull& hull) {
             return fmt::format("<toccata.ConvexHull of {} vertices>", shape_of<ConvexHull>(hull).vertex_count());
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound, [](const Hull& hull) { return nb::make_tuple(vertex_array(shape_of<ConvexHull>(hull))); });
}

void bind_height_field(nb::module_& module) {
  nb::class_<Field, AnyShape> bound(
      module, "HeightField",
      "A surface above a grid in the x-y plane of its own frame: the vertex of row j and column i is (i * spacing[0], "
      "j * spacing[1], "
      "heights[j, i]), in any unit. Heights of the shape (rows, columns), at least two of each. Raises Error when a "
      "number is not finite, or a spacing is not positive.");
  bound
      .def(
          "__init__",
          [](Field* place, const ArrayLike& heights, const ArrayLike& spacing) {
            const HeightField field = height_field_of(heights, spacing);
            Model model = without_lock([&] { return Model(field); });
            new (place) Field{AnyShape{std::move(model)}};
          },
          nb::arg("heights"), nb::arg("spacing") = nb::make_tuple(1.0, 1.0))
      .def_prop_ro(
          "heights", [](const Field& field) { return nb::borrow<Floats>(heights_of(shape_of<HeightField>(field))); },
          "Shape (rows, columns): a new array.")
      .def_prop_ro("spacing",
                   [](const Field& field) {
                     const HeightField& shape = shape_of<HeightField>(field);
                     return std::pair(shape.spacing_x(), shape.spacing_y());
                   })
      .def("__repr__",
           [](const Field& field) {
             const HeightField& shape = shape_of<HeightField>(field);
             return fmt::format("<toccata.HeightField of {} rows and {} columns>", shape.rows(), shape.columns());
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound, [](const Field& field) {
    const HeightField& shape = shape_of<HeightField>(field);
    return nb::make_tuple(heights_of(shape), nb::make_tuple(shape.spacing_x(), shape.spacing_y()));
  });
}

void bind_rounded(nb::module_& module) {
  const auto core = [](const Round& round) {
    return std::visit([](const auto& shape) { return shape_object(Model(shape)); }, shape_of<Rounded>(round).core());
  };
  nb::class_<Round, AnyShape> bound(
      module, "Rounded",
      "A point, segment, triangle, box or convex hull grown by a ball: all points within the radius "
      "of it, in the unit of the shape. Its pose may not deform it. Raises Error when the radius is not positive, and "
      "for another shape.");
  bound
      .def(
          "__init__",
          [](Round* place, const AnyShape& shape, double radius) {
            new (place) Round{AnyShape{Model(Rounded(core_of(shape.model.shape()), radius))}};
          },
          nb::arg("core"), nb::arg("radius"))
      .def_prop_ro("core", core, "The shape within.", nb::sig("def core(self) -> Shape"))
      .def_prop_ro("radius", [](const Round& round) { return shape_of<Rounded>(round).radius(); })
      .def("__repr__",
           [core](const Round& round) {
             return fmt::format("Rounded(core={}, radius={})", nb::cast<std::string>(nb::repr(core(round))),
                                nb::cast<std::string>(nb::repr(nb::float_(shape_of<Rounded>(round).radius()))));
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound,
                [core](const Round& round) { return nb::make_tuple(core(round), shape_of<Rounded>(round).radius()); });
}

void bind_compound(nb::module_& module) {
  nb::class_<Parts, AnyShape> bound(
      module, "Compound",
      "The union of shapes, each a shape or a pair (shape, pose) in the frame of the whole, in one unit; solid if all "
      "parts are. Raises Error when there is none, and for a pose that is not finite.");
  bound
      .def(
          "__init__",
          [](Parts* place, const nb::object& parts) {
            if (!nb::hasattr(parts, "__iter__"))
              throw Error("parts: a list of shapes is needed, or of pairs (shape, pose)");
            const Compound compound = compound_of(parts);
            Model model = without_lock([&] { return Model(compound); });
            new (place) Parts{AnyShape{std::move(model)}};
          },
          nb::arg("parts"),
          nb::sig("def __init__(self, parts: collections.abc.Iterable[Shape | tuple[Shape, toccata._typing.PoseLike | "
                  "None]]) -> None"))
      .def_prop_ro("parts", &parts_of, "Pairs (shape, pose).", nb::sig("def parts(self) -> list[tuple[Shape, Pose]]"))
      .def("__repr__",
           [](const Parts& compound) {
             return fmt::format("<toccata.Compound of {} parts>", shape_of<Compound>(compound).parts().size());
           })
      .attr("__hash__") = nb::none();
  bind_pickling(bound, [](const Parts& compound) { return nb::make_tuple(parts_of(compound)); });
}

void bind_base(nb::module_& module) {
  nb::class_<AnyShape> bound(
      module, "Shape",
      "What all shapes have in common. A shape is made once, may be shared by threads, and is asked about "
      "under any pose. Lengths have no unit: they come back in that of the numbers given.",
      nb::is_weak_referenceable());
  bound
      .def_prop_ro(
          "kind", [](const AnyShape& shape) { return std::string(name_of(shape.model.shape())); },
          "'sphere', 'convex hull', 'mesh' …")
      .def_prop_ro(
          "element_count", [](const AnyShape& shape) { return shape.model.element_count(); },
          "Triangles of a mesh or height field, of a compound those of its parts, else 1.")
      .def_prop_ro("face_count", [](const AnyShape& shape) { return shape.model.face_count(); })
      .def_prop_ro(
          "solid", [](const AnyShape& shape) { return taken_as_solid(shape.model, Solid::automatic); },
          "It has an interior, and is no mere surface.")
      .def(
          "__eq__",
          [](const AnyShape& a, const nb::object& other) {
            return nb::isinstance<AnyShape>(other) &&
                   equal(a.model.shape(), nb::cast<const AnyShape&>(other).model.shape());
          },
          nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"))
      .def("__repr__",
           [](const AnyShape& shape) { return fmt::format("<toccata.Shape: {}>", name_of(shape.model.shape())); });
  bind_copying(bound);
}

void bind_plain_shapes(nb::module_& module) {
  bind_described<Point>(
      module, "Point",
      "One point, shape (3,), in its own frame and any unit: a surface. Raises Error when a number is not finite.");
  bind_described<Segment>(module, "Segment",
                          "A segment between two points, shape (3,), in its own frame and any unit: a surface. Raises "
                          "Error when a number is "
                          "not finite.");
  bind_triangle(module);
  bind_described<Sphere>(module, "Sphere",
                         "A solid ball around a centre, shape (3,), in its own frame and any unit. Its pose may not "
                         "deform it. Raises Error when the "
                         "radius is not positive, or a number is not finite.");
  bind_described<Box>(
      module, "Box",
      "A solid box along the axes of its own frame; half extents, shape (3,), from the centre to the faces, in any "
      "unit. Raises Error when one is not positive, or a number is not finite.");
  bind_described<Capsule>(module, "Capsule",
                          "All points within the radius of a segment between two points, shape (3,), in its own frame "
                          "and any unit. Its pose may not "
                          "deform it. Raises Error when the radius is not positive, or a number is not finite.");
  bind_described<HalfSpace>(
      module, "HalfSpace",
      "All that lies on the side of a plane away from the normal, which may have any length but 0: solid, and "
      "without end. A point of the plane and the normal have the shape (3,), in its own frame and any unit. Its pose "
      "may not deform it. Raises Error when a number is not finite, or the normal is 0.");
  bind_described<Cylinder>(
      module, "Cylinder",
      "A solid cylinder around the z axis of its own frame from -half_height to half_height, in any unit. "
      "Raises Error when a number is not positive and finite.");
  bind_described<Cone>(
      module, "Cone",
      "A solid cone around the z axis of its own frame, its base at -half_height and its tip at half_height, in "
      "any unit. Raises Error when a number is not positive and finite.");
  bind_described<Ellipsoid>(
      module, "Ellipsoid",
      "A solid ellipsoid around the origin of its own frame, its half axes, shape (3,), along the axes, in any unit. "
      "Raises Error when one is not positive and finite.");
}

}  // namespace

std::string_view how_made(nb::handle given) {
  const bool is_mesh = nb::hasattr(given, "vertices") && nb::hasattr(given, "faces");
  return is_mesh ? "; toccata.Mesh(it) makes one of a mesh of trimesh or the like" : "";
}

Models models_of(nb::handle given, std::string_view what) {
  if (nb::isinstance<AnyShape>(given)) return {{nb::cast<const AnyShape&>(given).model}, true};
  if (!is_list(given)) throw Error(fmt::format("{}: a shape is needed, or a list of them{}", what, how_made(given)));
  Models models;
  for (const nb::handle shape : given) {
    if (!nb::isinstance<AnyShape>(shape))
      throw Error(fmt::format("{}: entry {} is no shape{}", what, models.each.size(), how_made(shape)));
    models.each.push_back(nb::cast<const AnyShape&>(shape).model);
  }
  return models;
}

nb::object shape_object(const Model& model) {
  return std::visit([&]<class S>(const S&) { return nb::cast(ShapeOf<S>{AnyShape{model}}); }, model.shape());
}

void bind_shapes(nb::module_& module) {
  nb::enum_<Solid>(module, "Solid", "What a mesh is taken for.")
      .value("automatic", Solid::automatic, "Closed meshes are solids, open ones surfaces.")
      .value("all", Solid::all, "It must be a solid: an open mesh is an error.")
      .value("none", Solid::none, "A surface.");
  bind_answer<MeshHealth>(module);
  bind_base(module);
  bind_plain_shapes(module);
  bind_hull(module);
  bind_rounded(module);
  bind_height_field(module);
  bind_mesh(module);
  bind_compound(module);
}

}  // namespace toccata::python
