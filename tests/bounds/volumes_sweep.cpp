#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "support/sweep.hpp"
#include "support/volume_cases.hpp"
#include "support/volume_sets.hpp"
#include "toccata/toccata.hpp"

// What every volume promises, whatever the points: it holds them, also merged and posed; its gap is not above the true
// distance, it does not say apart of what meets, and nothing enters later than it does in truth.
namespace toccata::test {
namespace {

/// A case with this number is also compared with the rational oracle.
constexpr std::uint64_t oracle_step = 64;

template <class V>
std::string fault_of_containment(const V& volume, const std::vector<Vec3>& points, const std::string& name) {
  for (const Vec3& p : points)
    if (!contains(volume, p)) return name + " does not hold a point";
  const Vec3 point = points.back();
  return holds(volume, point) ? "" : name + " says to hold a point that lies outside";
}

template <class V>
std::string fault_of_numbers(const V& volume) {
  for (const double number : {measure(volume), surface_area(volume), half_area(volume)})
    if (!(number >= 0)) return "a size is negative or not a number";
  return holds_but_for_rounding(box_around(volume), farthest_point(volume, {1, -0.5, 0.25}).x) ? ""
                                                                                               : "the box is wrong";
}

/// a and b are the volumes of these points.
template <class V>
std::string fault_of_pair(const V& a, const V& b, const VolumeCase& input) {
  const double found = gap(a, b);
  if (!(found >= 0)) return "a gap is negative or not a number";
  if (found > 0 && !found_less_than_every_pair(found, input.a, input.b))
    return "a gap is above the distance of two points";
  if (input.shared && (found > 0 || !overlap(a, b) || !overlap(b, a))) return "apart, though a point is common";
  if (gap(a, PointVolume{input.a.front()}) != 0) return "a gap to a point inside";
  const auto motion = exact_difference_of(input.b.front(), input.a.front());
  if (!motion) return "";
  if (!(sweep_entry(a, *motion, b) <= 1)) return "a sweep enters too late";
  if (!(ray_entry(input.a.front(), *motion, b) <= 1)) return "a ray enters too late";
  return "";
}

template <class V>
std::string fault_by_oracle(const V& a, const V& b, const VolumeCase& input) {
  const double found = gap(a, b);
  const bool meet = overlap(a, b);
  const oracle::ConvexSet held_by_a = oracle::hull_set(input.a), held_by_b = oracle::hull_set(input.b);
  if (std::isfinite(found) && oracle::compare_distance(held_by_a, held_by_b, oracle::exact(found)) < 0)
    return "the gap is above the distance of what is held";
  if (!meet && oracle::overlap(held_by_a, held_by_b)) return "apart, though what is held meets";
  if constexpr (HasExactSet<V>) {
    const oracle::ConvexSet set_a = exact_set(a), set_b = exact_set(b);
    if (std::isfinite(found) && oracle::compare_distance(set_a, set_b, oracle::exact(found)) < 0)
      return "the gap is above the volumes' distance";
    if (!meet && oracle::overlap(set_a, set_b)) return "apart, though the volumes meet";
  }
  return "";
}

template <class V>
std::string fault_of(const VolumeCase& input, bool with_oracle) {
  const V a = fit<V>(input.a), b = fit<V>(input.b);
  const V of_triangles = fit<V>(input.triangles), both = merge(a, b), turned = posed(a, input.pose);
  std::string fault = fault_of_containment(a, input.a, "the fitted volume");
  if (fault.empty()) fault = fault_of_containment(of_triangles, corners(input.triangles), "the volume of triangles");
  if (fault.empty()) fault = fault_of_containment(both, input.a, "the merged volume");
  if (fault.empty()) fault = fault_of_containment(both, input.b, "the merged volume");
  if (fault.empty()) fault = fault_of_containment(turned, transform(input.pose, input.a), "the posed volume");
  for (const V* volume : {&a, &both, &turned})
    if (fault.empty()) fault = fault_of_numbers(*volume);
  if (fault.empty()) fault = fault_of_pair(a, b, input);
  if (fault.empty() && with_oracle) fault = fault_by_oracle(a, b, input);
  return fault;
}

template <class V>
SweepResult run_volume(std::uint64_t seed, std::uint64_t cases) {
  Random random(Random(seed).bits());
  SweepResult result;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const std::string& regime = volume_regimes()[i % volume_regimes().size()];
    const VolumeCase input = volume_case(regime, random);
    const std::string fault = fault_of<V>(input, i % oracle_step == 0);
    ++result.cases;
    if (fault.empty()) continue;
    if (result.wrong++ == 0) result.first_failure = fmt::format("case {}, {}: {}{}", i, regime, fault, to_text(input));
  }
  return result;
}

struct VolumeSweep {
  std::string_view name;
  SweepResult (*run)(std::uint64_t seed, std::uint64_t cases);
};
constexpr auto volume_sweeps = AllVolumes::of_each([]<class V>(std::type_identity<V>) {
  return VolumeSweep{V::name, &run_volume<V>};
});

SweepResult run_volumes(const std::string& family, std::uint64_t seed, std::uint64_t cases) {
  return std::ranges::find(volume_sweeps, family, &VolumeSweep::name)->run(seed, cases);
}

std::vector<std::string> volume_names() {
  std::vector<std::string> names;
  for (const VolumeSweep& sweep : volume_sweeps) names.emplace_back(sweep.name);
  return names;
}

const bool volumes_known = register_sweep({"volumes", volume_names(), 1'000'000, 1000, run_volumes, 20'000, 200});

}  // namespace
}  // namespace toccata::test
