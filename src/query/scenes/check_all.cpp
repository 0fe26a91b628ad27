#include "toccata/query/check_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/require_length.hpp"
#include "math/vec3_measures.hpp"
#include "query/contacts/local_depth_limit.hpp"
#include "query/contacts/part_contacts.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "query/posed_shape.hpp"
#include "query/relation/relation_locality.hpp"
#include "query/relation/relation_posed.hpp"
#include "query/scenes/candidate_pairs.hpp"
#include "query/scenes/check_wanted.hpp"
#include "query/scenes/clearances.hpp"
#include "query/scenes/posed_name.hpp"
#include "query/scenes/task_reporter.hpp"
#include "query/scenes/tolerance_verdict.hpp"
#include "query/volume/solid_volume.hpp"
#include "query/volume/winding_volume.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/distance.hpp"

namespace toccata {
namespace {

// Pairs are looked at so many at once: memory follows the objects and the answer, not the pairs whose boxes overlap.
constexpr std::size_t pairs_at_once = 4096;

class Check {
 public:
  Check(std::span<const SceneInstance> models, const CheckOptions& options, const CheckPairRules& rules,
        const CheckWatch& watch)
      : models_(models),
        options_(options),
        rules_(rules),
        watch_(watch),
        clearances_({models.size(), [&](std::size_t i) { return name_for_messages(models[i], i); },
                     [&](std::size_t i) -> std::string_view { return models[i].group; }},
                    options, rules.clearances),
        posed_(posed_model_pair()),
        groups_(group_numbers()) {}

  WantedAnswer answer() {
    const std::vector<Aabb> boxes = world_boxes();
    const std::vector<IndexPair> others = near_pairs_with_own_clearance(boxes);
    const std::vector<Aabb> offset_boxes = offset_by_half(boxes);
    std::atomic<std::size_t> left_out = 0;
    bool is_counting = true;  // while the candidates are: then each pair is asked about once
    const PairFilter is_candidate = [&](const IndexPair& pair) {
      if (!is_checked(pair) || (clearances_.have_rules() && !are_near(boxes, pair))) return false;
      if (!rules_.wanted || rules_.wanted(pair)) return true;
      if (is_counting) left_out.fetch_add(1, std::memory_order_relaxed);
      return false;
    };
    CandidatePairs candidates(offset_boxes, is_candidate, others, options_.threads);
    is_counting = false;
    CheckAnswer answer = answer_of(candidates);
    const std::size_t unfinished = answer.candidate_pairs - finished_;
    return {std::move(answer), left_out, unfinished};
  }

 private:
  [[nodiscard]] CheckAnswer answer_of(CandidatePairs& candidates) const {
    CheckAnswer answer;
    answer.candidate_pairs = candidates.count();
    TaskReporter reporter(options_.progress, answer.candidate_pairs);
    for (std::vector<IndexPair> run = candidates.next(); !run.empty() && !stopped_; run = candidates.next())
      for (std::size_t first = 0; first < run.size(); first += pairs_at_once) {
        const std::size_t count = std::min(pairs_at_once, run.size() - first);
        for (std::optional<PairAnswer>& pair : answers_of(std::span(run).subspan(first, count), reporter))
          if (pair) answer.pairs.push_back(std::move(*pair));
      }
    return answer;
  }

  /// Looks at every model alone, wherever it is: what is asked wrongly is an error, also far from everything else.
  [[nodiscard]] std::vector<PosedModel> posed_model_pair() const {
    std::vector<PosedModel> made(models_.size());
    parallel_for(models_.size(), options_.threads, [&](std::size_t i) {
      const SceneInstance& model = models_[i];
      made[i] = pose_model(model.model, model.pose, model.solid, name_for_messages(model, i));
    });
    return made;
  }

  /// Equal for models of one group, and 0 for those of none.
  [[nodiscard]] std::vector<std::size_t> group_numbers() const {
    std::map<std::string_view, std::size_t> number_of{{"", 0}};
    std::vector<std::size_t> numbers;
    numbers.reserve(models_.size());
    for (const SceneInstance& model : models_)
      numbers.push_back(number_of.emplace(model.group, number_of.size()).first->second);
    return numbers;
  }

  [[nodiscard]] std::vector<Aabb> world_boxes() const {
    std::vector<Aabb> boxes;
    boxes.reserve(posed_.size());
    for (const PosedModel& model : posed_) boxes.push_back(world_box(model));
    return boxes;
  }

