#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "toccata/core/parallel.hpp"
#include "toccata/core/type_list.hpp"
#include "toccata/motion/rigid_motion.hpp"
#include "toccata/query/subdivision.hpp"
#include "toccata/reports/crowd_report.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/world/character_mover.hpp"

// What the command's subcommands ask about a scene, as values: they can be asked, written down with the scene
// (case_file.hpp), and asked again. Lengths and points are in the world.
//
// What the library does with a question, from reading it to drawing what it found, is its `kind`, in a file of its own
// in src/reports/questions.
namespace toccata {

/// Which pairs touch, or are nearer than their clearance: `check`.
using CheckQuestion = ReportOptions;

/// What it asks of `check_all`; its rules, order and groups are no part of that.
[[nodiscard]] CheckOptions check_all_options(const CheckQuestion& question);

/// Whether rules leave a pair to be checked: two models that are not of one group. A check of which they leave none is
/// passed by looking at nothing.
[[nodiscard]] bool leave_a_pair(const NameRules& rules, std::span<const SceneInstance> models);

/// How two objects lie at many poses: `check --poses`.
struct CheckPosesQuestion {
  static const io::QuestionKind kind;
  std::vector<PairQuery> queries;  ///< the first object is A, the second B
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
  DepthOptions depth = CheckOptions{}.depth;  ///< of penetrations
};

/// Where each object intersects itself: `check --self`.
struct SelfQuestion {
  static const io::QuestionKind kind;
  bool faces = false;
};

/// How far apart the objects are: `distance`.
struct DistanceQuestion {
  static const io::QuestionKind kind;
  /// 0: every two objects. Else each of the first so many objects and each of the others. Two of one group are no pair.
  std::size_t first_objects = 0;
};

/// How far apart two objects are at many poses: `distance --poses`.
struct DistancePosesQuestion {
  static const io::QuestionKind kind;
  std::vector<PairQuery> queries;
};

/// What rays meet first: `ray`. Only the origin and the motion of each ray count.
struct RayQuestion {
  static const io::QuestionKind kind;
  std::vector<RayQuery> rays;
};

/// Which faces lie in a region: `faces`.
struct FacesQuestion {
  static const io::QuestionKind kind;
  Region region;
};

/// What is nearest to points: `nearest`.
struct NearestQuestion {
  static const io::QuestionKind kind;
  std::vector<Vec3> points;
  std::size_t k = 1;
  double within = std::numeric_limits<double>::infinity();
  bool sides = false;  ///< on which side of the surface each point is
};

/// What the objects are, and what is out of order in their meshes: `inspect`.
struct InspectQuestion {
  static const io::QuestionKind kind;
  bool volumes = false;     ///< every bounding volume and hierarchy of each mesh, too
  bool partitions = false;  ///< every partition of space over each mesh, too
  bool faults = false;      ///< where the faults are that are counted
};

/// How good the scene's tree of nodes is as a hierarchy: `inspect --hierarchy`.
struct HierarchyQuestion {
  static const io::QuestionKind kind;
};

/// What a question about two meshes costs with each bounding volume and hierarchy: `cost`.
struct CostQuestion {
  static const io::QuestionKind kind;
  std::vector<PairQuery> queries;  ///< the first object is A, the second B
  CostOptions options{};           ///< `progress` plays no part: AskOptions has one
};

/// Whether something that moves meets what stands, and when first: `sweep`.
struct SweepQuestion {
  static const io::QuestionKind kind;
  std::size_t moving_objects = 1;  ///< the first so many move, as one body; the others stand
  std::vector<MotionKey> keys;     ///< of the body, at least two; each object's own pose comes before them
  bool screw = false;      ///< from the one key to the other about one axis and along it, instead of straight on
  Vec3 centre{};           ///< in the body's frame, what goes straight on while the body turns about it
  double stop_before = 0;  ///< in world units
};

/// How two objects meet, of which A moves.
struct ReportedSweep {
  Index a = 0;  ///< the object's place in the scene
  Index b = 0;
  std::optional<ShapeHit> hit;
};

struct SweepReport {
  SweepQuestion question;
  std::vector<ReportedSweep> pairs;  ///< those that meet first come first, by (upper, a, b); then those that do not
};

/// How many of the pairs meet.
[[nodiscard]] std::size_t meeting_count(const SweepReport& report);

/// How an object of a scene moves whose pose is `pose`, when it is part of the body that moves.
[[nodiscard]] RigidMotion motion_of(const SweepQuestion& question, const Pose& pose);

/// The mesh that stands for the limit surface of a cage, the only object; or how far the limit surface of the first of
/// two objects is from the second: `subdivide`. A cage is the polygons of a mesh (`cage_polygons`).
struct SubdivideQuestion {
  static const io::QuestionKind kind;
  SubdivisionScheme scheme = SubdivisionScheme::catmull_clark;
  /// The tolerance in world units; 0: a thousandth of the diagonal of the cage's box, of two objects a millionth.
  double within = 0;
  int levels = 0;                                     ///< as in RefinementOptions
  std::size_t max_triangles = std::size_t{1} << 22;   ///< likewise; for two objects LimitQuery::max_faces
  CageFeatures features{};                            ///< of the first object, by the vertices of its mesh
  std::optional<double> crease_angle = std::nullopt;  ///< edges that turn by more are creases; in degrees
  bool both = false;                                  ///< the second object is a cage, too, of the same scheme

