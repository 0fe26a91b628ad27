#include "toccata/distributed/distributed_scene.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "distributed/pair_answer_bytes.hpp"
#include "distributed/ranks.hpp"
#include "distributed/space_of_ranks.hpp"
#include "distributed/wanted_of_scene.hpp"
#include "query/posed_shape.hpp"
#include "query/scenes/check_wanted.hpp"
#include "query/scenes/clearances.hpp"
#include "query/scenes/posed_name.hpp"
#include "toccata/broad/box_bvh.hpp"
#include "toccata/core/error.hpp"

namespace toccata {
class DistributedScene::State {
 public:
  /// What every rank keeps of a model.
  struct KnownModel {
    std::string name;
    std::string group;
    Aabb box;
    std::size_t part = 0;
  };

  State(MpiCommunicator communicator, std::size_t part_count, ReadPart read, double patience_seconds)
      : ranks_(communicator.fortran_handle, patience_seconds),
        part_count_(part_count),
        read_(std::move(read)),
        space_(ranks_.count()) {
    look_at_parts();
    divide();
  }

  WantedAnswer check(const CheckOptions& options, const CheckPairRules& rules) {
    require_same(options);
    const Clearances asked = clearances(options, rules.clearances);
    WantedAnswer found;
    ranks_.all_do([&] {
      found = decide(options, rules, asked);
      return false;
    });
    costs_.candidates = found.answer.candidate_pairs;
    std::array<std::uint64_t, 2> counts{costs_.candidates, found.left_out};
    ranks_.add_up(counts);
    found.answer = gathered(found.answer.pairs);
    found.answer.candidate_pairs = counts[0];
    found.left_out = counts[1];
    costs_.bytes_sent = ranks_.bytes_sent();
    return found;
  }

  [[nodiscard]] const Ranks& ranks() const { return ranks_; }
  [[nodiscard]] const std::vector<KnownModel>& models() const { return models_; }
  [[nodiscard]] std::size_t first_model(std::size_t part) const { return first_models_.at(part); }
  [[nodiscard]] const DistributedCheckCosts& costs() const { return costs_; }

 private:
  /// Throws Error on all ranks where one asks something else than rank 0. How many threads it takes is its own matter.
  void require_same(const CheckOptions& options) {
    MessageWriter own;
    for (const bool flag : {options.contacts, options.penetration, options.volume}) own.put(flag);
    for (const double number : {options.depth.precision, options.depth.time_limit}) own.put(number);
    for (const std::optional<double>& length : {options.tolerance, options.clearance}) {
      own.put(length.has_value());
      own.put(length.value_or(0));
    }
    own.put_all(std::span<const PairClearance>(options.pair_clearances));
    if (const std::optional<std::ptrdiff_t> other = ranks_.unlike_first(own.take()))
      throw Error(fmt::format("rank {} checks with other options than rank 0", *other));
  }

  /// A part that was read for its boxes alone.
  void put_known(MessageWriter& writer, const std::vector<SceneInstance>& models) const {
    writer.put(std::uint64_t{models.size()});
    for (std::size_t i = 0; i < models.size(); ++i) {
      const SceneInstance& one = models[i];
      writer.put_text(one.name);
      writer.put_text(one.group);
      writer.put(world_box(pose_model(one.model, one.pose, one.solid, name_for_messages(one, i))));
      writer.put(std::uint64_t{one.model.element_count()});
    }
  }

  void look_at_parts() {
    MessageWriter own;
    const auto ranks = static_cast<std::size_t>(ranks_.count());
    ranks_.all_do([&] {
      for (auto part = static_cast<std::size_t>(ranks_.rank()); part < part_count_; part += ranks)
        put_known(own, read_(part));
      return false;
    });
    const std::vector<Bytes> all = ranks_.of_all(own.take());
    std::vector<MessageReader> readers;
    for (const Bytes& bytes : all) readers.emplace_back(bytes);
    for (std::size_t part = 0; part < part_count_; ++part) {
      MessageReader& reader = readers[part % ranks];
      first_models_.push_back(models_.size());
      KnownPart known;
      for (auto count = reader.get<std::uint64_t>(); count > 0; --count) {
        KnownModel model;
        model.name = reader.get_text();
        model.group = reader.get_text();
        model.box = reader.get<Aabb>();
        model.part = part;
        known.elements += reader.get<std::uint64_t>();
        models_.push_back(std::move(model));
      }
      parts_.push_back(known);
    }
    first_models_.push_back(models_.size());
  }

