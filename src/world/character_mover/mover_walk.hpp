#pragma once

#include <optional>
#include <span>
#include <vector>

#include "world/character_mover/motion_planes.hpp"
#include "world/character_mover/mover_surroundings.hpp"

namespace toccata {

/// The options of a mover, checked, and what follows from them.
struct MoverSetting {
  Vec3 up;  ///< unit
  double skin;
  double level_cosine;  ///< of the greatest slope; a little less, for rounding
  double step_height;
  double snap_distance;
  int max_slides;

  /// Nothing is approached nearer than this: a 16th less than the skin, so that what stays at the skin meets nothing on
  /// a way beside it, however its position is rounded.
  [[nodiscard]] double least_gap() const { return 0.9375 * skin; }
  /// What is nearer is moved away from.
  [[nodiscard]] double too_near() const { return 0.90625 * skin; }
};

/// Something met on the way.
struct WalkContact {
  Index object = 0;
  Index element = 0;
  Vec3 point{};
  Vec3 normal{};
};

/// Where a way ended that slides along what it meets.
struct SlideEnd {
  Vec3 position;
  std::vector<WalkContact> contacts{};
  bool cut_short = false;               ///< it was not proved that it goes no farther
  std::optional<WalkContact> ground{};  ///< what it stands on there, if that was asked and is something
};

/// Which motions are nearest to those wanted: to a walker the level part alone counts.
enum class Footing { walking, free };

/// How a character comes out of what it begins in.
struct RecoveredPlace {
  Vec3 position;
  bool tight = false;
  bool stuck = false;
};

/// The parts that a step is made of.
class MoverWalk {
 public:
  MoverWalk(MoverSurroundings& around, const MoverSetting& setting)
      : around_(around), setting_(setting), depth_below_(around.body().depth_below(setting.up)) {}

  /// Away from what is nearer than the skin, if there is a way out.
  [[nodiscard]] RecoveredPlace recovered(const Vec3& position, const SearchedObjects& objects);

  /// As far as it goes, along what is met.
  [[nodiscard]] SlideEnd slide(const Vec3& position, const Vec3& wanted, Footing footing,
                               std::optional<Index> without = {});

  /// Up, on and down again, where that leads farther on than `flat`; the motion is level. Where it does not, and what
  /// was in the way is not proved to be, `flat` is cut short.
  [[nodiscard]] std::optional<SlideEnd> step_up(const Vec3& position, const Vec3& motion, SlideEnd& flat);

  /// Down onto ground no more than `snap_distance` below, after a level motion. What is too steep to be ground may lead
  /// it aside on the way, but not on, and no farther than the motion is long; the last of the contacts is the ground.
  [[nodiscard]] std::optional<SlideEnd> put_down(const Vec3& position, const Vec3& motion);

  /// What the body stands on, where it is.
  [[nodiscard]] std::optional<WalkContact> ground_at(const Vec3& position);

  /// Where something is met.
  struct Stop {
    Vec3 position;
    bool is_proved = true;  ///< that it goes no farther
  };

  /// Straight on until the skin of what is met; none if nothing is.
  [[nodiscard]] std::optional<Stop> stopped(const Vec3& position, const Vec3& motion);

  [[nodiscard]] bool is_walkable(const Vec3& normal) const { return dot(normal, setting_.up) >= setting_.level_cosine; }

 private:
  struct Plane {
    LevelElement thing;
    MoverGap gap;
  };

  /// A way that bends.
  struct Sliding {
    SlideEnd end;
    Vec3 rest;  ///< of what is wanted
    Footing footing;
    double least;  ///< shorter motions are none
    std::vector<Plane> planes{};
  };

  /// Up, on and down, and whether that is a step.
  struct TriedStep {
    bool is_step;
    SlideEnd end;
  };

  [[nodiscard]] TriedStep tried_step(const Vec3& position, const Vec3& motion, const SlideEnd& flat);
  [[nodiscard]] bool goes_on(Sliding& way, std::optional<Index> without = {});
  [[nodiscard]] Vec3 allowed(const Vec3& wanted, std::span<const Plane> planes, Footing footing) const;
  [[nodiscard]] double time_at_skin(const MoverMeeting& met, const Vec3& motion) const;
  [[nodiscard]] bool stands_on_edge(const NearThing& near, const Vec3& position) const;
  [[nodiscard]] std::optional<Vec3> way_out(const Vec3& position, std::vector<NearThing> near,
                                            std::span<const Plane> blocking) const;
  [[nodiscard]] bool is_free(const Vec3& position);
  [[nodiscard]] std::optional<Vec3> nearer_place(const Vec3& position, double distance);
  [[nodiscard]] std::optional<Vec3> out_of_solid(const Vec3& position, const SearchedObjects& objects);

  MoverSurroundings& around_;
  const MoverSetting& setting_;
  double depth_below_;
};

}  // namespace toccata
