#include "toccata/robots/allowed_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "robots/robot_tree.hpp"
#include "robots/scene_made.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/random.hpp"
#include "toccata/robots/robot_scene.hpp"

namespace toccata {
namespace {

using LinkPair = std::pair<Index, Index>;

LinkPair link_pair_of(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }

/// The pairs of links with shapes that are joined, ascending.
std::set<LinkPair> adjacent_links(const Robot& robot) {
  const auto links = robot.links();
  std::set<LinkPair> pairs;
  // Links without shapes join what hangs on them and what they hang on: each is a group, and others border on it.
  std::vector<Index> group(links.size());
  for (Index link = 0; link < links.size(); ++link) group[link] = link;
  const auto group_of = [&](Index link) {
    while (group[link] != link) link = group[link];
    return link;
  };
  for (const RobotJoint& joint : robot.joints()) {
    const Index a = robot.link_of(joint.parent), b = robot.link_of(joint.child);
    if (links[a].shapes.empty() && links[b].shapes.empty()) group[group_of(a)] = group_of(b);
  }
  std::vector<std::vector<Index>> bordering(links.size());
  for (const RobotJoint& joint : robot.joints()) {
    const Index a = robot.link_of(joint.parent), b = robot.link_of(joint.child);
    const bool has_a = !links[a].shapes.empty(), has_b = !links[b].shapes.empty();
    if (has_a && has_b) pairs.insert(link_pair_of(a, b));
    if (has_a != has_b) bordering[group_of(has_a ? b : a)].push_back(has_a ? a : b);
  }
  for (const std::vector<Index>& around : bordering)
    for (const Index a : around)
      for (const Index b : around)
        if (a != b) pairs.insert(link_pair_of(a, b));
  return pairs;
}

/// Between its limits; without any, a whole turn or from −1 to 1.
double sampled_position(const RobotPosition& position, Random& random) {
  if (const std::optional<JointLimits>& limits = position.limits) {
    if (std::isfinite(limits->upper - limits->lower)) return random.between(limits->lower, limits->upper);
    const double share = random.between(0, 1);
    return (1 - share) * limits->lower + share * limits->upper;
  }
  return position.turns ? random.between(-std::numbers::pi, std::numbers::pi) : random.between(-1, 1);
}

/// Counts how often links meet.
class MeetingCounts {
 public:
  explicit MeetingCounts(std::size_t links) : links_(links), counts_(links * links) {}

  void add(std::span<const RobotContact> contacts) {
    for (const RobotContact& contact : contacts) ++counts_[contact.link * links_ + contact.other];
  }
  [[nodiscard]] std::size_t of(const LinkPair& pair) const { return counts_[pair.first * links_ + pair.second]; }

 private:
  std::size_t links_;
  std::vector<std::size_t> counts_;
};

}  // namespace

std::string_view name_of(AllowedReason reason) {
  constexpr std::array<std::string_view, 5> names{"given", "adjacent", "always", "at rest", "never"};
  return names[static_cast<std::size_t>(reason)];
}

std::vector<AllowedPair> adjacent_pairs(const Robot& robot) {
  std::vector<AllowedPair> pairs;
  for (const auto& [a, b] : adjacent_links(robot))
    pairs.push_back({robot.links()[a].name, robot.links()[b].name, AllowedReason::adjacent});
  return pairs;
}

std::vector<double> sampled_configurations(const Robot& robot, std::size_t count, std::uint64_t seed) {
  std::vector<double> configurations;
  configurations.reserve(count * robot.positions().size());
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i)
    for (const RobotPosition& position : robot.positions())
      configurations.push_back(sampled_position(position, random));
  return configurations;
}

std::vector<AllowedPair> allowed_pairs_by_samples(const Robot& robot, const SampleOptions& options) {
  const RobotScene scene(robot, {}, {.allow_adjacent = false});
  const auto links = robot.links();
  MeetingCounts samples(links.size()), rest(links.size());
  rest.add(scene.contacts(robot.rest()));
  const std::size_t sample_count = robot.positions().empty() ? 0 : options.samples;
  if (sample_count == 0 && !robot.positions().empty())
    throw Error("no samples: no pair would be seen to meet, and each be allowed; take some thousands");
  if (sample_count > 0) {
    const std::vector<double> configurations = sampled_configurations(robot, sample_count, options.seed);
    for (const auto& contacts : scene.contacts_each(configurations, ContactsTold::all,
                                                    {.threads = options.threads, .progress = options.progress}))
      samples.add(contacts);
  }
  const std::set<LinkPair> adjacent = adjacent_links(robot);
  std::vector<AllowedPair> pairs;
  for (Index a = 0; a < links.size(); ++a)
    for (Index b = a + 1; b < links.size(); ++b) {
      if (links[a].shapes.empty() || links[b].shapes.empty()) continue;
      const LinkPair pair{a, b};
      std::optional<AllowedReason> reason;
      if (adjacent.contains(pair))
        reason = AllowedReason::adjacent;
      else if (sample_count > 0 && samples.of(pair) == sample_count)
        reason = AllowedReason::always;
      else if (rest.of(pair) > 0)
        reason = AllowedReason::at_rest;
      else if (samples.of(pair) == 0)
        reason = AllowedReason::never;
      if (reason) pairs.push_back({links[a].name, links[b].name, *reason});
    }
  return pairs;
}

}  // namespace toccata
