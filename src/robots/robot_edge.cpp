#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "math/vec3_measures.hpp"
#include "robots/each_configuration.hpp"
#include "robots/placed_robot.hpp"
#include "robots/scene_made.hpp"
#include "toccata/core/error.hpp"
#include "toccata/robots/robot_scene.hpp"

namespace toccata {
namespace {

constexpr double above_edge_roundings = 1 + 0x1p-30;

/// What of an edge is looked for.
enum class EdgeEnd : std::uint8_t {
  first_contact,
  any_contact,
};

/// A stretch of time is looked at in its middle: how far can points of each body be from where they are then? With
/// turns about one axis after the other, from the body inwards, a joint moves a point that is no farther than d from
/// its axis by no more than its turn times d; and joints farther out have changed d by no more than they move the
/// point. What joints farther in do changes neither.
class EdgeSearch {
 public:
  EdgeSearch(PlacedRobot& placed, std::span<const double> from, std::span<const double> to, double precision,
             EdgeEnd end)
      : placed_(placed),
        scene_(placed.scene()),
        tree_(scene_.robot.tree()),
        from_(from),
        to_(to),
        precision_(precision),
        end_(end),
        configuration_(from.size()),
        ways_(scene_.robot.bodies().size()) {
    find_rates();
    find_rounding();
  }

  RobotEdge answer() {
    if (end_ == EdgeEnd::any_contact && (meets_at(0) || meets_at(1))) return {.is_free = false};
    if (end_ == EdgeEnd::first_contact && meets_at(0)) return {false, 0, 0, Status::exact, least_contact_at(0)};
    for (const SelfPair& self : scene_.self_pairs) pairs_.push_back({self.pair, &self, {}});
    for (Index body = 0; body < ways_.size(); ++body)
      if (scene_.body_rests[body] == 0) bodies_.push_back(body);
    look_at({0, 1, 0, pairs_.size(), 0, bodies_.size()});
    if (!is_over()) return {};
    if (end_ == EdgeEnd::any_contact) return {.is_free = false};
    if (!contact_) look_behind(unclear_->end);
    const double upper = contact_ ? *contact_ : unclear_->end;
    if (!contact_) return {false, unclear_->begin, upper, Status::undecided, scene_.contact_of(unclear_->pair)};
    return {false, unclear_ ? unclear_->begin : upper, upper, Status::exact, least_contact_at(upper)};
  }

 private:
  struct OpenPair {
    RobotBodyPair pair;
    const SelfPair* self;  ///< none with a part of an obstacle
    SimplexCache kept;     ///< where the last look at their hulls ended: a hint
  };

  /// A stretch of time, and what is not known to be free in it: pairs, and bodies of which it is not even known which
  /// obstacles they come near to. They lie in the stacks of the search.
  struct Stretch {
    double begin, end;
    std::size_t first_pair, end_pair;
    std::size_t first_body, end_body;
  };

  struct Unclear {
    double begin, end;
    RobotBodyPair pair;
  };

  enum class InStretch : std::uint8_t { free, open, meets };

  void find_rates() {
    for (const RobotFrame& frame : tree_.frames) {
      const bool moves = frame.motion != RobotFrame::Motion::none;
      rates_.push_back(moves ? std::fabs(frame.multiplier * (to_[frame.position] - from_[frame.position])) *
                                   above_edge_roundings
                             : 0);
    }
  }

  /// Poses round lengths that are no greater than all together, some tens of times each; and angles, of which the last
  /// bits of many turns are large.
  void find_rounding() {
    double lengths = sum_of_magnitudes(tree_.description.base.offset), farthest = 0;
    for (const RobotFrame& frame : tree_.frames) {
      lengths += sum_of_magnitudes(frame.origin.offset);
      if (frame.motion == RobotFrame::Motion::none) continue;
      const double position =
          std::fabs(frame.position_in(from_)) + std::fabs(frame.position_in(to_)) + std::fabs(frame.offset);
      if (frame.motion == RobotFrame::Motion::slide)
        lengths += position;
      else
        farthest = std::max(farthest, position);
    }
    double largest = 0;
    for (const LocalBox& box : scene_.body_boxes)
      if (std::isfinite(box.magnitude)) largest = std::max(largest, box.magnitude);
    rounding_ = 0x1p-44 * static_cast<double>(tree_.frames.size()) * (lengths + largest) * (1 + farthest);
  }

