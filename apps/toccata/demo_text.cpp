#include "demo_text.hpp"

#include <fmt/format.h>

#include <chrono>

#include "check_table.hpp"
#include "toccata/generate/scenes.hpp"
#include "words.hpp"

namespace toccata::command {

CheckReport demo_report(const std::vector<SceneInstance>& models, int threads) {
  CheckOptions options;
  options.threads = threads;
  return make_check_report(models, check_all(models, options));
}

std::string demo_text(int threads) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  std::string text;
  for (const NamedScene& named : demo_scenes()) {
    const Scene scene = demo_scene(named.name);
    const CheckReport report = demo_report(scene_models(scene, threads), threads);
    text += fmt::format("{}: {}\n{}\n", named.name, named.description, check_table(scene, report));
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return text +
         fmt::format(
             "{0} made, built and checked in {1:.2f} s. Every answer is exact: no tolerance, no hull in place of a "
             "shape.\nTo play with them as files:\n  {2} demo --write scenes\n  {2} check scenes/a.obj scenes/b.stl "
             "--faces\n",
             counted(demo_scenes().size(), "scene"), seconds, called_as());
}

}  // namespace toccata::command
