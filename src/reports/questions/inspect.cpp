#include <array>
#include <utility>

#include "io/formats/utf8.hpp"
#include "io/scenes/scene_shape.hpp"
#include "query/posed_shape.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/drawn_faults.hpp"
#include "reports/view/finding_layers.hpp"
#include "toccata/core/error.hpp"
#include "toccata/core/version.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/reports/report.hpp"
#include "toccata/shapes/close_mesh.hpp"

namespace toccata {
namespace {
using io::json_of;

io::Json json_of(const MeshHealth& h) {
  return {{"vertices", h.vertices},
          {"distinct_vertices", h.distinct_vertices},
          {"unused_vertices", h.unused_vertices},
          {"triangles", h.triangles},
          {"faces", h.faces},
          {"components", h.components},
          {"closed", h.closed},
          {"unbalanced_edges", h.unbalanced_edges},
          {"boundary_edges", h.boundary_edges},
          {"non_manifold_edges", h.non_manifold_edges},
          {"flipped_edges", h.flipped_edges},
          {"degenerate_triangles", h.degenerate_triangles},
          {"duplicate_triangles", h.duplicate_triangles},
          {"signed_volume", h.signed_volume},
          {"box", {{"lower", json_of(h.lower)}, {"upper", json_of(h.upper)}}}};
}

io::Json json_of(const VolumeCost& cost) {
  return {{"volume", name_of(cost.volume)},
          {"arity", cost.arity},
          {"builder", name_of(cost.method)},
          {"root_volume", cost.root_volume},
          {"root_surface", cost.root_surface},
          {"fill", cost.fill},
          {"nodes", cost.balance.nodes},
          {"leaves", cost.balance.leaves},
          {"least_depth", cost.balance.least_depth},
          {"greatest_depth", cost.balance.greatest_depth},
          {"mean_depth", cost.balance.mean_depth},
          {"best_depth", cost.balance.best_depth},
          {"bytes", cost.bytes},
          {"build_ns", cost.build_ns}};
}

io::Json json_of(const PartitionCost& cost) {
  return {{"partition", name_of(cost.kind)},
          {"object_centric", is_object_centric(cost.kind)},
          {"cells", cost.cells},
          {"items_per_cell", cost.items_per_cell},
          {"most_in_a_cell", cost.most_in_a_cell},
          {"copies_per_item", cost.copies_per_item},
          {"cells_at_an_item", cost.cells_at_an_item},
          {"bytes", cost.bytes},
          {"build_ns", cost.build_ns},
          {"candidates", cost.candidates},
          {"answers", cost.answers},
          {"question_ns", cost.question_ns},
          {"candidate_pairs", cost.candidate_pairs},
          {"pairs", cost.pairs},
          {"pairs_ns", cost.pairs_ns}};
}

io::Json json_of(const MeshFault& fault) {
  io::Json json = {{"kind", name_of(fault.kind)}, {"count", fault.count()}};
  if (!fault.edges.empty()) json["edges"] = fault.edges;
  if (!fault.triangles.empty()) json["triangles"] = fault.triangles;
  if (!fault.vertices.empty()) json["vertices"] = fault.vertices;
  return json;
}

io::Json json_of(const ConvexHull& hull) {
  const HullTopology topology = hull.topology();
  return {{"vertices", hull.vertex_count()},
          {"edges", topology.origin.size() / 2},
          {"faces", topology.face_count()},
          {"dimension", hull.dimension()}};
}

io::Json json_of_shape(const Shape& shape);

io::Json json_of(const Compound& compound) {
  io::Json parts = io::Json::array();
  for (const CompoundPart& part : compound.parts()) {
    io::Json item = json_of_shape(part.shape);
    item["pose"] = part.pose.numbers();
    parts.push_back(std::move(item));
  }
  return parts;
}

/// What it is and its numbers, as scene files have them; of meshes how large they are.
io::Json json_of_shape(const Shape& shape) {
  io::Json json = {{"shape", io::type_of(shape)}};
  if (const auto mesh = mesh_of(shape)) {
    json["triangles"] = mesh->triangle_count();
    json["faces"] = mesh->face_count();
  } else if (const auto* compound = std::get_if<Compound>(&shape)) {
    json["parts"] = json_of(*compound);
  } else {
    json["numbers"] = io::json_of(shape, [](const auto&) { return io::Json(); });
    json["numbers"].erase("type");
    if (const auto* hull = std::get_if<ConvexHull>(&shape)) json["hull"] = json_of(*hull);
  }
  return json;
}

bool is_empty_or_bounded(const Aabb& box) { return is_empty(box) || (is_finite(box.lower) && is_finite(box.upper)); }

std::optional<Aabb> finite_box_of(const PosedModel& posed) {
  const Aabb box = world_box(posed);
  return is_empty_or_bounded(box) ? std::optional(box) : std::nullopt;
}

void add_mesh(const TriangleMesh& mesh, InspectedObject& result) {
  const SceneObject& object = result.object;
  result.health = inspect(mesh);
  const bool may_be_solid = !std::holds_alternative<HeightField>(object.shape);
  result.solid = may_be_solid && object.solid != Solid::none && result.health->closed;
  Aabb box;
  for (const auto& corners : mesh.triangles())
    for (const Index corner : corners) box = merge(box, transform(object.pose, mesh.vertices()[corner]));
  result.world_box = box;
}

void add_shape(InspectedObject& result) {
  const Model model(result.object.shape);
  try {
    const PosedModel posed = pose_model(model, result.object.pose, result.object.solid, "this object");
    result.solid = posed.solid;
    result.world_box = finite_box_of(posed);
  } catch (const Error& error) {
    result.refusal = error.what();
  }
}

/// What a mesh does to itself, and how far an open one is from closed.
void add_state(const SceneInstance& posed, InspectedObject& inspected) {
  inspected.self_intersections = self_contacts(posed.model).size();
  if (inspected.health->closed || std::holds_alternative<HeightField>(inspected.object.shape)) return;
  inspected.boundaries = boundary_count(*inspected.object.mesh());
  inspected.closing_gap = closing_gap(*inspected.object.mesh());
}

SceneObject object_of(const SceneInstance& posed) {
  SceneObject object;
  object.name = posed.name;
  object.shape = posed.model.shape();
  object.pose = posed.pose;
  object.solid = posed.solid;
  object.group = posed.group;
  return object;
}

/// "boundary edges".
std::string spaced_name(MeshFaultKind kind) {
  std::string words = toccata::name_of(kind);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

struct InspectKind {
  using Question = InspectQuestion;
  using Report = InspectReport;
  static constexpr const char* name = "inspect";

  static io::Json write(const InspectQuestion& q) {
    return {{"volumes", q.volumes}, {"partitions", q.partitions}, {"faults", q.faults}};
  }

  static InspectQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "volumes", "partitions", "faults"});
    return InspectQuestion{value.flag_or("volumes", false), value.flag_or("partitions", false),
                           value.flag_or("faults", false)};
  }

