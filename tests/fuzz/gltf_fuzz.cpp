#include <cstddef>
#include <cstdint>

#include "io/scenes/scene_parts.hpp"
#include "toccata/core/error.hpp"

// Any bytes are a glTF or GLB scene or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    (void)toccata::io::parse_gltf({{reinterpret_cast<const char*>(data), size}, "fuzz.glb", "no/such/folder"});
  } catch (const toccata::Error&) {
  }
  return 0;
}
