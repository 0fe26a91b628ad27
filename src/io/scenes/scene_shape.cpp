#include "io/scenes/scene_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/formats/number_rows.hpp"
#include "io/formats/pose_text.hpp"
#include "toccata/core/error.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata::io {
namespace {

Mat3 rotation_of(const JsonValue& value) {
  value.expect_keys({"axis", "degrees", "quaternion"});
  if (!value.has("quaternion"))
    return located(value, [&] { return rotation_about(value.at("axis").vector(), value.at("degrees").number()); });
  if (value.has("axis") || value.has("degrees"))
    value.fail("there is a quaternion and an axis or an angle", "keep one of the two");
  const std::vector<double> q = value.at("quaternion").numbers(4);
  return located(value, [&] { return toccata::rotation_of(Quaternion{q[0], q[1], q[2], q[3]}); });
}

/// The value of a parameter of a shape, as its constructor takes it.
template <class S>
double read_parameter(const JsonValue& shape, const ShapeParameter<S, double>& parameter) {
  if (parameter.when_left_out == WhenLeftOut::zero && !shape.has(parameter.name)) return 0;
  return shape.at(parameter.name).number();
}
template <class S>
Vec3 read_parameter(const JsonValue& shape, const ShapeParameter<S, const Vec3&>& parameter) {
  if (parameter.when_left_out == WhenLeftOut::zero && !shape.has(parameter.name)) return {};
  return shape.at(parameter.name).vector();
}

std::vector<Vec3> points_of(const JsonValue& list) {
  std::vector<Vec3> points;
  const std::vector<double> numbers = rows_of_numbers(list, 3, "point");
  for (std::size_t i = 0; i < numbers.size(); i += 3) points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return points;
}

/// The shape S of these numbers; what is wrong with them is said to be at `place`.
template <class S, class... Arguments>
Shape made(const JsonValue& place, const Arguments&... arguments) {
  return located(place, [&] { return Shape(S(arguments...)); });
}

/// Reads a shape, and the shapes in it.
class ShapeReader {
 public:
  ShapeReader(const MeshReading& read_mesh, int depth) : read_mesh_(read_mesh), depth_(depth) {}

  [[nodiscard]] Shape read(const JsonValue& value) const {
    using Reading = Shape (ShapeReader::*)(const JsonValue&) const;
    static const std::map<std::string, Reading, std::less<>> readings = all_readings<Reading>();
    const std::string type = value.at("type").text();
    const auto found = readings.find(type);
    if (found != readings.end()) return (this->*found->second)(value);
    std::vector<std::string> known;
    for (const auto& [name, reading] : readings) known.push_back(name);
    const std::string near = nearest_word(type, known);
    value.at("type").fail(fmt::format("there is no type of shape '{}'", type),
                          near.empty() ? "see docs/reference/scene-file.md" : fmt::format("did you mean '{}'?", near));
  }

 private:
  template <class Reading>
  [[nodiscard]] static std::map<std::string, Reading, std::less<>> all_readings() {
    std::map<std::string, Reading, std::less<>> readings = {{"triangle", &ShapeReader::triangle},
                                                            {"convex-hull", &ShapeReader::convex_hull},
                                                            {"rounded", &ShapeReader::rounded},
                                                            {"height-field", &ShapeReader::height_field},
                                                            {"compound", &ShapeReader::compound}};
    AllShapes::for_each([&]<class S>(std::type_identity<S>) {
      if constexpr (DescribedShape<S>) readings.emplace(S::name, &ShapeReader::described<S>);
    });
    return readings;
  }

  template <DescribedShape S>
  [[nodiscard]] Shape described(const JsonValue& value) const {
    const auto read_all = [&value](const auto&... parameters) {
      value.expect_keys({"type", parameters.name...});
      // Braces, so that the first that is wrong is told.
      const std::tuple values{read_parameter(value, parameters)...};
      return std::apply([&value](const auto&... numbers) { return made<S>(value, numbers...); }, values);
    };
    return std::apply(read_all, S::parameters);
  }

