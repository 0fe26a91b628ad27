#include "toccata/query/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "query/ask.hpp"
#include "query/contacts/region_members.hpp"
#include "query/meshes/pair_search.hpp"
#include "query/penetration/solid_body.hpp"
#include "query/volume/common_surface.hpp"
#include "query/volume/enclosing_meshes.hpp"
#include "query/volume/overlap_bodies.hpp"
#include "query/volume/solid_volume.hpp"
#include "query/volume/volume_bracket.hpp"
#include "query/volume/volume_cells.hpp"
#include "query/volume/winding_volume.hpp"
#include "toccata/core/error.hpp"
#include "toccata/query/relation.hpp"

namespace toccata {
namespace {

/// What is looked for besides the volume.
enum class CommonWanted { volume, body };

/// What two parts have in common, as a bracket, and where it is wanted as a body.
struct CommonPiece {
  VolumeBracket volume;
  std::size_t curve_count = 0;  ///< 0 where one of the two passes through itself there
  std::optional<ContactSide> pierces{};
  std::optional<Vec3> middle{};
  std::optional<TriangleMesh> body{};
  const char* no_body = nullptr;  ///< why there is none, where there should be one
};

constexpr const char* several_windings = "a mesh passes through itself there, or has no inside that can be proved";
constexpr const char* rounded_away = "rounding the corners leaves faces that cannot be cut";
constexpr const char* too_thin = "it is thinner than the rounding of coordinates";

/// Gives a piece, whose volume is known, its body. None of what its volume does not prove to be right is given.
void add_body(CommonPiece& piece, CrossedSurfaces& surfaces, int winding_of_first, int winding_of_second) {
  if (std::abs(winding_of_first) != 1 || std::abs(winding_of_second) != 1) {
    piece.no_body = several_windings;
    return;
  }
  auto surface = common_surface(surfaces, winding_of_first, winding_of_second);
  if (!surface) {
    piece.no_body = rounded_away;
  } else if (surface->triangles.empty()) {
    piece.no_body = too_thin;
  } else {
    const EnclosedVolume enclosed = enclosed_volume(*surface);
    if (enclosed.volume + enclosed.error < piece.volume.lower || enclosed.volume - enclosed.error > piece.volume.upper)
      piece.no_body = rounded_away;
    else
      piece.body.emplace(std::move(surface->vertices), std::move(surface->triangles));
  }
}

CommonPiece with_sides_exchanged(CommonPiece piece) {
  if (piece.pierces) piece.pierces = *piece.pierces == ContactSide::a ? ContactSide::b : ContactSide::a;
  return piece;
}

std::optional<ContactSide> piercing_side(const PosedMesh& a, const PosedMesh& b, std::span<const Contact> contacts) {
  VertexGraph graph_a(a), graph_b(b);
  const SurfaceWithin a_in_b(graph_a, b, contacts, ContactSide::a), b_in_a(graph_b, a, contacts, ContactSide::b);
  return side_that_pierces(contacts, graph_a, a_in_b, graph_b, b_in_a);
}

CommonPiece common_piece(const PosedMesh& a, const PosedMesh& b, CommonWanted wanted, SearchScratch& scratch) {
  if (!overlap(a.box(), b.box())) return {};
  if (!comes_first(a, b)) return with_sides_exchanged(common_piece(b, a, wanted, scratch));
  const Aabb region = common_box(a.box(), b.box());
  const auto winding_a = only_winding_in(a, region, scratch), winding_b = only_winding_in(b, region, scratch);
  if (winding_a == 0 || winding_b == 0) return {};
  const auto contacts = surface_contacts(a, b, scratch);
  CrossedSurfaces surfaces(a, b, contacts);
  const WindingVolume found = winding_volume(surfaces);
  CommonPiece piece;
  piece.middle = found.middle;
  if (!winding_a || !winding_b) {
    piece.volume = volume_by_cells(a, b);
    piece.no_body = several_windings;
    return piece;
  }
  piece.curve_count = found.curve_count;
  if (wanted == CommonWanted::volume && found.curve_count > 1) piece.pierces = piercing_side(a, b, contacts);
  const BoundedNumber volume = found.integral / exactly(static_cast<double>(*winding_a) * *winding_b);
  piece.volume = narrower(volume_bracket_of(volume), {0, ceiling_of(bounded_volume(region))});
  if (wanted == CommonWanted::body) add_body(piece, surfaces, *winding_a, *winding_b);
  return piece;
}

Aabb box_near(const PosedModel& model, const PosedModel& other) {
  const Aabb box = world_box(model);
  return std::isfinite(box.lower.x) && std::isfinite(box.upper.x) ? box : world_box(other);
}

struct EnclosedPart {
  EnclosingMeshes meshes;
  const PosedShape* shape;
  Aabb box;
  bool is_enclosed = false;  ///< else it is so small or so thin that nothing but its box is known
};

/// It is its own mesh, where it has one.
bool is_polyhedron(const PosedShape& shape) {
  const auto* convex = std::get_if<PosedPolytope>(&shape);
  return std::holds_alternative<PosedTriangles>(shape) || (convex != nullptr && convex->radius() == 0);
}

std::vector<EnclosedPart> enclosed_parts(const PosedModel& model, const PosedModel& other) {
  std::vector<EnclosedPart> parts;
  for (const PosedPart& part : model.parts) {
    EnclosingMeshes meshes = enclosing_meshes(part.shape, box_near(other, model));
    if (!meshes.within && is_polyhedron(part.shape)) continue;  // flat
    const bool is_enclosed = meshes.within && (meshes.around || is_polyhedron(part.shape));
    parts.push_back({std::move(meshes), &part.shape, world_box(part.shape), is_enclosed});
  }
  return parts;
}

CommonPiece piece_of(const EnclosedPart& a, const EnclosedPart& b, CommonWanted wanted, SearchScratch& scratch) {
  if (!a.is_enclosed || !b.is_enclosed) {
    if (!overlap(a.box, b.box)) return {};
    CommonPiece piece;
    piece.volume = {0, ceiling_of(bounded_volume(common_box(a.box, b.box)))};
    piece.no_body = "one is so small or so thin that nothing but its box is known";
    return piece;
  }
  if (!overlap(a.meshes.outer().box(), b.meshes.outer().box())) return {};
  CommonPiece piece = common_piece(*a.meshes.within, *b.meshes.within, wanted, scratch);
  if (!a.meshes.around && !b.meshes.around) return piece;
  piece.volume.upper = common_piece(a.meshes.outer(), b.meshes.outer(), CommonWanted::volume, scratch).volume.upper;
  if (!piece.body && piece.no_body == nullptr) piece.no_body = "polyhedra within the round shapes do not overlap";
  return piece;
}

/// The interiors of two of them have no point in common, as far as the meshes around them tell.
bool are_separate(const std::vector<EnclosedPart>& parts, SearchScratch& scratch) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (piece_of(parts[i], parts[j], CommonWanted::volume, scratch).volume.upper > 0) return false;
  return true;
}

bool some_part_holds(const std::vector<EnclosedPart>& parts, const Vec3& point) {
  return std::any_of(parts.begin(), parts.end(), [&](const EnclosedPart& part) {
    if (const auto* half_space = std::get_if<PosedHalfSpace>(part.shape))
      return overlap(PosedPolytope(Point{point}), *half_space);
    return holds(*part.shape, point);
  });
}

Status volume_status(const VolumeBracket& volume) {
  const bool is_narrow = std::isfinite(volume.upper) && volume.upper - volume.lower <= 1e-9 * volume.upper;
  return is_narrow ? Status::exact : Status::not_converged;
}

bool has_half_space(const PosedModel& model) {
  return std::any_of(model.parts.begin(), model.parts.end(),
                     [](const PosedPart& part) { return std::holds_alternative<PosedHalfSpace>(part.shape); });
}

/// A point that is likely in the interior of a mesh.
Vec3 likely_middle(const PosedMesh& mesh) { return 0.5 * mesh.box().lower + 0.5 * mesh.box().upper; }

class CommonParts {
 public:
  CommonParts(const PosedModel& a, const PosedModel& b, CommonWanted wanted, SearchScratch& scratch)
      : a_(enclosed_parts(a, b)), b_(enclosed_parts(b, a)), wanted_(wanted), scratch_(scratch) {
    for (const EnclosedPart& part_a : a_)
      for (const EnclosedPart& part_b : b_) see(part_a, part_b);
  }

