#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "toccata/generate/scenes.hpp"

namespace toccata {
namespace {

Index add_node(Scene& scene, std::string name, std::optional<Index> parent, const Pose& pose = {}) {
  scene.nodes.push_back({std::move(name), parent, pose});
  return static_cast<Index>(scene.nodes.size() - 1);
}

void hang(Scene& scene, SceneObject& object, Index parent) {
  object.node = add_node(scene, object.name, parent, object.pose);
}

/// "gear" of "gear 17".
std::string kind_of(const SceneObject& object) { return object.name.substr(0, object.name.rfind(' ')); }

}  // namespace

Scene parts_by_kind(std::size_t count, std::uint64_t seed) {
  Scene scene = many_parts(count, seed);
  const Index root = add_node(scene, "machine", std::nullopt);
  std::map<std::string, Index> node_of;
  for (const SceneObject& object : scene.objects) node_of.emplace(kind_of(object), 0);
  for (auto& [kind, node] : node_of) node = add_node(scene, "all of kind " + kind, root);
  for (SceneObject& object : scene.objects) hang(scene, object, node_of.at(kind_of(object)));
  return scene;
}

Scene parts_in_a_chain(std::size_t count, std::uint64_t seed) {
  Scene scene = many_parts(count, seed);
  std::optional<Index> link;
  for (SceneObject& object : scene.objects) {
    link = add_node(scene, fmt::format("link of {}", object.name), link);
    hang(scene, object, *link);
  }
  return scene;
}

Scene parts_side_by_side(std::size_t count, std::uint64_t seed) {
  Scene scene = many_parts(count, seed);
  const Index root = add_node(scene, "everything", std::nullopt);
  for (SceneObject& object : scene.objects) hang(scene, object, root);
  return scene;
}

}  // namespace toccata