  [[nodiscard]] Shape triangle(const JsonValue& value) const {
    value.expect_keys({"type", "vertices"});
    const std::vector<Vec3> vertices = points_of(value.at("vertices"));
    if (vertices.size() != 3)
      value.at("vertices")
          .fail(fmt::format("a triangle has three vertices, and here are {}", vertices.size()),
                "write three, or \"convex-hull\"");
    return Triangle{{vertices[0], vertices[1], vertices[2]}};
  }
  [[nodiscard]] Shape convex_hull(const JsonValue& value) const {
    value.expect_keys({"type", "points", "file"});
    if (value.has("points") == value.has("file"))
      value.fail("a hull is of points or of the vertices of a file", "write either \"points\" or \"file\"");
    if (!value.has("file")) return made<ConvexHull>(value, points_of(value.at("points")));
    return made<ConvexHull>(value, read_mesh_(value)->vertices());
  }
  [[nodiscard]] Shape rounded(const JsonValue& value) const {
    value.expect_keys({"type", "core", "radius"});
    const Shape core = inner(value.at("core"));
    const double radius = value.at("radius").number();
    if (const auto* shape = std::get_if<Point>(&core)) return made<Rounded>(value, *shape, radius);
    if (const auto* shape = std::get_if<Segment>(&core)) return made<Rounded>(value, *shape, radius);
    if (const auto* shape = std::get_if<Triangle>(&core)) return made<Rounded>(value, *shape, radius);
    if (const auto* shape = std::get_if<Box>(&core)) return made<Rounded>(value, *shape, radius);
    if (const auto* shape = std::get_if<ConvexHull>(&core)) return made<Rounded>(value, *shape, radius);
    value.at("core").fail(fmt::format("a {} cannot be the core of a rounded shape", name_of(core)),
                          "use a point, segment, triangle, box or convex-hull");
  }
  [[nodiscard]] Shape height_field(const JsonValue& value) const {
    value.expect_keys({"type", "columns", "rows", "spacing", "heights"});
    constexpr std::size_t most = 1U << 20;
    const std::vector<double> spacing = value.at("spacing").numbers(2);
    const std::vector<double> heights = rows_of_numbers(value.at("heights"), 1, "height");
    const auto columns = static_cast<Index>(value.at("columns").whole(most)),
               rows = static_cast<Index>(value.at("rows").whole(most));
    return made<HeightField>(value, columns, rows, spacing[0], spacing[1], heights);
  }
  [[nodiscard]] Shape compound(const JsonValue& value) const {
    value.expect_keys({"type", "parts"});
    std::vector<CompoundPart> parts;
    for (const JsonValue& part : value.at("parts").elements()) {
      part.expect_keys({"shape", "file", "mesh", "pose"});
      if (part.has("shape") + part.has("file") + part.has("mesh") != 1)
        part.fail("a part needs one shape", "write one of \"shape\", \"file\" and \"mesh\"");
      Shape shape = part.has("shape") ? inner(part.at("shape")) : Shape(read_mesh_(part));
      if (!part.has("pose")) {
        parts.push_back({std::move(shape), {}});
        continue;
      }
      const ScaledPose placed = pose_of(part.at("pose"));
      if (keeps_its_form(shape))
        parts.push_back({located(part, [&] { return scaled_in_itself(shape, placed.scale); }),
                         {placed.unscaled, placed.pose.offset}});
      else
        parts.push_back({std::move(shape), placed.pose});
    }
    return made<Compound>(value, parts);
  }

  [[nodiscard]] Shape inner(const JsonValue& value) const {
    constexpr int deepest = 32;
    if (depth_ == deepest) value.fail("shapes are nested more than 32 deep", "write them side by side");
    return ShapeReader(read_mesh_, depth_ + 1).read(value);
  }

  const MeshReading& read_mesh_;
  int depth_;
};

Json parameter_json(double number) { return number; }
Json parameter_json(const Vec3& v) { return json_of(v); }

/// Writes a shape, and the shapes in it.
class ShapeWriter {
 public:
  explicit ShapeWriter(const MeshWriting& write_mesh) : write_mesh_(write_mesh) {}

