#include "toccata/query/check_all.hpp"

#include <algorithm>
#include <optional>

#include "query/pair_search.hpp"
#include "query/posed_mesh.hpp"
#include "query/posed_name.hpp"
#include "query/relation_posed.hpp"
#include "query/semantics.hpp"
#include "query/task_reporter.hpp"
#include "toccata/broad/box_pairs.hpp"
#include "toccata/core/parallel.hpp"

namespace toccata {
namespace {

// Answers of pairs that are apart are dropped after every so many pairs, so that memory follows the answer.
constexpr std::size_t pairs_at_once = 4096;

class Check {
 public:
  Check(std::span<const Posed> models, const CheckOptions& options)
      : models_(models), options_(options), solid_(models.size()), posed_(models.size()) {}

  CheckAnswer answer() {
    const std::vector<IndexPair> pairs = candidate_pairs();
    pose_models_of(pairs);
    CheckAnswer answer;
    answer.candidate_pairs = pairs.size();
    TaskReporter reporter(options_.progress, pairs.size());
    for (std::size_t first = 0; first < pairs.size(); first += pairs_at_once) {
      const auto chunk = std::span(pairs).subspan(first, std::min(pairs_at_once, pairs.size() - first));
      for (std::optional<PairAnswer>& pair : answers_of(chunk, reporter))
        if (pair) answer.pairs.push_back(std::move(*pair));
    }
    return answer;
  }

 private:
  [[nodiscard]] std::string name_of(std::size_t i) const { return name_for_messages(models_[i], i); }

  [[nodiscard]] PosedMesh pose_model(std::size_t i) const { return {models_[i].model, models_[i].pose, name_of(i)}; }

  [[nodiscard]] bool in_one_group(const IndexPair& pair) const {
    const std::string& group = models_[pair.first].group;
    return !group.empty() && group == models_[pair.second].group;
  }

  /// Looks at every model alone, wherever it is: what is asked wrongly is an error, also far from everything else.
  std::vector<IndexPair> candidate_pairs() {
    std::vector<Aabb> boxes(models_.size());
    parallel_for(models_.size(), options_.threads, [&](std::size_t i) {
      solid_[i] = taken_as_solid(models_[i].model, models_[i].pose, models_[i].solid, name_of(i)) ? 1 : 0;
      boxes[i] = pose_model(i).box();
    });
    std::vector<IndexPair> pairs = overlapping_pairs(boxes);
    std::erase_if(pairs, [&](const IndexPair& pair) { return in_one_group(pair); });
    return pairs;
  }

  /// Poses every model that is in a pair, once.
  void pose_models_of(std::span<const IndexPair> pairs) {
    std::vector<Index> needed;
    for (const IndexPair& pair : pairs) needed.insert(needed.end(), {pair.first, pair.second});
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    parallel_for(needed.size(), options_.threads,
                 [&](std::size_t i) { posed_[needed[i]].emplace(pose_model(needed[i])); });
  }

  std::vector<std::optional<PairAnswer>> answers_of(std::span<const IndexPair> pairs, TaskReporter& reporter) const {
    std::vector<std::optional<PairAnswer>> answers(pairs.size());
    parallel_for(pairs.size(), options_.threads, [&](std::size_t i) {
      if (reporter.cancelled()) return;
      answers[i] = answer_of(pairs[i]);
      reporter.finished_one();
    });
    return answers;
  }

  /// Nothing where the two are apart.
  [[nodiscard]] std::optional<PairAnswer> answer_of(const IndexPair& pair) const {
    const PosedMesh& a = *posed_[pair.first];
    const PosedMesh& b = *posed_[pair.second];
    const Relation relation = relation_of({a, solid_[pair.first] != 0}, {b, solid_[pair.second] != 0});
    if (relation.kind == RelationKind::apart) return std::nullopt;
    return PairAnswer{pair.first, pair.second, relation,
                      options_.contacts ? surface_contacts(a, b) : std::vector<Contact>()};
  }

  std::span<const Posed> models_;
  const CheckOptions& options_;
  std::vector<char> solid_;  // written from many threads, so not bits
  std::vector<std::optional<PosedMesh>> posed_;
};

}  // namespace

CheckAnswer check_all(std::span<const Posed> models, const CheckOptions& options) {
  return Check(models, options).answer();
}

}  // namespace toccata