  /// By the clearances that are not of pairs of their own.
  [[nodiscard]] std::vector<Aabb> offset_by_half(std::vector<Aabb> boxes) const {
    for (std::size_t i = 0; i < boxes.size(); ++i)
      boxes[i] = widened(boxes[i], half_rounded_up(clearances_.greatest_of(i)));
    return boxes;
  }

  /// By the clearance of that pair.
  [[nodiscard]] bool are_near(std::span<const Aabb> boxes, const IndexPair& pair) const {
    const double half = half_rounded_up(clearances_.of(pair));
    return overlap(widened(boxes[pair.first], half), widened(boxes[pair.second], half));
  }

  /// The pairs that are near by a clearance of their own, ascending: no other pair's boxes grow by it.
  [[nodiscard]] std::vector<IndexPair> near_pairs_with_own_clearance(std::span<const Aabb> boxes) const {
    std::vector<IndexPair> pairs;
    for (const auto& [pair, clearance] : clearances_.of_pairs())
      if (are_near(boxes, {pair.first, pair.second})) pairs.push_back({pair.first, pair.second});
    return pairs;
  }

  /// By the clearance of all, if it is wanted.
  [[nodiscard]] bool is_checked(const IndexPair& pair) const {
    const bool share_group = groups_[pair.first] != 0 && groups_[pair.first] == groups_[pair.second];
    const bool is_here = !rules_.here || rules_.here(pair);
    return is_here && !share_group && !clearances_.of_pairs().contains({pair.first, pair.second});
  }

  [[nodiscard]] std::vector<std::optional<PairAnswer>> answers_of(std::span<const IndexPair> pairs,
                                                                  TaskReporter& reporter) const {
    std::vector<std::optional<PairAnswer>> answers(pairs.size());
    parallel_for(pairs.size(), options_.threads, [&](std::size_t i) {
      if (reporter.cancelled() || is_stopped()) return;
      answers[i] = workspaces_.with([&](Workspace& workspace) {
        workspace.scratch().stop = &watch_.stop;
        return answer_of(pairs[i], workspace);
      });
      finished_.fetch_add(1, std::memory_order_relaxed);
      if (answers[i]) tell(*answers[i]);
      if (!watch_.keeps_found) answers[i].reset();
      reporter.finished_one();
    });
    return answers;
  }

  [[nodiscard]] bool is_stopped() const {
    if (!stopped_ && watch_.stop && watch_.stop()) stopped_ = true;
    return stopped_;
  }

  void tell(const PairAnswer& pair) const {
    if (!watch_.found) return;
    const std::lock_guard lock(telling_);
    watch_.found(pair);
  }

  /// Nothing where the two are apart, by more than their clearance.
  [[nodiscard]] std::optional<PairAnswer> answer_of(const IndexPair& pair, Workspace& workspace) const {
    SearchScratch& scratch = workspace.scratch();
    const PosedModel& a = posed_[pair.first];
    const PosedModel& b = posed_[pair.second];
    PairAnswer answer;
    answer.a = pair.first;
    answer.b = pair.second;
    const PosedTriangles *mesh_a = only_mesh(a), *mesh_b = only_mesh(b);
    if (mesh_a != nullptr && mesh_b != nullptr)
      answer_of_meshes({mesh_a->mesh, mesh_a->solid}, {mesh_b->mesh, mesh_b->solid}, scratch, answer);
    else
      answer_of_shapes(a, b, scratch, answer);
    answer.distance = distance_in(pair, workspace);
    if (clearances_.is_asked()) answer.clearance = clearances_.of(pair);
    answer.kind = kind_of_clash(answer.relation);
    answer.common_box = common_box(world_box(a), world_box(b));
    if (answer.relation.kind == RelationKind::apart) {
      if (!answer.distance) return std::nullopt;
      if (is_undecided(*answer.distance, clearances_.of(pair), a, b)) answer.relation.status = Status::undecided;
      return answer;
    }
    if (options_.penetration) add_depth(answer, workspace);
    if (const auto tolerance = tolerance_of(pair))
      tell_verdict(answer, *tolerance,
                   {models_[answer.a].model, models_[answer.b].model, query_of(answer), options_.depth}, workspace);
    if (options_.volume) add_volume(answer, workspace);
    return answer;
  }

  [[nodiscard]] std::optional<double> tolerance_of(const IndexPair& pair) const {
    const std::optional<double> own = rules_.tolerances ? rules_.tolerances(pair) : std::nullopt;
    return own ? own : options_.tolerance;
  }

