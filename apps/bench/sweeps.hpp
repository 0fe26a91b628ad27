#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "convex_library.hpp"
#include "toccata/motion/rigid_motion.hpp"

// When two bodies that move and turn first meet, and who answers that.
namespace toccata::bench {

/// A mesh is taken as a surface where it is open.
using SweepBody = std::variant<Sphere, Capsule, Box, ConvexHull, std::shared_ptr<const TriangleMesh>>;

/// The origin of a body's own frame goes straight on at an even speed and the body turns about it at another, by less
/// than half a turn: so two poses tell the motion, and every library has the same.
struct SweepWay {
  Pose start{};
  Pose end{};
  [[nodiscard]] RigidMotion motion() const { return RigidMotion::between(start, end); }
};

struct SweepQuestion {
  std::size_t pair = 0;
  SweepWay a;
  SweepWay b;
};

struct SweepPair {
  SweepBody a;
  SweepBody b;
};

struct SweepWork {
  std::string set;
  std::vector<SweepPair> pairs{};
  std::vector<SweepQuestion> questions{};
  std::size_t block = 1;  ///< so many questions are asked, and times taken, at a time
};

struct SweepAnswer {
  bool hit = false;
  bool is_decided = true;  ///< false: it may be no hit, and who answers says so
  double lower = 0;        ///< of the time; of one who gives a single number, that
  double upper = 0;
};

class SweepLibrary {
 public:
  virtual ~SweepLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes shapes and poses over in the library's own types; not measured. Called once.
  virtual void prepare(const SweepWork& work) = 0;
  /// Answers the questions from `first` on, one for each element of `answers`.
  virtual void answer(std::size_t first, std::span<SweepAnswer> answers) = 0;
  /// Where the library puts the bodies of a question at a time, which is to be where they are.
  [[nodiscard]] virtual PosePair poses_at(std::size_t question, double time) = 0;
};

struct SweepOffer {
  std::vector<std::unique_ptr<SweepLibrary>> libraries;
  std::vector<Unasked> unasked;
};

/// The names that --peer takes.
std::vector<std::string> sweep_peers();

SweepOffer toccata_sweeps(const SweepWork& work);
SweepOffer bullet_sweeps(const SweepWork& work);
SweepOffer fcl_sweeps(const SweepWork& work);

/// Toccata first, then the named peers.
SweepOffer sweep_libraries(const std::vector<std::string>& peers, const SweepWork& work);

}  // namespace toccata::bench
