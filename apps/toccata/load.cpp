#include "load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <variant>

#include "converted.hpp"
#include "free_names.hpp"
#include "memory.hpp"
#include "named_files.hpp"
#include "output.hpp"
#include "progress_bar.hpp"
#include "temporary_folder.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/generate/meshes.hpp"
#include "toccata/io/query_files.hpp"
#include "toccata/io/scene_file.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

double parse_double(const std::string& word, const std::string& option) {
  const bool plain = word.find_first_not_of("+-.0123456789eE") == std::string::npos;
  char* end = nullptr;
  const double value = plain ? std::strtod(word.c_str(), &end) : 0;
  if (!plain || word.empty() || end != word.c_str() + word.size() || !std::isfinite(value))
    throw Error(fmt::format("{}: '{}' is not a finite number", option, word));
  return value;
}

ReadOptions read_options(const InputArguments& input) {
  ReadOptions options;
  if (!input.unit.empty()) options.metres_per_unit = metres_per_unit(input.unit);
  options.scale = input.scale;
  options.split = input.split;
  return options;
}

constexpr const char* name_of_standard_input = "standard input";

/// What is read by another program or library is a file for it.
ConvertedScene converted_standard_input(const std::string& text, const std::string& format,
                                        const Conversion& conversion) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / ("input." + format)).string();
  std::ofstream(path, std::ios::binary) << text;
  const auto as_input = [&](std::string words) {
    for (std::size_t at = words.find(path); at != std::string::npos; at = words.find(path))
      words.replace(at, path.size(), name_of_standard_input);
    return words;
  };
  try {
    ConvertedScene read = read_converted(path, conversion);
    for (SceneObject& object : read.scene.objects) object.source = as_input(object.source);
    for (std::string& note : read.notes) note = as_input(note);
    return read;
  } catch (const Error& error) {
    throw Error(as_input(error.what()));
  }
}

ConvertedScene read_standard_input_as(const std::string& format, const ReadOptions& options,
                                      const Conversion& conversion) {
  const std::string text = read_standard_input();
  if (!text.empty() && is_converted("input." + format)) return converted_standard_input(text, format, conversion);
  return {read_scene({text, name_of_standard_input, format}, options), {}};
}

/// Meshes that are equal to the bit become one, so that they share a tree: copies of a bolt, each in a file.
class SharedMeshes {
 public:
  void share(Scene& scene) {
    for (SceneObject& object : scene.objects)
      if (auto* mesh = std::get_if<std::shared_ptr<const TriangleMesh>>(&object.shape)) *mesh = known(*mesh);
  }

 private:
  using Mesh = std::shared_ptr<const TriangleMesh>;

  template <class Element>
  static bool same_bits(std::span<const Element> a, std::span<const Element> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
  }

  static bool are_equal(const TriangleMesh& a, const TriangleMesh& b) {
    if (!same_bits(a.vertices(), b.vertices()) || !same_bits(a.triangles(), b.triangles())) return false;
    for (Index i = 0; i < a.triangle_count(); ++i)
      if (a.face_of(i) != b.face_of(i)) return false;
    return true;
  }

  Mesh known(const Mesh& mesh) {
    std::vector<Mesh>& alike = known_[{mesh->vertices().size(), mesh->triangles().size()}];
    for (const Mesh& other : alike)
      if (other == mesh || are_equal(*other, *mesh)) return other;
    alike.push_back(mesh);
    return mesh;
  }

  std::map<std::array<std::size_t, 2>, std::vector<Mesh>> known_;  ///< by the numbers of vertices and triangles
};

fs::path path_of(const std::string& file, const std::string& folder) {
  return folder.empty() || is_generator_specification(file) ? fs::path(file) : fs::path(folder) / file;
}

std::string unit_text(const std::string& file, const Scene& scene) {
  return scene.unit == "unit" ? file + " states no unit" : fmt::format("{} has the unit {}", file, scene.unit);
}

/// The files, each once.
std::vector<std::string> different_files(const std::vector<std::string>& files) {
  std::vector<std::string> different;
  std::set<std::string> known;
  for (const std::string& file : files)
    if (known.insert(file).second) different.push_back(file);
  return different;
}

/// Tells how much of all files is read whenever one of them is.
class FilesRead {
 public:
  FilesRead(const std::vector<fs::path>& files, Progress tell) : tell_(std::move(tell)) {
    for (const fs::path& file : files) {
      std::error_code code;
      const auto bytes = fs::file_size(file, code);
      megabytes_.push_back(code ? 0 : static_cast<std::size_t>(bytes / 1'000'000));
      total_ += megabytes_.back();
    }
    tell_(0, total_);
  }

  void finished(std::size_t file) {
    const std::lock_guard lock(mutex_);
    done_ += megabytes_[file];
    tell_(done_, total_);
  }

 private:
  Progress tell_;
  std::vector<std::size_t> megabytes_;
  std::size_t total_ = 0, done_ = 0;
  std::mutex mutex_;
};

