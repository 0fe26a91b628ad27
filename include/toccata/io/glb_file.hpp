#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "toccata/io/crowd_page.hpp"
#include "toccata/io/view_page.hpp"
#include "toccata/io/world_page.hpp"

namespace toccata {

/// The same as a page shows (view_page), as a GLB file for Blender and other programs (docs/reference/glb-file.md):
/// objects under their names, and where the answer tells it, for each pair the faces that meet, the curves in which
/// they do, depth and distance, or ways of rays, nearest points, faces in a region, self-contacts; levels of a
/// hierarchy, cells of a partition, Voronoi regions and walks through them; a crowd as recording_glb does. Metres, Y
/// up: the root node holds the change from the scene's unit (one that is not known counts as a metre) and from
/// `options.up`. Vertices are floats, counted from a place near them, and nodes are doubles: points are off by at most
/// 2⁻²⁰ of the size of their mesh or, where they are shown of pairs, of their pair. The same bytes on every machine.
/// Throws Error as view_page does, when the file would have 4 GiB, and for poses that shear what they move.
[[nodiscard]] std::string scene_glb(const Scene& scene, std::span<const SceneInstance> models,
                                    const SceneAnswer& answer, const ViewOptions& options = {});

/// The same as crowd_page and world_page show, as an animation: a frame of 24 a second for each that is recorded. The
/// boxes or bodies under "objects", each moving; what was found in a frame hangs under a node "frame 0" or "step 0" …
/// that is seen in that frame alone: under "pairs" segments between the middles of pairs, of bodies those begun, kept
/// and ended, contact points and distances; under "cells" the edges of the method's cells. Of `options` it takes
/// `title` and `up`. Throws Error when nothing is recorded, for more than 20,000 boxes or bodies, of which programs
/// make an object each, and as crowd_page and world_page do.
[[nodiscard]] std::string recording_glb(const CrowdRecording& recording, const ViewOptions& options = {});
[[nodiscard]] std::string recording_glb(const WorldRecording& recording, const ViewOptions& options = {});

/// Writes what scene_glb made: the file is complete or not there. Throws Error naming the file when it exists and was
/// not written by Toccata, or cannot be written.
void write_glb(const std::string& glb, const std::filesystem::path& path);

}  // namespace toccata
