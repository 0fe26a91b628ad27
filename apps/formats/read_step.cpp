// Writes a scene file of what a STEP file (ISO 10303-21, AP203, AP214 and AP242) holds: the tree of its assembly, each
// product meshed once however often it is placed, with the faces of the file as faces. By Open CASCADE.
//
// usage: toccata-read-step FILE.step SCENE.json [--tessellation LENGTH]
//
// What is to be told about the reading goes to standard output, a line each; why it failed, to standard error.
#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene_parts.hpp"

namespace {

using toccata::formats::base64_of;
using toccata::formats::PartNames;
using Json = nlohmann::json;
using Label = TDF_Label;

/// Triangles of one product, in the numbers of the file's faces.
struct Mesh {
  std::vector<double> vertices;
  std::vector<std::uint32_t> triangles, faces;
  std::size_t faces_without = 0;  ///< faces that could not be meshed
};

void add_face(Mesh& mesh, const TopoDS_Face& face, std::uint32_t number) {
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
  if (triangulation.IsNull() || triangulation->NbTriangles() == 0) {
    ++mesh.faces_without;
    return;
  }
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / 3);
  for (int i = 1; i <= triangulation->NbNodes(); ++i) {
    gp_Pnt point = triangulation->Node(i);
    if (!place.IsIdentity()) point.Transform(place.Transformation());
    mesh.vertices.insert(mesh.vertices.end(), {point.X(), point.Y(), point.Z()});
  }
  const bool is_reversed = face.Orientation() == TopAbs_REVERSED;
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    if (is_reversed) std::swap(b, c);
    for (const int corner : {a, b, c}) mesh.triangles.push_back(first + static_cast<std::uint32_t>(corner) - 1);
    mesh.faces.push_back(number);
  }
}

std::string name_of(const Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return {};
  const TCollection_ExtendedString& text = name->Get();
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter buffer = utf8.data();
  utf8.resize(static_cast<std::size_t>(text.ToUTF8CString(buffer)));
  while (!utf8.empty() && utf8.back() == '\0') utf8.pop_back();
  return utf8;
}

std::array<double, 12> numbers_of(const TopLoc_Location& location) {
  const gp_Trsf place = location.Transformation();
  std::array<double, 12> numbers{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      numbers[static_cast<std::size_t>(3 * row + column)] = place.Value(row + 1, column + 1);
    numbers[static_cast<std::size_t>(9 + row)] = place.Value(row + 1, 4);
  }
  return numbers;
}

std::string entry_of(const Label& label) {
  TCollection_AsciiString entry;
  TDF_Tool::Entry(label, entry);
  return entry.ToCString();
}

/// Walks the assembly, and writes what it meets.
class SceneOfStep {
 public:
  SceneOfStep(std::string source, double tessellation) : source_(std::move(source)), tessellation_(tessellation) {}

  void add_all(const Handle(XCAFDoc_ShapeTool) & shapes) {
    TDF_LabelSequence roots;
    shapes->GetFreeShapes(roots);
    for (int i = 1; i <= roots.Length(); ++i) {
      const Label& root = roots.Value(i);
      const std::string name = name_of(root);
      // The name of the only product is that of the file: it tells nothing in front of each part.
      const bool is_told = roots.Length() > 1 || !XCAFDoc_ShapeTool::IsAssembly(root);
      add(root, is_told ? name.empty() ? "part" : name : "", "", std::nullopt);
    }
    if (objects_.empty()) throw std::runtime_error("there is no shape with a surface in it; export it with its solids");
  }

  [[nodiscard]] Json json() const {
    return {{"format", "toccata-scene"}, {"version", 1},        {"unit", "mm"},
            {"frames", frames_},         {"objects", objects_}, {"meshes", meshes_}};
  }

  [[nodiscard]] std::vector<std::string> notes() const {
    std::vector<std::string> notes{fmt::format(
        "{} of {}, curved faces as triangles within {:g} mm of them (--tessellation): what overlaps or is apart by "
        "less than twice that may be otherwise in the file",
        objects_.size() == 1 ? "1 part" : fmt::format("{} parts", objects_.size()),
        meshes_.size() == 1 ? "1 shape" : fmt::format("{} shapes", meshes_.size()), tessellation_)};
    if (faces_without_ > 0)
      notes.push_back(fmt::format("{} could not be meshed, and {} left out: the parts are open there",
                                  faces_without_ == 1 ? "1 face" : fmt::format("{} faces", faces_without_),
                                  faces_without_ == 1 ? "is" : "are"));
    return notes;
  }

