#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "toccata/core/progress.hpp"
#include "toccata/io/cost_report.hpp"
#include "toccata/io/crowd_report.hpp"
#include "toccata/io/crowd_world_report.hpp"
#include "toccata/io/decompose_report.hpp"
#include "toccata/io/distance_report.hpp"
#include "toccata/io/faces_report.hpp"
#include "toccata/io/hierarchy_report.hpp"
#include "toccata/io/inspect_report.hpp"
#include "toccata/io/minkowski_report.hpp"
#include "toccata/io/nearest_report.hpp"
#include "toccata/io/poses_report.hpp"
#include "toccata/io/ray_report.hpp"
#include "toccata/io/report.hpp"
#include "toccata/io/self_report.hpp"

// What the command's subcommands ask about a scene, as values: they can be asked, written down with the scene
// (case_file.hpp), and asked again. Lengths and points are in the world.
namespace toccata {

/// Which pairs touch, or are nearer than their clearance: `check`.
using CheckQuestion = ReportOptions;

/// How two objects lie at many poses: `check --poses`.
struct CheckPosesQuestion {
  std::vector<PairQuery> queries;  ///< the first object is A, the second B
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
};

/// Where each object meets itself: `check --self`.
struct SelfQuestion {
  bool faces = false;
};

/// How far apart the objects are: `distance`.
struct DistanceQuestion {
  /// 0: every two objects. Else each of the first so many objects and each of the others. Two of one group are no pair.
  std::size_t first_objects = 0;
};

/// How far apart two objects are at many poses: `distance --poses`.
struct DistancePosesQuestion {
  std::vector<PairQuery> queries;
};

/// What rays meet first: `ray`. Of each ray only its origin and its motion count.
struct RayQuestion {
  std::vector<RayQuery> rays;
};

/// Which faces lie in a region: `faces`.
struct FacesQuestion {
  Region region;
};

/// What is nearest to points: `nearest`.
struct NearestQuestion {
  std::vector<Vec3> points;
  std::size_t k = 1;
  double within = std::numeric_limits<double>::infinity();
  bool sides = false;  ///< on which side of the surface each point is
};

/// What the objects are, and what is out of order in their meshes: `inspect`.
struct InspectQuestion {
  bool volumes = false;     ///< every bounding volume and hierarchy of each mesh, too
  bool partitions = false;  ///< every partition of space over each mesh, too
  bool faults = false;      ///< where the faults are that are counted
};

/// How good the scene's tree of nodes is as a hierarchy: `inspect --hierarchy`.
struct HierarchyQuestion {};

/// What a question about two meshes costs with each bounding volume and hierarchy: `cost`.
struct CostQuestion {
  std::vector<PairQuery> queries;  ///< the first object is A, the second B
  CostOptions options{};           ///< `progress` plays no part: AskOptions has one
};

/// Those of crowds are about no scene: they are asked of no models (`is_of_crowd`).
using SceneQuestion =
    std::variant<CheckQuestion, CheckPosesQuestion, SelfQuestion, DistanceQuestion, DistancePosesQuestion, RayQuestion,
                 FacesQuestion, NearestQuestion, InspectQuestion, HierarchyQuestion, CostQuestion, CrowdQuestion,
                 DecomposeQuestion, MinkowskiQuestion, CrowdWorldQuestion>;

/// It makes what it asks about, from a seed, and no scene has a part in it.
[[nodiscard]] bool is_of_crowd(const SceneQuestion& question);

struct DistanceReport {
  std::vector<ReportedDistance> pairs;
};
struct RayReport {
  std::vector<ReportedRay> rays;
};
struct FacesReport {
  Region region;
  std::vector<ReportedFaces> found;
};
struct NearestReport {
  std::vector<ReportedPoint> points;
  bool sides = false;  ///< with the side on which each is
};

struct InspectReport {
  std::vector<InspectedObject> objects;  ///< those of the scene, in its order
};

struct CostReport {
  CostTable table;
  CostQuestion question;
};

/// What a question found, in the order of SceneQuestion's alternatives.
using SceneAnswer = std::variant<CheckReport, PosesReport, SelfReport, DistanceReport, DistancePosesReport, RayReport,
                                 FacesReport, NearestReport, InspectReport, RebalanceReport, CostReport, CrowdReport,
                                 DecomposeReport, MinkowskiReport, CrowdWorldReport>;

struct AskOptions {
  int threads = 0;  ///< 0: as many as the machine has; the answer does not depend on it
  Progress progress{};
};

/// The answer, of the alternative of the question. Throws Error as the question of the query room does, naming objects;
/// for poses of other than two objects, a sum of other than two, and parts of other than one; and for a distance that
/// no double tells.
[[nodiscard]] SceneAnswer ask(std::span<const SceneInstance> models, const SceneQuestion& question,
                              const AskOptions& options = {});

/// The same; a question about the scene's tree of nodes needs the scene, whose objects the models are.
[[nodiscard]] SceneAnswer ask(const Scene& scene, std::span<const SceneInstance> models, const SceneQuestion& question,
                              const AskOptions& options = {});

/// "check", "check-poses", "check-self", "distance", "distance-poses", "ray", "faces", "nearest", "inspect",
/// "hierarchy", "cost", "crowd", "decompose", "minkowski", "crowd-world".
[[nodiscard]] std::string name_of(const SceneQuestion& question);

/// The report of that answer as JSON, by the schema toccata/<name>/1. Doubles round-trip.
[[nodiscard]] std::string report_json(const Scene& scene, std::span<const SceneInstance> models,
                                      const SceneAnswer& answer, std::span<const std::string> warnings = {});

/// The same as comma-separated values with a header line. Throws Error for answers that have no such form: those to
/// `inspect`, `decompose` and `minkowski`, and of crowds.
[[nodiscard]] std::string report_csv(const Scene& scene, const SceneAnswer& answer);

}  // namespace toccata