  friend bool operator==(const SubdivideQuestion&, const SubdivideQuestion&) = default;
};

/// Reads a creases file (docs/reference/subdivide-report.md): a line per feature of a cage, `crease A B` or `corner V`,
/// the numbers of vertices counted from 0, and how sharp it is, where it is not sharp for ever; # starts a comment.
/// Throws Error naming the file and the line, also for a file without a feature.
[[nodiscard]] CageFeatures read_creases(const std::string& path);

struct SubdivideReport {
  SubdivideQuestion question;
  std::string cage{};                    ///< what the first object is called
  double within = 0;                     ///< the tolerance that was asked for, also where the question has none
  std::size_t faces = 0;                 ///< of the cage
  bool closed = false;                   ///< the cage
  std::optional<SubdividedMesh> mesh{};  ///< for one object
  std::optional<LimitDistance> gap{};    ///< for two objects
};

/// The mesh in the world, as an object of its own; there must be one.
[[nodiscard]] SceneObject limit_object(const SubdivideReport& report);
/// Where a character gets that walks among the objects, which rest: `walk`. Each step is one of `move_character`.
struct WalkQuestion {
  static const io::QuestionKind kind;
  Shape walker = Capsule({0, 0, 0.4}, {0, 0, 1.4}, 0.4);
  Vec3 from{};                ///< where the origin of the walker's frame is at first
  std::vector<Vec3> motions;  ///< what it wants to go, step by step; none: it heads for `to`
  Vec3 to{};                  ///< where that origin is wanted: within the skin, and a step's height along `up`
  double stride = 0.1;        ///< how far it wants to go in a step on its way there, square to `up`; above 0
  double fall = 0.01;  ///< how much farther than it last fell it wants to fall in each step in the air; 0 or more
  std::size_t most_steps = 10'000;  ///< on its way to `to`
  MoverOptions options{};
};

/// How a walk ends.
enum class WalkOutcome {
  done,       ///< all motions were taken
  arrived,    ///< it is at `to`
  hindered,   ///< it gets no nearer to `to`
  fallen,     ///< it fell for thirty steps, and nothing is below it for a million strides
  unfinished  ///< `most_steps` were too few
};

[[nodiscard]] const char* name_of(WalkOutcome end);  ///< "done", "arrived", "hindered", "fallen", "unfinished"

/// A step, and what was wanted in it. Ids are places of objects in the scene.
struct WalkedStep {
  Vec3 motion;  ///< falling included
  MoverStep<Index> step;
};

/// A program that walks a character itself may record its steps so: reports, pages and GLB files are made of them.
struct WalkReport {
  WalkQuestion question;
  std::vector<WalkedStep> steps;
  WalkOutcome end = WalkOutcome::done;
};

/// Where the walker is after so many steps, of which there are as many; after none, at the start.
[[nodiscard]] Vec3 place_after(const WalkReport& report, std::size_t steps);

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

/// A question, and the report of what it found.
template <class SomeQuestion, class SomeReport>
struct QuestionAndReport {
  using Question = SomeQuestion;
  using Report = SomeReport;
};

/// All that can be asked. Those of crowds are about no scene: they are asked of no models (`is_of_crowd`).
using SceneQuestions =
    TypeList<QuestionAndReport<CheckQuestion, CheckReport>, QuestionAndReport<CheckPosesQuestion, PosesReport>,
             QuestionAndReport<SelfQuestion, SelfReport>, QuestionAndReport<DistanceQuestion, DistanceReport>,
             QuestionAndReport<DistancePosesQuestion, DistancePosesReport>, QuestionAndReport<RayQuestion, RayReport>,
             QuestionAndReport<FacesQuestion, FacesReport>, QuestionAndReport<NearestQuestion, NearestReport>,
             QuestionAndReport<InspectQuestion, InspectReport>, QuestionAndReport<HierarchyQuestion, RebalanceReport>,
             QuestionAndReport<CostQuestion, CostReport>, QuestionAndReport<CrowdQuestion, CrowdReport>,
             QuestionAndReport<DecomposeQuestion, DecomposeReport>,
             QuestionAndReport<MinkowskiQuestion, MinkowskiReport>,
             QuestionAndReport<CrowdWorldQuestion, CrowdWorldReport>, QuestionAndReport<SweepQuestion, SweepReport>,
             QuestionAndReport<SubdivideQuestion, SubdivideReport>, QuestionAndReport<WalkQuestion, WalkReport>>;

template <class... Listed>
using QuestionVariant = std::variant<typename Listed::Question...>;
template <class... Listed>
using ReportVariant = std::variant<typename Listed::Report...>;

using SceneQuestion = SceneQuestions::put_into<QuestionVariant>;
using SceneAnswer = SceneQuestions::put_into<ReportVariant>;

/// Whether the question makes what it asks about, from a seed, so that no scene has a part in it.
[[nodiscard]] bool is_of_crowd(const SceneQuestion& question);

struct AskOptions {
  int threads = all_threads;
  Progress progress{};
  /// Asked before each pair that `check` looks at, from any thread: once it is true no pair is begun any more, and the
  /// report says how many are left (CheckReport::unfinished).
  std::function<bool()> stop{};
  /// Is called with each pair that `check` will report as soon as it is found, as a report of that pair alone: in the
  /// order in which they are found, from any thread, never from two at once.
  std::function<void(const CheckReport&)> found{};
  /// Where it is false, the report has none of the pairs that `found` was told of and only counts them
  /// (CheckReport::not_kept): memory does not follow how many there are. Then it cannot be compared with a baseline,
  /// sorted, grouped or asked by winding, which is an error.
  bool keeps_found = true;
};

/// A pair of a report of `check` as its JSON has it, in one line.
[[nodiscard]] std::string pair_line_json(const Scene& scene, const CheckReport& report, std::size_t pair);

/// The answer, of the alternative of the question. Throws Error as the question of the query room does, naming objects;
/// for poses of other than two objects, a sum of other than two, and parts of other than one; and for a distance that
/// no double holds.
[[nodiscard]] SceneAnswer ask(std::span<const SceneInstance> models, const SceneQuestion& question,
                              const AskOptions& options = {});

/// The same; a question about the scene's tree of nodes needs the scene, whose objects the models are.
[[nodiscard]] SceneAnswer ask(const Scene& scene, std::span<const SceneInstance> models, const SceneQuestion& question,
                              const AskOptions& options = {});

/// "check", "check-poses", "check-self", "distance", "distance-poses", "ray", "faces", "nearest", "inspect",
/// "hierarchy", "cost", "crowd", "decompose", "minkowski", "crowd-world", "sweep",
/// "walk", "subdivide".
[[nodiscard]] std::string name_of(const SceneQuestion& question);

/// The report of that answer as JSON, by the schema toccata/<name>/1. Doubles round-trip.
[[nodiscard]] std::string report_json(const Scene& scene, std::span<const SceneInstance> models,
                                      const SceneAnswer& answer, std::span<const std::string> warnings = {});

/// The same as comma-separated values with a header line. Throws Error for answers that have no such form: those to
/// `inspect`, `decompose`, `minkowski` and `subdivide`, and of crowds.
[[nodiscard]] std::string report_csv(const Scene& scene, const SceneAnswer& answer);

}  // namespace toccata

