#include "demo_cloth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cloth.hpp"
#include "toccata/query/overlap.hpp"
#include "toccata/query/self_contacts.hpp"

namespace toccata::command {
namespace {

/// What all steps did together.
struct ClothTotals {
  int steps = 0;
  std::size_t most_near = 0;
  std::size_t near = 0;
  std::size_t limited_steps = 0;
  std::size_t shortened = 0;
  std::size_t frames_that_meet = 0;

  void add(const ClothStep& step) {
    ++steps;
    near += step.near;
    most_near = std::max(most_near, step.near);
    limited_steps += step.stopped > 0 ? 1 : 0;
    shortened += step.shortened;
  }
};

/// By another question than the one that the steps are made with, and by coordinates in place of numbers of vertices.
class FrameCheck {
 public:
  explicit FrameCheck(const Cloth& cloth) : model_(cloth.mesh()), obstacles_(cloth.obstacles()) {}
  bool meets_something(const Cloth& cloth) {
    const TriangleMesh mesh = cloth.mesh();
    static_cast<void>(model_.deform({mesh.vertices().begin(), mesh.vertices().end()}));
    return self_overlap(model_) || overlap(model_, obstacles_);
  }

 private:
  Model model_;
  Model obstacles_;
};

ClothTotals totals_of(Cloth& cloth, int steps) {
  FrameCheck check(cloth);
  ClothTotals totals;
  for (int i = 0; i < steps; ++i) {
    totals.add(cloth.step());
    totals.frames_that_meet += check.meets_something(cloth) ? 1 : 0;
  }
  return totals;
}

}  // namespace

ClothAnswer fallen_cloth(const ClothArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  Cloth cloth({.cells = arguments.cells, .threads = arguments.threads});
  const Index triangles = cloth.mesh().triangle_count();
  const ClothTotals totals = totals_of(cloth, arguments.steps);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ClothAnswer answer{{}, {}, totals.frames_that_meet == 0, cloth.mesh(), cloth.obstacles()};
  answer.text = fmt::format(
      "A cloth of {} triangles falls onto a ball and folds: {} steps in {:.1f} s.\n"
      "{:<52}{:>9}\n{:<52}{:>9}\n{:<52}{:>9}\n{:<52}{:>9}\n"
      "{}\n",
      triangles, totals.steps, seconds, "pairs of features that came within 10 mm, all steps", totals.near,
      "in one step at most", totals.most_near, "steps in which a vertex was stopped before its end",
      totals.limited_steps, "frames in which the cloth meets anything", totals.frames_that_meet,
      answer.is_clean
          ? "Every step is proved free of contact from its start to its end, every frame was looked at once "
            "more by itself."
          : "Some frames meet something: please report this.");
  answer.json = nlohmann::ordered_json{{"scene", "cloth"},
                                       {"triangles", triangles},
                                       {"steps", totals.steps},
                                       {"seconds", seconds},
                                       {"near_pairs", totals.near},
                                       {"most_near_pairs", totals.most_near},
                                       {"limited_steps", totals.limited_steps},
                                       {"shortened", totals.shortened},
                                       {"frames_that_meet", totals.frames_that_meet}}
                    .dump(2) +
                "\n";
  return answer;
}

}  // namespace toccata::command