  void place_at(double time) {
    for (std::size_t i = 0; i < configuration_.size(); ++i)
      configuration_[i] = time == 1 ? to_[i] : from_[i] + time * (to_[i] - from_[i]);
    placed_.place(configuration_);
  }

  bool meets_at(double time) {
    place_at(time);
    return placed_.meets();
  }

  RobotContact least_contact_at(double time) {
    place_at(time);
    return placed_.contacts(ContactsTold::first).front();
  }

  /// What came too near to be told mostly meets soon afterwards, which is told exactly then.
  void look_behind(double time) {
    constexpr int looks = 5;
    double step = 0;
    for (int i = 0; i < looks && time + step <= 1 && !contact_; ++i) {
      if (meets_at(time + step)) contact_ = time + step;
      step = std::max(2 * step, precision_);
    }
  }

  [[nodiscard]] bool is_over() const { return contact_ || unclear_; }

  /// ways_[body][k]: by the k outermost frames that it hangs on, when they have so much time.
  void find_ways(double time) {
    for (Index body = 0; body < ways_.size(); ++body) {
      std::vector<double>& ways = ways_[body];
      ways.assign(1, 0);
      const Vec3 centre = placed_.box(body).centre;
      const double radius = scene_.body_radius[body];
      for (const Index number : scene_.body_frames[body]) {
        double way = rates_[number] * time;
        if (way > 0 && tree_.frames[number].motion == RobotFrame::Motion::turn) {
          const Pose& pose = placed_.frames()[number];
          const Vec3 axis = pose.linear * tree_.frames[number].axis;
          way *= plain_length(cross(axis, centre - pose.offset)) + radius + ways.back();
        }
        ways.push_back(ways.back() + way * above_edge_roundings);
      }
    }
  }

  [[nodiscard]] double way_of(const OpenPair& open) const {
    const std::vector<double>& ways = ways_[open.pair.body];
    if (open.self == nullptr) return ways.back() + rounding_;
    return ways[open.self->frames_of_body] + ways_[open.pair.other][open.self->frames_of_other] + rounding_;
  }

  InStretch look_at_pair(OpenPair& open) {
    const double way = way_of(open);
    if (placed_.certainly_apart(open.pair, way)) return InStretch::free;
    const double gap = placed_.hull_gap(open.pair, way, &open.kept);
    if (gap >= way) return InStretch::free;
    if (gap == 0 && !placed_.certainly_apart(open.pair, 0) && placed_.are_met_within_hulls(open.pair))
      return InStretch::meets;
    // Halves of the stretch tell it with less work, until the way is little beside the shape.
    const bool is_long = way > 0.03125 * scene_.body_radius[open.pair.body] && stretch_length_ > precision_;
    if (is_long && !std::isinf(placed_.box_of_other(open.pair).slack)) return InStretch::open;
    return placed_.nearby(open.pair, WantedDistance::within(way)) ? InStretch::open : InStretch::free;
  }

  /// Whether a pair meets in the middle; those that are not free are put on the stack.
  bool keep_open(OpenPair open) {
    const InStretch found = look_at_pair(open);
    if (found != InStretch::free) pairs_.push_back(open);
    return found == InStretch::meets;
  }

  /// The obstacles that the body comes near to become pairs, unless it goes so far that there would be too many.
  bool open_body(Index body) {
    const double way = ways_[body].back() + rounding_;
    const bool goes_far = stretch_length_ > precision_ && way > 2 * scene_.body_radius[body];
    bool meets = false, is_near_any = false;
    scene_.part_tree.visit_near(placed_.box(body), way, [&](Index part) {
      const OpenPair open{{body, true, part}, nullptr, {}};
      if (scene_.is_allowed(body, part) || placed_.certainly_apart(open.pair, way)) return true;
      is_near_any = true;
      if (!goes_far) meets = keep_open(open) || meets;
      return !goes_far;
    });
    if (goes_far && is_near_any) bodies_.push_back(body);
    return meets;
  }

