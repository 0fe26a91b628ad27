#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "toccata/shapes/triangle_mesh.hpp"

namespace toccata {

/// A parameter of a generator: its name, the value it has when not given, and what it means.
struct GeneratorParameter {
  std::string name;
  double standard;
  double least;
  double greatest;
  bool whole;  ///< must be a whole number
  std::string meaning;
};

struct NamedGenerator {
  std::string name;
  std::string description;
  bool closed;  ///< the meshes are closed and turn outward
  std::vector<GeneratorParameter> parameters;
};

/// All mesh generators, by name. Their meshes have the same bits on every platform.
[[nodiscard]] const std::vector<NamedGenerator>& mesh_generators();

using GeneratorParameters = std::map<std::string, double>;

/// The mesh of a named generator; parameters that are not given have their standard values. Throws Error naming an
/// unknown generator or parameter (with the closest known one), and a value out of range.
[[nodiscard]] TriangleMesh generate_mesh(std::string_view name, const GeneratorParameters& parameters = {});

/// A generator with parameters, as written in "gen:torus-knot?p=2&q=3".
struct GeneratorSpecification {
  std::string name;
  GeneratorParameters parameters;
};

/// Whether `text` starts with "gen:".
[[nodiscard]] bool is_generator_specification(std::string_view text);

/// Throws Error when `text` is not of the form above.
[[nodiscard]] GeneratorSpecification parse_generator(std::string_view text);

/// A mesh turned inside out within a box: the solid is the box, `margin` larger than the mesh's box on every side,
/// without the inside of the mesh. For a closed mesh it is closed, and touches the mesh everywhere on its surface.
[[nodiscard]] TriangleMesh negative_image(const TriangleMesh& mesh, double margin);

/// The mesh with every coordinate multiplied by `factor`.
[[nodiscard]] TriangleMesh scaled_mesh(const TriangleMesh& mesh, double factor);

}  // namespace toccata
