#pragma once

#include <optional>

#include "query/manifolds/triangle_surroundings.hpp"

namespace toccata {

/// An element of a posed model that is in contact, and, of a triangle of a mesh, what lies around it.
class ContactElement {
 public:
  /// The model has to outlive it.
  ContactElement(const PosedModel& model, Index element);
  ContactElement(const ContactElement&) = delete;
  ContactElement& operator=(const ContactElement&) = delete;
  ~ContactElement() = default;

  [[nodiscard]] Index number() const { return number_; }
  /// A shape that needs no tree.
  [[nodiscard]] const PosedPart& part() const { return part_; }

  /// The surroundings of a triangle of a mesh; none for any other shape.
  [[nodiscard]] const std::optional<TriangleSurroundings>& around() const { return around_; }

  /// What lies on it may do so along this direction, which is out of it and unit.
  [[nodiscard]] bool allows(const Vec3& direction) const { return !around_ || around_->allows(direction); }
  /// For a triangle of a mesh, TriangleSurroundings::visit_normals.
  void visit_normals(FunctionRef<void(const Vec3&)> see) const {
    if (around_) around_->visit_normals(see);
  }
  /// Likewise, TriangleSurroundings::visit_ridges.
  void visit_ridges(FunctionRef<void(const PosedPart&)> see) const {
    if (around_) around_->visit_ridges(see);
  }

 private:
  Index number_;
  PosedPart part_;
  std::optional<TriangleSurroundings> around_;
};

}  // namespace toccata