 private:
  /// `path` is what a part is called: the names from the assembly down.
  void add(const Label& label, const std::string& path, const std::string& parent,
           const std::optional<TopLoc_Location>& location) {
    constexpr std::size_t deepest = 200, most_parts = 1'000'000;
    if (++depth_ > deepest || frames_.size() + objects_.size() > most_parts)
      throw std::runtime_error("its assembly is nested so deep, or so often, that it has no end");
    if (XCAFDoc_ShapeTool::IsAssembly(label))
      add_assembly(label, path, parent, location);
    else
      add_part(label, path, parent, location);
    --depth_;
  }

  void add_assembly(const Label& label, const std::string& path, const std::string& parent,
                    const std::optional<TopLoc_Location>& location) {
    std::string frame = parent;
    if (!path.empty()) {
      frame = names_.take(path + "/");
      frames_.push_back(placed(frame, parent, location));
    }
    TDF_LabelSequence components;
    XCAFDoc_ShapeTool::GetComponents(label, components);
    for (int i = 1; i <= components.Length(); ++i) {
      const Label& component = components.Value(i);
      Label product;
      if (!XCAFDoc_ShapeTool::GetReferredShape(component, product)) product = component;
      std::string name = name_of(component);
      if (name.empty() || name == "=>") name = name_of(product);
      if (name.empty()) name = "part";
      add(product, path.empty() ? name : path + "/" + name, frame, XCAFDoc_ShapeTool::GetLocation(component));
    }
  }

  void add_part(const Label& label, const std::string& path, const std::string& parent,
                const std::optional<TopLoc_Location>& location) {
    const std::string mesh = mesh_of(label, path);
    if (mesh.empty()) return;
    Json object = placed(names_.take(path), parent, location);
    object["mesh"] = mesh;
    object["source"] = source_;
    objects_.push_back(std::move(object));
  }

  static Json placed(const std::string& name, const std::string& parent,
                     const std::optional<TopLoc_Location>& location) {
    Json json = {{"name", name}};
    if (!parent.empty()) json["parent"] = parent;
    if (location && !location->IsIdentity()) json["pose"] = numbers_of(*location);
    return json;
  }

  /// The name of the product's mesh, which is made when it is first asked for; empty where it has no surface.
  std::string mesh_of(const Label& label, const std::string& path) {
    const auto [found, is_new] = mesh_of_label_.try_emplace(entry_of(label));
    if (!is_new) return found->second;
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (shape.IsNull()) return {};
    constexpr double turn = 0.35;  // radians from one chord to the next: coarse circles would look broken
    BRepMesh_IncrementalMesh(shape, tessellation_, Standard_False, turn, Standard_False);
    Mesh mesh;
    std::uint32_t number = 0;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
      add_face(mesh, TopoDS::Face(faces.Current()), number++);
    faces_without_ += mesh.faces_without;
    if (mesh.triangles.empty()) return {};
    found->second = fmt::format("{} ({})", name_of(label).empty() ? path : name_of(label), found->first);
    meshes_[found->second] = {{"vertices", base64_of(mesh.vertices)},
                              {"triangles", base64_of(mesh.triangles)},
                              {"faces", base64_of(mesh.faces)}};
    return found->second;
  }

  std::string source_;
  double tessellation_;
  std::size_t depth_ = 0, faces_without_ = 0;
  Json frames_ = Json::array(), objects_ = Json::array(), meshes_ = Json::object();
  std::map<std::string, std::string> mesh_of_label_;
  PartNames names_;
};

/// In millimetres, in which Open CASCADE has everything.
double length_of(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  static const std::map<std::string_view, double> units = {{"", 1},     {"mm", 1},    {"cm", 10},
                                                           {"m", 1000}, {"in", 25.4}, {"ft", 304.8}};
  if (error != std::errc() || !(number > 0) || !std::isfinite(number) || !units.contains(unit))
    throw std::runtime_error(fmt::format("--tessellation {} is no length above 0: write 0.1mm, say", text));
  return number * units.at(unit);
}

struct Arguments {
  std::string file, scene;
  double tessellation = 0.1;
};

