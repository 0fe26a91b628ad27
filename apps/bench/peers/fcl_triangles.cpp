#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include <array>

#include "library.hpp"

namespace toccata::bench {
namespace {

using FclTriangle = std::array<fcl::Vector3d, 3>;

FclTriangle converted(const Triangle& t) {
  return {fcl::Vector3d(t[0].x, t[0].y, t[0].z), fcl::Vector3d(t[1].x, t[1].y, t[1].z),
          fcl::Vector3d(t[2].x, t[2].y, t[2].z)};
}

class FclTriangles : public TriangleLibrary {
 public:
  Description description() const override {
    return {"fcl", "separating axes, rounded", TOCCATA_BENCH_FCL_VERSION, "as packaged"};
  }

  void prepare(std::span<const TriangleQuestion> questions) override {
    for (const TriangleQuestion& question : questions) {
      a_.push_back(converted(question.a));
      b_.push_back(converted(question.b));
    }
  }

  void answer(std::size_t first, std::span<char> answers) const override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const FclTriangle& a = a_[first + i];
      const FclTriangle& b = b_[first + i];
      answers[i] = fcl::detail::Intersect<double>::intersect_Triangle(a[0], a[1], a[2], b[0], b[1], b[2]) ? 1 : 0;
    }
  }

 private:
  std::vector<FclTriangle> a_;
  std::vector<FclTriangle> b_;
};

}  // namespace

TriangleLibraries fcl_triangle_libraries() {
  TriangleLibraries libraries;
  libraries.push_back(std::make_unique<FclTriangles>());
  return libraries;
}

}  // namespace toccata::bench
