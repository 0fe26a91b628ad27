#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "toccata/broad/broad_phase.hpp"
#include "toccata/methods/cost.hpp"
#include "toccata/partitions/measure.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/reports/scene_question.hpp"
#include "toccata/shapes/scene.hpp"
#include "toccata/world/world.hpp"

namespace toccata {

/// Which axis of the world points up on the screen.
enum class UpAxis { y, z };

struct ViewOptions {
  std::string title = "Toccata";
  UpAxis up = UpAxis::z;
  /// Draws for every mesh the levels of a binary hierarchy of these volumes, down to 1,024 of them; for `wide`, those
  /// of the tree that queries use.
  std::optional<CostVolume> hierarchy{};
  /// Draws for every mesh the cells of a partition of this kind over its triangles, with the counts of each depth: down
  /// to 4,096 of them, and all as they are.
  std::optional<PartitionKind> partition{};
  /// Draws for every object, which has to be a convex polytope, the Voronoi regions of its faces, edges and vertices.
  bool voronoi = false;
  /// Draws for every pair of objects, which have to be convex polytopes, the features that `distance_by_voronoi_walk`
  /// visits from a vertex of each on, one after the other. At most 32 pairs.
  bool voronoi_walk = false;
};

/// One HTML page that shows a scene and what was found in it, whatever was asked: self-contained, so that it opens from
/// disk without a network or a server, in any browser with WebGL 2. It computes no collision; it draws what the answer
/// says: where a report of `check` has faces, these and the curves in which they meet, where it has penetrations and
/// distances, their segments and numbers; ways of rays and what they meet, nearest points, faces in a region; of many
/// poses the objects at the one that is chosen. `models` are the scene's, in its order. Meshes are rounded for display
/// to 1/65535 of their boxes; poses, depths and distances stay exact (docs/reference/view-page.md). Names may hold
/// anything. Throws Error when an object reaches beyond the doubles, and when hierarchies or partitions of more than 32
/// meshes are asked for.
[[nodiscard]] std::string view_page(const Scene& scene, std::span<const SceneInstance> models,
                                    const SceneAnswer& answer, const ViewOptions& options = {},
                                    std::span<const std::string> warnings = {});

/// Writes a page: the file is complete or not there. Throws Error naming the file when it exists and was not written by
/// Toccata, or cannot be written (write_output).
void write_view_page(const std::string& page, const std::filesystem::path& path);

/// The updates of a broad phase, one after the other, for a page that shows them as time goes on. What a page can hold
/// is bounded: when there is more, every second frame is given up, and from then on as many are passed over.
class CrowdRecording {
 public:
  /// Bytes that the frames take in a page, before they are written as text (base64: four thirds of it). A box takes 14,
  /// a pair 4 (8 from 65,537 boxes on), a cell 14.
  static constexpr std::size_t most_bytes = 16'000'000;
  /// No frame of more boxes fits, however few their pairs and cells are.
  static constexpr std::size_t most_boxes = most_bytes / 14;

  struct Frame {
    std::size_t number = 0;     ///< of the update, from 0
    std::vector<Aabb> boxes{};  ///< by number; empty where a number is not in use
    std::vector<IndexPair> pairs{};
    std::size_t begin = 0, end = 0;  ///< pairs, since the update before, which may not be kept
    BroadPhaseMethod method{};
    BroadPhaseCells space{};
  };

  /// The boxes, pairs and cells of the last update. Throws Error when boxes have come, gone or moved since, and when
  /// this frame alone is more than a page may hold.
  void add(const BroadPhase& phase);
  /// The same with these cells in place of those of the method.
  void add(const BroadPhase& phase, BroadPhaseCells space);

  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }  ///< those that are kept
  /// How many updates were shown to it, and each how many-th of them is kept.
  [[nodiscard]] std::size_t seen() const { return seen_; }
  [[nodiscard]] std::size_t stride() const { return stride_; }
  /// Whether a box has been seen at two places.
  [[nodiscard]] bool has_moved(Index number) const { return has_moved_[number]; }

 private:
  void give_up_every_second();
  void note_motion(const BroadPhase& phase);

  std::vector<Frame> frames_;
  std::vector<Aabb> last_;
  std::vector<bool> has_moved_;
  std::size_t seen_ = 0, stride_ = 1, bytes_ = 0;
};

