#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <CGAL/version.h>

#include <type_traits>

#include "library.hpp"

namespace toccata::bench {
namespace {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using RoundedKernel = CGAL::Simple_cartesian<double>;

template <class Kernel>
typename Kernel::Triangle_3 converted(const Triangle& t) {
  using Point = typename Kernel::Point_3;
  return {Point(t[0].x, t[0].y, t[0].z), Point(t[1].x, t[1].y, t[1].z), Point(t[2].x, t[2].y, t[2].z)};
}

template <class Kernel>
class CgalTriangles : public TriangleLibrary {
 public:
  Description description() const override {
    const bool exact = std::is_same_v<Kernel, ExactKernel>;
    return {"cgal", exact ? "EPICK, exact" : "Simple_cartesian<double>, rounded", CGAL_VERSION_STR,
            TOCCATA_BENCH_COMPILER ", -O3 -DNDEBUG -frounding-math"};
  }

  void prepare(std::span<const TriangleQuestion> questions) override {
    for (const TriangleQuestion& question : questions) {
      a_.push_back(converted<Kernel>(question.a));
      b_.push_back(converted<Kernel>(question.b));
    }
  }

  void answer(std::size_t first, std::span<char> answers) const override {
    for (std::size_t i = 0; i < answers.size(); ++i)
      answers[i] = CGAL::do_intersect(a_[first + i], b_[first + i]) ? 1 : 0;
  }

 private:
  std::vector<typename Kernel::Triangle_3> a_;
  std::vector<typename Kernel::Triangle_3> b_;
};

}  // namespace

TriangleLibraries cgal_triangle_libraries() {
  TriangleLibraries libraries;
  libraries.push_back(std::make_unique<CgalTriangles<ExactKernel>>());
  libraries.push_back(std::make_unique<CgalTriangles<RoundedKernel>>());
  return libraries;
}

}  // namespace toccata::bench
