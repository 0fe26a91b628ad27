#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "reports/glb/glb_scene.hpp"
#include "reports/view/contact_geometry.hpp"
#include "toccata/reports/report.hpp"

namespace toccata::io {

inline const GlbPaint first_faces{"faces of the first that meet", 0x0072b2};
inline const GlbPaint faults{"faults of meshes", 0xd55e00};
inline const GlbPaint lengths{"depths, distances and rays", 0xcc79a7};

/// Points of a finding, in the world, and how they are shown.
struct Shown {
  std::vector<Vec3> points;
  GlbMode mode;
  GlbPaint paint;
};

/// A node for each thing that was found.
class GlbFindings {
 public:
  explicit GlbFindings(GlbScene& glb) : glb_(glb) {}

  [[nodiscard]] GlbScene& glb() { return glb_; }
  /// Those that were added.
  [[nodiscard]] const std::vector<std::size_t>& nodes() const { return nodes_; }

  void add_node(const std::string& name, std::span<const Shown> shown, Json extras);
  void add_contacts(const ReportedPair& pair);
  void add_depth(const std::array<Index, 2>& pair, const Penetration& depth);
  /// Nothing of two that meet.
  void add_distance(const std::array<Index, 2>& pair, const Distance& distance);
  /// Puts the nodes that were added under one that shows them at this pose.
  std::size_t at_pose(std::size_t pose, std::size_t poses);

  /// What faces have in common.
  [[nodiscard]] static std::vector<Shown> shown_of(ContactGeometry found);
  /// The corners of the triangles that are drawn for these faces.
  [[nodiscard]] std::vector<Vec3> corners(Index object, std::span<const Index> faces) const;

 private:
  [[nodiscard]] std::string title(const char* what, const std::array<Index, 2>& pair) const;
  /// A segment.
  void add_length(const char* what, const std::array<Index, 2>& pair, const std::array<Vec3, 2>& ends, Json extras);

  GlbScene& glb_;
  std::vector<std::size_t> nodes_;
};

}  // namespace toccata::io
