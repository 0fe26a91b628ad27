#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "convex_library.hpp"
#include "toccata/narrow/quadrics.hpp"

// When a ray or a convex shape on a straight way first meets another shape, and who answers that.
namespace toccata::bench {

/// Around the origin of its own frame, cylinders and cones along z; a point is that of a ray.
using CastBody = std::variant<Point, Box, Cylinder, Cone, Ellipsoid>;

struct CastPair {
  CastBody moving;
  CastBody standing;
};

struct CastQuestion {
  std::size_t pair = 0;
  Pose start{};  ///< of what moves; a ray begins at its offset
  Vec3 motion{};
  Pose standing{};
};

struct CastWork {
  std::string pair;  ///< "ray-cylinder", "cone-box", …: of all pairs
  std::vector<CastPair> pairs{};
  std::vector<CastQuestion> questions{};
};

struct CastAnswer {
  bool hit = false;
  double lower = 0;  ///< of the time, as a part of the way; of one who gives a single number, that
  double upper = 0;
  bool certain = true;  ///< false: the library itself says that it could not tell
};

/// Questions are asked, and times taken, by so many: one may take less time than a look at the clock.
inline constexpr std::size_t cast_block = 100;

class CastLibrary {
 public:
  virtual ~CastLibrary() = default;
  [[nodiscard]] virtual Description description() const = 0;
  /// Takes shapes and poses over in the library's own types; not measured. Called once.
  virtual void prepare(const CastWork& work) = 0;
  /// Answers the questions from `first` on, one for each element of `answers`.
  virtual void answer(std::size_t first, std::span<CastAnswer> answers) = 0;
};

struct CastOffer {
  std::vector<std::unique_ptr<CastLibrary>> libraries;
  std::vector<Unasked> unasked;
};

/// Calls `function` with the two types of shape of a pair as template arguments.
template <class Function>
auto with_cast_types(const std::string& pair, Function function) {
  if (pair == "ray-cylinder") return function.template operator()<Point, Cylinder>();
  if (pair == "ray-cone") return function.template operator()<Point, Cone>();
  if (pair == "ray-ellipsoid") return function.template operator()<Point, Ellipsoid>();
  if (pair == "cylinder-box") return function.template operator()<Cylinder, Box>();
  if (pair == "cone-box") return function.template operator()<Cone, Box>();
  return function.template operator()<Ellipsoid, Ellipsoid>();
}

/// What Toccata tells of shapes that it poses for this question.
template <class Moving, class Standing>
std::optional<Cast> cast_given(const Moving& moving, const Standing& standing, const CastQuestion& question) {
  const PosedAs<Standing> target(standing, question.standing);
  if constexpr (std::is_same_v<Moving, Point>)
    return cast_ray(question.start.offset, question.motion, target);
  else
    return cast_shape(PosedAs<Moving>(moving, question.start), question.motion, target);
}

/// The pairs that --pair takes, and the names that --peer takes.
std::vector<std::string> cast_pairs();
std::vector<std::string> cast_peers();

CastOffer toccata_casts(const CastWork& work);
CastOffer bullet_casts(const CastWork& work);
CastOffer fcl_casts(const CastWork& work);
CastOffer ode_casts(const CastWork& work);

/// Toccata first, then the named peers.
CastOffer cast_libraries(const std::vector<std::string>& peers, const CastWork& work);

}  // namespace toccata::bench
