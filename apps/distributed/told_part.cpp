#include "told_part.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "check_input.hpp"
#include "reports/pair_motion.hpp"
#include "toccata/bounds/aabb.hpp"
#include "toccata/reports/scene_question.hpp"

namespace toccata::command {
namespace {

std::shared_ptr<const TriangleMesh> mesh_across(const Aabb& box) {
  return std::make_shared<const TriangleMesh>(std::vector{box.lower, box.upper},
                                              std::vector<std::array<Index, 3>>{{0, 1, 1}});
}

template <class T>
void put_optional(MessageWriter& writer, const std::optional<T>& value) {
  writer.put(value.has_value());
  if (value) writer.put(*value);
}

template <class T>
std::optional<T> get_optional(MessageReader& reader) {
  return reader.get<bool>() ? std::optional(reader.get<T>()) : std::nullopt;
}

}  // namespace

void put_told_part(MessageWriter& writer, const ConvertedScene& file, std::span<const SceneInstance> models) {
  writer.put_text(file.scene.unit);
  writer.put(std::uint64_t{file.notes.size()});
  for (const std::string& note : file.notes) writer.put_text(note);
  const std::vector<std::string> summaries = object_summaries(file.scene, models);
  const std::vector<TableObject> tables = table_objects(file.scene);
  writer.put(std::uint64_t{models.size()});
  for (std::size_t i = 0; i < models.size(); ++i) {
    const SceneObject& object = file.scene.objects[i];
    writer.put_text(object.name);
    writer.put_text(object.group);
    writer.put(object.pose);
    const auto mesh = object.mesh();
    put_optional(writer, mesh ? std::optional(fit_aabb(mesh->vertices())) : std::nullopt);
    writer.put_text(summaries[i]);
    writer.put(tables[i]);
    put_optional(writer, io::placed(models[i]).box);
    writer.put(is_open_mesh(models[i]));
  }
}

ToldPart get_told_part(MessageReader& reader) {
  ToldPart part;
  part.file.scene.unit = reader.get_text();
  for (auto count = reader.get<std::uint64_t>(); count > 0; --count) part.file.notes.push_back(reader.get_text());
  for (auto count = reader.get<std::uint64_t>(); count > 0; --count) {
    SceneObject& object = part.file.scene.objects.emplace_back();
    object.name = reader.get_text();
    object.group = reader.get_text();
    object.pose = reader.get<Pose>();
    object.shape = Point{};
    if (const auto box = get_optional<Aabb>(reader)) object.shape = mesh_across(*box);
    ToldObject& told = part.objects.emplace_back();
    told.summary = reader.get_text();
    told.table = reader.get<TableObject>();
    told.box = get_optional<Aabb>(reader);
    told.is_open = reader.get<bool>();
  }
  return part;
}

}  // namespace toccata::command