  static InspectReport ask(const InspectQuestion& question, const io::Asking& asking) {
    CostOptions options;
    options.progress = asking.options.progress;
    InspectReport report;
    for (const SceneInstance& posed : asking.models) {
      InspectedObject& inspected = report.objects.emplace_back(inspect(object_of(posed)));
      const auto mesh = inspected.object.mesh();
      if (inspected.refusal.empty() && mesh) add_state(posed, inspected);
      if (mesh && question.faults) inspected.faults = mesh_faults(*mesh);
      if (mesh && question.volumes) inspected.volumes = measure_volumes(*mesh, options);
      if (mesh && question.partitions)
        inspected.partitions = measure_partitions(PartitionItems(*mesh), {1000, 1, asking.options.progress});
    }
    return report;
  }

  static std::string json(const InspectReport& report, const io::Reporting& reporting) {
    io::Json json = {{"schema", "toccata/inspect/1"},
                     {"version", version},
                     {"unit", reporting.scene.unit},
                     {"warnings", reporting.warnings}};
    io::Json& list = json["objects"] = io::Json::array();
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      const InspectedObject& inspected = report.objects[i];
      const SceneObject& object = inspected.object;
      io::Json item = {{"name", io::as_utf8(object.name)}, {"source", io::as_utf8(reporting.scene.objects[i].source)}};
      item.update(json_of_shape(object.shape));
      item["pose"] = object.pose.numbers();
      item["solid"] = inspected.solid;
      if (inspected.health) item.update(json_of(*inspected.health));
      item["world_box"] = inspected.world_box ? json_of(*inspected.world_box) : io::Json();
      if (inspected.self_intersections) item["self_intersections"] = *inspected.self_intersections;
      if (inspected.health && !inspected.health->closed && inspected.boundaries > 0) {
        item["boundaries"] = inspected.boundaries;
        item["closing_gap"] = inspected.closing_gap ? io::Json(*inspected.closing_gap) : io::Json();
      }
      if (!inspected.refusal.empty()) item["refusal"] = io::as_utf8(inspected.refusal);
      for (const MeshFault& fault : inspected.faults) item["faults"].push_back(json_of(fault));
      for (const VolumeCost& cost : inspected.volumes) item["volumes"].push_back(json_of(cost));
      for (const PartitionCost& cost : inspected.partitions) item["partitions"].push_back(json_of(cost));
      list.push_back(std::move(item));
    }
    return io::document(json);
  }

  static void mark(const InspectReport& report, io::LayerWriter& layers) {
    const std::vector<io::InspectFinding> findings = io::inspect_findings(report);
    for (std::size_t i = 0; i < findings.size(); ++i) {
      if (!findings[i].fault) continue;
      layers.begin(i);
      const SceneObject& object = report.objects[findings[i].object].object;
      const io::FaultGeometry shown = io::geometry_of(*findings[i].fault, *object.mesh(), object.pose);
      const std::string role = name_of(findings[i].fault->kind);
      layers.add_triangles(role.c_str(), shown.triangles);
      layers.add_segments(role.c_str(), shown.segments);
      layers.add_points(role.c_str(), shown.points);
    }
  }

  static io::Json words(const InspectReport& report, io::PairMethods&) {
    io::Json words = io::Json::array();
    for (const io::InspectFinding& finding : io::inspect_findings(report)) {
      io::Json& entry = words.emplace_back(io::Json{{"object", finding.object}});
      if (!finding.fault) continue;
      entry["fault"] = name_of(finding.fault->kind);
      entry["count"] = finding.fault->count();
      entry["groups"] = finding.groups;
    }
    return words;
  }

  static void show(const InspectReport& report, io::GlbFindings& nodes) {
    for (const io::InspectFinding& finding : io::inspect_findings(report)) {
      if (!finding.fault) continue;
      const SceneObject& object = report.objects[finding.object].object;
      io::FaultGeometry found = io::geometry_of(*finding.fault, *object.mesh(), object.pose);
      nodes.add_node(fmt::format("{} of {}", spaced_name(finding.fault->kind), nodes.glb().name_of(finding.object)),
                     std::vector<io::Shown>{{std::move(found.triangles), io::GlbMode::triangles, io::faults},
                                            {std::move(found.segments), io::GlbMode::lines, io::faults},
                                            {std::move(found.points), io::GlbMode::points, io::faults}},
                     {{"count", finding.fault->count()}});
    }
    nodes.glb().add_group("faults", nodes.nodes());
  }

  static void leave_out_drawn(InspectReport& report) {
    for (InspectedObject& object : report.objects) object.faults.clear();
  }
};

}  // namespace

InspectedObject inspect(const SceneObject& object) {
  InspectedObject result{object, {}, false, {}, {}, {}, {}};
  if (const auto mesh = object.mesh())
    add_mesh(*mesh, result);
  else
    add_shape(result);
  return result;
}

std::string name_of(MeshFaultKind kind) {
  constexpr std::array names = {"boundary_edges",       "non_manifold_edges",  "flipped_edges",
                                "degenerate_triangles", "duplicate_triangles", "unused_vertices"};
  return names[static_cast<std::size_t>(kind)];
}

constinit const io::QuestionKind InspectQuestion::kind = io::question_kind<InspectKind>();

}  // namespace toccata
