#include <cstddef>
#include <cstdint>

#include "io/scenes/scene_parts.hpp"
#include "toccata/core/error.hpp"

// Any bytes are a scene or an Error. Scenes that generate large meshes are slow, not wrong, and left out.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.find("parameters") != std::string_view::npos) return 0;
  try {
    (void)toccata::io::parse_scene_file({text, "fuzz.json", "no/such/folder"});
  } catch (const toccata::Error&) {
  }
  return 0;
}
