#include "toccata/io/model_file.hpp"

#include "toccata/generate/meshes.hpp"

namespace toccata {

Model load_model(const std::string& path) {
  if (!is_generator_specification(path)) return Model(read_mesh(path), all_threads);
  const GeneratorSpecification specification = parse_generator(path);
  return Model(generate_mesh(specification.name, specification.parameters), all_threads);
}

}  // namespace toccata
