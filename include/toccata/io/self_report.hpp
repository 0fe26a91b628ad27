#pragma once

#include <span>
#include <string>
#include <vector>

#include "toccata/io/report.hpp"

namespace toccata {

/// How an object meets itself.
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

/// JSON by the schema toccata/check-self/2 of docs/reference/check-report.md. Doubles round-trip.
[[nodiscard]] std::string self_report_json(const Scene& scene, std::span<const SceneInstance> models,
                                           const SelfReport& report, std::span<const std::string> warnings);

/// Comma-separated values with a header line: a line per object, or per pair of faces when the report has them.
[[nodiscard]] std::string self_report_csv(const Scene& scene, const SelfReport& report);

}  // namespace toccata
