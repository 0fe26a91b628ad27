#include "saved.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "named_files.hpp"
#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata::command {
namespace {

namespace fs = std::filesystem;

/// What one of the files holds, with its tree of nodes counted from its first.
Scene part_of(const LoadedScene& loaded, std::size_t file) {
  const auto from = [](auto& list, const std::vector<std::size_t>& first, std::size_t i) {
    return std::pair{list.begin() + static_cast<std::ptrdiff_t>(first[i]),
                     list.begin() + static_cast<std::ptrdiff_t>(first[i + 1])};
  };
  const auto objects = from(loaded.scene.objects, loaded.first_object, file);
  const auto nodes = from(loaded.scene.nodes, loaded.first_node, file);
  Scene part{{objects.first, objects.second}, {nodes.first, nodes.second}, loaded.units[file]};
  const auto first = static_cast<Index>(loaded.first_node[file]);
  for (SceneNode& node : part.nodes)
    if (node.parent) *node.parent -= first;
  for (SceneObject& object : part.objects)
    if (object.node) *object.node -= first;
  return part;
}

/// What is saved of the objects of each file, as they are asked about, and of their nodes where these are asked about
/// too.
std::vector<AskedFile> files_of(const LoadedScene& loaded, const std::vector<std::string>& names,
                                const SceneQuestion& question) {
  const bool has_nodes = std::holds_alternative<HierarchyQuestion>(question);
  const std::span<const SceneObject> objects = loaded.scene.objects;
  std::vector<AskedFile> files;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t first = loaded.first_object[i], end = loaded.first_object[i + 1];
    files.push_back({names[i], has_nodes ? content_digest(part_of(loaded, i))
                                         : content_digest(objects.subspan(first, end - first), loaded.units[i])});
  }
  return files;
}

PosedArguments arguments_of(const Asked& asked, const fs::path& folder, int threads) {
  PosedArguments arguments;
  for (const AskedFile& file : asked.files) arguments.input.files.push_back(file.name);
  arguments.input.folder = folder.string();
  arguments.input.unit = asked.unit;
  arguments.input.scale = asked.scale;
  arguments.input.split = asked.split;
  arguments.input.tessellation = asked.tessellation;
  arguments.input.close = asked.close;
  arguments.pose_a = asked.pose_a;
  arguments.pose_b = asked.pose_b;
  arguments.solid = asked.solid;
  arguments.threads = threads;
  return arguments;
}

/// The first of the files that is not there.
std::optional<fs::path> missing_file(const Asked& asked, const fs::path& folder) {
  for (const AskedFile& file : asked.files)
    if (file.name == standard_input)
      throw Error("it is about what standard input held, which is not kept; ask about a file");
  std::error_code trouble;  // of a name that is too long, say
  for (const AskedFile& file : asked.files)
    if (!is_generator_specification(file.name) && !fs::exists(folder / file.name, trouble)) return folder / file.name;
  return std::nullopt;
}

/// The first of the files that holds something else now.
std::optional<std::string> changed_file(const Asked& asked, const CheckInput& input,
                                        const std::vector<std::string>& names) {
  const std::vector<AskedFile> files = files_of(input.loaded, names, asked.question);
  for (std::size_t i = 0; i < files.size(); ++i)
    if (files[i].digest != asked.files[i].digest) return files[i].name;
  return std::nullopt;
}

/// What came of one folder: the input, or what is wrong there.
struct Attempt {
  std::optional<CheckInput> input;
  std::string trouble;
  bool has_files = true;
};

Attempt read_in(const fs::path& folder, const Asked& asked, int threads) {
  if (const auto missing = missing_file(asked, folder))
    return {{}, fmt::format("{} is gone; put it back, or ask again", missing->string()), false};
  const PosedArguments arguments = arguments_of(asked, folder, threads);
  CheckInput input = read_check_input(arguments);
  if (const auto changed = changed_file(asked, input, arguments.input.files))
    return {{},
            fmt::format("{} holds something else than when it was asked about (its digest is another); put the old "
                        "file back, or ask again",
                        (folder / *changed).string())};
  return {std::move(input), {}};
}

/// Whatever else is wrong in one folder, the files may be in the next.
Attempt attempt_in(const fs::path& folder, const Asked& asked, int threads) {
  try {
    return read_in(folder, asked, threads);
  } catch (const Error& error) {
    return {{}, error.what()};
  }
}

std::vector<fs::path> folders_of(const Asked& asked, const std::string& report) {
  std::error_code trouble;  // where the folder of now was deleted
  const fs::path beside = fs::absolute(report, trouble).parent_path().lexically_normal();
  if (asked.folder == beside) return {beside};
  return {beside, asked.folder};
}

}  // namespace

Asked asked_of(const CheckInput& input, const PosedArguments& arguments, const SceneQuestion& question) {
  return asked_of(files_of(input.loaded, arguments.input.files, question), arguments, question);
}

Asked asked_of(std::vector<AskedFile> files, const PosedArguments& arguments, const SceneQuestion& question) {
  std::error_code trouble;  // where it was deleted
  return {fs::current_path(trouble).string(),
          std::move(files),
          arguments.input.unit,
          arguments.input.scale,
          arguments.input.split,
          arguments.input.tessellation,
          arguments.input.close,
          arguments.pose_a,
          arguments.pose_b,
          arguments.solid,
          question};
}

CheckInput about_no_file() {
  CheckInput input;
  input.loaded.scene.unit = "unit";
  return input;
}

CheckInput read_again(const SavedReport& saved, const std::string& report, int threads) {
  if (saved.asked.files.empty()) return about_no_file();
  std::string trouble;
  bool had_files = false;
  for (const fs::path& folder : folders_of(saved.asked, report)) {
    Attempt attempt = attempt_in(folder, saved.asked, threads);
    if (attempt.has_files || !had_files) trouble = attempt.trouble;  // a changed file tells more than one that is gone
    had_files = had_files || attempt.has_files;
    if (!attempt.input) continue;
    std::vector<SceneObject>& objects = attempt.input->loaded.scene.objects;
    for (std::size_t i = 0; i < objects.size() && i < saved.sources.size(); ++i) objects[i].source = saved.sources[i];
    return std::move(*attempt.input);
  }
  throw Error(fmt::format("{}: {}", report, trouble));
}

}  // namespace toccata::command
