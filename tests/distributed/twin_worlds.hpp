#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "distributed/ranks.hpp"
#include "toccata/core/error.hpp"
#include "toccata/distributed.hpp"
#include "toccata/world/world.hpp"

namespace toccata::test {

[[nodiscard]] MpiCommunicator all_ranks();
/// For the tests' own messages.
[[nodiscard]] Ranks& our_ranks();

/// Values of all ranks, one rank after the other.
template <class T>
std::vector<T> gathered(const std::vector<T>& own) {
  MessageWriter writer;
  writer.put_all(std::span<const T>(own));
  std::vector<T> all;
  for (const Bytes& bytes : our_ranks().of_all(writer.take()))
    for (const T& one : MessageReader(bytes).get_all<T>()) all.push_back(one);
  return all;
}

inline std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing was thrown";
}

inline void expect_message(const std::function<void()>& call, const std::string& words) {
  const std::string message = message_of(call);
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

/// Touching spheres, each two next to each other.
inline std::vector<Body> row_of_spheres(int count) {
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back({Sphere(0.6), Pose::translation(i, 0, 0)});
  return bodies;
}

struct ToldPair {
  GlobalId a = 0, b = 0;
  bool in_contact = false;
  friend auto operator<=>(const ToldPair&, const ToldPair&) = default;
};

/// The same bodies in a DistributedWorld and, on every rank, in one World: what they tell has to be the same.
class TwinWorlds {
 public:
  explicit TwinWorlds(const DistributedOptions& options = {})
      : world(options.world), distributed(all_ranks(), with_patience(options)) {}

  /// Each body is given by one rank, whichever.
  void add(std::span<const Body> bodies) {
    std::vector<GlobalBody> own;
    for (const Body& body : bodies) {
      const GlobalId id = 1000 + 7 * next_++;
      const BodyId local = world.add(body);
      ids_[local] = id;
      locals_[id] = local;
      if (static_cast<int>((id / 7 * 5) % static_cast<GlobalId>(distributed.rank_count())) == distributed.rank())
        own.push_back({id, body});
    }
    distributed.add(own);
  }

  void move(BodyId local, const Pose& pose) {
    world.move(local, pose);
    const GlobalId id = ids_.at(local);
    if (distributed.lives_here(id)) distributed.move({&id, 1}, {&pose, 1});
  }

  void move_along(BodyId local, const RigidMotion& motion) {
    world.move_along(local, motion);
    const GlobalId id = ids_.at(local);
    if (distributed.lives_here(id)) distributed.move_along({&id, 1}, {&motion, 1});
  }

  void deform(BodyId local, const std::vector<Vec3>& vertices) {
    world.deform(local, vertices);
    const GlobalId id = ids_.at(local);
    if (distributed.lives_here(id)) distributed.deform(id, vertices);
  }

  /// Given by one rank, whichever.
  void set_rule(const PairRule& rule) {
    world.set_rule(rule);
    const GlobalPairRule named{ids_.at(rule.a), ids_.at(rule.b), rule.excluded, rule.margin};
    if (static_cast<int>((named.a + named.b) % static_cast<GlobalId>(distributed.rank_count())) == distributed.rank())
      distributed.set_rules({&named, 1});
  }

  void replace(BodyId local, const Body& body) {
    world.replace(local, body);
    const GlobalBody named{ids_.at(local), body};
    if (distributed.lives_here(named.id)) distributed.replace({&named, 1});
  }

  void remove(BodyId local) {
    world.remove(local);
    const GlobalId id = ids_.at(local);
    if (distributed.lives_here(id)) distributed.remove({&id, 1});
  }

  /// Removes it and gives its id to a new body, on a rank that need not be where it lives.
  void remove_and_add(BodyId local, const Body& body) {
    const GlobalId id = ids_.at(local);
    remove(local);
    const BodyId next = world.add(body);
    ids_[next] = id;
    locals_[id] = next;
    const GlobalBody named{id, body};
    if (static_cast<int>(id % static_cast<GlobalId>(distributed.rank_count())) == distributed.rank())
      distributed.add({&named, 1});
  }

  /// Both steps, compared.
  void step() {
    const WorldStep& expected = world.step();
    const DistributedStep& found = distributed.step();
    EXPECT_EQ(differences(all_told(found.begin), told(expected.begin)), "") << "begin";
    EXPECT_EQ(differences(all_told(found.persist), told(expected.persist)), "") << "persist";
    EXPECT_EQ(differences(all_told(found.end), told(expected.end)), "") << "end";
    std::vector<GlobalId> live = gathered(distributed.bodies()), wanted;
    std::sort(live.begin(), live.end());
    for (const BodyId local : world.bodies()) wanted.push_back(ids_.at(local));
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(live, wanted) << "each body lives on one rank";
    compare_details(found.begin);
    compare_details(found.persist);
  }

  [[nodiscard]] GlobalId id_of(BodyId local) const { return ids_.at(local); }

  /// What this rank tells.
  static std::vector<ToldPair> own_told(std::span<const GlobalPairReport> reports) {
    std::vector<ToldPair> own;
    for (const GlobalPairReport& pair : reports) own.push_back({pair.a, pair.b, pair.in_contact});
    EXPECT_TRUE(std::is_sorted(own.begin(), own.end()));
    return own;
  }

  /// What all ranks tell, ascending.
  static std::vector<ToldPair> all_told(std::span<const GlobalPairReport> reports) {
    std::vector<ToldPair> all = gathered(own_told(reports));
    std::sort(all.begin(), all.end());
    return all;
  }

  World world;
  DistributedWorld distributed;

 private:
  static DistributedOptions with_patience(DistributedOptions options) {
    options.patience_seconds = 300;
    return options;
  }

  std::vector<ToldPair> told(const std::vector<PairReport>& reports) const {
    std::vector<ToldPair> pairs;
    for (const PairReport& pair : reports) {
      const auto [a, b] = std::minmax(ids_.at(pair.a), ids_.at(pair.b));
      pairs.push_back({a, b, pair.in_contact});
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// What one of two ascending lists has and the other has not.
  static std::string differences(const std::vector<ToldPair>& found, const std::vector<ToldPair>& expected) {
    std::string words;
    const auto add = [&](const char* what, const std::vector<ToldPair>& one, const std::vector<ToldPair>& other) {
      std::vector<ToldPair> more;
      std::set_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(more));
      for (const ToldPair& pair : more)
        words += fmt::format("{} ({}, {}){}; ", what, pair.a, pair.b, pair.in_contact ? " in contact" : "");
    };
    add("invented", found, expected);
    add("missing", expected, found);
    return words;
  }

  /// What is told of each pair, bit for bit.
  void compare_details(const std::vector<GlobalPairReport>& reports) const {
    std::map<std::pair<BodyId, BodyId>, const PairDetails*> expected;
    for (const PairReport& pair : world.pairs()) expected[{pair.a, pair.b}] = pair.details.get();
    for (const GlobalPairReport& pair : reports) {
      const BodyId a = locals_.at(pair.a), b = locals_.at(pair.b);
      if (a.index > b.index) continue;  // an index that was given out again: the World tells of (b, a)
      const auto known = expected.find({a, b});
      ASSERT_NE(known, expected.end()) << pair.a << " and " << pair.b;
      ASSERT_EQ(pair.details == nullptr, known->second == nullptr);
      if (pair.details != nullptr) {
        EXPECT_EQ(*pair.details, *known->second) << pair.a << " and " << pair.b;
      }
    }
  }

  GlobalId next_ = 0;
  std::map<BodyId, GlobalId> ids_;
  std::map<GlobalId, BodyId> locals_;
};

}  // namespace toccata::test
