#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/core/index.hpp"
#include "toccata/core/random.hpp"
#include "toccata/generate/scenes.hpp"
#include "toccata/math/pose.hpp"
#include "toccata/shapes/convex_hull.hpp"
#include "toccata/shapes/shape.hpp"

namespace toccata {

/// Boxes that move, for trying and measuring broad phases: about three pairs a box overlap. The same name, count and
/// seed give the same boxes in every frame, on every machine.
class Crowd {
 public:
  /// Throws Error naming the closest when there is no such scene.
  Crowd(std::string_view scene, std::size_t count, std::uint64_t seed = 1);

  [[nodiscard]] const std::vector<Aabb>& boxes() const { return boxes_; }
  /// The next frame. Gives the numbers of the boxes that moved, ascending.
  std::span<const Index> step();

 private:
  struct Body {
    Vec3 centre, half, velocity;  ///< a frame
    Vec3 least{}, most{};         ///< the centre stays between them
  };
  static void put_into_pile(Body& body, Index number, Index per_side);
  void place(Index number);

  std::vector<Body> bodies_;
  std::vector<Aabb> boxes_;
  std::vector<Index> moving_;
  double gravity_ = 0;      ///< a frame and frame
  bool on_ground_ = false;  ///< z follows x and y
};

/// uniform, clustered, sizes, static, terrain, fast, bounce and pile.
[[nodiscard]] std::span<const NamedScene> crowd_scenes();

/// Pairs in one number, whatever their order: other pairs have another one, but for one chance in 2^64.
struct PairDigest {
  std::size_t count = 0;
  std::uint64_t sum = 0;
  friend bool operator==(const PairDigest&, const PairDigest&) = default;
};

[[nodiscard]] PairDigest digest_of(std::span<const IndexPair> pairs);

/// What each frame of a crowd took, and its pairs.
struct CrowdFrames {
  std::vector<double> milliseconds;
  std::vector<PairDigest> pairs;

  [[nodiscard]] double median_ms() const;
  [[nodiscard]] double worst_ms() const { return *std::max_element(milliseconds.begin(), milliseconds.end()); }
};

/// Moves a crowd (`Crowd`, or what has its `step` and `boxes`) through its frames, at least one. `find` is given the
/// numbers of the boxes that moved, finds all pairs of the crowd's boxes and returns the milliseconds that it took;
/// `pairs` returns the digest of what it found.
template <class AnyCrowd, class Find, class Pairs>
CrowdFrames run_frames(AnyCrowd& crowd, std::size_t frames, const Find& find, const Pairs& pairs) {
  CrowdFrames run;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::span<const Index> moved = crowd.step();
    run.milliseconds.push_back(find(moved));
    run.pairs.push_back(pairs());
  }
  return run;
}

/// Spheres, boxes, capsules and convex hulls of about size 1 that fly and turn in a room, or lie, roll and fall, for
/// trying and measuring worlds of bodies. The same scene, count, share and seed give the same bodies in every frame, on
/// every machine. Nothing is simulated: bodies go on as they began.
class BodyCrowd {
 public:
  /// A crowd of bodies that fly. About this share of them is in contact at a time. Throws Error unless it lies between
  /// 0.001 and 1.
  explicit BodyCrowd(std::size_t count, double share_in_contact = 0.05, std::uint64_t seed = 1);
  /// One of the scenes of `body_crowd_scenes`, with `count` bodies besides the ground, which is body 0 of all scenes
  /// but `fly`. Throws Error naming the closest when there is no such scene.
  BodyCrowd(std::string_view scene, std::size_t count, std::uint64_t seed = 1);

  /// Shapes and places begin with the ground, if there is one.
  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }
  /// Where they are now: rotations and translations.
  [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }
  /// How many of the first bodies are ground, which stays: 0 or 1.
  [[nodiscard]] std::size_t ground_count() const { return ground_count_; }
  /// The next frame: each moves by up to a fiftieth and turns by up to three degrees; what falls, faster.
  void step();

 private:
  enum class Motion : std::uint8_t { fly, tremble, roll, fall, stay };

  struct Flight {
    Vec3 centre, velocity;  ///< a frame
    Vec3 axis;
    double angle = 0, spin = 0;  ///< degrees, a frame
    Motion motion = Motion::fly;
  };

  void fill(std::size_t count, Random& random);
  void add_ground(std::string_view scene);
  void add_stacks(std::size_t count, Random& random);
  void add_pile(std::size_t count, Random& random);
  void add_falling(std::size_t count, Random& random);
  void add(const Shape& shape, const Flight& flight);
  /// So far above where it lies.
  void lay_down(std::size_t number, double above);
  void go_on(std::size_t number);
  void place(std::size_t number);
  [[nodiscard]] double resting_height(std::size_t number) const;

  std::vector<ConvexHull> hulls_;
  std::vector<Shape> shapes_;
  std::vector<Flight> flights_;
  std::vector<Pose> poses_;
  std::size_t ground_count_ = 0;
  std::size_t frame_ = 0;
  double room_ = 0;  ///< centres stay between 0 and this, along x and y where there is ground
  bool has_hills_ = false;
};

/// fly, stacks, pile, floor and terrain.
[[nodiscard]] std::span<const NamedScene> body_crowd_scenes();

}  // namespace toccata
