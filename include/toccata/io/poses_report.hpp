#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/io/report.hpp"
#include "toccata/query/batch.hpp"

namespace toccata {

/// What `check --poses` found: an entry per query in each list.
struct PosesReport {
  std::vector<PairQuery> queries;  ///< as asked: with the objects' own poses
  std::vector<Relation> relations;
  std::vector<ContactCount> counts;                 ///< none when faces were not asked for
  std::vector<Penetration> penetrations;            ///< none when not asked for
  std::vector<std::vector<ContactRegion>> regions;  ///< none but of two meshes, with the penetrations
  Touching touching = Touching::count;
};

/// How many of the queries found a contact.
[[nodiscard]] std::size_t contact_count(const PosesReport& report);

/// JSON by the schema toccata/check-poses/1 of docs/reference/check-report.md; `scene` holds A and then B. Doubles
/// round-trip.
[[nodiscard]] std::string poses_report_json(const Scene& scene, std::span<const Posed> models,
                                            const PosesReport& report, std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per query.
[[nodiscard]] std::string poses_report_csv(const PosesReport& report);

}  // namespace toccata
