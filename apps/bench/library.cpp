#include "library.hpp"

#include <fmt/format.h>

#include <iterator>

#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

template <class Libraries>
void append(Libraries& libraries, Libraries more) {
  libraries.insert(libraries.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

const std::vector<std::string>& peer_names() {
  static const std::vector<std::string> names{"cgal", "fcl"};
  return names;
}

MeshLibraries mesh_libraries(const std::vector<std::string>& peers) {
  MeshLibraries libraries = toccata_mesh_libraries();
  for (const std::string& peer : peers)
    append(libraries, peer == "cgal" ? cgal_mesh_libraries() : fcl_mesh_libraries());
  return libraries;
}

TriangleLibraries triangle_libraries(const std::vector<std::string>& peers) {
  TriangleLibraries libraries = toccata_triangle_libraries();
  for (const std::string& peer : peers)
    append(libraries, peer == "cgal" ? cgal_triangle_libraries() : fcl_triangle_libraries());
  return libraries;
}

void peer_is_missing(const std::string& name) {
  throw Error(fmt::format(
      "the peer {} was not installed when this program was built; `./toccata bench --with-peers` installs it", name));
}

}  // namespace toccata::bench
