#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "io/formats/utf8.hpp"
#include "reports/glb/glb_findings.hpp"
#include "reports/questions/question_kinds.hpp"
#include "reports/questions/question_parts.hpp"
#include "reports/view/contact_geometry.hpp"
#include "reports/view/finding_layers.hpp"
#include "toccata/query/self_contacts.hpp"
#include "toccata/reports/report.hpp"

namespace toccata {
namespace {

/// Triangles are in the order of the faces in every mesh that a reader makes, but not in every mesh.
std::vector<Contact> lesser_face_first(std::vector<Contact> contacts) {
  for (Contact& contact : contacts)
    if (contact.face_b < contact.face_a)
      contact = {contact.element_b, contact.element_a, contact.face_b, contact.face_a, flipped(contact.intersection)};
  return contacts;
}

std::size_t count_face_pairs(const std::vector<Contact>& contacts) {
  std::vector<std::pair<Index, Index>> pairs;
  for (const Contact& contact : contacts) pairs.emplace_back(contact.face_a, contact.face_b);
  std::sort(pairs.begin(), pairs.end());
  return static_cast<std::size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

std::string utf8_name(const SceneObject& object) { return io::as_utf8(object.name); }

std::string csv_of_faces(const Scene& scene, const SelfReport& report) {
  std::string csv = "object,face_a,face_b,crossing\n";
  for (std::size_t i = 0; i < report.objects.size(); ++i)
    for (const ReportedFacePair& pair : report.objects[i].faces)
      csv += fmt::format("{},{},{},{}\n", io::csv_field(utf8_name(scene.objects[i])), pair.face_a, pair.face_b,
                         pair.crossing);
  return csv;
}

struct SelfKind {
  using Question = SelfQuestion;
  using Report = SelfReport;
  static constexpr const char* name = "check-self";

  static io::Json write(const SelfQuestion& q) { return {{"faces", q.faces}}; }

  static SelfQuestion read(const io::JsonValue& value) {
    value.expect_keys({"question", "faces"});
    return SelfQuestion{value.flag_or("faces", false)};
  }

  static SelfReport ask(const SelfQuestion& question, const io::Asking& asking) {
    return make_self_report(asking.models, self_contacts_each(asking.models, asking.batch()), question.faces);
  }

  static std::string json(const SelfReport& report, const io::Reporting& reporting) {
    io::Json json = reporting.head("toccata/check-self/2");
    json["self_intersecting"] = self_intersecting_count(report);
    io::Json& list = json["self_contacts"] = io::Json::array();
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      const ReportedSelf& object = report.objects[i];
      io::Json item = {{"object", utf8_name(reporting.scene.objects[i])},
                       {"object_index", i},
                       {"triangle_pairs", object.triangle_pairs},
                       {"face_pairs", object.face_pairs}};
      if (report.has_faces) {
        io::Json& faces = item["faces"] = io::Json::array();
        for (const ReportedFacePair& pair : object.faces) faces.push_back(io::json_of(pair));
      }
      list.push_back(std::move(item));
    }
    return io::document(json);
  }

  static std::string csv(const SelfReport& report, const Scene& scene) {
    if (report.has_faces) return csv_of_faces(scene, report);
    std::string csv = "object,triangle_pairs,face_pairs\n";
    for (std::size_t i = 0; i < report.objects.size(); ++i)
      csv += fmt::format("{},{},{}\n", io::csv_field(utf8_name(scene.objects[i])), report.objects[i].triangle_pairs,
                         report.objects[i].face_pairs);
    return csv;
  }

  static void mark(const SelfReport& report, io::LayerWriter& layers) {
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      layers.begin(i);
      layers.add_faces("contact", static_cast<Index>(i), io::faces_intersecting(report.objects[i].faces));
      io::add_contacts(layers, report.objects[i].faces);
    }
  }

  static void show(const SelfReport& report, io::GlbFindings& nodes) {
    for (std::size_t i = 0; i < report.objects.size(); ++i) {
      const ReportedSelf& found = report.objects[i];
      if (found.faces.empty()) continue;
      std::vector<io::Shown> shown = nodes.shown_of(io::contact_geometry(found.faces));
      shown.push_back({nodes.corners(static_cast<Index>(i), io::faces_intersecting(found.faces)),
                       io::GlbMode::triangles, io::first_faces});
      nodes.add_node("contacts of " + nodes.glb().name_of(i) + " with itself", shown,
                     {{"face_pairs", found.face_pairs}});
    }
    nodes.glb().add_group("self-contacts", nodes.nodes());
  }

  static std::vector<io::NamedObjects> named(const SelfReport& report) {
    std::vector<io::NamedObjects> named;
    for (Index i = 0; i < report.objects.size(); ++i)
      if (report.objects[i].face_pairs > 0) named.push_back({i, i});
    return named;
  }

  static void leave_out_drawn(SelfReport& report) { report.has_faces = false; }
};

}  // namespace

SelfReport make_self_report(std::span<const SceneInstance> models, std::span<const std::vector<Contact>> contacts,
                            bool faces) {
  SelfReport report;
  report.has_faces = faces;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::vector<Contact> ordered = lesser_face_first(contacts[i]);
    ReportedSelf& object = report.objects.emplace_back();
    object.triangle_pairs = ordered.size();
    object.face_pairs = count_face_pairs(ordered);
    if (faces) object.faces = io::reported_face_pairs(models[i], models[i], ordered);
  }
  return report;
}

std::size_t self_intersecting_count(const SelfReport& report) {
  return static_cast<std::size_t>(std::count_if(report.objects.begin(), report.objects.end(),
                                                [](const ReportedSelf& object) { return object.triangle_pairs > 0; }));
}

constinit const io::QuestionKind SelfQuestion::kind = io::question_kind<SelfKind>();

}  // namespace toccata