  /// Each part has its home where its middle is.
  void divide() {
    std::vector<Vec3> places, own;
    std::vector<std::uint64_t> costs;
    for (std::size_t part = 0; part < part_count_; ++part) {
      Aabb box;
      for (std::size_t i = first_models_[part]; i < first_models_[part + 1]; ++i) box = merge(box, models_[i].box);
      places.push_back(place_of(box));
      if (part % static_cast<std::size_t>(ranks_.count()) != static_cast<std::size_t>(ranks_.rank())) continue;
      own.push_back(places.back());
      costs.push_back(parts_[part].elements);
    }
    if (ranks_.count() > 1) space_ = SpaceOfRanks(ranks_, own, costs);
    for (std::size_t part = 0; part < part_count_; ++part) parts_[part].home = space_.part_of(places[part]);
  }

  /// The home of the larger part, which so is not read elsewhere for this pair.
  [[nodiscard]] int decider_of(std::size_t a, std::size_t b) const {
    const auto [first, second] = std::minmax(a, b);
    return parts_[first].elements >= parts_[second].elements ? parts_[first].home : parts_[second].home;
  }
  [[nodiscard]] bool is_decided_here(std::size_t a, std::size_t b) const {
    return decider_of(models_[a].part, models_[b].part) == ranks_.rank();
  }

  /// What is wrong with them is found here, on all ranks alike, and not where a pair is decided.
  [[nodiscard]] Clearances clearances(const CheckOptions& options, const RuleClearances& rules) const {
    return {{models_.size(), [&](std::size_t i) { return name_for_messages(models_[i].name, i); },
             [&](std::size_t i) -> std::string_view { return models_[i].group; }},
            options,
            rules};
  }

  [[nodiscard]] bool are_near(const PairClearance& pair) const {
    const double half = half_rounded_up(pair.clearance);
    return overlap(widened(models_[pair.a].box, half), widened(models_[pair.b].box, half));
  }

  /// Those that hold a model of a pair which is decided here. A pair that is not asked about may be among them.
  [[nodiscard]] std::set<std::size_t> needed_parts(const Clearances& asked,
                                                   std::span<const PairClearance> of_pairs) const {
    std::vector<Aabb> boxes;
    for (std::size_t i = 0; i < models_.size(); ++i)
      boxes.push_back(widened(models_[i].box, half_rounded_up(asked.greatest_of(i))));
    const BoxBvh tree(boxes);
    std::set<std::size_t> needed;
    for (std::size_t i = 0; i < models_.size(); ++i) {
      if (parts_[models_[i].part].home != ranks_.rank()) continue;
      tree.visit_overlapping(boxes[i], [&](Index j) {
        if (j != i && is_decided_here(i, j)) needed.insert({models_[i].part, models_[j].part});
        return true;
      });
    }
    for (const PairClearance& pair : of_pairs) needed.insert({models_[pair.a].part, models_[pair.b].part});
    return needed;
  }

  /// Answers the pairs that are decided here; their numbers are those of all models.
  [[nodiscard]] WantedAnswer decide(const CheckOptions& options, const CheckPairRules& rules, const Clearances& asked) {
    CheckOptions own = options;
    std::erase_if(own.pair_clearances,
                  [&](const PairClearance& pair) { return !is_decided_here(pair.a, pair.b) || !are_near(pair); });
    // Distances are told of all pairs where a clearance is asked of any, also of none that is decided here.
    if (!options.pair_clearances.empty()) own.clearance = options.clearance.value_or(0);
    const std::set<std::size_t> needed = needed_parts(asked, own.pair_clearances);
    const ModelsHere here = read_again(needed);
    for (PairClearance& pair : own.pair_clearances) pair = {here.local(pair.a), here.local(pair.b), pair.clearance};
    WantedAnswer found = check_wanted(here.models, own, rules_here(rules, asked, here.numbers));
    for (PairAnswer& pair : found.answer.pairs) {
      pair.a = here.numbers[pair.a];
      pair.b = here.numbers[pair.b];
    }
    return found;
  }

  /// Models of parts that were read again, ascending by their numbers among all.
  struct ModelsHere {
    std::vector<SceneInstance> models;
    std::vector<Index> numbers;