  [[nodiscard]] CommonSolid found() {
    CommonSolid result;
    VolumeBracket volume;
    for (const CommonPiece& piece : pieces_) {
      volume.lower = std::max(volume.lower, piece.volume.lower);
      volume.upper += piece.volume.upper;
    }
    if (pieces_.size() > 1) {
      volume.upper = std::nextafter(volume.upper * (1 + sum_rounding()), infinity);
      if (are_apart()) volume.lower = sum_of_lowers();
    }
    if (pieces_.size() == 1) {
      result.curve_count = pieces_[0].curve_count;
      result.pierces = pieces_[0].pierces;
    }
    result.volume = {volume.lower, volume.upper, volume_status(volume)};
    result.point = point_;
    return result;
  }

  /// Where bodies were wanted.
  [[nodiscard]] OverlapBodies bodies() {
    OverlapBodies result;
    result.volume = found().volume;
    for (CommonPiece& piece : pieces_) {
      if (piece.body) result.pieces.push_back(std::move(*piece.body));
      if (piece.no_body != nullptr && result.missing.empty()) result.missing = piece.no_body;
    }
    if (pieces_.empty()) result.missing = too_thin;
    const auto is_round = [](const EnclosedPart& part) { return part.meshes.around.has_value(); };
    result.are_within = std::any_of(a_.begin(), a_.end(), is_round) || std::any_of(b_.begin(), b_.end(), is_round);
    result.may_overlap = result.pieces.size() > 1 && !are_apart();
    return result;
  }