  [[nodiscard]] PairQuery query_of(const PairAnswer& answer) const {
    const SceneInstance &a = models_[answer.a], &b = models_[answer.b];
    return {a.pose, b.pose, a.solid, b.solid};
  }

  /// With the point and, as far as it can be told, what kind of clash it is.
  void add_volume(PairAnswer& answer, Workspace& workspace) const {
    const PosedModel &a = posed_[answer.a], &b = posed_[answer.b];
    if (!have_common_volume(a, b)) return;
    if (are_surely_touching(answer.relation)) {
      answer.volume = OverlapVolume{};  // none, which is exact
      return;
    }
    const CommonSolid common = common_solid(a, b, workspace.scratch());
    answer.volume = common.volume;
    const PosedTriangles *mesh_a = only_mesh(a), *mesh_b = only_mesh(b);
    if (mesh_a == nullptr || mesh_b == nullptr) {
      answer.common_point = common.point;
      if (is_open_kind(answer) && common.curve_count > 0) tell_kind(answer, common, common.curve_count > 1);
      return;
    }
    std::vector<ContactRegion> found;
    if (answer.regions.empty() && (!common.point || common.curve_count > 1)) found = regions_of(answer, workspace);
    const std::vector<ContactRegion>& regions = answer.regions.empty() ? found : answer.regions;
    if (is_open_kind(answer) && common.curve_count > 0)
      tell_kind(answer, common, std::ranges::any_of(regions, passes_through));
    answer.common_point = inner_point(regions, mesh_a->mesh, mesh_b->mesh);
    if (!answer.common_point) answer.common_point = common.point;
    if (!answer.common_point)
      answer.common_point =
          inner_common_point(models_[answer.a].model, models_[answer.b].model, query_of(answer), workspace.scratch());
  }

