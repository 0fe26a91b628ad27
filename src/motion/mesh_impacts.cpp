#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "motion/approach.hpp"
#include "motion/candidate_triangles.hpp"
#include "motion/feature_pairs.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
namespace {

bool impact_comes_before(const MeshImpact& a, const MeshImpact& b) {
  return std::tie(a.time.lower, a.time.upper, a.a, a.b) < std::tie(b.time.lower, b.time.upper, b.a, b.b);
}

/// The meshes of a question.
struct FeatureQuestion {
  const DeformingMesh& a;
  const DeformingMesh& b;
  bool is_within_one = false;
  const ImpactOptions& options;
};

enum class WantedImpacts { any, first, all };

/// The time after which nothing can come first any more, which all threads of a question make earlier. What is left out
/// by it comes after the first in every order, so that it cannot be seen in an answer when which thread found what.
class LatestTime {
 public:
  [[nodiscard]] double get() const { return time_.load(std::memory_order_relaxed); }
  void lessen(double time) {
    double known = get();
    while (time < known && !time_.compare_exchange_weak(known, time, std::memory_order_relaxed)) continue;
  }

 private:
  std::atomic<double> time_ = 1;
};

/// What one thread has found.
class ImpactSink {
 public:
  ImpactSink(WantedImpacts wanted, double separation, LatestTime& latest)
      : wanted_(wanted), separation_(separation), latest_(&latest) {}

  template <std::size_t Count>
  bool see(const MeshFeature& a, const MeshFeature& b, const MovingPolygon<Count>& polygon) {
    if (separation_ > 0) {
      const std::optional<Approach> near = time_of_approach(polygon, separation_, latest_->get());
      return !near || add({a, b, near->time, near->status});
    }
    const std::optional<TimeOfImpact> contact = time_of_finite(polygon);
    return !contact || add({a, b, *contact, Status::exact});
  }
  bool see_pierced(const MeshFeature& a, const MeshFeature& b) { return add({a, b, {0, 0}, Status::exact}); }

  /// Times of contact are exact, and what meets after the `upper` of another comes after it. Where an approach begins
  /// is a matter of its search, which may tell it a little too early: boxes tell nothing of that.
  [[nodiscard]] double latest() const { return separation_ > 0 ? 1 : latest_->get(); }

  [[nodiscard]] std::vector<MeshImpact>& found() { return found_; }

 private:
  bool add(const MeshImpact& impact) {
    if (wanted_ == WantedImpacts::first) latest_->lessen(separation_ > 0 ? impact.time.lower : impact.time.upper);
    if (wanted_ != WantedImpacts::first || found_.empty())
      found_.push_back(impact);
    else if (impact_comes_before(impact, found_[0]))
      found_[0] = impact;
    return wanted_ != WantedImpacts::any;
  }

  WantedImpacts wanted_;
  double separation_;
  LatestTime* latest_;
  std::vector<MeshImpact> found_;
};

/// Fractions of the ways of the vertices, each the least of its features'.
class StepSink {
 public:
  explicit StepSink(const FeatureQuestion& question)
      : question_(question), of_a_(question.a.start().size(), 1), of_b_(question.b.start().size(), 1) {}

  template <std::size_t Count>
  bool see(const MeshFeature& a, const MeshFeature& b, const MovingPolygon<Count>& polygon) {
    const double fraction = independent_fraction(polygon, question_.options.separation);
    if (fraction < 1) limit(a, b, fraction);
    return true;
  }
  bool see_pierced(const MeshFeature& a, const MeshFeature& b) {
    limit(a, b, 0);
    return true;
  }
  [[nodiscard]] static double latest() { return 1; }

  /// The lesser of each two.
  void merge(const StepSink& other) {
    const auto lesser = [](double x, double y) { return std::min(x, y); };
    std::transform(of_a_.begin(), of_a_.end(), other.of_a_.begin(), of_a_.begin(), lesser);
    std::transform(of_b_.begin(), of_b_.end(), other.of_b_.begin(), of_b_.begin(), lesser);
  }
  [[nodiscard]] FreeSteps steps() && { return {std::move(of_a_), std::move(of_b_)}; }

 private:
  void limit(const MeshFeature& a, const MeshFeature& b, double fraction) {
    limit(question_.a, a, fraction, of_a_);
    limit(question_.b, b, fraction, question_.is_within_one ? of_a_ : of_b_);
  }
  static void limit(const DeformingMesh& mesh, const MeshFeature& feature, double fraction,
                    std::vector<double>& steps) {
    const auto at = [&](Index vertex) { steps[vertex] = std::min(steps[vertex], fraction); };
    if (feature.kind == FeatureKind::vertex) return at(feature.number);
    if (feature.kind == FeatureKind::face) {
      for (const Index vertex : mesh.triangles()[feature.number]) at(vertex);
      return;
    }
    at(mesh.edges()[feature.number].first);
    at(mesh.edges()[feature.number].second);
  }