/// What one of the files holds, whatever its format.
ConvertedScene read_as_it_is(const std::string& file, const fs::path& path, const InputArguments& input,
                             const ReadOptions& options) {
  const Conversion conversion{options.scale, input.tessellation, options.metres_per_unit};
  if (file == standard_input) return read_standard_input_as(input.format, options, conversion);
  if (is_converted(path.string())) return read_converted(path.string(), conversion);
  return {read_scene(path.string(), options), {}};
}

/// One whose extension tells its format.
std::string name_with_format(const std::string& file, const InputArguments& input) {
  return file == standard_input ? "input." + input.format : file;
}

bool has_its_own_unit(const std::string& file, const InputArguments& input) {
  return states_its_unit(name_with_format(file, input));
}

/// The reader of a curved file tells how near its triangles are.
void warn_of_idle_tessellation(LoadedScene& loaded, const InputArguments& input) {
  const auto is_curved = [&](const std::string& file) { return may_be_curved(name_with_format(file, input)); };
  if (input.tessellation.empty() || std::any_of(input.files.begin(), input.files.end(), is_curved)) return;
  loaded.warnings.push_back(
      fmt::format("--tessellation {} changes nothing: it is about the curved faces of STEP and IFC files, and none of "
                  "the files is such",
                  input.tessellation));
}

/// Of the unit of a scene, which is no "unit".
double metres_of(std::string_view unit) {
  if (unit.ends_with(" m")) unit.remove_suffix(2);  // metres per unit, as a number
  return metres_per_unit(unit);
}

using ScenesRead = std::map<std::string, ConvertedScene>;

bool states_unit(const ScenesRead::value_type& read) { return read.second.scene.unit != "unit"; }

/// Which two files state different units, and which; empty where none do.
std::string different_units(const ScenesRead& read) {
  const auto first = std::find_if(read.begin(), read.end(), states_unit);
  const auto other = std::find_if(first, read.end(), [&](const ScenesRead::value_type& one) {
    return states_unit(one) && metres_of(one.second.scene.unit) != metres_of(first->second.scene.unit);
  });
  if (other == read.end()) return {};
  return fmt::format("{} and {}", unit_text(first->first, first->second.scene),
                     unit_text(other->first, other->second.scene));
}

/// In whatever order they are named.
void make_units_equal(ScenesRead& read) {
  const std::string why = why_metres(read);
  if (why.empty()) return;
  for (auto& [file, one] : read) make_metres(one, file, why);
}

/// The scenes of all files, several at once; one that is named twice is read once.
ScenesRead read_all(const InputArguments& input) {
  const std::vector<std::string> files = different_files(input.files);
  std::vector<fs::path> paths;
  for (const std::string& file : files) paths.push_back(path_of(file, input.folder));
  require_memory(paths);
  std::vector<ConvertedScene> scenes(files.size());
  // An end that is asked for waits until the programs that read for this one are ended, and their files are gone.
  std::optional<UninterruptedWriting> reading;
  const auto takes_program = [&](const std::string& file) { return is_read_by_program(name_with_format(file, input)); };
  if (std::any_of(files.begin(), files.end(), takes_program)) reading.emplace();
  ProgressBar bar("MB read");
  FilesRead progress(paths, bar.callback());
  parallel_for(files.size(), input.threads, [&](std::size_t i) {
    scenes[i] = read_file(files[i], input);
    progress.finished(i);
  });
  ScenesRead read;
  for (std::size_t i = 0; i < files.size(); ++i) read.emplace(files[i], std::move(scenes[i]));
  make_units_equal(read);
  return read;
}

/// Appends `part` to `whole`; its node and parent numbers move with it.
void append(Scene& whole, const Scene& part, const std::string& file, bool file_is_new, FreeNames& names) {
  const Index node_offset = static_cast<Index>(whole.nodes.size());
  for (SceneNode node : part.nodes) {
    if (node.parent) *node.parent += node_offset;
    whole.nodes.push_back(std::move(node));
  }
  for (SceneObject object : part.objects) {
    if (object.node) *object.node += node_offset;
    object.name = names.take(object.name, file, file_is_new);
    whole.objects.push_back(std::move(object));
  }
}

/// What --unit and --scale multiply coordinates by, where that rounds them: by no power of two.
std::string rounding_factor(const InputArguments& input) {
  const double factor = (input.unit.empty() ? 1 : metres_per_unit(input.unit)) * input.scale;
  int exponent = 0;
  return std::frexp(factor, &exponent) == 0.5 ? "" : fmt::format("{}", factor);
}

template <std::size_t count>
std::array<double, count> parse_doubles(const std::vector<std::string>& words, const std::string& option,
                                        std::string_view what) {
  if (words.size() != count) throw Error(fmt::format("{} takes {}; here are {}", option, what, words.size()));
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) numbers[i] = parse_double(words[i], option);
  return numbers;
}

}  // namespace

