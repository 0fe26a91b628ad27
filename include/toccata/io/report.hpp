#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "toccata/query/check_all.hpp"
#include "toccata/shapes/scene.hpp"

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

struct ReportedPair {
  Index a = 0;
  Index b = 0;
  Relation relation;
  std::vector<ReportedFacePair> face_pairs;  ///< ascending by (face_a, face_b); filled when the answer has contacts
  std::optional<Penetration> penetration;    ///< as in PairAnswer
  std::optional<Manifold> manifold;
  std::vector<ContactManifold> manifolds;
  std::vector<ContactRegion> regions;
  std::optional<Distance> distance;  ///< filled when the answer has distances
};

/// Whether pairs that touch without their interiors meeting are reported.
enum class Touching { count, ignore };

/// A pair that merely touches is no contact when touching is ignored, unless the faces cannot tell the sides apart.
[[nodiscard]] bool counts_as_contact(const Relation& relation, Touching touching);

/// What `check` found, ready to be written: pairs that count as contact or are nearer than their clearance, and how
/// many merely touching ones were left out.
struct CheckReport {
  std::vector<ReportedPair> pairs;
  std::size_t ignored_touching = 0;
  std::size_t candidate_pairs = 0;
  bool has_faces = false;
  bool has_penetration = false;
  std::optional<double> clearance{};  ///< what was asked for all pairs, where a clearance was
  std::vector<PairClearance> pair_clearances{};
};

/// What of an answer is reported. Faces, penetrations and distances are there when `check_all` was asked for them. The
/// clearances are those that it was asked for.
struct ReportOptions {
  Touching touching = Touching::count;
  bool faces = false;
  bool penetration = false;
  std::optional<double> clearance{};
  std::vector<PairClearance> pair_clearances{};
};

/// Throws Error where touching is to be ignored and a clearance is asked for: a pair that touches is nearer than any.
[[nodiscard]] CheckReport make_check_report(std::span<const SceneInstance> models, const CheckAnswer& answer,
                                            const ReportOptions& options = {});

/// JSON by the schema docs/reference/check-report.md. Doubles round-trip.
[[nodiscard]] std::string check_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                            const CheckReport& report, std::span<const std::string> warnings);

/// A JSON document, such as check_report_json makes, and its name.
struct NamedReport {
  std::string name;
  std::string json;
};

/// One document that has several as members.
[[nodiscard]] std::string joined_reports_json(std::span<const NamedReport> reports);

/// Comma-separated values with a header line: a line per pair, or per pair of faces when the report has them.
[[nodiscard]] std::string check_report_csv(const Scene& scene, const CheckReport& report);

/// "apart", "touching", "overlapping", "crossing".
[[nodiscard]] std::string name_of(RelationKind kind);
/// "none", "a_in_b", "b_in_a", "equal".
[[nodiscard]] std::string name_of(Containment containment);
/// "none", "point", "segment", "polygon".
[[nodiscard]] std::string name_of(IntersectionKind kind);
/// "exact", "undecided", "not_converged".
[[nodiscard]] std::string name_of(Status status);

}  // namespace toccata
