#include "toccata/query/convex_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "math/vec3_measures.hpp"
#include "query/decomposition/cut_cells.hpp"
#include "query/decomposition/cut_search.hpp"
#include "query/decomposition/part_concavity.hpp"
#include "query/decomposition/part_merging.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/parallel.hpp"
#include "toccata/shapes/mesh_health.hpp"

namespace toccata {
namespace {

constexpr double no_excess = 1e-9;           // of the volume of the solid
constexpr double resolution_of_size = 1e-3;  // of concavities

struct SolidCell {
  SolidPiece piece;
  std::vector<CellSide> sides;
  Index node = 0;
  double excess = 0;
  bool is_done = false;
};

class Decomposer {
 public:
  Decomposer(const Model& solid, const MeshHealth& health, const DecompositionOptions& options)
      : solid_(solid),
        options_(options),
        frame_(health),
        concave_(solid, frame_),
        resolution_(resolution_of_size * frame_.length(1)),
        reflex_(reflex_planes(solid.mesh(), frame_, health.signed_volume < 0 ? -1 : 1)),
        search_(frame_, reflex_, options.threads) {
    start(health.signed_volume < 0);
  }

  ConvexParts decompose() {
    // Merging mends cuts that were not good, so there are more than are kept.
    const std::size_t most = options_.max_parts == 1 ? 1 : options_.max_parts + options_.max_parts / 2 + 2;
    while (cells_.size() < most && cut_worst()) tell(cells_.size(), most + 1);
    return finished(merged(hulls()));
  }

 private:
  void start(bool inside_out) {
    SolidCell cell;
    const TriangleMesh& mesh = solid_.mesh();
    for (const auto& t : mesh.triangles()) {
      RoundedTriangle triangle{local(t[0]), local(t[1]), local(t[2])};
      if (inside_out) std::swap(triangle[1], triangle[2]);
      cell.piece.surface.push_back(triangle);
    }
    cell.piece.volume = enclosed_volume(cell.piece);
    solid_volume_ = cell.piece.volume;
    cells_.push_back(rated(std::move(cell)));
  }

  [[nodiscard]] Vec3 local(Index vertex) const { return frame_.local(solid_.mesh().vertices()[vertex]); }

  [[nodiscard]] SolidCell rated(SolidCell cell) const {
    const std::vector<Vec3> points = cell.piece.points();
    cell.excess = hull_volume(points) - cell.piece.volume;
    cell.is_done = cell.excess <= no_excess * solid_volume_ || is_within_limit(points);
    return cell;
  }

  [[nodiscard]] bool is_within_limit(std::vector<Vec3> points) const {
    if (options_.concavity == 0) return false;
    for (Vec3& p : points) p = frame_.world(p);
    return concave_.concavity_of(ConvexHull(points), 0, options_.concavity).upper <= options_.concavity;
  }

  /// False when there is none to cut.
  bool cut_worst() {
    const auto order = [](const SolidCell& a, const SolidCell& b) {
      return !a.is_done && (b.is_done || a.excess > b.excess);
    };
    const auto worst = std::ranges::min_element(cells_, order);
    if (worst->is_done) return false;
    const auto choice = search_.best_cut(worst->piece, planes_, worst->sides, worst->excess);
    if (!choice) {
      worst->is_done = true;
      return true;
    }
    cut(*worst, *choice);
    return true;
  }

  void cut(SolidCell& cell, const PlaneChoice& choice) {
    const auto plane = static_cast<Index>(planes_.size());
    planes_.push_back(frame_.plane(choice));
    tree_.planes.emplace_back(choice);
    const auto child = static_cast<Index>(tree_.nodes.size());
    tree_.nodes[cell.node] = {plane, {child, child + 1}};
    tree_.nodes.resize(tree_.nodes.size() + 2);
    SplitPiece pieces = split(cell.piece, planes_[plane], plane, flat_height);
    const auto half = [&](SolidPiece piece, int sign, Index node) {
      SolidCell result{std::move(piece), cell.sides, node, 0, false};
      result.sides.push_back({plane, sign});
      return rated(std::move(result));
    };
    SolidCell back = half(std::move(pieces.back), -1, child + 1);
    cell = half(std::move(pieces.front), 1, child);
    cells_.push_back(std::move(back));
  }

