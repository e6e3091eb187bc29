// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a CAD file with a cylinder "torso" and a sphere "head"; in STEP with an assembly as well.
//
//   write_cad_sample FILE.step|FILE.igs MM|INCH|M
//
// Torso: radius 40 mm, from z = 0 to 200 mm. Head: radius 30 mm about (0, 0, 220) mm. STEP only: product "lump" of an
// assembly, as large as the head, about (0, 100, 0) mm.
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Controller.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <string>

int main(int count, char** arguments)
{
  if (count != 3)
    return 2;
  const std::string file = arguments[1];
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());

  TDataStd_Name::Set(shapes->AddShape(BRepPrimAPI_MakeCylinder(40, 200).Shape(), false), "torso");
  TDataStd_Name::Set(shapes->AddShape(BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 220), 30).Shape(), false), "head");
  const bool step = file.find(".st") != std::string::npos;
  if (step) {
    const TDF_Label ball = shapes->AddShape(BRepPrimAPI_MakeSphere(30).Shape(), false);
    TDataStd_Name::Set(ball, "lump");
    const TDF_Label assembly = shapes->NewShape();
    TDataStd_Name::Set(assembly, "assembly");
    gp_Trsf move, turn;
    move.SetTranslation(gp_Vec(0, 100, 0));
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 0.5);
    shapes->AddComponent(assembly, ball, TopLoc_Location(move * turn));
    shapes->UpdateAssemblies();
    STEPControl_Controller::Init();
    Interface_Static::SetCVal("write.step.unit", arguments[2]);
    STEPCAFControl_Writer writer;
    writer.SetNameMode(true);
    return writer.Transfer(document, STEPControl_AsIs) && writer.Write(file.c_str()) == IFSelect_RetDone ? 0
                                                                                                         : 1;
  }
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("write.iges.unit", arguments[2]);
  IGESCAFControl_Writer writer;
  writer.SetNameMode(true);
  return writer.Transfer(document) && writer.Write(file.c_str()) ? 0 : 1;
}
