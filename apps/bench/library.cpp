#include "library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "toccata/core/error.hpp"

namespace toccata::bench {
namespace {

template <class Libraries>
struct Peer {
  std::string name;
  Libraries (*libraries)();
};

const std::vector<Peer<MeshLibraries>> peers_of_meshes{{"fcl", fcl_mesh_libraries},
                                                       {"cgal", cgal_mesh_libraries},
                                                       {"embree", embree_mesh_libraries},
                                                       {"ode", ode_mesh_libraries},
                                                       {"bullet", bullet_mesh_libraries}};
const std::vector<Peer<TriangleLibraries>> peers_of_triangles{{"fcl", fcl_triangle_libraries},
                                                              {"cgal", cgal_triangle_libraries}};

template <class Libraries>
std::vector<std::string> names_of(const std::vector<Peer<Libraries>>& peers) {
  std::vector<std::string> names;
  for (const auto& peer : peers) names.push_back(peer.name);
  return names;
}

template <class Libraries>
Libraries with_peers(Libraries libraries, const std::vector<Peer<Libraries>>& known,
                     const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto peer = std::find_if(known.begin(), known.end(), [&](const auto& one) { return one.name == name; });
    Libraries more = peer->libraries();
    libraries.insert(libraries.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return libraries;
}

}  // namespace

std::vector<std::string> mesh_peers() { return names_of(peers_of_meshes); }
std::vector<std::string> triangle_peers() { return names_of(peers_of_triangles); }

MeshLibraries mesh_libraries(const std::vector<std::string>& peers) {
  return with_peers(toccata_mesh_libraries(), peers_of_meshes, peers);
}

TriangleLibraries triangle_libraries(const std::vector<std::string>& peers) {
  return with_peers(toccata_triangle_libraries(), peers_of_triangles, peers);
}

void peer_is_missing(const std::string& name) {
  throw Error(fmt::format(
      "the peer {} was not installed when this program was built; `./toccata bench --with-peers` installs it", name));
}

}  // namespace toccata::bench