 private:
  void see(const EnclosedPart& part_a, const EnclosedPart& part_b) {
    const CommonPiece piece = piece_of(part_a, part_b, wanted_, scratch_);
    if (!(piece.volume.upper > 0)) return;
    pieces_.push_back(piece);
    if (point_ || !part_a.is_enclosed || !part_b.is_enclosed) return;
    const Aabb common = common_box(part_a.meshes.within->box(), part_b.meshes.within->box());
    for (const std::optional<Vec3>& point :
         {std::optional(0.5 * common.lower + 0.5 * common.upper), piece.middle,
          std::optional(likely_middle(*part_a.meshes.within)), std::optional(likely_middle(*part_b.meshes.within))})
      if (!point_ && point && some_part_holds(a_, *point) && some_part_holds(b_, *point)) point_ = point;
  }

  /// No two pieces have an interior in common.
  [[nodiscard]] bool are_apart() { return are_separate(a_, scratch_) && are_separate(b_, scratch_); }

  /// Twice what a sum of a number of each piece may be rounded by, as a share of it.
  [[nodiscard]] double sum_rounding() const { return 0x1p-52 * static_cast<double>(pieces_.size()); }

  [[nodiscard]] double sum_of_lowers() const {
    double sum = 0;
    for (const CommonPiece& piece : pieces_) sum += piece.volume.lower;
    return std::max(0.0, std::nextafter(sum * (1 - sum_rounding()), 0));
  }

  std::vector<EnclosedPart> a_;
  std::vector<EnclosedPart> b_;
  CommonWanted wanted_;
  SearchScratch& scratch_;
  std::vector<CommonPiece> pieces_;
  std::optional<Vec3> point_;
};

}  // namespace

bool have_common_volume(const PosedModel& a, const PosedModel& b) {
  return a.solid && b.solid && !(has_half_space(a) && has_half_space(b));
}

namespace {

void require_volumes(const PosedModelPair& models) {
  for (const auto& [model, name] : {std::pair(&models.a, "model a"), std::pair(&models.b, "model b")})
    if (!model->solid)
      throw Error(std::string(name) +
                  " is taken as a surface, which has no volume in common with anything: ask about closed meshes and "
                  "solid shapes");
  if (!have_common_volume(models.a, models.b))
    throw Error("what two half-spaces have in common has no end, and no volume: ask about a bounded solid");
}

}  // namespace

CommonSolid common_solid(const PosedModel& a, const PosedModel& b, SearchScratch& scratch) {
  return CommonParts(a, b, CommonWanted::volume, scratch).found();
}

OverlapBodies overlap_bodies(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedModelPair models(a, b, query, workspace.scratch());
  OverlapBodies none;
  if (!models.a.solid || !models.b.solid)
    none.missing = "a surface takes part, which has no inside";
  else if (!have_common_volume(models.a, models.b))
    none.missing = "what two half-spaces have in common has no end";
  else
    return CommonParts(models.a, models.b, CommonWanted::body, workspace.scratch()).bodies();
  return none;
}

std::vector<TriangleMesh> overlap_bodies(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  require_volumes(PosedModelPair(a, b, query, workspace.scratch()));
  const Relation lie = relation(a, b, query, workspace);
  if (lie.kind == RelationKind::apart || are_surely_touching(lie)) return {};
  OverlapBodies found = overlap_bodies(a, b, query, workspace);
  if (!found.missing.empty())
    throw Error("what they have in common is not told as closed meshes: " + found.missing + "; ask for its volume");
  return std::move(found.pieces);
}

OverlapVolume overlap_volume(const Model& a, const Model& b, const PairQuery& query) {
  Workspace workspace;
  return overlap_volume(a, b, query, workspace);
}

OverlapVolume overlap_volume(const Model& a, const Model& b, const PairQuery& query, Workspace& workspace) {
  const PosedModelPair models(a, b, query, workspace.scratch());
  require_volumes(models);
  return common_solid(models.a, models.b, workspace.scratch()).volume;
}

}  // namespace toccata
