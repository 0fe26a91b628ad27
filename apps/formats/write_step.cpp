// Writes a STEP file for the tests: an assembly "machine" of two arms, each of a plate and two pins, one of them turned
// by a quarter about z; all pins are one product.
//
// usage: write_step FILE.step [UNIT]
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>

namespace {

TopLoc_Location moved(double x, double y, double z) {
  gp_Trsf place;
  place.SetTranslation(gp_Vec(x, y, z));
  return place;
}

TopLoc_Location turned_by_a_quarter() {
  gp_Trsf place;
  place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), std::acos(0.0));
  return place;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const TDF_Label pin = shapes->AddShape(BRepPrimAPI_MakeCylinder(5, 40).Shape(), Standard_False);
  const TDF_Label plate = shapes->AddShape(BRepPrimAPI_MakeBox(100, 50, 20).Shape(), Standard_False);
  const TDF_Label arm = shapes->NewShape(), machine = shapes->NewShape();
  TDataStd_Name::Set(pin, "pin");
  TDataStd_Name::Set(plate, "plate");
  TDataStd_Name::Set(arm, "arm");
  TDataStd_Name::Set(machine, "machine");
  TDataStd_Name::Set(shapes->AddComponent(arm, plate, TopLoc_Location()), "plate");
  TDataStd_Name::Set(shapes->AddComponent(arm, pin, moved(20, 25, -10)), "left pin");
  TDataStd_Name::Set(shapes->AddComponent(arm, pin, moved(80, 25, 30)), "right pin");
  TDataStd_Name::Set(shapes->AddComponent(machine, arm, TopLoc_Location()), "front");
  TDataStd_Name::Set(shapes->AddComponent(machine, arm, moved(0, 0, 500) * turned_by_a_quarter()), "back");
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  if (argc > 2) Interface_Static::SetCVal("write.step.unit", argv[2]);
  if (!writer.Transfer(document, STEPControl_AsIs)) return 2;
  return writer.Write(argv[1]) == IFSelect_RetDone ? 0 : 2;
}
