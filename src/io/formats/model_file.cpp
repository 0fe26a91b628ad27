#include "toccata/io/model_file.hpp"

#include "toccata/generate/meshes.hpp"

namespace toccata {

Model load_model(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (!is_generator_specification(name)) return Model(read_mesh(path), all_threads);
  const GeneratorSpecification specification = parse_generator(name);
  return Model(generate_mesh(specification.name, specification.parameters), all_threads);
}

}  // namespace toccata