  const FeatureQuestion& question_;
  std::vector<double> of_a_;
  std::vector<double> of_b_;
};

void check_impact_options(const ImpactOptions& options) {
  if (!(options.separation >= 0) || !std::isfinite(options.separation))
    throw Error(
        fmt::format("a separation of {} was asked for: give a finite number that is not negative", options.separation));
}

/// Shows a sink for each thread the pairs of features that it is to look at.
template <FeatureSink Sink>
void search_features(const FeatureQuestion& question, std::vector<Sink>& sinks) {
  const auto& [a, b, is_within_one, options] = question;
  const WideFrame frame = frame_around(merge(a.tree().box, b.tree().box));
  const auto boxes_of = [&, &options = options](const DeformingMesh& mesh) {
    return vertex_boxes(mesh, frame, options.separation, options.threads);
  };
  const std::vector<VertexBoxes> boxes_a = boxes_of(a),
                                 boxes_b = is_within_one ? std::vector<VertexBoxes>() : boxes_of(b);
  const typename FeaturePairs<Sink>::Question asked{
      {a, boxes_a}, {b, is_within_one ? boxes_a : boxes_b}, is_within_one, !options.starts_free};
  const auto see = [&](std::size_t thread, std::span<const ItemPair> pairs) {
    return FeaturePairs<Sink>(asked, sinks[thread]).see(pairs);
  };
  const CandidateWork work{options.threads, options.progress};
  if (is_within_one)
    visit_candidates(a.tree(), options.separation, work, see);
  else
    visit_candidates(a.tree(), b.tree(), options.separation, work, see);
}

std::string feature_told(const DeformingMesh& mesh, const MeshFeature& feature) {
  if (feature.kind == FeatureKind::vertex) return fmt::format("vertex {}", feature.number);
  if (feature.kind == FeatureKind::face) return fmt::format("triangle {}", feature.number);
  const IndexPair ends = mesh.edges()[feature.number];
  return fmt::format("edge {}–{}", ends.first, ends.second);
}

/// What starts within a separation need not be in contact.
void check_promise(const FeatureQuestion& question, std::span<const MeshImpact> found) {
  const bool is_promised = question.options.starts_free && question.options.separation == 0;
  if (!is_promised || found.empty() || found[0].time.upper > 0) return;
  throw Error(fmt::format("the start was promised to be free, and {} and {} meet there: leave out starts_free",
                          feature_told(question.a, found[0].a), feature_told(question.b, found[0].b)));
}

/// Ascending.
std::vector<MeshImpact> impacts_of(const FeatureQuestion& question, WantedImpacts wanted) {
  check_impact_options(question.options);
  LatestTime latest;
  std::vector<ImpactSink> sinks(static_cast<std::size_t>(thread_count(question.options.threads)),
                                ImpactSink(wanted, question.options.separation, latest));
  search_features(question, sinks);
  std::vector<MeshImpact> all;
  for (ImpactSink& sink : sinks) all.insert(all.end(), sink.found().begin(), sink.found().end());
  std::sort(all.begin(), all.end(), impact_comes_before);
  if (wanted != WantedImpacts::any) check_promise(question, all);
  return all;
}

std::optional<MeshImpact> first_impact_of(const FeatureQuestion& question) {
  const std::vector<MeshImpact> found = impacts_of(question, WantedImpacts::first);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

/// A time that is told exactly is itself one of contact, so the step ends a cell before it.
FreeStep free_step_of(const FeatureQuestion& question) {
  const std::optional<MeshImpact> first = first_impact_of(question);
  if (!first) return {};
  const TimeOfImpact& time = first->time;
  return {time.lower < time.upper ? time.lower : std::max(0.0, time.lower - cell_length), first};
}

FreeSteps free_steps_of(const FeatureQuestion& question) {
  check_impact_options(question.options);
  std::vector<StepSink> sinks(static_cast<std::size_t>(thread_count(question.options.threads)), StepSink(question));
  search_features(question, sinks);
  for (std::size_t i = 1; i < sinks.size(); ++i) sinks[0].merge(sinks[i]);
  return std::move(sinks[0]).steps();
}

}  // namespace

bool meets(const DeformingMesh& mesh, const ImpactOptions& options) {
  return !impacts_of({mesh, mesh, true, options}, WantedImpacts::any).empty();
}
bool meets(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options) {
  return !impacts_of({a, b, false, options}, WantedImpacts::any).empty();
}

std::optional<MeshImpact> first_impact(const DeformingMesh& mesh, const ImpactOptions& options) {
  return first_impact_of({mesh, mesh, true, options});
}
std::optional<MeshImpact> first_impact(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options) {
  return first_impact_of({a, b, false, options});
}

std::vector<MeshImpact> impacts(const DeformingMesh& mesh, const ImpactOptions& options) {
  return impacts_of({mesh, mesh, true, options}, WantedImpacts::all);
}
std::vector<MeshImpact> impacts(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options) {
  return impacts_of({a, b, false, options}, WantedImpacts::all);
}

FreeStep free_step(const DeformingMesh& mesh, const ImpactOptions& options) {
  return free_step_of({mesh, mesh, true, options});
}
FreeStep free_step(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options) {
  return free_step_of({a, b, false, options});
}

std::vector<double> free_steps(const DeformingMesh& mesh, const ImpactOptions& options) {
  return free_steps_of({mesh, mesh, true, options}).of_a;
}
FreeSteps free_steps(const DeformingMesh& a, const DeformingMesh& b, const ImpactOptions& options) {
  return free_steps_of({a, b, false, options});
}

}  // namespace toccata
