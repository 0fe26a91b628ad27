#include "toccata/query/check_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "query/contacts/part_contacts.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/penetration/solid_penetration.hpp"
#include "query/relation/relation_posed.hpp"
#include "query/scenes/posed_name.hpp"
#include "query/scenes/task_reporter.hpp"
#include "query/workspace_pool.hpp"
#include "toccata/broad/box_pairs.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/query/closer_than.hpp"

namespace toccata {
namespace {

// Pairs are looked at so many at once: memory follows the objects and the answer, not the pairs whose boxes overlap.
constexpr std::size_t pairs_at_once = 4096;

bool is_bounded(const Aabb& box) { return is_empty(box) || (is_finite(box.lower) && is_finite(box.upper)); }

void require_length(double clearance) {
  if (!(clearance >= 0)) throw Error(fmt::format("a clearance is {}; it has to be a length of 0 or more", clearance));
}

/// Rounded up.
double half_of(double length) { return std::max(0.5 * length, length - 0.5 * length); }

/// How near which pairs have to be to be told.
class Clearances {
 public:
  Clearances(std::span<const Posed> models, const CheckOptions& options)
      : is_asked_(options.clearance || !options.pair_clearances.empty()),
        common_(options.clearance.value_or(0)),
        largest_(models.size(), common_) {
    require_length(common_);
    for (const PairClearance& pair : options.pair_clearances) {
      require_length(pair.clearance);
      require_pair(models, pair);
      const auto [place, is_new] = of_pair_.emplace(std::minmax(pair.a, pair.b), pair.clearance);
      if (!is_new && place->second != pair.clearance)
        throw Error(fmt::format("for {} two clearances are asked, {} and {}; a pair has one", names_of(models, pair),
                                place->second, pair.clearance));
      for (const Index i : {pair.a, pair.b}) largest_[i] = std::max(largest_[i], pair.clearance);
    }
  }

  [[nodiscard]] bool is_asked() const { return is_asked_; }

  /// Whether all pairs have the same.
  [[nodiscard]] bool are_equal() const { return of_pair_.empty(); }

  /// Of a pair in ascending order.
  [[nodiscard]] double of(const IndexPair& pair) const {
    const auto found = of_pair_.find({pair.first, pair.second});
    return found == of_pair_.end() ? common_ : found->second;
  }

  /// Not less than that of any pair of this model.
  [[nodiscard]] double largest_of(std::size_t model) const { return largest_[model]; }

 private:
  static std::string names_of(std::span<const Posed> models, const PairClearance& pair) {
    const auto [first, second] = std::minmax(pair.a, pair.b);
    return name_for_messages(models[first], first) + " and " + name_for_messages(models[second], second);
  }

  static void require_pair(std::span<const Posed> models, const PairClearance& pair) {
    if (pair.a >= models.size() || pair.b >= models.size() || pair.a == pair.b)
      throw Error(fmt::format("a clearance is asked for models {} and {}, and there are two different ones of {}",
                              pair.a, pair.b, models.size()));
    const std::string& group = models[pair.a].group;
    if (!group.empty() && group == models[pair.b].group)
      throw Error(
          fmt::format("a clearance is asked for {}, which are not checked against each other: both are in the "
                      "group \"{}\"",
                      names_of(models, pair), group));
  }

  bool is_asked_;
  double common_;
  std::vector<double> largest_;
  std::map<std::pair<Index, Index>, double> of_pair_;
};

class Check {
 public:
  Check(std::span<const Posed> models, const CheckOptions& options)
      : models_(models),
        options_(options),
        clearances_(models, options),
        posed_(posed_models()),
        groups_(group_numbers()),
        world_boxes_(world_boxes()),
        boxes_(grown_boxes()) {}

