#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/formats/json.hpp"
#include "io/scenes/scene_shape.hpp"
#include "reports/face_pairs.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/shapes/scene.hpp"

namespace toccata::io {

// What the reports have in common.

/// A length, or "all" for +∞.
[[nodiscard]] Json json_of_length(double length);

/// Its corners, "lower" and "upper".
[[nodiscard]] Json json_of(const Aabb& box);

/// An object as it was checked.
[[nodiscard]] Json json_of(const SceneObject& object, const SceneInstance& posed);

[[nodiscard]] Json json_of(const ReportedFacePair& pair);

[[nodiscard]] Json json_of(const Penetration& penetration);
/// With why it is no narrower, where it is wider than asked.
[[nodiscard]] Json json_of(const Penetration& penetration, DepthEnd end);

/// How narrow a depth was asked for.
void add_depth_options(Json& json, const DepthOptions& depth);
/// How narrow a question asks for depths. One that says nothing of it gets 2 %, as before one could say so. Throws
/// where it says so, and asks for no depths.
[[nodiscard]] DepthOptions depth_options_of(const JsonValue& question);
[[nodiscard]] DepthOptions depth_options_of(const JsonValue& question, bool is_asked);
[[nodiscard]] Json json_of(const Manifold& manifold);
[[nodiscard]] Json json_of(const std::vector<ContactManifold>& manifolds);
[[nodiscard]] Json json_of(const ContactRegion& region);
[[nodiscard]] Json json_of(const std::vector<ContactRegion>& regions);

/// The end of a line of comma-separated values that may tell of a penetration, with a comma in front: its names, with a
/// line end, and its values, empty for a pair that has none.
[[nodiscard]] std::string csv_penetration_head(bool told);
[[nodiscard]] std::string csv_of(const std::optional<Penetration>& penetration, DepthEnd end);

/// Adds what a distance says to an object, and to a line of comma-separated values, under names that begin with a
/// comma.
void add(Json& line, const Distance& d);
[[nodiscard]] std::string csv_of(const Distance& d);
inline constexpr const char* csv_distance_names =
    ",lower,upper,on_a_x,on_a_y,on_a_z,on_b_x,on_b_y,on_b_z,face_a,face_b,status";

/// The document as text, with a line end.
[[nodiscard]] std::string document(const Json& json);

/// Adds to a document, as its last member, a list of `count` items, a line or more each. So many items stay readable,
/// and are written without all being kept as values.
[[nodiscard]] std::string with_list(std::string document, const std::string& name, std::size_t count,
                                    const std::function<std::string(std::size_t)>& item);

/// On one line.
[[nodiscard]] std::string line_of(const Json& json);

/// The objects of a report: of a scene as they were checked; or by summaries of them (`object_summaries`), with the
/// names that they have in the scene.
[[nodiscard]] Json objects_json(const Scene& scene, std::span<const SceneInstance> models);
[[nodiscard]] Json objects_json(const Scene& scene, std::span<const std::string> summaries);

/// The box around an object in its own frame; null where it has no end.
[[nodiscard]] Json box_json(const SceneInstance& model);

/// The head that all reports of `check` have; `schema` is its name and number.
[[nodiscard]] Json report_head(const std::string& schema, const Scene& scene, Json objects,
                               std::span<const std::string> warnings);

/// A field with a comma, quote or line break is quoted (RFC 4180).
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace toccata::io
