#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "toccata/io/view_page.hpp"
#include "toccata/world/world.hpp"

namespace toccata {

/// The steps of a World, one after the other, for a page that shows them as time goes on. A body is drawn with the
/// shape that it had when it was first seen, also where `replace` has given it another one since.
class WorldRecording {
 public:
  /// That a page may hold, before they are written as text (base64: four thirds of it). The place of a body that has
  /// moved takes 24, a pair about 150.
  static constexpr std::size_t most_bytes = 48'000'000;

  enum class Change : std::uint8_t { begin, persist, end };

  struct Place {
    Index object = 0;  ///< of `objects`
    Pose pose;
  };
  struct Pair {
    Index a = 0, b = 0;  ///< of `objects`
    Change change = Change::begin;
    bool in_contact = false;
    Vec3 middle_a, middle_b;  ///< of their boxes; not finite for half-spaces
    std::shared_ptr<const PairDetails> details{};
  };
  struct Frame {
    std::vector<Place> placed;  ///< bodies that are new or have another pose than when they were last seen
    std::vector<Index> gone;    ///< that were there at the frame before
    std::vector<Pair> pairs;    ///< begin, persist and end
  };

  /// The bodies as they are and what the last step found: to be called after a step, before anything moves. Throws
  /// Error, and has changed nothing, when that is more than a page may hold.
  void add(const World& world);

  [[nodiscard]] std::span<const Body> objects() const { return objects_; }  ///< as they were first seen
  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }

 private:
  struct Seen {
    Index object = 0;
    Pose pose;
    Vec3 middle;  ///< of its box
  };
  struct Next;
  void add_bodies(const World& world, Next& next) const;
  void add_pairs(std::span<const PairReport> pairs, Change change, Next& next) const;

  std::vector<Body> objects_;
  std::vector<Frame> frames_;
  std::map<BodyId, Seen> seen_;
  std::vector<BodyId> there_;  ///< at the last frame
  std::size_t bytes_ = 0;
};

/// The bodies of `crowd --world` once more (run_crowd_world), with relations, contact points and depths, kept step by
/// step; the first is that before anything moves. Throws Error as WorldRecording and run_crowd_world do.
[[nodiscard]] WorldRecording record_crowd_world(const CrowdWorldQuestion& question, const Progress& progress = {});

/// A self-contained page as that of `view_page`: the bodies, a slider over the frames that moves them, the pairs of
/// each frame as they begin, persist and end, with contact points and distances where the World tells
/// these, and a list of them. Places are rounded for display to floats and turns to 1/32767; poses at first, depths and
/// distances are exact in its text. Of `options` it takes `title` and `up`. Throws Error when nothing is recorded, when
/// a body reaches beyond the doubles, and naming a body whose pose has changed by more than a turn and a move.
[[nodiscard]] std::string world_page(const WorldRecording& recording, const ViewOptions& options = {});

}  // namespace toccata