  [[nodiscard]] std::vector<Vec3> local_corners(const ConvexHull& hull) const {
    std::vector<Vec3> points;
    for (Index v = 0; v < hull.vertex_count(); ++v) points.push_back(frame_.local(hull.vertex(v)));
    return points;
  }

  [[nodiscard]] std::vector<GrowingPart> hulls() const {
    std::vector<double> volumes(tree_.nodes.size(), 0);
    for (const SolidCell& cell : cells_) volumes[cell.node] = cell.piece.volume;
    const std::vector<CellContent> contents = cell_contents(solid_, tree_);
    std::vector<GrowingPart> parts;
    for (std::size_t node = 0; node < contents.size(); ++node) {
      if (contents[node].points.empty()) continue;
      GrowingPart part{ConvexHull(contents[node].points), {}, 0, volumes[node], {}};
      part.corners = snapped(local_corners(part.hull));
      part.volume = hull_volume(part.corners);
      for (const Index t : contents[node].triangles) part.faces.push_back(solid_.mesh().face_of(t));
      part.faces.erase(std::unique(part.faces.begin(), part.faces.end()), part.faces.end());
      parts.push_back(std::move(part));
    }
    return parts;
  }

  [[nodiscard]] std::vector<GrowingPart> merged(std::vector<GrowingPart> parts) const {
    const auto allowed = [&](const GrowingPart& part) {
      if (part.volume - part.solid_volume <= no_excess * solid_volume_) return true;
      return options_.concavity > 0 &&
             concave_.concavity_of(part.hull, 0, options_.concavity).upper <= options_.concavity;
    };
    return merged_parts(std::move(parts), options_.max_parts, options_.threads, allowed);
  }

  [[nodiscard]] ConvexParts finished(std::vector<GrowingPart> growing) const {
    std::ranges::stable_sort(growing, [](const GrowingPart& a, const GrowingPart& b) { return a.volume > b.volume; });
    std::vector<Concavity> concavities(growing.size());
    parallel_for(growing.size(), options_.threads,
                 [&](std::size_t i) { concavities[i] = concave_.concavity_of(growing[i].hull, resolution_, {}); });
    ConvexParts result;
    double hull_sum = 0;
    for (std::size_t i = 0; i < growing.size(); ++i) {
      growing[i].volume = hull_volume(local_corners(growing[i].hull));
      hull_sum += growing[i].volume;
      result.concavity = std::max(result.concavity, concavities[i].upper);
      result.parts.push_back({growing[i].hull, frame_.volume(growing[i].volume), concavities[i].upper,
                              concavities[i].lower, std::move(growing[i].faces)});
    }
    result.mesh_volume = frame_.volume(solid_volume_);
    result.hull_volume = frame_.volume(hull_sum);
    result.excess = frame_.volume(hull_sum - solid_volume_);
    return result;
  }

  void tell(std::size_t done, std::size_t total) const {
    if (options_.progress) options_.progress(done, total);
  }