  template <DescribedShape S>
  Json operator()(const S& shape) const {
    Json json = {{"type", S::name}};
    const auto write = [&](const auto& parameter) {
      json[parameter.name] = parameter_json((shape.*parameter.value)());
    };
    std::apply([&](const auto&... parameters) { (write(parameters), ...); }, S::parameters);
    return json;
  }
  Json operator()(const Triangle& t) const {
    return {{"type", "triangle"}, {"vertices", Json::array({json_of(t[0]), json_of(t[1]), json_of(t[2])})}};
  }
  Json operator()(const ConvexHull& hull) const {
    Json points = Json::array();
    for (Index i = 0; i < hull.vertex_count(); ++i) points.push_back(json_of(hull.vertex(i)));
    return {{"type", "convex-hull"}, {"points", std::move(points)}};
  }
  Json operator()(const Rounded& s) const {
    return {{"type", "rounded"}, {"core", std::visit(*this, s.core())}, {"radius", s.radius()}};
  }
  Json operator()(const HeightField& field) const {
    Json heights = Json::array();
    for (Index row = 0; row < field.rows(); ++row)
      for (Index column = 0; column < field.columns(); ++column) heights.push_back(field.vertex(column, row).z);
    return {{"type", "height-field"},
            {"columns", field.columns()},
            {"rows", field.rows()},
            {"spacing", Json::array({field.spacing_x(), field.spacing_y()})},
            {"heights", std::move(heights)}};
  }
  Json operator()(const std::shared_ptr<const TriangleMesh>& mesh) const { return write_mesh_(mesh); }
  Json operator()(const Compound& compound) const {
    Json parts = Json::array();
    for (const CompoundPart& part : compound.parts()) {
      const Json shape = std::visit(*this, part.shape);
      Json entry = shape.contains("type") ? Json{{"shape", shape}} : shape;
      if (!is_left_out(part.pose)) entry["pose"] = part.pose.numbers();
      parts.push_back(std::move(entry));
    }
    return {{"type", "compound"}, {"parts", std::move(parts)}};
  }

 private:
  const MeshWriting& write_mesh_;
};

}  // namespace

void fail_at(const JsonValue& place, const Error& error) {
  const std::string message = error.what();
  const std::size_t end = message.rfind("; ");
  if (end == std::string::npos) place.fail(message, "correct it");
  place.fail(message.substr(0, end), message.substr(end + 2));
}

bool is_left_out(const Pose& pose) {
  using Bits = std::array<std::uint64_t, 12>;
  return std::bit_cast<Bits>(pose.numbers()) == std::bit_cast<Bits>(Pose{}.numbers());
}

ScaledPose pose_of(const JsonValue& value) {
  if (value.is_array()) {
    const std::size_t count = value.elements().size();
    const FailPose fail = [&](const std::string& what, const std::string& advice) { value.fail(what, advice); };
    const Pose pose = pose_of_numbers(value.numbers(is_count_of_pose(count) ? count : 12), fail);
    return {pose, pose.linear, 1};
  }
  value.expect_keys({"translation", "rotation", "scale"});
  const Vec3 translation = value.has("translation") ? value.at("translation").vector() : Vec3{};
  const Mat3 rotation = value.has("rotation") ? rotation_of(value.at("rotation")) : Mat3{};
  if (!value.has("scale")) return {toccata::pose_of(translation, rotation, {1, 1, 1}), rotation, 1};
  const JsonValue scale = value.at("scale");
  if (!scale.is_number()) {
    const Pose pose = toccata::pose_of(translation, rotation, scale.vector());
    return {pose, pose.linear, 1};
  }
  const double s = scale.number();
  const Pose pose = toccata::pose_of(translation, rotation, {s, s, s});
  // A mirror or a collapse is no scale of a length.
  return s > 0 ? ScaledPose{pose, rotation, s} : ScaledPose{pose, pose.linear, 1};
}

Shape shape_of(const JsonValue& value, const MeshReading& read_mesh) { return ShapeReader(read_mesh, 0).read(value); }

Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const Shape& shape, const MeshWriting& write_mesh) { return std::visit(ShapeWriter(write_mesh), shape); }

std::string type_of(const Shape& shape) {
  if (std::holds_alternative<Rounded>(shape)) return "rounded";
  std::string type(name_of(shape));
  std::ranges::replace(type, ' ', '-');
  return type;
}

}  // namespace toccata::io
