#include "mesher/check_shape.h"

#include <BOPAlgo_ArgumentAnalyzer.hxx>
#include <BOPAlgo_CheckResult.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListIteratorOfListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesher {
namespace {

[[noreturn]] void refuse(const std::string& file, const std::string& problem,
                         const char* remedy) {
  throw Error("M016", file, problem, remedy);
}

constexpr const char* kRepair =
    "Repair the solid in the CAD system and export it again.";

/// Middle of a shape's box, as text.
std::string where(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  if (box.IsVoid()) return "at an unknown place";
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) mm", (low.X() + high.X()) / 2,
                     (low.Y() + high.Y()) / 2, (low.Z() + high.Z()) / 2);
}

int count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found.Extent();
}

/// The first faces, shells or edges that belong to no solid or shell.
void require_no_loose_faces(const TopoDS_Shape& shape,
                            const std::string& file) {
  const TopExp_Explorer loose(shape, TopAbs_FACE, TopAbs_SOLID);
  if (!loose.More()) return;
  refuse(file,
         fmt::format("beside its solid the file has surfaces without volume, "
                     "the first {}",
                     where(loose.Current())),
         "Delete them, or hide them before the export.");
}

TopoDS_Solid only_solid(const TopoDS_Shape& shape, const std::string& file) {
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  if (solids.Extent() > 1) {
    refuse(file,
           fmt::format("the file has {} solids, the second {}", solids.Extent(),
                       where(solids(2))),
           "Join them to one solid, or export each part as a file of its own.");
  }
  if (solids.IsEmpty()) {
    refuse(file,
           fmt::format("the file has no solid, only {} faces in {} shells",
                       count(shape, TopAbs_FACE), count(shape, TopAbs_SHELL)),
           "Close the surfaces to a solid in the CAD system; shells are not "
           "checked.");
  }
  require_no_loose_faces(shape, file);
  return TopoDS::Solid(solids(1));
}

/// Every edge has a face on each side: the shells are closed and the part does
/// not touch itself along an edge.
void require_closed(const TopoDS_Solid& solid, const std::string& file) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(faces_of.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    const int sides = faces_of(i).Extent();
    if (sides == 2) continue;
    refuse(file,
           sides < 2 ? fmt::format("the surface is open along an edge {}",
                                   where(edge))
                     : fmt::format("{} faces meet along one edge {}: the part "
                                   "touches itself",
                                   sides, where(edge)),
           kRepair);
  }
}

/// OpenCASCADE's name for what is wrong.
std::string text_of(BRepCheck_Status status) {
  if (status == BRepCheck_SelfIntersectingWire) {
    return "has an outline that crosses itself";
  }
  if (status == BRepCheck_IntersectingWires) return "has outlines that cross";
  if (status == BRepCheck_NotClosed) return "is not closed";
  if (status == BRepCheck_UnorientableShape) return "has no outside";
  return fmt::format("is not valid (BRepCheck_Status {})", int(status));
}

void require_valid(const TopoDS_Solid& solid, const std::string& file) {
  const BRepCheck_Analyzer analysis(solid);
  if (analysis.IsValid()) return;
  for (const TopAbs_ShapeEnum kind :
       {TopAbs_FACE, TopAbs_EDGE, TopAbs_SHELL, TopAbs_SOLID}) {
    TopTools_IndexedMapOfShape shapes;
    TopExp::MapShapes(solid, kind, shapes);
    for (int i = 1; i <= shapes.Extent(); ++i) {
      const auto result = analysis.Result(shapes(i));
      if (result.IsNull()) continue;
      for (BRepCheck_ListIteratorOfListOfStatus status(result->Status());
           status.More(); status.Next()) {
        if (status.Value() == BRepCheck_NoError) continue;
        constexpr const char* kNames[] = {"",     "", "solid", "shell",
                                          "face", "", "edge"};
        refuse(file,
               fmt::format("{} {} {} {}", kNames[kind], i, where(shapes(i)),
                           text_of(status.Value())),
               kRepair);
      }
    }
  }
  refuse(file, "OpenCASCADE finds the solid not valid", kRepair);
}

void require_no_cuts(const TopoDS_Solid& solid, const std::string& file) {
  BOPAlgo_ArgumentAnalyzer analyzer;
  analyzer.SetShape1(solid);
  analyzer.SelfInterMode() = true;
  analyzer.StopOnFirstFaulty() = true;
  analyzer.Perform();
  if (!analyzer.HasFaulty()) return;
  for (const BOPAlgo_CheckResult& result : analyzer.GetCheckResult()) {
    if (result.GetCheckStatus() != BOPAlgo_SelfIntersect) continue;
    const auto& faulty = result.GetFaultyShapes1();
    refuse(file,
           fmt::format("the surface cuts itself {}",
                       faulty.IsEmpty() ? "" : where(faulty.First())),
           kRepair);
  }
}

}  // namespace

TopoDS_Solid one_sound_solid(const TopoDS_Shape& shape,
                             const std::string& file) {
  TopoDS_Solid solid = only_solid(shape, file);
  require_closed(solid, file);
  require_valid(solid, file);
  require_no_cuts(solid, file);
  BRepLib::OrientClosedSolid(solid);
  GProp_GProps volume;
  BRepGProp::VolumeProperties(solid, volume);
  if (!(volume.Mass() > 0.0)) {
    refuse(file,
           fmt::format("the solid has a volume of {:.3g} mm^3", volume.Mass()),
           kRepair);
  }
  return solid;
}

}  // namespace clevis::mesher
