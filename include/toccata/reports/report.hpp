#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/bounds/aabb.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/methods/minkowski.hpp"
#include "toccata/narrow/convex_convex.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/convex_parts.hpp"
#include "toccata/query/distance.hpp"
#include "toccata/query/faces_in_region.hpp"
#include "toccata/query/nearest.hpp"
#include "toccata/query/scene_hierarchy.hpp"
#include "toccata/query/scene_index.hpp"
#include "toccata/query/signed_distance.hpp"
#include "toccata/shapes/mesh_health.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {
struct QuestionKind;
}

namespace toccata {

/// One piece of what two faces have in common: its extreme points in world units, each number the double nearest to the
/// exact one.
struct ReportedIntersection {
  IntersectionKind kind = IntersectionKind::none;
  std::vector<Vec3> points;
  friend bool operator==(const ReportedIntersection&, const ReportedIntersection&) = default;
};

/// Two faces of the files that meet. Faces of more than three corners may meet in several pieces.
struct ReportedFacePair {
  Index face_a = 0;
  Index face_b = 0;
  bool crossing = false;
  std::vector<ReportedIntersection> intersections;
};

/// A pair that an earlier report lists.
struct FormerPair {
  std::string a, b;  ///< names of the objects
  RelationKind kind = RelationKind::apart;
  Containment containment = Containment::none;
  bool within_tolerance = false;
  bool demanded = true;  ///< no: two that were apart, of which no clearance was demanded (`--clearance all`)
  // What the report told of the overlap, in units of the world of now.
  std::optional<ContactRegion::Depth> penetration{}, local_depth{};
  std::optional<OverlapVolume> volume{};
  friend bool operator==(const FormerPair&, const FormerPair&) = default;
};

/// Where an object was in an earlier report.
struct FormerObject {
  std::string name;
  Pose pose;  ///< in units of the world of now
  /// In the object's own frame; of a half-space the point of its plane nearest to the origin; none of what has no end
  std::optional<Aabb> box;
  friend bool operator==(const FormerObject&, const FormerObject&) = default;
};

/// By what an overlap is certainly larger than it was: the least of now is more than the most of then, by more than a
/// hundredth of it, and of a depth by more than the pair's tolerance.
enum class ClashGrowth { none, penetration, local_depth, volume };

using ClashKind = PairAnswer::Kind;
using ClashPiercing = PairAnswer::Piercing;
using ToleranceVerdict = PairAnswer::Tolerance;

struct ReportedPair {
  Index a = 0;
  Index b = 0;
  Relation relation;
  std::vector<ReportedFacePair> face_pairs;  ///< ascending by (face_a, face_b); filled when the answer has contacts
  std::optional<Penetration> penetration;    ///< as in PairAnswer
  DepthEnd depth_end = DepthEnd::precise;
  std::optional<Manifold> manifold;
  std::vector<ContactManifold> manifolds;
  std::vector<ContactRegion> regions;
  std::optional<Distance> distance;  ///< filled when the answer has distances
  double clearance = 0;              ///< as in PairAnswer
  std::optional<FormerPair> was{};   ///< in the baseline, where there is one and the pair is in it; a and b as here
  ClashGrowth growth = ClashGrowth::none;  ///< since the baseline
  std::optional<double> moved_by{};        ///< how far one of the two has moved as seen from the other, where it has
  ClashKind kind = ClashKind::touching;    ///< as in PairAnswer, and so the following
  ClashPiercing piercing = ClashPiercing::none;
  ToleranceVerdict tolerance = ToleranceVerdict::none;
  std::optional<ContactRegion::Depth> local_depth{};
  std::optional<OverlapVolume> volume{};
  std::optional<Vec3> common_point{};
  Aabb place{};  ///< around where they meet or are nearest, as far as the answer says; else around what both may hold
  /// The winding number of the open mesh around the other object: filled where it alone, by ReportOptions::by_winding,
  /// says that this one is inside.
  std::optional<WindingNumber> winding{};
};

/// What counts as a clash: all that is reported but overlaps that are certainly within the tolerance, and pairs that
/// are apart of which no clearance was demanded: their distance alone was asked for.
[[nodiscard]] bool is_clash(const ReportedPair& pair);

/// Whether pairs that touch without their interiors meeting are reported.
enum class Touching { count, ignore };

/// A pair that merely touches is no contact when touching is ignored, unless the faces cannot tell the sides apart.
[[nodiscard]] bool counts_as_contact(const Relation& relation, Touching touching);

/// Two sets of objects, given by patterns of names (`matches_pattern`). Two objects are a pair of the rule when one is
/// in each, either way round.
struct NameRule {
  std::vector<std::string> a;
  std::vector<std::string> b;
};

/// A length that is asked of the pairs of a rule.
struct LengthRule {
  NameRule pairs;
  double length = 0;  ///< world units
};

/// Which pairs are checked: without rules all that are not of one group. And what is asked of some.
struct NameRules {
  std::vector<NameRule> between{};  ///< where there are any: only pairs of one of these
  std::vector<NameRule> ignored{};  ///< no pair of these
  /// Instead of the tolerance, and of the clearance, of all pairs. Where several rules are about a pair, the last
  /// counts; a clearance of that pair alone counts more.
  std::vector<LengthRule> tolerances{}, clearances{};
  /// Whether the rules leave no pair out.
  [[nodiscard]] bool empty() const { return between.empty() && ignored.empty(); }
};

/// Whether the whole name is as the pattern says: `*` stands for any characters or none, also for `/`, `?` for one
/// character of UTF-8, and `\` makes the next one mean itself. Capital letters are others than small ones.
[[nodiscard]] bool matches_pattern(std::string_view pattern, std::string_view name);

/// What an earlier report of `check` said, for comparison.
struct Baseline {
  std::string file;  ///< for people
  std::vector<FormerPair> pairs;
  std::vector<FormerObject> objects{};  ///< those of the pairs, where they are known
};

/// Why a pair of the baseline is no longer reported.
enum class GoneReason {
  apart,     ///< neither in contact nor as near as its clearance
  touching,  ///< merely touching, which is ignored
  left_out,  ///< not checked: by the rules, or of one group
  no_object  ///< one of the two is not in the scene
};

struct GonePair {
  FormerPair was;
  GoneReason reason = GoneReason::apart;
};

/// How a pair stands against the baseline. Contact is graver than nearness, overlap graver than touch, and an overlap
/// that has grown graver than it was. What is no graver has moved where one of the two lies otherwise to the other
/// (ReportedPair::moved_by).
enum class Since { added, known, moved, graver };

/// The order in which pairs are reported.
enum class PairOrder {
  objects,  ///< the order of their objects in the scene
  severity  ///< overlaps, the deepest first; then what touches; then what is near, the nearest first
};

/// Which clashes belong together.
enum class ClashGrouping {
  none,
  part,   ///< pairs of one object: the one that has most, then the one that has most of what is left, …
  region  ///< in places next to each other: around which boxes, each grown by its longest edge, overlap, and so on
};

/// Clashes that belong together.
struct ClashGroup {
  std::optional<Index> part{};     ///< the object that all are of
  Aabb place;                      ///< around their places
  std::vector<std::size_t> pairs;  ///< places in the report, ascending
};

/// What `check` found, ready to be written: pairs that count as contact or are nearer than their clearance, and how
/// many merely touching ones were left out.
struct CheckReport {
  std::vector<ReportedPair> pairs;
  std::size_t ignored_touching = 0;
  std::size_t candidate_pairs = 0;
  bool has_faces = false;
  bool has_boxes = true;  ///< whether JSON has the boxes of objects, by which a later check knows what has moved
  bool has_penetration = false;
  std::optional<double> clearance{};  ///< what was asked for all pairs, where a clearance was
  std::vector<PairClearance> pair_clearances{};
  std::vector<LengthRule> clearance_rules{};
  std::optional<std::size_t> left_out{};  ///< where there are rules: pairs that only they kept from being looked at
  std::optional<std::string> baseline{};  ///< the file, where there is one
  std::vector<GonePair> gone{};           ///< of the baseline, in its order
  /// The number of candidates that were not looked at because the check was stopped before; else 0. What is reported is
  /// right all the same, but not complete.
  std::size_t unfinished = 0;
  bool has_volume = false;
  std::optional<double> tolerance{};  ///< what was asked for all pairs, where a tolerance was; 0 with rules alone
  ClashGrouping grouping = ClashGrouping::none;
  std::vector<ClashGroup> groups{};  ///< of all its pairs, each in one; the largest first
  std::size_t not_kept = 0;          ///< pairs that were told as they were found and are not in `pairs`
};

/// "clearance", "touching", "crossing", "overlap", "protrude", "pierce", "contains", "equal".
[[nodiscard]] std::string name_of(ClashKind kind);
/// "none", "unknown", "a_through_b", "b_through_a".
[[nodiscard]] std::string name_of(ClashPiercing piercing);
/// "none", "within", "beyond", "undecided".
[[nodiscard]] std::string name_of(ToleranceVerdict verdict);
/// By which depth a verdict was come to, "local_depth" or "penetration"; nothing where there is none.
[[nodiscard]] std::string tolerance_decided_by(const ReportedPair& pair);
/// "none", "part", "region".
[[nodiscard]] std::string name_of(ClashGrouping grouping);

/// Where there is a baseline.
[[nodiscard]] Since since_baseline(const ReportedPair& pair);
/// "new", "known", "moved", "graver".
[[nodiscard]] std::string name_of(Since since);
/// "apart", "touching", "left_out", "no_object".
[[nodiscard]] std::string name_of(GoneReason reason);

/// What of an answer is reported. Faces, penetrations and distances are there when `check_all` was asked for them. The
/// clearances are those that it was asked for.
struct ReportOptions {
  static const io::QuestionKind kind;  ///< scene_question.hpp
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
  std::optional<double> clearance{};
  std::vector<PairClearance> pair_clearances{};
  DepthOptions depth = CheckOptions{}.depth;  ///< of penetrations
  bool volume = false;
  std::optional<double> tolerance{};
  // What `ask` heeds besides, and `make_check_report` does not.
  ClashGrouping grouping = ClashGrouping::none;
  NameRules rules{};
  std::optional<Baseline> baseline{};
  PairOrder order = PairOrder::objects;
  /// What lies within the box of an open mesh, no face of the two meeting, is inside where the generalised winding
  /// number of the mesh is more than a half in magnitude (docs/methods/winding-numbers.md). Such a pair overlaps,
  /// undecided.
  bool by_winding = false;
};

/// A pair that merely touches is left out where touching is ignored, however large its clearance.
[[nodiscard]] CheckReport make_check_report(std::span<const SceneInstance> models, const CheckAnswer& answer,
                                            const ReportOptions& options = {});

/// A JSON document, such as report_json makes, and its name.
struct NamedReport {
  std::string name;
  std::string json;
};

/// One document that has several as members.
[[nodiscard]] std::string joined_reports_json(std::span<const NamedReport> reports);

/// "apart", "touching", "overlapping", "crossing".
[[nodiscard]] std::string name_of(RelationKind kind);
/// "none", "a_in_b", "b_in_a", "equal".
[[nodiscard]] std::string name_of(Containment containment);
/// "none", "point", "segment", "polygon".
[[nodiscard]] std::string name_of(IntersectionKind kind);
/// "precise", "exhausted", "out of time".
[[nodiscard]] std::string name_of(DepthEnd end);
/// "exact", "undecided", "not_converged".
[[nodiscard]] std::string name_of(Status status);

/// The relation as a verb between the names of a and b: "overlaps", "contains", "lies inside", "touches", …
[[nodiscard]] std::string verb_of(const Relation& relation);

/// What the two were taken for, and what the relation leaves open: "(both solids)", "(a surface, a solid)",
/// "(undecided: …)", …
[[nodiscard]] std::string remark_on(const Relation& relation);

/// A length of 0 or more that lies between two bounds, for people: one number where both are the same in six digits,
/// else both, rounded outward so that the exact length lies between the two that are told, too: "20 to 21". Each has
/// two digits, and one more, up to six, for each decade that the width of the bracket lies below it. A part in 10⁹ of
/// a bound is taken for its rounding. An upper bound that is infinite tells nothing: "at least 20".
[[nodiscard]] std::string bracket_text(double lower, double upper);

/// One bound of it alone, rounded to its side.
[[nodiscard]] std::string lower_bound_text(double lower, int digits = 6);
[[nodiscard]] std::string upper_bound_text(double upper, int digits = 6);

/// How an object intersects itself.
struct ReportedSelf {
  std::size_t triangle_pairs = 0;
  std::size_t face_pairs = 0;
  /// Ascending, face_a ≤ face_b; filled when asked for. Two triangles of one face of the file are that face twice.
  std::vector<ReportedFacePair> faces;
};

/// What `check --self` found: an entry per object, in their order.
struct SelfReport {
  std::vector<ReportedSelf> objects;
  bool has_faces = false;
};

/// `contacts` is `self_contacts_each(models)`.
[[nodiscard]] SelfReport make_self_report(std::span<const SceneInstance> models,
                                          std::span<const std::vector<Contact>> contacts, bool faces);

/// How many of the objects intersect themselves.
[[nodiscard]] std::size_t self_intersecting_count(const SelfReport& report);

/// The question into which convex parts the closed mesh of a scene is cut: `decompose`. The mesh is taken as it is
/// posed, in the world.
struct DecomposeQuestion {
  static const io::QuestionKind kind;  ///< scene_question.hpp
  std::size_t max_parts = 32;          ///< as DecompositionOptions says
  double concavity = 0;
  friend bool operator==(const DecomposeQuestion&, const DecomposeQuestion&) = default;
};

struct DecomposeReport {
  std::string name;  ///< of the object
  Pose pose;         ///< of its parts: none where they are in the world, as `ask` makes them
  ConvexParts parts;
};

/// The parts as objects, "gear-01" of a gear, of one group: they are not checked against each other.
[[nodiscard]] Scene parts_scene(const DecomposeReport& report, const std::string& unit);

/// Writes the parts into one mesh file, OBJ, OFF, ASCII STL or PLY by the extension: in the world, and each of OBJ and
/// STL under its name. Of a flat part its front is written. Reading the file gives the same doubles. It is complete or
/// not there. Throws Error naming the file, also where no part has a face.
void write_parts(const DecomposeReport& report, const std::string& path);

struct ReportedDistance {
  Index a = 0;  ///< the object's place in the scene
  Index b = 0;
  Distance distance;
};

/// What `distance --poses` found: an entry per query in each list.
struct DistancePosesReport {
  std::vector<PairQuery> queries;  ///< as asked: with the objects' own poses
  std::vector<Distance> distances;
};

/// How many of the queries found the two meeting.
[[nodiscard]] std::size_t intersecting_count(const DistancePosesReport& report);

/// What of a scene lies within a region: of the object at that place in the scene.
struct ReportedFaces {
  Index object = 0;
  std::vector<FoundElement> found;
};

/// A scene's tree of nodes as a hierarchy, and what making it better would gain.
struct RebalanceReport {
  HierarchyReport as_is;
  HierarchyReport cured;
  HierarchyReport rebuilt;
  std::size_t named_nodes = 0;  ///< inner nodes as it is that stand for a node of the scene
  std::size_t kept_nodes = 0;   ///< those of the named nodes that the cure keeps
  std::size_t unbounded = 0;    ///< objects that have no end and so no place in it
};

/// Takes as long as `report_of` for each of the three. Throws Error like `hierarchy_of`.
[[nodiscard]] RebalanceReport rebalance_report(const Scene& scene);

/// An object and how it is, for `inspect`.
struct InspectedObject {
  SceneObject object;
  std::optional<MeshHealth> health;  ///< of meshes and height fields
  bool solid = false;                ///< what a check takes it for
  /// Contains the object in the world; exact but for shapes with a radius and compounds. None for a half-space, which
  /// has no end, and where the pose is refused.
  std::optional<Aabb> world_box;
  std::string refusal;  ///< why no question can be asked about it where it is; else empty
  /// What `measure_volumes` finds for its mesh, where that is asked for; `inspect` leaves it empty.
  std::vector<VolumeCost> volumes{};
  std::vector<PartitionCost> partitions{};          ///< what `measure_partitions` finds for its triangles, likewise
  std::vector<MeshFault> faults{};                  ///< what `mesh_faults` finds in its mesh, likewise
  std::optional<std::size_t> self_intersections{};  ///< pairs of its triangles that meet; for meshes, filled by `ask`
  std::size_t boundaries = 0;                       ///< holes and rims of an open mesh (`boundary_count`), filled by
                                                    ///< `ask`
  std::optional<double> closing_gap{};              ///< what `closing_gap` finds for an open mesh, in its own units
};

/// Everything that `inspect` reports about the object.
[[nodiscard]] InspectedObject inspect(const SceneObject& object);

/// "boundary_edges", "non_manifold_edges", "flipped_edges", "degenerate_triangles", "duplicate_triangles",
/// "unused_vertices".
[[nodiscard]] std::string name_of(MeshFaultKind kind);

/// The sum of two convex objects, the first of which is A and the second B: `minkowski`. In the world.
struct MinkowskiQuestion {
  static const io::QuestionKind kind;  ///< scene_question.hpp
  bool difference = false;             ///< A − B instead of A + B
  bool hulls = false;           ///< meshes that are not convex stand for their convex hulls; else they are refused
  std::optional<Vec3> point{};  ///< where it lies is asked too
  friend bool operator==(const MinkowskiQuestion&, const MinkowskiQuestion&) = default;
};

struct MinkowskiReport {
  MinkowskiQuestion question;
  std::string a, b;  ///< names of the objects
  MinkowskiSum sum;
};

/// "A + B" or "A − B".
[[nodiscard]] std::string name_of(const MinkowskiQuestion& question);

/// "inside", "boundary", "outside": of negative, zero and positive.
[[nodiscard]] std::string name_of_side(Sign side);

/// The sum as an object of that name.
[[nodiscard]] SceneObject sum_object(const MinkowskiReport& report);

/// A point of the surface of a scene's object, which is named by its place in the scene.
struct ReportedSurfacePoint {
  SurfacePoint nearest;
  Index object = 0;
  /// When asked for: the side is that of the point, of the whole object; the distance is that of `nearest`, negative
  /// inside.
  std::optional<SignedDistance> signed_distance{};
};

/// A point that was asked about, and what is nearest to it, nearest first; none where nothing is within the greatest
/// distance.
struct ReportedPoint {
  Vec3 point;
  std::vector<ReportedSurfacePoint> nearest;
  std::optional<SceneSignedDistance> in_scene{};  ///< that of all objects together, when asked for
};

/// What `check --poses` found: an entry per query in each list.
struct PosesReport {
  std::vector<PairQuery> queries;  ///< as asked: with the objects' own poses
  std::vector<Relation> relations;
  std::vector<ContactCount> counts;                 ///< none when faces were not asked for
  std::vector<Penetration> penetrations;            ///< none when not asked for
  std::vector<DepthEnd> depth_ends;                 ///< why their brackets are no narrower
  std::vector<std::vector<ContactRegion>> regions;  ///< none but of two meshes, with the penetrations
  Touching touching = Touching::count;
  std::vector<std::vector<ReportedFacePair>> face_pairs{};  ///< those of the first queries, by `with_face_pairs`: for
                                                            ///< pages
};

/// The same with the faces that meet at each pose, which reports only count: in the order of the queries, for so many
/// that there are at most `most` pairs of faces in all.
[[nodiscard]] PosesReport with_face_pairs(PosesReport report, std::span<const SceneInstance> models, std::size_t most);

/// How many of the queries found a contact.
[[nodiscard]] std::size_t contact_count(const PosesReport& report);

/// A ray at a scene: what it meets first, of the object at that place in the scene.
struct ReportedRay {
  RayQuery query;
  std::optional<RayHit> hit;
  Index object = 0;
};

}  // namespace toccata
