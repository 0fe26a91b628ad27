#include <array>

#include "convex_library.hpp"
#include "peers/ode_shapes.hpp"

namespace toccata::bench {
namespace {

using bench::converted;

// ODE has none alone, and its convex shapes are not compared; `ode_convex` offers no such pair.
Geometry converted(const Triangle&) { return nullptr; }
Geometry converted(const ConvexHull&) { return nullptr; }
Geometry converted(const Cone&) { return nullptr; }
Geometry converted(const Ellipsoid&) { return nullptr; }

Geometry converted(const ConvexBody& body) {
  return std::visit([](const auto& shape) { return converted(shape); }, body);
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
  OdeEngine engine_;
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