void require_use_of_unit(const InputArguments& input) {
  const auto states = [&](const std::string& file) { return has_its_own_unit(file, input); };
  if (!input.unit.empty() && std::all_of(input.files.begin(), input.files.end(), states))
    throw Error(fmt::format("{}: the file states its unit itself: leave out --unit", input.files.front()));
}

ConvertedScene read_file(const std::string& file, const InputArguments& input) {
  const fs::path path = path_of(file, input.folder);
  ReadOptions options = read_options(input);
  if (!options.metres_per_unit || !has_its_own_unit(file, input)) return read_as_it_is(file, path, input, options);
  options.metres_per_unit.reset();
  ConvertedScene read = read_as_it_is(file, path, input, options);
  make_metres(read, file, "for the sake of --unit");
  return read;
}

void make_metres(ConvertedScene& read, const std::string& file, std::string_view why) {
  const std::string unit = read.scene.unit;
  if (unit == "unit")
    throw Error(
        fmt::format("{}: its unit is \"unit\", which is no length that could become the metres of --unit; "
                    "change \"unit\" there, or leave out --unit",
                    file));
  read.scene = scaled(std::move(read.scene), metres_of(unit));
  read.scene.unit = "m";
  if (unit != "m")
    read.notes.push_back(
        fmt::format("{}: its unit is {}; {} its numbers are made metres and rounded to doubles: "
                    "what touches or fits exactly there may not any more",
                    file, unit, why));
}

std::string why_metres(const std::map<std::string, ConvertedScene>& read) {
  const std::string stated = different_units(read);
  if (stated.empty()) return {};
  const auto none = std::find_if_not(read.begin(), read.end(), states_unit);
  if (none != read.end())
    throw Error(fmt::format("{} states no unit, and {}: say with --unit what its numbers are", none->first, stated));
  return fmt::format("since {},", stated);
}

LoadedScene joined(const InputArguments& input, const std::map<std::string, ConvertedScene>& read) {
  LoadedScene loaded;
  loaded.warnings = input.warnings;
  const auto stated = std::find_if(read.begin(), read.end(), states_unit);
  loaded.scene.unit = stated == read.end() ? "unit" : stated->second.scene.unit;
  FreeNames names;
  std::set<std::string> known;
  for (const std::string& file : input.files) {
    const bool file_is_new = known.insert(file).second;
    loaded.first_object.push_back(loaded.scene.objects.size());
    loaded.first_node.push_back(loaded.scene.nodes.size());
    const Scene& scene = read.at(file).scene;
    if (file_is_new)
      loaded.warnings.insert(loaded.warnings.end(), read.at(file).notes.begin(), read.at(file).notes.end());
    loaded.units.push_back(scene.unit);
    if (file_is_new && scene.unit != loaded.scene.unit)
      loaded.warnings.push_back(
          fmt::format("{} states no unit, and {}: its numbers are taken for {}, too; say with --unit what they are",
                      file, unit_text(stated->first, stated->second.scene), loaded.scene.unit));
    append(loaded.scene, scene, file, file_is_new, names);
  }
  SharedMeshes().share(loaded.scene);
  loaded.first_object.push_back(loaded.scene.objects.size());
  loaded.first_node.push_back(loaded.scene.nodes.size());
  warn_of_idle_tessellation(loaded, input);
  for (std::string& warning : scale_warnings(loaded.scene)) loaded.warnings.push_back(std::move(warning));
  loaded.scaled_by = rounding_factor(input);
  return loaded;
}

LoadedScene load(const InputArguments& input) {
  if (input.files.empty()) throw Error("no file was named: name " + input.wanted);
  require_use_of_unit(input);
  return joined(input, read_all(input));
}

Pose parse_pose(const std::vector<std::string>& words, const std::string& option) {
  try {
    return pose_from_text(fmt::format("{}", fmt::join(words, " ")));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", option, error.what()));
  }
}

Vec3 parse_point(const std::vector<std::string>& words, const std::string& option) {
  const auto [x, y, z] = parse_doubles<3>(words, option, "three numbers");
  return {x, y, z};
}

Aabb parse_box(const std::vector<std::string>& words, const std::string& option) {
  const auto n = parse_doubles<6>(words, option, "six numbers, the least corner and then the greatest");
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (n[axis] > n[axis + 3])
      throw Error(
          fmt::format("{}: the box is empty, its {} goes from {} to {}; give the least corner and then the greatest",
                      option, "xyz"[axis], n[axis], n[axis + 3]));
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

Ball parse_ball(const std::vector<std::string>& words, const std::string& option) {
  const auto n = parse_doubles<4>(words, option, "four numbers, the centre and then the radius");
  if (n[3] < 0) throw Error(fmt::format("{}: the radius is {}; give a radius of 0 or more", option, n[3]));
  return {{n[0], n[1], n[2]}, n[3]};
}

}  // namespace toccata::command
