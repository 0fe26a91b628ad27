#include <ode/ode.h>

#include <array>

#include "convex_library.hpp"

namespace toccata::bench {
namespace {

/// ODE is set up and closed once for the whole program.
class Engine {
 public:
  Engine() { dInitODE2(0); }
  ~Engine() { dCloseODE(); }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
};

struct Destroy {
  void operator()(dxGeom* geometry) const { dGeomDestroy(geometry); }
};
using Geometry = std::unique_ptr<dxGeom, Destroy>;

Geometry converted(const Sphere& sphere) { return Geometry(dCreateSphere(nullptr, sphere.radius())); }

Geometry converted(const Box& box) {
  const Vec3& half = box.half_extents();
  return Geometry(dCreateBox(nullptr, 2 * half.x, 2 * half.y, 2 * half.z));
}

Geometry converted(const Capsule& capsule) {
  return Geometry(dCreateCapsule(nullptr, capsule.radius(), 2 * capsule.end().z));
}

Geometry converted(const Cylinder& cylinder) {
  return Geometry(dCreateCylinder(nullptr, cylinder.radius(), 2 * cylinder.half_height()));
}

// ODE has none alone, and its convex shapes are not compared; `ode_convex` offers no such pair.
Geometry converted(const Triangle&) { return nullptr; }
Geometry converted(const ConvexHull&) { return nullptr; }
Geometry converted(const Cone&) { return nullptr; }
Geometry converted(const Ellipsoid&) { return nullptr; }

Geometry converted(const ConvexBody& body) {
  return std::visit([](const auto& shape) { return converted(shape); }, body);
}

dxGeom* place(dxGeom* geometry, const Pose& pose) {
  const Mat3& m = pose.linear;
  const dMatrix3 rotation{m[0].x, m[0].y, m[0].z, 0, m[1].x, m[1].y, m[1].z, 0, m[2].x, m[2].y, m[2].z, 0};
  dGeomSetPosition(geometry, pose.offset.x, pose.offset.y, pose.offset.z);
  dGeomSetRotation(geometry, rotation);
  return geometry;
}

class OdeConvex : public ConvexLibrary {
 public:
  Description description() const override { return {"ode", "dCollide", TOCCATA_BENCH_ODE_VERSION, "as packaged"}; }

  void prepare(const ConvexWork& work) override {
    work_ = &work;
    for (const ConvexPair& pair : work.pairs) {
      a_.push_back(converted(pair.a));
      b_.push_back(converted(pair.b));
    }
  }

  void answer(std::size_t first, std::span<ConvexAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const ConvexQuestion& question = work_->questions[first + i];
      answers[i] = asked(place(a_[question.pair].get(), question.a), place(b_[question.pair].get(), question.b));
    }
  }

 private:
  ConvexAnswer asked(dxGeom* a, dxGeom* b) const {
    std::array<dContactGeom, 8> contacts{};
    const int wanted = work_->task == ConvexTask::overlap ? (1 | static_cast<int>(CONTACTS_UNIMPORTANT)) : 8;
    const int count = dCollide(a, b, wanted, contacts.data(), sizeof contacts[0]);
    ConvexAnswer answer{count > 0};
    answer.points = count;
    for (int i = 0; i < count; ++i) {
      const dContactGeom& contact = contacts[static_cast<std::size_t>(i)];
      if (i > 0 && contact.depth <= answer.upper) continue;
      answer.lower = answer.upper = contact.depth;
      // ODE's normal is the way in which A is to be moved.
      answer.direction = {-contact.normal[0], -contact.normal[1], -contact.normal[2]};
    }
    return answer;
  }

  const ConvexWork* work_ = nullptr;
  Engine engine_;
  std::vector<Geometry> a_;
  std::vector<Geometry> b_;
};

std::string obstacle(const ConvexWork& work) {
  if (work.pair == "hull" || work.pair.ends_with("-dop")) return "its convex shapes are not compared here";
  if (work.pair == "sphere-triangle") return "it has triangles only in meshes";
  if (work.pair == "cone-box" || work.pair == "ellipsoid") return "it has no such shape";
  return work.task == ConvexTask::distance ? "it tells no distances" : "";
}

}  // namespace

ConvexOffer ode_convex(const ConvexWork& work) {
  ConvexOffer offer;
  auto library = std::make_unique<OdeConvex>();
  const std::string reason = obstacle(work);
  if (reason.empty())
    offer.libraries.push_back(std::move(library));
  else
    offer.unasked.push_back({library->description(), reason});
  return offer;
}

}  // namespace toccata::bench