    [[nodiscard]] Index local(Index model) const {
      return static_cast<Index>(std::lower_bound(numbers.begin(), numbers.end(), model) - numbers.begin());
    }
  };

  ModelsHere read_again(const std::set<std::size_t>& needed) {
    ModelsHere here;
    costs_.parts = needed.size();
    costs_.elements = 0;
    for (const std::size_t part : needed) {
      std::vector<SceneInstance> some = read_(part);
      if (some.size() != first_models_[part + 1] - first_models_[part])
        throw Error(fmt::format("part {} has {} models, and had {} when it was first read", part, some.size(),
                                first_models_[part + 1] - first_models_[part]));
      costs_.elements += parts_[part].elements - 1;
      for (std::size_t i = 0; i < some.size(); ++i) {
        here.numbers.push_back(static_cast<Index>(first_models_[part] + i));
        here.models.push_back(std::move(some[i]));
      }
    }
    return here;
  }

  /// What rules about all models say of those here, of the pairs that are decided here. All that they refer to must
  /// outlive them.
  [[nodiscard]] CheckPairRules rules_here(const CheckPairRules& rules, const Clearances& asked,
                                          const std::vector<Index>& numbers) const {
    const auto among_all = [&numbers](const IndexPair& pair) {
      return IndexPair{numbers[pair.first], numbers[pair.second]};
    };
    CheckPairRules here;
    here.here = [this, &asked, among_all](const IndexPair& pair) {
      const auto [a, b] = among_all(pair);
      return is_decided_here(a, b) && !asked.of_pairs().contains({a, b});
    };
    if (rules.wanted)
      here.wanted = [&rules, among_all](const IndexPair& pair) { return rules.wanted(among_all(pair)); };
    if (rules.tolerances)
      here.tolerances = [&rules, among_all](const IndexPair& pair) { return rules.tolerances(among_all(pair)); };
    if (!rules.clearances.of_pair) return here;
    here.clearances.of_pair = [&rules, among_all](const IndexPair& pair) {
      return rules.clearances.of_pair(among_all(pair));
    };
    for (const Index model : numbers) here.clearances.greatest.push_back(rules.clearances.greatest[model]);
    return here;
  }

  /// On rank 0 the pairs of all ranks, ascending.
  [[nodiscard]] CheckAnswer gathered(const std::vector<PairAnswer>& own) {
    std::map<int, MessageWriter> letters;
    for (const PairAnswer& pair : own) put_pair_answer(letters[0], pair);
    CheckAnswer answer;
    for (const Received& received : ranks_.exchange(letters))
      for (MessageReader reader(received.bytes); !reader.is_at_end();) answer.pairs.push_back(get_pair_answer(reader));
    std::ranges::sort(answer.pairs, {}, [](const PairAnswer& pair) { return std::pair(pair.a, pair.b); });
    return answer;
  }

  struct KnownPart {
    std::uint64_t elements = 1;
    int home = 0;
  };

  Ranks ranks_;
  std::size_t part_count_;
  ReadPart read_;
  SpaceOfRanks space_;
  std::vector<KnownModel> models_;
  std::vector<KnownPart> parts_;
  std::vector<std::size_t> first_models_;
  DistributedCheckCosts costs_;
};

DistributedScene::DistributedScene(MpiCommunicator communicator, std::size_t part_count, ReadPart read,
                                   double patience_seconds)
    : state_(std::make_unique<State>(communicator, part_count, std::move(read), patience_seconds)) {}
DistributedScene::DistributedScene(DistributedScene&&) noexcept = default;
DistributedScene& DistributedScene::operator=(DistributedScene&&) noexcept = default;
DistributedScene::~DistributedScene() = default;

CheckAnswer DistributedScene::check(const CheckOptions& options) { return check_wanted(*this, options, {}).answer; }
std::size_t DistributedScene::model_count() const { return state_->models().size(); }
std::size_t DistributedScene::first_model(std::size_t part) const { return state_->first_model(part); }
const std::string& DistributedScene::name(std::size_t model) const { return state_->models().at(model).name; }
const DistributedCheckCosts& DistributedScene::costs() const { return state_->costs(); }
int DistributedScene::rank() const { return state_->ranks().rank(); }

WantedAnswer check_wanted(DistributedScene& scene, const CheckOptions& options, const CheckPairRules& rules) {
  return scene.state_->check(options, rules);
}

}  // namespace toccata
