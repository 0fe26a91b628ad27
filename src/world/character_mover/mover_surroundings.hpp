#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "query/scenes/object_search.hpp"
#include "world/character_mover/mover_body.hpp"
#include "world/character_mover/plane_cast.hpp"

namespace toccata {

/// Something that a body comes as near to as it may.
struct MoverMeeting {
  double time = 0;  ///< the fraction of the way; proved: before it nothing is nearer
  MoverGap gap;     ///< then
  LevelElement thing;
  bool is_proved = true;  ///< no: it may be passed, but that could not be proved
};

/// A thing that a body is near to.
struct NearThing {
  MoverGap gap;
  const LevelElement* thing;  ///< until the surroundings are asked again
};

/// What of a level is around a body. What was looked up once is kept for the rest of a step.
class MoverSurroundings {
 public:
  /// The body stays `least_gap` from everything, or as far as it was.
  MoverSurroundings(const SearchedObjects& objects, const MoverBody& body, double skin, double least_gap)
      : objects_(objects), body_(body), skin_(skin), least_gap_(least_gap) {}

  /// What is in the box will be asked for.
  void look_around(const Aabb& box);

  /// What is first met on a way; nothing of the object `without`. None: the whole way is proved to be free.
  [[nodiscard]] std::optional<MoverMeeting> first_meeting(const Vec3& position, const Vec3& motion,
                                                          std::optional<Index> without = {});

  /// All that is no farther than that, ascending by (object, element).
  [[nodiscard]] std::vector<NearThing> things_within(const Vec3& position, double distance);

  /// A solid mesh that holds the body's point, by its object, and the mesh at its place; the first.
  struct Holder {
    Index object = 0;
    PosedMesh mesh;
  };
  [[nodiscard]] std::optional<Holder> holder_of(const Vec3& position);

  [[nodiscard]] const MoverBody& body() const { return body_; }

 private:
  struct Met {
    double time;
    const LevelElement* thing;
    bool is_proved = true;
  };
  struct AllMet {
    std::vector<Met> met;
    double first = 1;  ///< the time of the first of them
  };
  struct Waiting {
    PlaneCast::Times times;
    const LevelElement* thing;
  };

  static constexpr auto no_face = static_cast<std::size_t>(-1);

  /// Something whose box meets the region. What a triangle's planes and edges are is found when it is first looked at.
  struct Candidate {
    Aabb box;
    Triangle triangle{};
    Index object = 0;
    Index element = 0;
    const LevelElement* made = nullptr;
    std::size_t face = no_face;  ///< in `faces_`
  };
  [[nodiscard]] const LevelElement& made(Candidate& candidate);
  /// The face of a triangle of which no more has been asked yet; valid until the next is asked for.
  [[nodiscard]] const TriangleFace* face_alone(Candidate& candidate);
  [[nodiscard]] bool is_kept_off(Candidate& candidate, const PlaneCast& planes);

  void gather();
  void gather_object(Index object);
  void gather_triangles(const PosedMesh& mesh, Index object, Index first_element);
  [[nodiscard]] bool is_long(const Vec3& motion) const;
  [[nodiscard]] bool is_too_long_for_planes(const Vec3& motion) const;
  [[nodiscard]] std::optional<MoverMeeting> first_around(const Vec3& position, const Vec3& motion,
                                                         std::optional<Index> without);
  [[nodiscard]] std::vector<Candidate*> on_the_way(const MoverBody::Placed& start, const Vec3& motion,
                                                   std::optional<Index> without);
  [[nodiscard]] double latest_time(std::span<Candidate* const> near, const MoverBody::Placed& start,
                                   const Vec3& motion);
  [[nodiscard]] std::vector<Waiting> waiting_of(std::span<Candidate* const> near, const MoverBody::Placed& start,
                                                const Vec3& motion, double latest);
  [[nodiscard]] AllMet met_of(std::span<const Waiting> waiting, const MoverBody::Placed& start,
                              const Vec3& motion) const;
  [[nodiscard]] RoundedBox reach_of_way(const MoverBody::Placed& start, const Vec3& motion) const;
  [[nodiscard]] std::optional<MoverMeeting> first_far_on(const Vec3& position, const Vec3& motion,
                                                         std::optional<Index> without) const;
  [[nodiscard]] std::optional<MoverMeeting> nearest_of(std::span<const Met> met, double time, const Vec3& position,
                                                       const Vec3& motion) const;
  [[nodiscard]] std::optional<Met> meeting_with(const LevelElement& thing, const MoverBody::Placed& start,
                                                const Vec3& motion, double limit) const;
  /// None where planes tell nothing.
  [[nodiscard]] std::optional<PlaneCast> plane_cast(const MoverBody::Placed& start, const Vec3& motion) const;
  /// Two times within this are not told apart.
  [[nodiscard]] double same_time(const Vec3& motion) const;

  const SearchedObjects& objects_;
  const MoverBody& body_;
  double skin_;
  double least_gap_;
  Aabb region_;  ///< what meets it is in `candidates_`
  std::vector<Candidate> candidates_;
  std::vector<TriangleFace> faces_;
  std::deque<LevelElement> elements_;
  std::vector<Holder> solids_;
};

}  // namespace toccata
