#include <cstddef>
#include <cstdint>

#include "fuzz/reader_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  toccata::fuzz::check_reader(toccata::io::parse_poses, {reinterpret_cast<const char*>(data), size});
  return 0;
}
