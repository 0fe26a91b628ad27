#include "query/subdivision/adaptive_levels.hpp"

#include <algorithm>
#include <utility>

namespace toccata {
namespace {

/// Deeper than this doubles do not resolve what is near a point.
constexpr int deepest_useful_level = 60;

/// The choice of the faces of one level that are refined.
class Selection {
 public:
  Selection(const LevelMesh& mesh, const std::vector<FaceBound>& bounds, const AllowedDistance& allowed)
      : mesh_(mesh), bounds_(bounds), allowed_(allowed), chosen_(mesh.face_count(), 0), moved_(mesh.points.size()) {}

  std::vector<char> chosen(bool take_all) {
    for (Index f = 0; f < mesh_.face_count(); ++f)
      if (mesh_.whole[f] && (take_all || bounds_[f].to_limit + bounds_[f].from_triangles > allowed_(mesh_, f)))
        choose(f);
    while (!waiting_.empty()) {
      const Index vertex = waiting_.back();
      waiting_.pop_back();
      for (const Index side : mesh_.sides_at(vertex)) {
        const Index f = mesh_.face_of_side[side];
        // A neighbour that is refined moves points of the border, by no more than the face's own bound.
        if (mesh_.whole[f] && 2 * bounds_[f].to_limit + bounds_[f].from_triangles > allowed_(mesh_, f)) choose(f);
      }
    }
    return std::move(chosen_);
  }

 private:
  void choose(Index face) {
    if (chosen_[face]) return;
    chosen_[face] = 1;
    for (const Index corner : mesh_.face(face)) {
      if (moved_[corner]) continue;
      moved_[corner] = 1;
      waiting_.push_back(corner);
    }
  }

  const LevelMesh& mesh_;
  const std::vector<FaceBound>& bounds_;
  const AllowedDistance& allowed_;
  std::vector<char> chosen_;
  std::vector<char> moved_;
  std::vector<Index> waiting_;
};

std::vector<FaceBound> bounds_of_whole(const LevelMesh& mesh) {
  LimitBounds limits(mesh);
  std::vector<FaceBound> bounds(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (mesh.whole[f]) bounds[f] = limits.of(f);
  return bounds;
}

std::size_t marked_count(const std::vector<char>& marks) {
  return static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
}

}  // namespace

AdaptiveLevels adaptive_levels(const SubdivisionCage& cage, const RefinementOptions& options,
                               const AllowedDistance& allowed) {
  // A quadrangle is two triangles, and a leaf beside finer ones a fan: at most four times as many, which is rare.
  const std::size_t triangles_of_face = cage.scheme() == SubdivisionScheme::loop ? 1 : 2;
  AdaptiveLevels levels;
  levels.meshes.push_back(first_level(cage));
  std::size_t leaves = 0;
  while (true) {
    LevelMesh& mesh = levels.meshes.back();
    levels.bounds.push_back(bounds_of_whole(mesh));
    std::vector<char> chosen = Selection(mesh, levels.bounds.back(), allowed).chosen(mesh.level < options.levels);
    const std::size_t count = marked_count(chosen);
    const std::size_t later = leaves + marked_count(mesh.whole) + 3 * count;
    const bool is_too_much = later > options.max_triangles / triangles_of_face || mesh.level >= deepest_useful_level;
    if (count == 0 || is_too_much) {
      levels.are_complete = count == 0;
      levels.refined.emplace_back(mesh.face_count(), 0);
      return levels;
    }
    if (options.progress) options.progress(triangles_of_face * later, options.max_triangles);
    leaves += marked_count(mesh.whole) - count;
    levels.refined.push_back(std::move(chosen));
    levels.meshes.push_back(subdivided(mesh, levels.refined.back()));
  }
}

}  // namespace toccata
