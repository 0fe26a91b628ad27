#include <nanobind/nanobind.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <toccata/core/error.hpp>
#include <toccata/reports/pages.hpp>

#include "calls.hpp"
#include "scenes.hpp"
#include "shapes.hpp"

namespace toccata::python {
namespace {

/// The objects as a scene, those without a name called by what they are and their number.
Scene scene_of(std::span<const SceneInstance> instances) {
  Scene scene;
  for (const SceneInstance& instance : instances) {
    const Shape& shape = instance.model.shape();
    std::string name =
        instance.name.empty() ? fmt::format("{} {}", name_of(shape), scene.objects.size()) : instance.name;
    scene.objects.push_back(
        {std::move(name), shape, instance.pose, instance.solid, instance.group, std::nullopt, "Python"});
  }
  return scene;
}

UpAxis up_of(const std::string& up) {
  if (up == "y") return UpAxis::y;
  if (up == "z") return UpAxis::z;
  throw Error(fmt::format("up: 'y' or 'z' is needed, and not '{}'", up));
}

std::string page_of(std::vector<SceneInstance> instances, const CheckQuestion& question, const ViewOptions& view,
                    const BatchOptions& options) {
  const Scene scene = scene_of(instances);
  for (std::size_t i = 0; i < instances.size(); ++i) instances[i].name = scene.objects[i].name;
  const SceneAnswer answer = ask(scene, instances, question, {options.threads, options.progress});
  return view_page(scene, instances, answer, view);
}

}  // namespace

void bind_pages(nb::module_& module) {
  module.def(
      "view_page",
      [](const ObjectsLike& objects, const std::string& title, const std::string& up, bool faces, bool penetration,
         std::optional<double> clearance, int threads) {
        std::vector<SceneInstance> instances = instances_of(objects, "objects");
        CheckQuestion question;
        question.faces = faces;
        question.penetration = penetration;
        question.clearance = clearance;
        const ViewOptions view{title, up_of(up), {}, {}};
        const Interruptible call(threads);
        return call.ask(
            [&](const BatchOptions& options) { return page_of(std::move(instances), question, view, options); });
      },
      nb::arg("objects"), nb::kw_only(), nb::arg("title") = "Toccata", nb::arg("up") = "z", nb::arg("faces") = true,
      nb::arg("penetration") = true, nb::arg("clearance") = nb::none(), nb::arg("threads") = all_threads,
      R"(One self-contained HTML page that shows posed shapes and what check_all finds of them.

It opens from disk in any browser with WebGL 2. up: the axis that points up, 'y' or 'z'. faces: which faces meet, and in what
curves; penetration: how deep; clearance: how far apart, in the unit of the coordinates. Raises Error like check_all, and for
another axis.)");
  module.def(
      "write_view_page",
      [](const std::string& page, const std::filesystem::path& path) {
        without_lock([&] { write_view_page(page, path.string()); });
      },
      nb::arg("page"), nb::arg("path"),
      "Writes a page: the file is complete or not there. Raises Error naming the file when it exists and was not "
      "written "
      "by Toccata, or cannot be written.");
}

}  // namespace toccata::python