// A report in JSON that says what was asked (docs/reference/asked.md), so that the question can be asked again.
namespace toccata {

/// A file that was asked about.
struct AskedFile {
  std::string name;    ///< as it was given: a path, or "gen:…"
  std::string digest;  ///< of what it held (`content_digest`)
};

/// What was asked about which files.
struct Asked {
  std::string folder;            ///< where relative names of files began; absolute
  std::vector<AskedFile> files;  ///< none of a crowd
  std::string unit{};            ///< of plain mesh files, as `metres_per_unit` takes it; empty: as the files say
  double scale = 1;              ///< of all files; positive
  bool split = false;            ///< parts of mesh files are objects (ReadOptions)
  std::string tessellation{};    ///< how near meshes of curved surfaces are to be to them, as it was written
  std::string close{};           ///< how wide the gaps are that were closed, as it was written; empty: none were
  std::optional<Pose> pose_a{};  ///< of everything in the first of two files; composed with what the file says
  std::optional<Pose> pose_b{};  ///< of the second
  std::optional<Solid> solid{};  ///< overrides what the files say
  SceneQuestion question{};
};

/// 16 hexadecimal digits that tell apart objects of other names, shapes, poses, groups, taken for something else, or of
/// a scene in another unit (`Scene::unit`): equal by chance for one in 2⁶⁴. Where a shape came from does not count.
[[nodiscard]] std::string content_digest(std::span<const SceneObject> objects, const std::string& unit);

/// The same of a scene with its tree of nodes, for a question about that.
[[nodiscard]] std::string content_digest(const Scene& scene);

/// What a report of `check` and the digest tell of each object of a scene, as JSON: made where the shapes are, for
/// those who know no more than the names of the objects, as other ranks do (distributed_scene.hpp).
[[nodiscard]] std::vector<std::string> object_summaries(const Scene& scene, std::span<const SceneInstance> models);

/// `report_json` and `content_digest` of objects of which only the names are looked at, and their summaries.
[[nodiscard]] std::string check_report_json(const Scene& scene, std::span<const std::string> summaries,
                                            const CheckReport& report, std::span<const std::string> warnings = {});
[[nodiscard]] std::string content_digest(std::span<const SceneObject> objects, std::span<const std::string> summaries,
                                         const std::string& unit);

/// The report that `report_json` made, with what was asked as its last member.
[[nodiscard]] std::string with_asked(std::string report, const Asked& asked);

/// A report from a file.
struct SavedReport {
  Asked asked;
  std::vector<std::string> sources;  ///< of its objects, in their order
  std::string answer;                ///< the whole report, as JSON
};

/// Whether the file is a JSON object with a "schema" of Toccata: a report, and neither a scene nor a case. Throws Error
/// naming the file when it cannot be read or is no JSON.
[[nodiscard]] bool is_report(const std::filesystem::path& path);

/// Throws Error naming the file and the place in it; also for a report that does not say what was asked.
[[nodiscard]] SavedReport read_report(const std::filesystem::path& path);

/// What a report of `check` said, as the baseline of another check: `CheckQuestion::baseline`. Throws Error naming the
/// file when it is no such report, or is about objects of which none is in the scene: it is about another model.
[[nodiscard]] Baseline read_baseline(const std::filesystem::path& path, const Scene& scene);

}  // namespace toccata
