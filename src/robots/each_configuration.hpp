#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "query/ask_each.hpp"
#include "robots/placed_robot.hpp"
#include "robots/robot_tree.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {

/// `ask(placed robot)` at one configuration.
template <class Ask>
auto of_configuration(const RobotScene::Made& scene, std::span<const double> configuration, const Ask& ask) {
  require_configuration(scene.robot, configuration);
  PlacedRobot placed(scene);
  placed.place(configuration);
  return ask(placed);
}

/// What it throws begins with the number of the one that is asked about.
template <class Ask>
auto naming_number(std::string_view noun, std::size_t i, const Ask& ask) {
  try {
    return ask();
  } catch (const Error& error) {
    throw Error(fmt::format("{} {}: {}", noun, i, error.what()));
  }
}

/// `answers[i] = ask(placed robot, i)` for so many, in rows, each with a robot of its own on one thread. Whatever could
/// be asked wrongly has been looked at before.
template <class Answer, class Ask>
std::vector<Answer> in_rows_of_robots(const RobotScene::Made& scene, std::size_t count, std::string_view noun,
                                      int threads, const Progress& progress, const Ask& ask) {
  constexpr std::size_t enough_together = 64;
  const auto thread_number = static_cast<std::size_t>(thread_count(threads));
  const std::size_t share = std::min(enough_together, (count + thread_number - 1) / thread_number);
  std::vector<Answer> answers(count);
  const Chunks rows{count, std::max(row_length(count, threads), share)};
  TaskReporter reporter(progress, count);
  parallel_for(rows.size(), threads, [&](std::size_t row) {
    const std::span<Answer> of_row = rows.of(std::span(answers), row);
    const auto first = static_cast<std::size_t>(of_row.data() - answers.data());
    PlacedRobot placed(scene);
    for (std::size_t i = 0; i < of_row.size() && !reporter.cancelled(); ++i) {
      of_row[i] = naming_number(noun, first + i, [&] { return ask(placed, first + i); });
      reporter.finished_one();
    }
  });
  return answers;
}

/// `ask(placed robot)` at each of many configurations.
template <class Answer, class Ask>
std::vector<Answer> of_each_configuration(const RobotScene::Made& scene, std::span<const double> configurations,
                                          const BatchOptions& options, const Ask& ask) {
  const std::size_t count = configuration_count(scene.robot, configurations);
  const auto at = [&](std::size_t i) { return configuration_at(scene.robot, configurations, i); };
  require_one_each(options.warm_start, 0, "configuration");
  for (std::size_t i = 0; i < count; ++i)
    naming_number("configuration", i, [&] { require_configuration(scene.robot, at(i)); });
  return in_rows_of_robots<Answer>(scene, count, "configuration", options.threads, options.progress,
                                   [&](PlacedRobot& placed, std::size_t i) {
                                     placed.place(at(i));
                                     return ask(placed);
                                   });
}

}  // namespace toccata