/// What is shown as the cells of a frame, of its boxes.
using CrowdCells = std::function<BroadPhaseCells(const std::vector<Aabb>& boxes)>;

/// A crowd (run_crowd) once more by the first of the methods, kept frame by frame; the first is that before anything
/// moves. Throws Error as CrowdRecording does.
[[nodiscard]] CrowdRecording record_crowd(const CrowdQuestion& question, const Progress& progress = {},
                                          const CrowdCells& cells = {});

/// A self-contained page as that of `view_page`, which shows the boxes, their pairs and the cells of the method as
/// layers, with a slider over the frames. What is drawn is rounded to 1/65535 of what it lies in. Infinite sides end
/// where the finite boxes do; intervals and rectangles of sweeps are drawn beside the boxes. It takes `title` and `up`
/// of `options`. Throws Error when nothing is recorded.
[[nodiscard]] std::string crowd_page(const CrowdRecording& recording, const ViewOptions& options = {});

/// The steps of a World, one after the other, for a page that shows them as time goes on. A body is drawn with the
/// shape that it had when it was first seen, also where `replace` has given it another one since.
class WorldRecording {
 public:
  /// That a page may hold, before they are written as text (base64: four thirds of it). The place of a body that has
  /// moved takes 24, a pair about 150.
  static constexpr std::size_t most_bytes = 48'000'000;

  enum class Change : std::uint8_t { begin, persist, end };

  struct Place {
    Index object = 0;  ///< of `objects`
    Pose pose;
  };
  struct Pair {
    Index a = 0, b = 0;  ///< of `objects`
    Change change = Change::begin;
    bool in_contact = false;
    Vec3 middle_a, middle_b;  ///< the middles of their boxes; not finite for half-spaces
    std::shared_ptr<const PairDetails> details{};
  };
  /// Where a body stands on another one, or met it.
  struct Touched {
    Vec3 point;
    Vec3 normal;  ///< unit
  };
  struct Frame {
    std::vector<Place> placed;  ///< bodies that are new or have another pose than when they were last seen
    std::vector<Index> gone;    ///< that were there at the frame before
    std::vector<Pair> pairs;    ///< begin, persist and end
    std::string label{};        ///< as the page calls it; empty: by its number
    std::vector<Touched> touched{};
  };
  /// Something beside the bodies that is there in all frames: triangles in the world, three corners each.
  struct Surface {
    std::string name;
    std::vector<Vec3> corners;
  };
  /// The same of a way from point to point.
  struct Path {
    std::string name;
    std::vector<Vec3> points;
  };

  /// The bodies as they are and what the last step found: to be called after a step, before anything moves. Throws
  /// Error, and has changed nothing, when that is more than a page may hold.
  void add(const World& world, const std::string& label = {}, std::vector<Touched> touched = {});
  /// Both throw the same way.
  void add(Surface surface);
  void add(Path path);

  [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }
  [[nodiscard]] std::span<const Body> objects() const { return objects_; }  ///< as they were first seen
  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }

 private:
  struct Seen {
    Index object = 0;
    Pose pose;
    Vec3 middle;  ///< of its box
  };
  struct Next;
  void add_bodies(const World& world, Next& next) const;
  void add_pairs(std::span<const PairReport> pairs, Change change, Next& next) const;

  std::vector<Body> objects_;
  std::vector<Frame> frames_;
  std::vector<Surface> surfaces_;
  std::vector<Path> paths_;
  std::map<BodyId, Seen> seen_;
  std::vector<BodyId> there_;  ///< at the last frame
  std::size_t bytes_ = 0;
};

/// The bodies of `crowd --world` once more (run_crowd_world), with relations, contact points and depths, kept step by
/// step; the first is that before anything moves. Throws Error as WorldRecording and run_crowd_world do.
[[nodiscard]] WorldRecording record_crowd_world(const CrowdWorldQuestion& question, const Progress& progress = {});

/// What a sweep found (SweepReport), moment by moment: the bodies on their way and how far apart those that move and
/// those that stand are, at even times and at the times of the first contacts, and the volumes that those that move
/// pass (swept_volume). Throws Error as WorldRecording does.
[[nodiscard]] WorldRecording record_sweep(std::span<const SceneInstance> models, const SweepReport& report);

