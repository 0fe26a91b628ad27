#include <fmt/format.h>

#include <map>
#include <utility>

#include "reports/glb/glb_scene.hpp"
#include "reports/view/partition_layers.hpp"

namespace toccata::io {
namespace {

const GlbPaint cell_edges{"cells of partitions", 0x009e73};

class PartitionNodes {
 public:
  PartitionNodes(GlbScene& glb, PartitionKind kind) : glb_(glb), kind_(kind) {}

  void add(std::size_t object) {
    const Model& model = glb_.models()[object].model;
    if (!model.has_mesh()) return;
    const std::vector<PartitionLevel>& levels = levels_of(model.mesh());
    const GlbPlace place = GlbPlace::of(glb_.models()[object].pose);
    const GlbFrame frame = place.is_plain() ? GlbFrame::around(DisplayFrame::around(model.bounds()))
                                            : GlbFrame::around(place.placed(model.mesh().vertices()));
    const std::vector<std::size_t> meshes = meshes_of(model.mesh(), levels, place, frame);
    std::vector<std::size_t> depths;
    for (std::size_t i = 0; i < meshes.size(); ++i)
      depths.push_back(glb_.add_node(partition_label(levels[i], levels.size()), place.node, frame,
                                     {{"mesh", meshes[i]}, {"extras", {{"cells", levels[i].cells.size()}}}}));
    if (!depths.empty())
      nodes_.push_back(
          glb_.add_parent(fmt::format("cells of the {} over {}", name_of(kind_), glb_.name_of(object)), depths));
  }

  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

 private:
  const std::vector<PartitionLevel>& levels_of(const TriangleMesh& mesh) {
    const auto [found, is_new] = levels_.try_emplace(&mesh);
    require_few_partitions(levels_.size());
    if (is_new) found->second = partition_levels(kind_, PartitionItems(mesh));
    return found->second;
  }

  /// Copies of a mesh share them.
  std::vector<std::size_t> meshes_of(const TriangleMesh& mesh, const std::vector<PartitionLevel>& levels,
                                     const GlbPlace& place, const GlbFrame& frame) {
    const auto known = shared_.find(&mesh);
    if (place.is_plain() && known != shared_.end()) return known->second;
    std::vector<std::size_t> meshes;
    for (const PartitionLevel& level : levels) {
      std::vector<Aabb> boxes;
      for (const PartitionCell& cell : level.cells) boxes.push_back(cell.box);
      if (boxes.empty()) break;
      Json parts = Json::array();
      parts.push_back(glb_.part(edges_part(boxes, place, frame), GlbMode::lines, cell_edges));
      meshes.push_back(
          glb_.add_mesh(fmt::format("{} {}", name_of(kind_), partition_label(level, levels.size())), std::move(parts)));
    }
    if (place.is_plain()) shared_[&mesh] = meshes;
    return meshes;
  }

  GlbScene& glb_;
  PartitionKind kind_;
  std::map<const TriangleMesh*, std::vector<PartitionLevel>> levels_;
  std::map<const TriangleMesh*, std::vector<std::size_t>> shared_;
  std::vector<std::size_t> nodes_;
};

}  // namespace

void add_partitions(GlbScene& glb, PartitionKind kind) {
  PartitionNodes partitions(glb, kind);
  for (std::size_t object = 0; object < glb.models().size(); ++object) partitions.add(object);
  glb.add_group("partitions", partitions.nodes());
}

}  // namespace toccata::io
