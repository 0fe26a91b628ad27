#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/view/display_frame.hpp"
#include "reports/view/display_mesh.hpp"
#include "reports/view/view_data.hpp"
#include "toccata/query/check_all.hpp"
#include "toccata/query/pair_query.hpp"

namespace toccata::io {

/// What is drawn of each object: a mesh that objects may share, and for spheres and boxes how the unit shape becomes
/// theirs.
class ViewMeshes {
 public:
  struct Drawn {
    std::size_t mesh = 0;
    std::optional<Pose> fit;  ///< from the mesh to the shape's own frame
  };

  /// Another place of a model, which the frame holds too.
  struct Place {
    Index model = 0;
    Pose pose;
  };

  explicit ViewMeshes(std::span<const SceneInstance> models, std::span<const Place> places = {});

  [[nodiscard]] const DisplayFrame& frame() const { return frame_; }
  [[nodiscard]] const std::vector<DisplayMesh>& meshes() const { return meshes_; }
  [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }  ///< of each model

  /// The triangles that are drawn for these faces of a model; `faces` ascend. None when all of it is one face, as
  /// shapes other than meshes are.
  [[nodiscard]] std::vector<Index> triangles_of(std::size_t model, std::span<const Index> faces) const;

  /// The members "meshes" and "objects" of the header.
  void write(Json& header, ViewData& data) const;

 private:
  Drawn drawn_of(const SceneInstance& posed);
  std::size_t mesh_number(const std::string& key, const Model& model);
  /// The box in the world of a model that is there.
  [[nodiscard]] Aabb box_at(std::size_t model, const Aabb& mesh_box, const Pose& pose, const std::string& name) const;
  [[nodiscard]] DisplayMesh mesh_for(const std::string& key, const Model& model) const;

  std::vector<DisplayMesh> meshes_;
  std::map<std::string, std::size_t> number_of_;
  std::vector<Drawn> drawn_;
  int circles_ = most_circles;  ///< of latitude, of round shapes
  DisplayFrame frame_;
};

/// Where the first two models are in these queries.
[[nodiscard]] std::vector<ViewMeshes::Place> places_of(std::span<const PairQuery> queries);

}  // namespace toccata::io