  CheckAnswer answer() {
    const std::vector<std::size_t> counts = candidate_counts();
    CheckAnswer answer;
    answer.candidate_pairs = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
    TaskReporter reporter(options_.progress, answer.candidate_pairs);
    for (std::size_t first = 0, last = 0; first < counts.size(); first = last) {
      std::size_t pairs = counts[last++];
      while (last < counts.size() && pairs + counts[last] <= pairs_at_once) pairs += counts[last++];
      for (std::optional<PairAnswer>& pair : answers_of(candidates_of(first, last), reporter))
        if (pair) answer.pairs.push_back(std::move(*pair));
    }
    return answer;
  }

 private:
  /// Looks at every model alone, wherever it is: what is asked wrongly is an error, also far from everything else.
  [[nodiscard]] std::vector<PosedModel> posed_models() const {
    std::vector<PosedModel> made(models_.size());
    parallel_for(models_.size(), options_.threads, [&](std::size_t i) {
      const Posed& model = models_[i];
      made[i] = pose_model(model.model, model.pose, model.solid, name_for_messages(model, i));
    });
    return made;
  }

  /// Equal for models of one group, and 0 for those of none.
  [[nodiscard]] std::vector<std::size_t> group_numbers() const {
    std::map<std::string_view, std::size_t> number_of{{"", 0}};
    std::vector<std::size_t> numbers;
    numbers.reserve(models_.size());
    for (const Posed& model : models_)
      numbers.push_back(number_of.emplace(model.group, number_of.size()).first->second);
    return numbers;
  }

  [[nodiscard]] std::vector<Aabb> world_boxes() const {
    std::vector<Aabb> boxes;
    boxes.reserve(posed_.size());
    for (const PosedModel& model : posed_) boxes.push_back(world_box(model));
    return boxes;
  }

  /// Half-spaces have no end; what of one lies where the others are is all that matters.
  [[nodiscard]] BoxIndex grown_boxes() const {
    std::vector<Aabb> boxes;
    boxes.reserve(posed_.size());
    for (std::size_t i = 0; i < posed_.size(); ++i)
      boxes.push_back(grown(world_boxes_[i], half_of(clearances_.largest_of(i))));
    Aabb all{{0, 0, 0}, {0, 0, 0}};
    for (const Aabb& box : boxes)
      if (is_bounded(box)) all = merge(all, box);
    for (Aabb& box : boxes)
      if (!is_bounded(box)) box = all;
    return BoxIndex(boxes);
  }

  /// Whether the boxes of the two, i < j, are as near as the clearance of that pair; those of their other pairs may be
  /// larger.
  [[nodiscard]] bool are_boxes_near(std::size_t i, Index j) const {
    const double half = half_of(clearances_.of({static_cast<Index>(i), j}));
    return overlap(grown(world_boxes_[i], half), grown(world_boxes_[j], half));
  }

  /// The models after `i` that it may meet.
  [[nodiscard]] std::vector<Index> partners_after(std::size_t i) const {
    std::vector<Index> partners = boxes_.overlapping_after(static_cast<Index>(i));
    if (groups_[i] != 0) std::erase_if(partners, [&](Index j) { return groups_[j] == groups_[i]; });
    if (!clearances_.are_equal()) std::erase_if(partners, [&](Index j) { return !are_boxes_near(i, j); });
    return partners;
  }

  [[nodiscard]] std::vector<std::size_t> candidate_counts() const {
    std::vector<std::size_t> counts(models_.size());
    parallel_for(counts.size(), options_.threads, [&](std::size_t i) { counts[i] = partners_after(i).size(); });
    return counts;
  }

  /// The pairs of the models [first, last) with later ones, ascending.
  [[nodiscard]] std::vector<IndexPair> candidates_of(std::size_t first, std::size_t last) const {
    std::vector<std::vector<Index>> partners(last - first);
    parallel_for(partners.size(), options_.threads, [&](std::size_t i) { partners[i] = partners_after(first + i); });
    std::vector<IndexPair> pairs;
    for (std::size_t i = 0; i < partners.size(); ++i)
      for (const Index j : partners[i]) pairs.push_back({static_cast<Index>(first + i), j});
    return pairs;
  }

