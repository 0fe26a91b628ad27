#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/io/report.hpp"
#include "toccata/query/batch.hpp"
#include "toccata/query/check_all.hpp"

namespace toccata {

/// What `check --poses` found: an entry per query in each list.
struct PosesReport {
  std::vector<PairQuery> queries;  ///< as asked: with the objects' own poses
  std::vector<Relation> relations;
  std::vector<ContactCount> counts;                 ///< none when faces were not asked for
  std::vector<Penetration> penetrations;            ///< none when not asked for
  std::vector<std::vector<ContactRegion>> regions;  ///< none but of two meshes, with the penetrations
  Touching touching = Touching::count;
  std::vector<std::vector<ReportedFacePair>> face_pairs{};  ///< of the first queries, by `with_face_pairs`: for pages
};

/// The same with the faces that meet at each pose, which reports only count: in the order of the queries, for so many
/// that there are at most `most` pairs of faces in all.
[[nodiscard]] PosesReport with_face_pairs(PosesReport report, std::span<const SceneInstance> models, std::size_t most);

/// How many of the queries found a contact.
[[nodiscard]] std::size_t contact_count(const PosesReport& report);

/// JSON by the schema toccata/check-poses/2 of docs/reference/check-report.md; `scene` holds A and then B. Doubles
/// round-trip.
[[nodiscard]] std::string poses_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                            const PosesReport& report, std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per query.
[[nodiscard]] std::string poses_report_csv(const PosesReport& report);

}  // namespace toccata
