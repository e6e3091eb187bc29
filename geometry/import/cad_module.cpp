// SPDX-License-Identifier: GPL-3.0-or-later
// STEP and IGES into named triangles, by OpenCASCADE: solids of an assembly with the names of their products, faces
// that hang together by their edges, and triangles within a given distance of them.
#include "geometry/import/cad_module.h"

#include "core/error.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace birdstrike {

namespace {

constexpr double occt_unit = 1e-3;    // OpenCASCADE turns every file into millimetres [m]
constexpr double largest_turn = 0.3;  // between the normals of neighbouring triangles [rad]
constexpr double sewing_share = 1e-5; // gap between faces without common edges, as a share of the diagonal

//! "millimetre", "INCH", "metre", as files spell it; millimetres where they do not say. [m]
double length_of(std::string unit)
{
  std::transform(unit.begin(), unit.end(), unit.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  const auto has = [&](const char* word) { return unit.find(word) != std::string::npos; };
  return has("milli") || unit == "mm"                  ? 1e-3
         : has("centi") || unit == "cm"                ? 1e-2
         : has("micro") || unit == "um"                ? 1e-6
         : has("inch") || unit == "in"                 ? 0.0254
         : has("foot") || unit == "ft"                 ? 0.3048
         : has("metre") || has("meter") || unit == "m" ? 1.0
                                                       : 1e-3;
}

class CadReader
{
public:
  CadReader(const std::filesystem::path& file, double coarseness, RawScene& scene)
      : file_(file), text_("mesh file '" + file.string() + "'"), coarseness_(coarseness), scene_(scene)
  {
  }

  void read()
  {
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
    std::string extension = file_.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".iges" || extension == ".igs")
      load_iges(document);
    else
      load_step(document);
    scene_.unit_source = "its header";

    shapes_ = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    Bnd_Box box;
    for (const TDF_Label& root : roots)
      BRepBndLib::Add(XCAFDoc_ShapeTool::GetShape(root), box);
    if (box.IsVoid())
      throw InputError(text_ + " holds no surface; export solids or shells");
    diagonal_ = std::sqrt(box.SquareExtent());
    for (const TDF_Label& root : roots)
      visit(root, TopLoc_Location(), "");
  }

private:
  [[noreturn]] void fail() const
  {
    throw InputError(text_ +
                     " cannot be read; it may be cut short or not what its extension says: export it again");
  }

  void load_step(Handle(TDocStd_Document) & document)
  {
    STEPCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(false);
    if (reader.ReadFile(file_.c_str()) != IFSelect_RetDone)
      fail();
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.ChangeReader().FileUnits(lengths, angles, solid_angles);
    scene_.unit = length_of(lengths.IsEmpty() ? "" : lengths.First().ToCString());
    if (!reader.Transfer(document))
      fail();
  }

  void load_iges(Handle(TDocStd_Document) & document)
  {
    IGESCAFControl_Reader reader;
    reader.SetNameMode(true);
    reader.SetColorMode(false);
    if (reader.ReadFile(file_.c_str()) != IFSelect_RetDone)
      fail();
    const Handle(IGESData_IGESModel) model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
    if (model.IsNull())
      fail();
    scene_.unit = occt_unit * model->GlobalSection().UnitValue(); // given in millimetres
    if (!(scene_.unit > 0) || !reader.Transfer(document))
      fail();
  }

  static std::string name_of(const TDF_Label& label)
  {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name))
      return {};
    const TCollection_ExtendedString& wide = name->Get();
    std::string text(std::size_t(wide.LengthOfCString()) + 1, '\0');
    Standard_PCharacter bytes = text.data();
    wide.ToUTF8CString(bytes);
    text.resize(text.find('\0'));
    // What OpenCASCADE and its writers call things that have no name.
    for (const char* invented :
         {"NAUO", "=>[", "SOLID", "SHELL", "COMPOUND", "FACE", "ASSEMBLY", "Open CASCADE"})
      if (text.rfind(invented, 0) == 0)
        return {};
    return text;
  }

  void visit(const TDF_Label& label, const TopLoc_Location& above, const std::string& name_above)
  {
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      TDF_Label product;
      if (!XCAFDoc_ShapeTool::GetReferredShape(label, product))
        return;
      const std::string name = name_of(label);
      visit(product, above * XCAFDoc_ShapeTool::GetLocation(label), name.empty() ? name_above : name);
      return;
    }
    const std::string own = name_of(label), name = own.empty() ? name_above : own;
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      for (const TDF_Label& component : components)
        visit(component, above, name);
      return;
    }
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    if (!shape.IsNull())
      add_bodies(label, shape, above, name);
  }

  void add_bodies(const TDF_Label& label, const TopoDS_Shape& shape, const TopLoc_Location& place,
                  const std::string& name)
  {
    const auto add_all = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum within) {
      for (TopExp_Explorer at(shape, kind, within); at.More(); at.Next()) {
        TDF_Label own;
        const bool labelled = shapes_->FindSubShape(label, at.Current(), own);
        const std::string own_name = labelled ? name_of(own) : std::string();
        add(at.Current(), place, own_name.empty() ? name : own_name);
      }
    };
    add_all(TopAbs_SOLID, TopAbs_SHAPE);
    add_all(TopAbs_SHELL, TopAbs_SOLID);

    // IGES knows faces only: neighbours get common edges, or their triangles would not fit.
    BRepBuilderAPI_Sewing sewing(sewing_share * diagonal_);
    bool any = false;
    for (TopExp_Explorer at(shape, TopAbs_FACE, TopAbs_SHELL); at.More(); at.Next()) {
      sewing.Add(at.Current());
      any = true;
    }
    if (any) {
      sewing.Perform();
      if (!sewing.SewedShape().IsNull())
        add(sewing.SewedShape(), place, name);
    }
  }

  void add(const TopoDS_Shape& body, const TopLoc_Location& place, const std::string& name)
  {
    BRepMesh_IncrementalMesh mesher(body, coarseness_ * diagonal_, false, largest_turn, false);
    const auto [at, is_new] = row_.try_emplace(name, scene_.parts.size());
    if (is_new)
      scene_.parts.push_back({name, {}, {}});
    for (TopExp_Explorer face(body, TopAbs_FACE); face.More(); face.Next())
      add_face(TopoDS::Face(face.Current()), place, scene_.parts[at->second]);
  }

  void add_face(const TopoDS_Face& face, const TopLoc_Location& place, SurfacePart& part) const
  {
    TopLoc_Location within;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, within);
    if (triangles.IsNull())
      throw InputError(
          text_ + " has a face that cannot be made of triangles; heal the model in CAD and export it again");
    const gp_Trsf move = (place * within).Transformation();
    const bool flipped = (face.Orientation() == TopAbs_REVERSED) != move.IsNegative();
    if (part.points.size() + std::size_t(triangles->NbNodes()) > 3 * largest_part)
      throw InputError(text_ + " has more than 700 million triangles");
    const int first = int(part.points.size()) - 1; // nodes count from one
    const double scale = occt_unit / scene_.unit;
    for (int i = 1; i <= triangles->NbNodes(); ++i) {
      const gp_Pnt p = triangles->Node(i).Transformed(move);
      part.points.emplace_back(scale * p.X(), scale * p.Y(), scale * p.Z());
    }
    for (int i = 1; i <= triangles->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      triangles->Triangle(i).Get(a, b, c);
      part.triangles.push_back({first + a, first + (flipped ? c : b), first + (flipped ? b : c)});
    }
  }

  const std::filesystem::path& file_;
  std::string text_;
  double coarseness_, diagonal_ = 0; // [-], [mm]
  RawScene& scene_;
  Handle(XCAFDoc_ShapeTool) shapes_;
  std::unordered_map<std::string, std::size_t> row_;
};

} // namespace

} // namespace birdstrike

extern "C" void birdstrike_read_cad_file(const std::filesystem::path& file, double coarseness,
                                         birdstrike::RawScene& scene)
{
  try {
    birdstrike::CadReader(file, coarseness, scene).read();
  } catch (const Standard_Failure& failure) {
    throw birdstrike::InputError("mesh file '" + file.string() + "' cannot be read (" +
                                 failure.GetMessageString() +
                                 "); it may be cut short or damaged: export it again");
  }
}