  [[nodiscard]] std::vector<std::optional<PairAnswer>> answers_of(std::span<const IndexPair> pairs,
                                                                  TaskReporter& reporter) const {
    std::vector<std::optional<PairAnswer>> answers(pairs.size());
    parallel_for(pairs.size(), options_.threads, [&](std::size_t i) {
      if (reporter.cancelled()) return;
      answers[i] = workspaces_.with([&](Workspace& workspace) { return answer_of(pairs[i], workspace); });
      reporter.finished_one();
    });
    return answers;
  }

  /// Nothing where the two are apart, by more than their clearance.
  [[nodiscard]] std::optional<PairAnswer> answer_of(const IndexPair& pair, Workspace& workspace) const {
    SearchScratch& scratch = workspace.scratch();
    const PosedModel& a = posed_[pair.first];
    const PosedModel& b = posed_[pair.second];
    PairAnswer answer{pair.first, pair.second, {}, {}, {}, {}, {}, {}};
    const PosedTriangles *mesh_a = only_mesh(a), *mesh_b = only_mesh(b);
    if (mesh_a != nullptr && mesh_b != nullptr)
      answer_of_meshes({mesh_a->mesh, mesh_a->solid}, {mesh_b->mesh, mesh_b->solid}, scratch, answer);
    else
      answer_of_shapes(a, b, scratch, answer);
    answer.distance = distance_in(pair, workspace);
    if (answer.relation.kind == RelationKind::apart) return answer.distance ? std::optional(answer) : std::nullopt;
    if (options_.penetration) add_depth(answer);
    return answer;
  }

  /// Where clearances are asked for, and the two are as near.
  [[nodiscard]] std::optional<Distance> distance_in(const IndexPair& pair, Workspace& workspace) const {
    if (!clearances_.is_asked()) return std::nullopt;
    const double clearance = clearances_.of(pair);
    const Posed &a = models_[pair.first], &b = models_[pair.second];
    workspace.scratch().convex = {};  // it was another pair's
    return distance_within(a.model, b.model, clearance, {a.pose, b.pose, a.solid, b.solid}, workspace);
  }

  /// The mesh that a model is, if it is one.
  static const PosedTriangles* only_mesh(const PosedModel& model) {
    return model.parts.size() == 1 ? std::get_if<PosedTriangles>(&model.parts[0].shape) : nullptr;
  }

  void answer_of_meshes(const TakenMesh& a, const TakenMesh& b, SearchScratch& scratch, PairAnswer& answer) const {
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

  /// Where the table of pairs.hpp defines it.
  void add_depth(PairAnswer& answer) const {
    const Posed &a = models_[answer.a], &b = models_[answer.b];
    const PairQuery query{a.pose, b.pose, a.solid, b.solid};
    const auto defined = [&](ShapeQuestion question) {
      return pair_cell(question, kind_of(a.model.shape()), kind_of(b.model.shape())).state == PairState::defined;
    };
    if (a.model.has_mesh() && b.model.has_mesh()) answer.regions = contact_regions(a.model, b.model, query);
    if (defined(ShapeQuestion::manifold)) answer.manifold = manifold(a.model, b.model, query);
    if (answer.relation.a_solid && answer.relation.b_solid && defined(ShapeQuestion::penetration) &&
        may_be_parted(posed_[answer.a], posed_[answer.b]))
      answer.penetration = penetration(a.model, b.model, query);
  }

  std::span<const Posed> models_;
  const CheckOptions& options_;
  Clearances clearances_;
  std::vector<PosedModel> posed_;
  std::vector<std::size_t> groups_;
  std::vector<Aabb> world_boxes_;
  BoxIndex boxes_;  ///< each grown by half the largest clearance of its model
  mutable WorkspacePool workspaces_;
};

}  // namespace

CheckAnswer check_all(std::span<const Posed> models, const CheckOptions& options) {
  return Check(models, options).answer();
}

}  // namespace toccata
