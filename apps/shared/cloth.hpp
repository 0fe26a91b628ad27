#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "toccata/motion/deforming_mesh.hpp"
#include "toccata/shapes/triangle_mesh.hpp"

// A cloth that falls edge first onto a ball, over which it comes to hang in folds, and the floor: what continuous
// collision of meshes that deform is for. Lengths are in metres, times in seconds.
namespace toccata {

struct ClothOptions {
  int cells = 20;            ///< squares along a side of one metre, each two triangles
  double thickness = 0.01;   ///< layers keep so far apart, where they can
  double least_gap = 0.001;  ///< and certainly so far
  double step = 0.005;
  int threads = all_threads;
};

/// What one step did.
struct ClothStep {
  std::size_t near = 0;       ///< pairs of features that came within the thickness on their ways
  std::size_t stopped = 0;    ///< vertices that could not go all their way
  std::size_t shortened = 0;  ///< times that the step was halved because the rounded positions met something
};

class Cloth {
 public:
  explicit Cloth(const ClothOptions& options = {});

  /// Moves on. What it accepts is proved: from where it was to where it is, every vertex going straight, nothing of the
  /// cloth meets anything of itself or of what it falls onto.
  ClothStep step();

  /// Where it is.
  [[nodiscard]] TriangleMesh mesh() const;
  [[nodiscard]] const TriangleMesh& obstacles() const { return obstacles_; }

 private:
  struct Contact;
  struct Spring {
    Index a;
    Index b;
    double length;
  };

  [[nodiscard]] std::vector<Vec3> wanted() const;
  void pull_together(std::vector<Vec3>& positions) const;
  [[nodiscard]] std::vector<Contact> contacts_on_the_way() const;
  [[nodiscard]] Contact contact_of(const MeshImpact& impact, const DeformingMesh& other) const;
  void keep_apart(std::span<const Contact> contacts, std::vector<Vec3>& positions) const;
  [[nodiscard]] std::vector<double> free_parts() const;
  std::size_t accept(const std::vector<double>& parts);

  ClothOptions options_;
  TriangleMesh obstacles_;
  DeformingMesh at_rest_;  ///< the obstacles
  TriangleMesh pattern_;   ///< the cloth as it was made
  DeformingMesh moving_;   ///< the step that is tried
  std::vector<Vec3> velocities_;
  std::vector<Spring> springs_;
};

}  // namespace toccata