  /// Off both surfaces, in the deepest region where one is found: half way across it, or where that is deepest, or a
  /// little from there towards the middle of the region.
  static std::optional<Vec3> inner_point(const std::vector<ContactRegion>& regions, const PosedMesh& a,
                                         const PosedMesh& b) {
    for (const ContactRegion& region : regions) {
      if (!region.depth || !(region.depth->lower > 0)) break;
      const Vec3 half = (0.5 * region.depth->lower) * region.normal;
      const Vec3 middle = 0.5 * region.box.lower + 0.5 * region.box.upper;
      for (const Vec3& point : {region.deepest, region.deepest - half, region.deepest + half}) {
        const Vec3 inward = point + (0.25 * region.depth->lower) * unit_or_zero(middle - point);
        for (const Vec3& one : {point, inward})
          if (is_interior(one, a) && is_interior(one, b)) return one;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::vector<ContactRegion> regions_of(const PairAnswer& answer, Workspace& workspace) const {
    return contact_regions(models_[answer.a].model, models_[answer.b].model, query_of(answer), workspace);
  }

  static bool is_open_kind(const PairAnswer& answer) {
    return answer.kind == PairAnswer::Kind::overlap && answer.relation.containment == Containment::none;
  }

  static bool passes_through(const ContactRegion& region) {
    return region.curve_count > 1 && region.depth && region.depth->upper > 0;
  }

  static void tell_kind(PairAnswer& answer, const CommonSolid& common, bool is_pierced) {
    using Piercing = PairAnswer::Piercing;
    answer.kind = is_pierced ? PairAnswer::Kind::pierce : PairAnswer::Kind::protrude;
    if (!is_pierced) return;
    answer.piercing = !common.pierces                     ? Piercing::unknown
                      : *common.pierces == ContactSide::a ? Piercing::a_through_b
                                                          : Piercing::b_through_a;
  }

  static PairAnswer::Kind kind_of_clash(const Relation& relation) {
    if (relation.kind == RelationKind::apart) return PairAnswer::Kind::clearance;
    if (relation.kind == RelationKind::touching) return PairAnswer::Kind::touching;
    if (relation.containment == Containment::equal) return PairAnswer::Kind::equal;
    if (relation.containment != Containment::none) return PairAnswer::Kind::contains;
    return relation.kind == RelationKind::crossing ? PairAnswer::Kind::crossing : PairAnswer::Kind::overlap;
  }

  /// Where clearances are asked for, and the two are as near.
  [[nodiscard]] std::optional<Distance> distance_in(const IndexPair& pair, Workspace& workspace) const {
    if (!clearances_.is_asked()) return std::nullopt;
    const double clearance = clearances_.of(pair);
    const SceneInstance &a = models_[pair.first], &b = models_[pair.second];
    workspace.scratch().convex = {};  // it was another pair's
    return distance_within(a.model, b.model, clearance, {a.pose, b.pose, a.solid, b.solid}, workspace);
  }

  /// A pair of quadrics is told where its interval leaves open whether it is as near as its clearance.
  static bool is_undecided(const Distance& distance, double clearance, const PosedModel& a, const PosedModel& b) {
    const auto is_quadric = [](const PosedPart& part) { return std::holds_alternative<PosedQuadric>(part.shape); };
    return distance.upper > clearance &&
           (std::ranges::any_of(a.parts, is_quadric) || std::ranges::any_of(b.parts, is_quadric));
  }

  /// The mesh that a model is, if it is one.
  static const PosedTriangles* only_mesh(const PosedModel& model) {
    return model.parts.size() == 1 ? std::get_if<PosedTriangles>(&model.parts[0].shape) : nullptr;
  }

  void answer_of_meshes(const PosedTrianglesView& a, const PosedTrianglesView& b, SearchScratch& scratch,
                        PairAnswer& answer) const {
    if (!options_.contacts) {
      answer.relation = relation_of(a, b, scratch);
      return;
    }
    const auto found = surface_contacts(a.mesh, b.mesh, scratch);
    answer.relation = relation_of(a, b, found);
    answer.contacts.assign(found.begin(), found.end());
  }

  void answer_of_shapes(const PosedModel& a, const PosedModel& b, SearchScratch& scratch, PairAnswer& answer) const {
    answer.relation = relation_of(a, b, scratch);
    if (!options_.contacts || answer.relation.kind == RelationKind::apart) return;
    const auto found = contacts_of(a, b, scratch, 1);
    answer.contacts.assign(found.begin(), found.end());
  }

  void add_depth(PairAnswer& answer, Workspace& workspace) const {
    const SceneInstance &a = models_[answer.a], &b = models_[answer.b];
    SearchScratch& scratch = workspace.scratch();
    scratch.convex = {};  // it was another pair's
    answer.manifold = manifold_where_defined(a.model, b.model, query_of(answer), workspace);
    tell_depth(answer, {a.model, b.model, query_of(answer), options_.depth}, workspace);
    if (a.model.has_mesh() && b.model.has_mesh()) {
      answer.regions = regions_of(answer, workspace);
    } else if (!answer.manifold) {
      answer.manifolds = manifolds_of(posed_[answer.a], posed_[answer.b], scratch);
    }
  }

  /// The contact points of every two elements that meet. Two half-spaces have none.
  static std::vector<ContactManifold> manifolds_of(const PosedModel& a, const PosedModel& b, SearchScratch& scratch) {
    const std::span<const Contact> found = contacts_of(a, b, scratch, 1);
    const std::vector<Contact> contacts(found.begin(), found.end());
    const auto is_half_space = [](const PosedPart& part) { return std::holds_alternative<PosedHalfSpace>(part.shape); };
    std::vector<ContactManifold> manifolds;
    for (const Contact& contact : contacts) {
      const PosedPart part_a = posed_element(a, contact.element_a), part_b = posed_element(b, contact.element_b);
      if (is_half_space(part_a) && is_half_space(part_b)) continue;
      scratch.convex = {};  // it was another pair's
      manifolds.push_back({contact, manifold_of(part_a, part_b, scratch)});
    }
    return manifolds;
  }

  std::span<const SceneInstance> models_;
  const CheckOptions& options_;
  const CheckPairRules& rules_;
  const CheckWatch& watch_;
  Clearances clearances_;
  std::vector<PosedModel> posed_;
  std::vector<std::size_t> groups_;
  mutable WorkspacePool workspaces_;
  mutable std::atomic<bool> stopped_ = false;
  mutable std::atomic<std::size_t> finished_ = 0;  ///< candidates that were looked at
  mutable std::mutex telling_;
};

}  // namespace

CheckAnswer check_all(std::span<const SceneInstance> models, const CheckOptions& options) {
  return check_wanted(models, options, {}).answer;
}

WantedAnswer check_wanted(std::span<const SceneInstance> models, const CheckOptions& options,
                          const CheckPairRules& rules, const CheckWatch& watch) {
  require_usable(options.depth);
  if (options.tolerance) require_length(*options.tolerance, "the tolerance");
  return Check(models, options, rules, watch).answer();
}

}  // namespace toccata
