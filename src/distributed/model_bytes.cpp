#include "distributed/model_bytes.hpp"

#include <array>
#include <memory>
#include <tuple>
#include <variant>

namespace toccata {
namespace {

template <class S, std::size_t... I>
S get_described(MessageReader& reader, std::index_sequence<I...>) {
  using Values = std::tuple<std::decay_t<decltype((std::declval<S>().*std::get<I>(S::parameters).value)())>...>;
  const Values values{reader.get<std::tuple_element_t<I, Values>>()...};  // braces: from the first to the last
  return std::make_from_tuple<S>(values);
}

struct PutShape {
  template <DescribedShape S>
  void operator()(const S& shape) const {
    std::apply([&](const auto&... parameter) { (writer.put((shape.*parameter.value)()), ...); }, S::parameters);
  }
  void operator()(const Triangle& triangle) const { writer.put(triangle.vertex); }
  void operator()(const ConvexHull& hull) const {
    std::vector<Vec3> vertices;
    for (Index i = 0; i < hull.vertex_count(); ++i) vertices.push_back(hull.vertex(i));
    writer.put_all(std::span<const Vec3>(vertices));
  }
  void operator()(const Rounded& rounded) const {
    std::visit([&](const auto& core) { put_shape(writer, Shape(core)); }, rounded.core());
    writer.put(rounded.radius());
  }
  void operator()(const std::shared_ptr<const TriangleMesh>& mesh) const {
    writer.put_all(mesh->vertices());
    writer.put_all(mesh->triangles());
    std::vector<Index> faces;
    for (Index i = 0; i < mesh->triangle_count(); ++i) faces.push_back(mesh->face_of(i));
    writer.put_all(std::span<const Index>(faces));
  }
  void operator()(const Compound& compound) const {
    writer.put_number(compound.parts().size());
    for (const CompoundPart& part : compound.parts()) {
      put_shape(writer, part.shape);
      writer.put(part.pose);
    }
  }
  void operator()(const HeightField& field) const {
    std::vector<double> heights;
    for (Index row = 0; row < field.rows(); ++row)
      for (Index column = 0; column < field.columns(); ++column) heights.push_back(field.vertex(column, row).z);
    writer.put(std::array{field.columns(), field.rows()});
    writer.put(std::array{field.spacing_x(), field.spacing_y()});
    writer.put_all(std::span<const double>(heights));
  }

  MessageWriter& writer;
};

template <class S>
struct Of {};

struct GetShape {
  template <DescribedShape S>
  S operator()(Of<S>) const {
    return get_described<S>(reader, std::make_index_sequence<std::tuple_size_v<decltype(S::parameters)>>());
  }
  Triangle operator()(Of<Triangle>) const { return {reader.get<std::array<Vec3, 3>>()}; }
  ConvexHull operator()(Of<ConvexHull>) const { return ConvexHull(reader.get_all<Vec3>()); }
  Rounded operator()(Of<Rounded>) const {
    const Shape core = get_shape(reader);
    const auto radius = reader.get<double>();
    return std::visit(
        [&]<class S>(const S& shape) -> Rounded {
          if constexpr (std::is_constructible_v<Rounded::Core, const S&>)
            return Rounded(shape, radius);
          else
            throw Error("a message between ranks has a rounded shape without a core");
        },
        core);
  }
  std::shared_ptr<const TriangleMesh> operator()(Of<std::shared_ptr<const TriangleMesh>>) const {
    std::vector<Vec3> vertices = reader.get_all<Vec3>();
    std::vector<std::array<Index, 3>> triangles = reader.get_all<std::array<Index, 3>>();
    return std::make_shared<const TriangleMesh>(std::move(vertices), std::move(triangles), reader.get_all<Index>());
  }
  Compound operator()(Of<Compound>) const {
    std::vector<CompoundPart> parts;
    for (std::uint64_t count = reader.get_number(); count > 0; --count) {
      Shape shape = get_shape(reader);
      parts.push_back({std::move(shape), reader.get<Pose>()});
    }
    return Compound(parts);
  }
  HeightField operator()(Of<HeightField>) const {
    const auto [columns, rows] = reader.get<std::array<Index, 2>>();
    const auto [spacing_x, spacing_y] = reader.get<std::array<double, 2>>();
    return HeightField(columns, rows, spacing_x, spacing_y, reader.get_all<double>());
  }

  MessageReader& reader;
};

/// The alternative with that number.
template <std::size_t Kind = 0>
Shape get_shape_of(std::size_t kind, MessageReader& reader) {
  if constexpr (Kind == std::variant_size_v<Shape>) {
    throw Error("a message between ranks has a shape of no kind");
  } else {
    if (kind == Kind) return Shape(GetShape{reader}(Of<std::variant_alternative_t<Kind, Shape>>()));
    return get_shape_of<Kind + 1>(kind, reader);
  }
}

}  // namespace

void put_shape(MessageWriter& writer, const Shape& shape) {
  writer.put(static_cast<std::uint8_t>(shape.index()));
  std::visit(PutShape{writer}, shape);
}

Shape get_shape(MessageReader& reader) { return get_shape_of(reader.get<std::uint8_t>(), reader); }

const void* ModelStore::identity_of(const Shape& shape) {
  if (const auto* hull = std::get_if<ConvexHull>(&shape)) return hull->padded_coordinates(0).data();
  if (const auto* compound = std::get_if<Compound>(&shape)) return compound->parts().data();
  return mesh_of(shape).get();
}

ModelStore::Name ModelStore::name_of(const Model& model, const void* identity) {
  const auto found = names_.find(identity);
  if (found != names_.end()) return found->second;
  const Name name{rank_, named_++};
  names_.emplace(identity, name);
  models_.emplace(name, model);  // as long as it is kept nothing else comes to be where its parts are
  return name;
}

/// A small model has none, in a byte.
void ModelStore::put_name(MessageWriter& writer, const Name& name) {
  writer.put_number(static_cast<std::uint64_t>(name.rank + 1));
  if (name.rank >= 0) writer.put_number(name.number);
}

ModelStore::Name ModelStore::get_name(MessageReader& reader) {
  Name name;
  name.rank = static_cast<std::int32_t>(reader.get_number()) - 1;
  if (name.rank >= 0) name.number = static_cast<std::uint32_t>(reader.get_number());
  return name;
}

void ModelStore::put_whole(MessageWriter& writer, const Model& model) {
  put_name(writer, {});
  put_shape(writer, model.shape());
}

void ModelStore::put(MessageWriter& writer, const Model& model, int to) {
  const void* identity = identity_of(model.shape());
  if (identity == nullptr) {
    put_whole(writer, model);
    return;
  }
  const Name name = name_of(model, identity);
  const bool is_new = to != rank_ && sent_.emplace(to, name).second;
  put_name(writer, name);
  writer.put(is_new);
  if (is_new) put_shape(writer, model.shape());
}

Model ModelStore::get(MessageReader& reader) {
  const Name name = get_name(reader);
  if (name.rank < 0) return Model(get_shape(reader));
  if (reader.get<bool>()) {
    // Several ranks may send the same.
    Model model(get_shape(reader));
    const auto [place, is_new] = models_.emplace(name, std::move(model));
    if (is_new) names_.emplace(identity_of(place->second.shape()), name);
  }
  return models_.at(name);
}

}  // namespace toccata
