#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "io/formats/number.hpp"
#include "io/formats/parse.hpp"
#include "io/formats/utf8.hpp"
#include "io/scenes/scene_parts.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata {
namespace io {
namespace {

/// The largest magnitude among the nine numbers that are no translation.
double largest_linear(const Pose& pose) {
  const std::array<double, 12> numbers = pose.numbers();
  double largest = 0;
  for (std::size_t i = 0; i < 9; ++i) largest = std::max(largest, std::abs(numbers[i]));
  return largest;
}

bool is_gltf_extension(std::string_view extension) { return extension == ".gltf" || extension == ".glb"; }

std::vector<NamedMesh> meshes_of(const SceneBytes& source, const std::string& extension, MeshFileIs mesh_file) {
  if (mesh_file == MeshFileIs::its_parts) return parse_mesh_parts(source.bytes, source.file, extension);
  std::vector<NamedMesh> one;
  one.push_back({"", parse_mesh(source.bytes, source.file, extension)});
  return one;
}

/// What is in a file of that extension (lower case, with its point) that is no scene file. `name` is that of a mesh.
Scene parse_shapes(const SceneBytes& source, const std::string& extension, const std::string& name,
                   MeshFileIs mesh_file) {
  if (is_gltf_extension(extension)) return parse_gltf(source);
  Scene scene;
  scene.unit = "unit";
  UniqueNames names;
  for (NamedMesh& part : meshes_of(source, extension, mesh_file)) {
    SceneObject object;
    object.name = names.make(part.name.empty() ? name : as_utf8(part.name));
    object.shape = std::make_shared<const TriangleMesh>(std::move(part.mesh));
    object.source = source.file;
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

}  // namespace

bool is_gltf(const std::filesystem::path& path) { return is_gltf_extension(lower_case_extension(path)); }

bool is_scale(double factor) { return factor > 0 && std::isnormal(factor); }

bool is_collapsed(const Pose& before, const Pose& after) {
  const double size = largest_linear(before);
  return size > 0 && largest_linear(after) < std::min(size, std::numeric_limits<double>::min());
}

std::string UniqueNames::make(const std::string& name) {
  std::string unique = name;
  int& uses = uses_[name];
  // A name with a number may itself be one that the file gives.
  for (++uses; uses > 1; ++uses) {
    unique = fmt::format("{} #{}", name, uses);
    if (uses_.emplace(unique, 1).second) break;
  }
  return unique;
}

Scene read_shapes(const std::filesystem::path& path, MeshFileIs mesh_file) {
  const FileBytes bytes = read_file(path);
  return parse_shapes({bytes.span(), path.string(), path.parent_path()}, lower_case_extension(path),
                      as_utf8(path.stem().string()), mesh_file);
}

Scene parse_file(const SceneBytes& source, const std::string& extension, const std::string& name,
                 MeshFileIs mesh_file) {
  if (extension == ".json") return parse_scene_file(source);
  return parse_shapes(source, extension, name, mesh_file);
}

}  // namespace io

namespace {

Scene generated_scene(const std::string& text) {
  const GeneratorSpecification specification = parse_generator(text);
  Scene scene;
  scene.unit = "unit";
  SceneObject object;
  object.name = specification.name;
  object.shape = std::make_shared<const TriangleMesh>(generate_mesh(specification.name, specification.parameters));
  object.source = "generated: " + text;
  scene.objects.push_back(std::move(object));
  return scene;
}

void check_options(const ReadOptions& options) {
  for (const double factor : {options.scale, options.metres_per_unit.value_or(1)})
    if (!(factor > 0) || !std::isfinite(factor))
      throw Error(fmt::format("a scale or unit must be positive and finite, and is {}", factor));
}

/// The unit times the scale.
double factor_of(const std::string& name, const ReadOptions& options) {
  const double metres = options.metres_per_unit.value_or(1), factor = metres * options.scale;
  if (!io::is_scale(factor))
    throw Error(
        fmt::format("{}: the unit {} times the scale {} is {}, which leaves no shape; change the options unit "
                    "or scale so that their product is between 1e-307 and 1e308",
                    name, metres, options.scale, factor));
  return factor;
}

/// What `read` gives, in the unit and with the scale of the options. `extension` is that of the file.
template <class Read>
Scene scene_as_asked(const std::string& name, const std::string& extension, const ReadOptions& options,
                     const Read& read) {
  check_options(options);
  if (extension == ".json" && options.metres_per_unit)
    throw Error(fmt::format("{}: a scene file states its units itself; change \"unit\" there", name));
  const double factor = factor_of(name, options);
  Scene scene = scaled(read(), factor);
  if (options.metres_per_unit) scene.unit = "m";
  return scene;
}

io::MeshFileIs mesh_file_of(const ReadOptions& options) {
  return options.split ? io::MeshFileIs::its_parts : io::MeshFileIs::one_object;
}

}  // namespace

Scene scaled(Scene scene, double factor) {
  if (factor == 1) return scene;
  const Pose larger = scaled(Pose{}, factor);
  for (SceneNode& node : scene.nodes)
    if (!node.parent) node.pose = larger * node.pose;
  for (SceneObject& object : scene.objects) {
    const Pose before = object.pose;
    object.pose = larger * before;
    if (keeps_its_form(object.shape)) {
      object.shape = scaled_in_itself(object.shape, factor);
      object.pose.linear = before.linear;
    }
    if (io::is_collapsed(before, object.pose))
      throw Error(
          fmt::format("{}: the object '{}' shrinks to nothing when it is scaled by {}; use a larger unit or scale",
                      object.source, object.name, factor));
    if (!is_finite(object.pose))
      throw Error(fmt::format("{}: the object '{}' grows beyond the doubles when it is scaled by {}", object.source,
                              object.name, factor));
  }
  return scene;
}

Scene read_scene(const std::string& path, const ReadOptions& options) {
  const bool is_generated = is_generator_specification(path);
  const std::string extension = is_generated ? "" : io::lower_case_extension(path);
  return scene_as_asked(path, extension, options, [&] {
    if (is_generated) return generated_scene(path);
    const std::filesystem::path file(path);
    const io::FileBytes bytes = io::read_file(file);
    return io::parse_file({bytes.span(), path, file.parent_path()}, extension, io::as_utf8(file.stem().string()),
                          mesh_file_of(options));
  });
}

Scene read_scene(const FileContent& content, const ReadOptions& options) {
  const std::string extension = "." + content.format;
  return scene_as_asked(content.name, extension, options, [&] {
    if (content.bytes.empty()) throw Error(content.name + ": there is nothing in it; is what writes it at fault?");
    return io::parse_file({content.bytes, content.name, ""}, extension, io::as_utf8(content.name),
                          mesh_file_of(options));
  });
}

double metres_per_unit(std::string_view unit) {
  static const std::map<std::string, double, std::less<>> known = {{"mm", 0.001}, {"cm", 0.01},   {"m", 1},
                                                                   {"km", 1000},  {"in", 0.0254}, {"ft", 0.3048}};
  if (const auto found = known.find(unit); found != known.end()) return found->second;
  const io::ParsedNumber number = io::parse_number(unit.data(), unit.data() + unit.size());
  if (number.fault != io::NumberFault::none || number.end != unit.data() + unit.size() || !(number.value > 0))
    throw Error(fmt::format("'{}' is not a unit; write mm, cm, m, km, in, ft, or a positive number of metres", unit));
  return number.value;
}

}  // namespace toccata