Arguments arguments_of(const std::vector<std::string>& words) {
  if (words.size() != 2 && !(words.size() == 4 && words[2] == "--tessellation"))
    throw std::runtime_error("usage: toccata-read-step FILE.step SCENE.json [--tessellation LENGTH]");
  Arguments arguments{words[0], words[1]};
  if (words.size() == 4) arguments.tessellation = length_of(words[3]);
  return arguments;
}

/// Says it where the file is in another unit than the scene.
void tell_unit(STEPCAFControl_Reader& reader) {
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
  for (int i = 1; i <= lengths.Length(); ++i)
    if (const std::string unit = lengths.Value(i).ToCString(); unit != "millimetre" && unit != "MILLIMETRE")
      fmt::print("its unit is the {}; here it is in millimetres\n", unit);
}

using Product = Handle(StepBasic_ProductDefinition);

std::string name_of(const Product& product) {
  const auto formation = product->Formation();
  const auto named = formation.IsNull() ? nullptr : formation->OfProduct();
  return named.IsNull() || named->Name().IsNull() ? "without a name" : named->Name()->ToCString();
}

/// Which products an assembly holds, in the order of the file.
using ProductTree = std::map<Product, std::vector<Product>>;

ProductTree products_of(STEPCAFControl_Reader& reader) {
  ProductTree parts;
  const Handle(Interface_InterfaceModel) model = reader.ChangeReader().WS()->Model();
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto use = Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Value(i));
    if (use.IsNull() || use->RelatingProductDefinition().IsNull() || use->RelatedProductDefinition().IsNull()) continue;
    parts[use->RelatingProductDefinition()].push_back(use->RelatedProductDefinition());
  }
  return parts;
}

/// Depth first; `above` are the assemblies that hold this one, `done` those below which there is no circle.
void require_an_end(const ProductTree& parts, const Product& product, std::set<Product>& above,
                    std::set<Product>& done) {
  if (done.contains(product)) return;
  if (!above.insert(product).second)
    throw std::runtime_error(
        fmt::format("its assembly '{}' is a part of itself, so that it has no end; export it again", name_of(product)));
  if (const auto held = parts.find(product); held != parts.end())
    for (const Product& part : held->second) require_an_end(parts, part, above, done);
  above.erase(product);
  done.insert(product);
}

/// Open CASCADE leaves out what hangs on an assembly within itself, and says nothing.
void require_an_end(STEPCAFControl_Reader& reader) {
  const ProductTree parts = products_of(reader);
  std::set<Product> above, done;
  for (const auto& [product, held] : parts) require_an_end(parts, product, above, done);
}

/// Entities that are not as the standard says: what they describe may be missing.
std::size_t broken_entities(STEPCAFControl_Reader& reader) {
  std::size_t count = 0;
  Interface_CheckIterator checks = reader.ChangeReader().WS()->ModelCheckList(Standard_True);
  for (checks.Start(); checks.More(); checks.Next())
    if (checks.Value()->NbFails() > 0) ++count;
  return count;
}

void convert(const Arguments& arguments) {
  for (Message_SequenceOfPrinters& printers = Message::DefaultMessenger()->ChangePrinters(); !printers.IsEmpty();)
    printers.Remove(1);
  STEPCAFControl_Reader reader;
  reader.SetNameMode(Standard_True);
  if (reader.ReadFile(arguments.file.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("this is no whole STEP file (ISO 10303-21); export it again");
  require_an_end(reader);
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  if (!reader.Transfer(document)) throw std::runtime_error("nothing in it could be read as a product; export it again");
  SceneOfStep scene(arguments.file, arguments.tessellation);
  scene.add_all(XCAFDoc_DocumentTool::ShapeTool(document->Main()));
  std::ofstream out(arguments.scene, std::ios::binary);
  out << scene.json().dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
  if (!out.flush()) throw std::runtime_error(arguments.scene + " cannot be written; is the disk full?");
  tell_unit(reader);
  if (const std::size_t broken = broken_entities(reader); broken > 0)
    fmt::print("{} in it {} damaged: what {} may be missing or another\n",
               broken == 1 ? "1 entity" : fmt::format("{} entities", broken), broken == 1 ? "is" : "are",
               broken == 1 ? "it describes" : "they describe");
  for (const std::string& note : scene.notes()) fmt::print("{}\n", note);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    convert(arguments_of({argv + 1, argv + argc}));
    return 0;
  } catch (const Standard_Failure& failure) {
    fmt::print(stderr, "Open CASCADE could not read it: {}; export it again\n", failure.GetMessageString());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
