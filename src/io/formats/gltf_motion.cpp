#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "io/formats/file_bytes.hpp"
#include "io/formats/file_error.hpp"
#include "io/formats/gltf_data.hpp"
#include "io/formats/gltf_motion.hpp"
#include "io/formats/gltf_nodes.hpp"
#include "toccata/core/error.hpp"
#include "toccata/motion/rigid_motion.hpp"

// Animations of glTF 2.0 (section 3.11 and appendix C): between two keys a translation goes straight on and a rotation
// turns the shorter way at an even speed, which is what a RigidMotion through keys does.
namespace toccata::io {
namespace {

/// What one channel says of a node: its translation, rotation or scale at times.
struct Channel {
  JsonValue json;
  std::string path;
  std::size_t node;
  JsonValue sampler;
};

class AnimationReader {
 public:
  AnimationReader(const JsonValue& top, GltfData& data)
      : top_(top), data_(data), nodes_(top.elements("nodes")), channels_(channels_of_all()), moves_(nodes_.size(), 0) {
    for (const Channel& channel : channels_) moves_[channel.node] = 1;
  }

  FileMotion read(const std::string& name) {
    const std::size_t node = chosen(name);
    const std::vector<std::size_t> ancestors = ancestors_of(node);
    for (const std::size_t above : ancestors)
      if (moves_[above] != 0)
        nodes_[node].fail(fmt::format("'{}' moves, and so does '{}' above it", name_of(node), name_of(above)),
                          "export the animation with one of them at rest");
    return motion_of(node, pose_through(ancestors));
  }

 private:
  [[nodiscard]] std::vector<Channel> channels_of_all() const {
    std::vector<Channel> channels;
    for (const JsonValue& animation : top_.elements("animations")) {
      const std::vector<JsonValue> samplers = animation.elements("samplers");
      for (const JsonValue& channel : animation.elements("channels")) {
        const JsonValue target = channel.at("target");
        if (!target.has("node")) continue;  // an extension's
        channels.push_back({channel, target.at("path").text(), index_of(target.at("node"), nodes_.size(), "node"),
                            samplers.at(index_of(channel.at("sampler"), samplers.size(), "sampler"))});
      }
    }
    if (channels.empty()) top_.fail("the file has no animation of a node", "export it with its animation");
    return channels;
  }

  [[nodiscard]] std::string name_of(std::size_t node) const {
    return nodes_[node].text_or("name", fmt::format("node {}", node));
  }

  /// The node of that name that moves; the only one that moves when no name is given.
  [[nodiscard]] std::size_t chosen(const std::string& name) const {
    std::vector<std::size_t> moving, found;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if (moves_[node] != 0) moving.push_back(node);
    std::copy_if(moving.begin(), moving.end(), std::back_inserter(found),
                 [&](std::size_t node) { return name.empty() || name == name_of(node); });
    if (found.empty()) top_.fail(fmt::format("no node '{}' moves", name), "name one of " + some_names(moving));
    if (found.size() > 1)
      top_.fail(fmt::format("{} nodes move{}", found.size(), name.empty() ? "" : " that have this name"),
                name.empty() ? "name one of " + some_names(moving) : "give them names of their own");
    return found.front();
  }

  [[nodiscard]] std::string some_names(std::span<const std::size_t> nodes) const {
    constexpr std::size_t most = 8;
    std::string names;
    for (const std::size_t node : nodes.first(std::min(most, nodes.size())))
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name_of(node));
    return nodes.size() > most ? names + ", …" : names;
  }

  /// The ancestors of a node, from its parent up.
  [[nodiscard]] std::vector<std::size_t> ancestors_of(std::size_t node) const {
    std::vector<std::optional<std::size_t>> parents(nodes_.size());
    for (std::size_t parent = 0; parent < nodes_.size(); ++parent)
      for (const JsonValue& child : nodes_[parent].elements("children"))
        parents[index_of(child, nodes_.size(), "node")] = parent;
    std::vector<std::size_t> ancestors;
    for (std::optional<std::size_t> above = parents[node]; above; above = parents[*above]) {
      if (ancestors.size() == nodes_.size())
        nodes_[node].fail("the node is its own ancestor", "nodes must form a tree; export the file again");
      ancestors.push_back(*above);
    }
    return ancestors;
  }

  [[nodiscard]] Pose pose_through(const std::vector<std::size_t>& ancestors) const {
    Pose pose;
    for (auto above = ancestors.rbegin(); above != ancestors.rend(); ++above)
      pose = pose * pose_of_node(nodes_[*above]);
    if (!is_finite(pose) || is_singular(pose.linear))
      nodes_[ancestors.front()].fail("with what is above it, the node flattens what is below, or is not finite",
                                     "export the file again");
    return pose;
  }

  /// The channel of the node with that path, if there is one; two animations must not both move it.
  [[nodiscard]] const Channel* channel_of(std::size_t node, std::string_view path) const {
    const Channel* found = nullptr;
    for (const Channel& channel : channels_) {
      if (channel.node != node || channel.path != path) continue;
      if (found != nullptr) channel.json.fail(fmt::format("the {} is animated twice", path), "export one animation");
      found = &channel;
    }
    return found;
  }

  /// The times of a channel's keys, and as many numbers for each as its values have.
  struct Keys {
    std::vector<double> times;
    std::vector<double> values;
  };

