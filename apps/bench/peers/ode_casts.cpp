#include <cmath>

#include "casts.hpp"
#include "peers/ode_shapes.hpp"

namespace toccata::bench {
namespace {

/// `dCollide` of a ray and a cylinder.
class OdeRays : public CastLibrary {
 public:
  Description description() const override {
    return {"ode", "dCollide of a ray", TOCCATA_BENCH_ODE_VERSION, "as packaged"};
  }

  void prepare(const CastWork& work) override {
    work_ = &work;
    for (const CastPair& pair : work.pairs) standing_.push_back(converted(std::get<Cylinder>(pair.standing)));
    for (const CastQuestion& question : work.questions) lengths_.push_back(length(question.motion));
    ray_.reset(dCreateRay(nullptr, 1));
    dGeomRaySetClosestHit(ray_.get(), 1);
  }

  void answer(std::size_t first, std::span<CastAnswer> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const CastQuestion& question = work_->questions[first + i];
      const Vec3 &from = question.start.offset, &way = question.motion;
      dGeomRaySetLength(ray_.get(), lengths_[first + i]);
      dGeomRaySet(ray_.get(), from.x, from.y, from.z, way.x, way.y, way.z);
      dContactGeom contact{};
      const bool hit = dCollide(ray_.get(), place(standing_[question.pair].get(), question.standing), 1, &contact,
                                sizeof contact) > 0;
      const double time = contact.depth / lengths_[first + i];
      answers[i] = hit ? CastAnswer{true, time, time} : CastAnswer{};
    }
  }

 private:
  static double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

  const CastWork* work_ = nullptr;
  OdeEngine engine_;
  Geometry ray_;
  std::vector<Geometry> standing_;
  std::vector<double> lengths_;
};

std::string obstacle(const std::string& pair) {
  if (!pair.starts_with("ray-")) return "it casts no shapes";
  return pair == "ray-cylinder" ? "" : "it has no such shape";
}

}  // namespace

CastOffer ode_casts(const CastWork& work) {
  CastOffer offer;
  auto library = std::make_unique<OdeRays>();
  const std::string reason = obstacle(work.pair);
  if (reason.empty())
    offer.libraries.push_back(std::move(library));
  else
    offer.unasked.push_back({library->description(), reason});
  return offer;
}

}  // namespace toccata::bench