  const Model& solid_;
  const DecompositionOptions& options_;
  SolidFrame frame_;
  ConcaveSolid concave_;
  double resolution_;
  ReflexPlanes reflex_;
  CutSearch search_;
  std::vector<SolidCell> cells_;
  std::vector<RoundedPlane> planes_;
  CutTree tree_;
  double solid_volume_ = 0;
};

void require_limits(const DecompositionOptions& options) {
  if (options.max_parts == 0) throw Error("a decomposition has at least one part: max_parts must not be 0");
  if (!(options.concavity >= 0 && std::isfinite(options.concavity)))
    throw Error(
        fmt::format("the concavity limit {} is no length: give 0 or more, in units of the mesh", options.concavity));
}

MeshHealth closed_health(const Model& model) {
  if (!std::holds_alternative<std::shared_ptr<const TriangleMesh>>(model.shape()))
    throw Error("convex decomposition is of meshes; a convex shape is its own part");
  MeshHealth health = inspect(model.mesh());
  if (!health.closed)
    throw Error(fmt::format(
        "the mesh is open ({} edges are not used equally often in both directions), so it encloses no solid to "
        "decompose: close its holes and turn its faces all outwards (`inspect` counts the edges of both kinds), or "
        "make "
        "the hull of its vertices (ConvexHull)",
        health.unbalanced_edges));
  return health;
}

/// Exactly, or nothing where a coordinate would be rounded.
std::optional<std::vector<Vec3>> times_power_of_two(std::span<const Vec3> points, int exponent) {
  std::vector<Vec3> result;
  result.reserve(points.size());
  for (const Vec3& p : points) {
    const Vec3 scaled{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    const Vec3 back{std::ldexp(scaled.x, -exponent), std::ldexp(scaled.y, -exponent), std::ldexp(scaled.z, -exponent)};
    if (!(back == p)) return {};
    result.push_back(scaled);
  }
  return result;
}

/// How many doublings a mesh is too large, or if negative too small, to be measured quickly; 0 where it is neither, or
/// so small that lengths would be rounded.
int exponent_far_from_one(const MeshHealth& health) {
  constexpr int near_one = 100, least = -900;
  const double largest = std::fmax(largest_magnitude(health.lower), largest_magnitude(health.upper));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  return exponent >= least && std::abs(exponent) > near_one ? exponent : 0;
}

/// What is told of the parts of a mesh, for the mesh that is 2^exponent times as large; nothing where a corner of a
/// part would be rounded.
std::optional<ConvexParts> enlarged(const ConvexParts& parts, int exponent) {
  const auto length = [&](double l) { return std::ldexp(l, exponent); };
  const auto volume = [&](double v) { return std::ldexp(v, 3 * exponent); };
  ConvexParts result{
      {}, volume(parts.mesh_volume), volume(parts.hull_volume), volume(parts.excess), length(parts.concavity)};
  for (const ConvexPart& part : parts.parts) {
    std::vector<Vec3> corners;
    for (Index v = 0; v < part.hull.vertex_count(); ++v) corners.push_back(part.hull.vertex(v));
    const auto scaled = times_power_of_two(corners, exponent);
    if (!scaled) return {};
    result.parts.push_back(
        {ConvexHull(*scaled), volume(part.volume), length(part.concavity), length(part.concavity_found), part.faces});
  }
  return result;
}

/// Decomposes a copy of about size 1: queries about it are quick, where the squares of tiny and huge numbers need exact
/// arithmetic. Nothing where the copy would be rounded.
std::optional<ConvexParts> decomposed_near_one(const TriangleMesh& mesh, int exponent, DecompositionOptions options) {
  auto scaled = times_power_of_two(mesh.vertices(), -exponent);
  if (!scaled) return {};
  options.concavity = std::fmin(std::ldexp(options.concavity, -exponent), std::numeric_limits<double>::max());
  const Model copy(mesh.with_vertices(std::move(*scaled)), options.threads);
  return enlarged(Decomposer(copy, inspect(copy.mesh()), options).decompose(), exponent);
}

}  // namespace

Compound ConvexParts::compound() const {
  std::vector<CompoundPart> shapes;
  for (const ConvexPart& part : parts) shapes.push_back({part.hull, {}});
  return Compound(shapes);
}

ConvexParts decompose(const Model& model, const DecompositionOptions& options) {
  require_limits(options);
  const MeshHealth health = closed_health(model);
  if (const int exponent = exponent_far_from_one(health); exponent != 0)
    if (auto parts = decomposed_near_one(model.mesh(), exponent, options)) return *std::move(parts);
  return Decomposer(model, health, options).decompose();
}

ConvexParts decompose(const TriangleMesh& mesh, const DecompositionOptions& options) {
  require_limits(options);
  return decompose(Model(mesh, options.threads), options);
}

}  // namespace toccata