/// A walk (WalkReport) step by step, of a long one some two thousand of its steps: the walker on its way, what it
/// stands on and met with the normals there, the objects that it is as near as twice its skin, and the whole path.
/// Throws Error as WorldRecording does.
[[nodiscard]] WorldRecording record_walk(std::span<const SceneInstance> models, const WalkReport& report);

/// A self-contained page as that of `view_page`: the bodies, a slider over the frames that moves them, the pairs of
/// each frame as they begin, persist and end, with contact points and distances where the World reports these, and a
/// list of them. Places are rounded for display to floats and turns to 1/32767; poses at first, depths and distances
/// are exact in its text. It takes `title` and `up` of `options`. Throws Error when nothing is recorded, when a body
/// reaches beyond the doubles, and naming a body whose pose has changed by more than a turn and a move.
[[nodiscard]] std::string world_page(const WorldRecording& recording, const ViewOptions& options = {});

/// The same as a page shows (view_page), as a GLB file for Blender and other programs (docs/reference/glb-file.md):
/// objects under their names, and where the answer has it, for each pair the faces that meet, the curves in which they
/// do, depth and distance, or ways of rays, nearest points, faces in a region, self-contacts; levels of a hierarchy,
/// cells of a partition, Voronoi regions and walks through them; a crowd as recording_glb does. Metres, Y up: the root
/// node holds the change from the scene's unit (one that is not known counts as a metre) and from `options.up`.
/// Vertices are floats, counted from a place near them, and nodes are doubles: points are off by at most 2⁻²⁰ of the
/// size of their mesh or, where they are shown of pairs, of their pair. The same bytes on every machine. Throws Error
/// as view_page does, when the file would have 4 GiB, and for poses that shear what they move.
[[nodiscard]] std::string scene_glb(const Scene& scene, std::span<const SceneInstance> models,
                                    const SceneAnswer& answer, const ViewOptions& options = {});

/// The same as crowd_page and world_page show, as an animation: a frame of 24 a second for each that is recorded. The
/// boxes or bodies under "objects", each moving; what was found in a frame hangs under a node "frame 0" or "step 0" …
/// that is visible in that frame alone: under "pairs" segments between the middles of pairs, of bodies those begun,
/// kept and ended, contact points and distances; under "cells" the edges of the method's cells. It takes `title` and
/// `up` of `options`. Throws Error when nothing is recorded, for more than 20,000 boxes or bodies, of which programs
/// make an object each, and as crowd_page and world_page do.
[[nodiscard]] std::string recording_glb(const CrowdRecording& recording, const ViewOptions& options = {});
[[nodiscard]] std::string recording_glb(const WorldRecording& recording, const ViewOptions& options = {});

/// The bodies that the pairs of a check have in common, in a GLB file that waits to be written.
struct OverlapBodiesGlb {
  /// Writes it to a file, which is complete or not there. Throws Error as write_glb does.
  std::function<void(const std::filesystem::path&)> write;
  std::size_t bodies = 0;  ///< so many pairs have one
  /// Each pair that overlaps or crosses and has none: its place in the report, and why.
  std::vector<std::pair<std::size_t, std::string>> left_out;
  std::size_t stopped = 0;  ///< so many of these because of `stop`
};

/// What each two solids have in common that overlap by the report: a closed mesh in the world, under a node "A × B". No
/// body is there that is not proved to be right but for the rounding of its corners; of a pair that has none, as one of
/// the two is a surface, the node tells the reason (docs/reference/exchange.md). It takes `title` and `up` of `view`,
/// and `threads`, `progress` and `stop` of `options`. The same bytes on any number of threads. With `beside`, corners
/// and triangles wait in a file without a name in the folder of that one, and not in memory. Throws Error as scene_glb
/// does, and naming `beside` when nothing can be written there.
[[nodiscard]] OverlapBodiesGlb overlap_bodies_glb(const Scene& scene, std::span<const SceneInstance> models,
                                                  const CheckReport& report, const ViewOptions& view = {},
                                                  const AskOptions& options = {},
                                                  const std::filesystem::path& beside = {});

/// Writes what scene_glb made: the file is complete or not there. Throws Error naming the file when it exists and was
/// not written by Toccata, or cannot be written.
void write_glb(const std::string& glb, const std::filesystem::path& path);

}  // namespace toccata
