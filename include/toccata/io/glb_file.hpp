#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "toccata/io/view_page.hpp"

namespace toccata {

/// The same as a page shows (view_page), as a GLB file for Blender and other programs (docs/reference/glb-file.md):
/// objects under their names, and where the answer tells it, for each pair the faces that meet, the curves in which
/// they do, depth and distance, or ways of rays, nearest points, faces in a region, self-contacts; levels of a
/// hierarchy. Metres, Y up: the root node holds the change from the scene's
/// unit (one that is not known counts as a metre) and from `options.up`. Vertices are floats, counted from a place near
/// them, and nodes are doubles: points are off by at most 2⁻²⁰ of the size of their mesh or, where they are shown of
/// pairs, of their pair. The same bytes on every machine. Throws Error as view_page does, when the file would have
/// 4 GiB, for a crowd, and for poses that shear what they move.
[[nodiscard]] std::string scene_glb(const Scene& scene, std::span<const Posed> models, const SceneAnswer& answer,
                                    const ViewOptions& options = {});

/// Writes what scene_glb made: the file is complete or not there. Throws Error naming the file when it exists and was
/// not written by Toccata, or cannot be written.
void write_glb(const std::string& glb, const std::filesystem::path& path);

}  // namespace toccata