  Keys keys_of(const Channel& channel, std::string_view type, std::size_t components) {
    const std::string way = channel.sampler.text_or("interpolation", "LINEAR");
    if (way != "LINEAR")
      channel.sampler.at("interpolation")
          .fail(fmt::format("keys are joined by {}, and only LINEAR is read", way), "export it with linear keys");
    Keys keys{data_.numbers(accessor(channel.sampler.at("input")), "SCALAR"),
              data_.numbers(accessor(channel.sampler.at("output")), type)};
    if (keys.values.size() != components * keys.times.size())
      channel.sampler.fail(
          fmt::format("there are {} times for {} values", keys.times.size(), keys.values.size() / components),
          "export the file again");
    for (std::size_t i = 1; i < keys.times.size(); ++i)
      if (!(keys.times[i - 1] < keys.times[i]))
        channel.sampler.at("input").fail(fmt::format("the time of key {} is not later than that before", i),
                                         "export the file again");
    return keys;
  }

  [[nodiscard]] std::size_t accessor(const JsonValue& reference) const {
    return index_of(reference, data_.accessor_count(), "accessor");
  }

  /// The poses that one channel gives the node, at the times of the file; `pose_of_values` takes the numbers of a key.
  template <class PoseOf>
  std::vector<MotionKey> poses_of(std::size_t node, std::string_view path, std::string_view type,
                                  std::size_t components, const PoseOf& pose_of_values) {
    const Channel* const channel = channel_of(node, path);
    if (channel == nullptr) return {};
    const Keys keys = keys_of(*channel, type, components);
    std::vector<MotionKey> poses;
    for (std::size_t i = 0; i < keys.times.size(); ++i) {
      try {
        poses.push_back({keys.times[i], pose_of_values(std::span(keys.values).subspan(components * i, components))});
      } catch (const Error& error) {
        channel->sampler.at("output").fail(fmt::format("key {}: {}", i, error.what()), "correct the rotation");
      }
      if (!is_finite(poses.back().pose) || !std::isfinite(poses.back().time))
        channel->sampler.fail(fmt::format("key {} is not finite", i), "export the file again");
    }
    return poses;
  }

  void require_a_rigid_motion(std::size_t node) {
    if (nodes_[node].has("matrix"))
      nodes_[node].at("matrix").fail("a node that is animated has no matrix", "export the file again");
    for (const Channel& channel : channels_)
      if (channel.node == node && channel.path != "translation" && channel.path != "rotation")
        channel.json.fail(fmt::format("its {} changes, and what is swept keeps its form", channel.path),
                          "export the animation without");
  }

  /// With P the pose of what is above the node, N its own in the file and N(t) that at a time, all of a rotation and a
  /// translation but for P: what is at w in the file is at P N(t) N⁻¹ P⁻¹ w. The node's origin goes straight on.
  FileMotion motion_of(std::size_t node, const Pose& above) {
    require_a_rigid_motion(node);
    const std::vector<MotionKey> shifts = poses_of(
        node, "translation", "VEC3", 3, [](std::span<const double> v) { return Pose::translation(v[0], v[1], v[2]); });
    const std::vector<MotionKey> turns = poses_of(
        node, "rotation", "VEC4", 4, [](std::span<const double> v) { return Pose::rigid(quaternion_of(v), {}); });
    const JsonValue& json = nodes_[node];
    const Pose rest = pose_of_node(json);
    const Pose turned = json.has("rotation") ? Pose::rigid(quaternion_of(json.at("rotation").numbers(4)), {}) : Pose{};
    const Pose undone = inverse(above * (Pose::translation(rest.offset) * turned));

    FileMotion motion{{}, {}, true};
    motion.centre = above * rest.offset;
    const std::vector<double> times = times_of(shifts, turns, json);
    const RigidMotion shift = through(shifts, times, Pose::translation(rest.offset));
    const RigidMotion turn = through(turns, times, turned);
    for (const double time : times) {
      const double part = part_of(time, times);
      const Pose there{turn.at(part).linear, shift.at(part).offset};
      motion.keys.push_back({part, (above * there) * undone});
    }
    return motion;
  }

  static Quaternion quaternion_of(std::span<const double> q) { return {q[0], q[1], q[2], q[3]}; }

  /// The times of the keys of both, each once.
  static std::vector<double> times_of(const std::vector<MotionKey>& shifts, const std::vector<MotionKey>& turns,
                                      const JsonValue& json) {
    std::set<double> times;
    for (const std::vector<MotionKey>* keys : {&shifts, &turns})
      for (const MotionKey& key : *keys) times.insert(key.time);
    if (times.size() < 2) json.fail("its animation has a single moment", "export it with two keys or more");
    return {times.begin(), times.end()};
  }

  static double part_of(double time, const std::vector<double>& times) {
    return (time - times.front()) / (times.back() - times.front());
  }

  /// Through keys that may begin later than the first time and end before the last: it rests before and after, or
  /// always where there are none.
  static RigidMotion through(std::vector<MotionKey> keys, const std::vector<double>& times, const Pose& rest) {
    if (keys.empty()) return rest;
    for (MotionKey& key : keys) key.time = part_of(key.time, times);
    if (keys.front().time > 0) keys.insert(keys.begin(), {0, keys.front().pose});
    if (keys.back().time < 1) keys.push_back({1, keys.back().pose});
    return RigidMotion::through(keys);
  }

  const JsonValue& top_;
  GltfData& data_;
  std::vector<JsonValue> nodes_;
  std::vector<Channel> channels_;
  std::vector<char> moves_;  ///< of each node, whether a channel is of it
};

}  // namespace

FileMotion read_gltf_motion(const std::filesystem::path& path, const std::string& node) {
  const FileBytes bytes = read_file(path);
  const SceneBytes source{bytes.span(), path.string(), path.parent_path()};
  const GltfChunks chunks = split_glb(source);
  const nlohmann::json document = parse_json(chunks.text, source.file, RepeatedKeys::last_counts);
  const JsonValue top(document, source.file);
  check_gltf_header(top);
  GltfData data(top, source, chunks);
  return AnimationReader(top, data).read(node);
}

}  // namespace toccata::io