  /// Afterwards the stacks are as before.
  void look_at(const Stretch& stretch) {
    if (unclear_ || (contact_ && (end_ == EdgeEnd::any_contact || stretch.begin >= *contact_))) return;
    const double middle = 0.5 * (stretch.begin + stretch.end);
    place_at(middle);
    stretch_length_ = stretch.end - stretch.begin;
    find_ways(0.5 * stretch_length_);
    const std::size_t pair_count = pairs_.size(), body_count = bodies_.size();
    bool meets = false;
    for (std::size_t i = stretch.first_pair; i < stretch.end_pair; ++i) meets = keep_open(pairs_[i]) || meets;
    for (std::size_t i = stretch.first_body; i < stretch.end_body; ++i) meets = open_body(bodies_[i]) || meets;
    if (meets) contact_ = middle;
    const bool is_any_open = pairs_.size() > pair_count || bodies_.size() > body_count;
    const bool is_found = meets && end_ == EdgeEnd::any_contact;
    if (is_any_open && !is_found) {
      if (stretch_length_ <= precision_ && pairs_.size() > pair_count) {
        unclear_ = {stretch.begin, stretch.end, least_open(pair_count)};
      } else {
        look_at({stretch.begin, middle, pair_count, pairs_.size(), body_count, bodies_.size()});
        look_at({middle, stretch.end, pair_count, pairs_.size(), body_count, bodies_.size()});
      }
    }
    pairs_.resize(pair_count);
    bodies_.resize(body_count);
  }

  [[nodiscard]] RobotBodyPair least_open(std::size_t first) const {
    const auto contact_of = [&](const OpenPair& open) { return scene_.contact_of(open.pair); };
    return std::ranges::min(std::span(pairs_).subspan(first), {}, contact_of).pair;
  }

  PlacedRobot& placed_;
  const RobotScene::Made& scene_;
  const Robot::Tree& tree_;
  std::span<const double> from_, to_;
  double precision_;
  EdgeEnd end_;
  std::vector<double> configuration_;
  std::vector<double> rates_;  ///< of each frame: radians or world units per unit of time
  double rounding_ = 0;
  double stretch_length_ = 0;  ///< of the stretch that is looked at
  std::vector<std::vector<double>> ways_;
  std::vector<OpenPair> pairs_;
  std::vector<Index> bodies_;
  std::optional<double> contact_;   ///< the earliest time that is known at which something meets
  std::optional<Unclear> unclear_;  ///< the first stretch that is too short to be halved, and not known to be free
};

void require_precision(const EdgeOptions& options) {
  if (!(options.precision >= 0x1p-40 && options.precision <= 1))
    throw Error(
        fmt::format("the precision of an edge is {}; it has to be at least 2^-40, and 1 at most", options.precision));
}

/// `ask(search)` of every edge.
template <class Answer, class Ask>
std::vector<Answer> of_each_edge(const RobotScene::Made& scene, std::span<const double> from,
                                 std::span<const double> to, const EdgeOptions& options, EdgeEnd end, const Ask& ask) {
  require_precision(options);
  const std::size_t count = configuration_count(scene.robot, from);
  if (configuration_count(scene.robot, to) != count)
    throw Error(fmt::format("edges from {} configurations lead to {}; give as many of both", count,
                            configuration_count(scene.robot, to)));
  const auto at = [&](std::span<const double> numbers, std::size_t i) {
    return configuration_at(scene.robot, numbers, i);
  };
  for (std::size_t i = 0; i < count; ++i)
    naming_number("edge", i, [&] {
      require_configuration(scene.robot, at(from, i));
      require_configuration(scene.robot, at(to, i));
    });
  return in_rows_of_robots<Answer>(scene, count, "edge", options.threads, options.progress,
                                   [&](PlacedRobot& placed, std::size_t i) -> Answer {
                                     EdgeSearch search(placed, at(from, i), at(to, i), options.precision, end);
                                     return ask(search);
                                   });
}

}  // namespace

RobotEdge RobotScene::edge(std::span<const double> from, std::span<const double> to, const EdgeOptions& options) const {
  require_precision(options);
  for (const auto& end : {from, to}) require_configuration(made_->robot, end);
  PlacedRobot placed(*made_);
  return EdgeSearch(placed, from, to, options.precision, EdgeEnd::first_contact).answer();
}

std::vector<RobotEdge> RobotScene::edge_each(std::span<const double> from, std::span<const double> to,
                                             const EdgeOptions& options) const {
  return of_each_edge<RobotEdge>(*made_, from, to, options, EdgeEnd::first_contact,
                                 [](EdgeSearch& search) { return search.answer(); });
}

std::vector<std::uint8_t> RobotScene::free_each(std::span<const double> from, std::span<const double> to,
                                                const EdgeOptions& options) const {
  return of_each_edge<std::uint8_t>(*made_, from, to, options, EdgeEnd::any_contact, [](EdgeSearch& search) {
    return static_cast<std::uint8_t>(search.answer().is_free ? 1 : 0);
  });
}

}  // namespace toccata
