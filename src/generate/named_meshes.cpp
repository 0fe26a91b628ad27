#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "toccata/core/error.hpp"
#include "toccata/generate/meshes.hpp"

namespace toccata {
namespace {

/// Every parameter of a generator, checked.
class Values {
 public:
  explicit Values(GeneratorParameters values) : values_(std::move(values)) {}
  double operator[](const char* name) const { return values_.at(name); }
  int whole(const char* name) const { return static_cast<int>(values_.at(name)); }
  std::uint64_t seed() const { return static_cast<std::uint64_t>(values_.at("seed")); }

 private:
  GeneratorParameters values_;
};

struct Generator {
  NamedGenerator named;
  std::function<TriangleMesh(const Values&)> make;
};

GeneratorParameter length(std::string name, double standard, std::string meaning) {
  return {std::move(name), standard, 1e-100, 1e100, false, std::move(meaning)};
}

GeneratorParameter number(std::string name, double standard, double least, double greatest, std::string meaning) {
  return {std::move(name), standard, least, greatest, false, std::move(meaning)};
}

GeneratorParameter count(std::string name, double standard, double least, double greatest, std::string meaning) {
  return {std::move(name), standard, least, greatest, true, std::move(meaning)};
}

GeneratorParameter seed() { return count("seed", 1, 0, 0x1p53, "another seed, another shape"); }

std::vector<Generator> round_generators() {
  return {
      {{"icosphere",
        "a ball of nearly equal triangles",
        true,
        {length("radius", 1, "radius"), count("subdivisions", 3, 0, 8, "20 · 4^subdivisions triangles")}},
       [](const Values& v) { return icosphere_mesh(v["radius"], v.whole("subdivisions")); }},
      {{"uv-sphere",
        "a ball of meridians and parallels around the z axis",
        true,
        {length("radius", 1, "radius"), count("around", 32, 3, 2000, "meridians"),
         count("along", 16, 2, 2000, "steps from pole to pole")}},
       [](const Values& v) { return uv_sphere_mesh(v["radius"], v.whole("around"), v.whole("along")); }},
      {{"noise-sphere",
        "a bumpy ball, star-shaped about the origin",
        true,
        {length("radius", 1, "mean radius"), number("roughness", 0.3, 0, 0.9, "the radius varies by this share"),
         count("subdivisions", 3, 0, 8, "20 · 4^subdivisions triangles"), seed()}},
       [](const Values& v) {
         return noise_sphere_mesh({v["radius"], v["roughness"], v.whole("subdivisions"), v.seed()});
       }},
      {{"prism",
        "an upright prism over a regular polygon, a cylinder with many sides; it stands on z = 0",
        true,
        {length("radius", 1, "to the corners"), length("height", 1, "along z"), count("sides", 32, 3, 10000, "sides")}},
       [](const Values& v) { return prism_mesh(v["radius"], v["height"], v.whole("sides")); }},
  };
}

std::vector<Generator> tube_generators() {
  return {
      {{"torus",
        "a ring around the z axis",
        true,
        {length("radius", 1, "of the ring"), length("tube-radius", 0.25, "of its tube, at most the radius"),
         count("around", 48, 3, 5000, "steps around"), count("sides", 16, 3, 1000, "sides of the tube")}},
       [](const Values& v) {
         return torus_mesh({v["radius"], v["tube-radius"], v.whole("around"), v.whole("sides")});
       }},
      {{"torus-knot",
        "a knotted tube on a ring around the z axis",
        true,
        {count("p", 2, 1, 50, "times around the axis"), count("q", 3, 1, 50, "times through the ring"),
         length("radius", 1, "of the ring"), length("second-radius", 0.4, "of the ring's tube"),
         length("tube-radius", 0.12, "of the knot's own tube"), count("around", 240, 3, 20000, "steps along the knot"),
         count("sides", 12, 3, 1000, "sides of the tube")}},
       [](const Values& v) {
         return torus_knot_mesh({v.whole("p"), v.whole("q"), v["radius"], v["second-radius"], v["tube-radius"],
                                 v.whole("around"), v.whole("sides")});
       }},
      {{"helix",
        "a tube that climbs around the z axis",
        true,
        {length("radius", 3, "of the middle line"), length("pitch", 5, "climb per turn"),
         length("tube-radius", 1, "of the tube"), count("turns", 3, 1, 200, "turns"),
         count("steps-per-turn", 48, 3, 2000, "steps in a turn"),
         count("sides", 8, 4, 1000, "sides of the tube, a multiple of 4")}},
       [](const Values& v) {
         return helix_mesh({v["radius"], v["pitch"], v["tube-radius"], v.whole("turns"), v.whole("steps-per-turn"),
                            v.whole("sides")});
       }},
  };
}

std::vector<Generator> other_generators() {
  return {
      {{"box",
        "an axis-aligned box around the origin",
        true,
        {length("half-x", 0.5, "half its extent along x"), length("half-y", 0.5, "along y"),
         length("half-z", 0.5, "along z")}},
       [](const Values& v) {
         return box_mesh({v["half-x"], v["half-y"], v["half-z"]});
       }},
      {{"tetrahedron",
        "a regular tetrahedron around the origin",
        true,
        {length("half-edge", 1, "half the edge of the cube whose corners it has")}},
       [](const Values& v) { return tetrahedron_mesh(v["half-edge"]); }},
      {{"gear",
        "a toothed wheel around the z axis; it stands on z = 0",
        true,
        {count("teeth", 16, 3, 2000, "teeth"), length("root-radius", 0.85, "between the teeth"),
         length("tip-radius", 1.1, "at their tips"),
         number("tooth-root", 0.62, 0.01, 0.99, "share of the pitch at the root"),
         number("tooth-tip", 0.26, 0.01, 0.99, "share of the pitch at the tip"), length("height", 0.3, "along z")}},
       [](const Values& v) {
         return gear_mesh(
             {v.whole("teeth"), v["root-radius"], v["tip-radius"], v["tooth-root"], v["tooth-tip"], v["height"]});
       }},
      {{"cavity-box",
        "a box with a bumpy hollow: the negative image of a noise sphere",
        true,
        {length("radius", 1, "mean radius of the hollow"),
         number("roughness", 0.3, 0, 0.9, "its radius varies by this share"),
         count("subdivisions", 3, 0, 8, "20 · 4^subdivisions triangles"),
         length("margin", 0.2, "thickness of the walls"), seed()}},
       [](const Values& v) {
         return negative_image(noise_sphere_mesh({v["radius"], v["roughness"], v.whole("subdivisions"), v.seed()}),
                               v["margin"]);
       }},
      {{"height-field",
        "a landscape over the xy-plane: an open surface",
        false,
        {count("cells-x", 32, 1, 4000, "cells along x"), count("cells-y", 32, 1, 4000, "cells along y"),
         length("cell", 0.1, "edge length of a cell"),
         number("height", 0.5, 0, 1e100, "heights lie between 0 and this"), seed()}},
       [](const Values& v) {
         return height_field_mesh({v.whole("cells-x"), v.whole("cells-y"), v["cell"], v["height"], v.seed()});
       }},
  };
}

const std::vector<Generator>& generators() {
  static const std::vector<Generator> all = [] {
    std::vector<Generator> list = other_generators();
    for (auto more : {round_generators(), tube_generators()})
      for (Generator& generator : more) list.push_back(std::move(generator));
    return list;
  }();
  return all;
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

const Generator& generator_named(std::string_view name) {
  for (const Generator& generator : generators())
    if (generator.named.name == name) return generator;
  throw Error(fmt::format("there is no generator '{}'{}", name, suggestion(name, names_of(mesh_generators()))));
}

void check_known(const NamedGenerator& generator, const GeneratorParameters& given) {
  const std::vector<std::string> known = names_of(generator.parameters);
  for (const auto& [name, value] : given)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Error(
          fmt::format("the generator '{}' has no parameter '{}'{}", generator.name, name, suggestion(name, known)));
}

double checked(const NamedGenerator& generator, const GeneratorParameter& parameter, double value) {
  // The comparison is written so that NaN is refused.
  if (!(value >= parameter.least && value <= parameter.greatest))
    throw Error(fmt::format("the parameter '{}' of the generator '{}' must be from {} to {}, and is {}", parameter.name,
                            generator.name, parameter.least, parameter.greatest, value));
  if (parameter.whole && std::floor(value) != value)
    throw Error(fmt::format("the parameter '{}' of the generator '{}' must be a whole number, and is {}",
                            parameter.name, generator.name, value));
  return value;
}

}  // namespace

const std::vector<NamedGenerator>& mesh_generators() {
  static const std::vector<NamedGenerator> named = [] {
    std::vector<NamedGenerator> list;
    for (const Generator& generator : generators()) list.push_back(generator.named);
    return list;
  }();
  return named;
}

TriangleMesh generate_mesh(std::string_view name, const GeneratorParameters& parameters) {
  const Generator& generator = generator_named(name);
  check_known(generator.named, parameters);
  GeneratorParameters values;
  for (const GeneratorParameter& parameter : generator.named.parameters) {
    const auto given = parameters.find(parameter.name);
    values[parameter.name] =
        given == parameters.end() ? parameter.standard : checked(generator.named, parameter, given->second);
  }
  try {
    return generator.make(Values(std::move(values)));
  } catch (const Error& error) {
    throw Error(fmt::format("the generator '{}': {}", name, error.what()));
  }
}

}  // namespace toccata
