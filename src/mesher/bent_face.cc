#include "mesher/bent_face.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Geom_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>

namespace clevis::mesher {
namespace {

constexpr int kFewest = 7;    // places along a parameter
constexpr int kMost = 200;    // likewise
constexpr int kPerSpan = 5;   // of a cubic
constexpr int kHalvings = 8;  // between two places
constexpr double kFar = 1e100;

bool is_spline(GeomAbs_CurveType type) {
  return type == GeomAbs_BSplineCurve || type == GeomAbs_BezierCurve;
}

/// Of the polynomials along u or v; 0: a surface has none there.
int degree_along(const BRepAdaptor_Surface& surface, bool along_u) {
  switch (surface.GetType()) {
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface:
      return along_u ? surface.UDegree() : surface.VDegree();
    case GeomAbs_SurfaceOfExtrusion:
    case GeomAbs_SurfaceOfRevolution: {
      const bool has_curve =
          along_u == (surface.GetType() == GeomAbs_SurfaceOfExtrusion);
      const auto curve = surface.BasisCurve();
      return has_curve && is_spline(curve->GetType()) ? curve->Degree() : 0;
    }
    default:
      return 0;
  }
}

/// Parameters to look at: of each span some, of all not too many.
std::vector<double> parameters(const BRepAdaptor_Surface& surface, bool along_u,
                               double from, double to) {
  const int spans = along_u ? surface.NbUIntervals(GeomAbs_CN)
                            : surface.NbVIntervals(GeomAbs_CN);
  TColStd_Array1OfReal ends(1, spans + 1);
  along_u ? surface.UIntervals(ends, GeomAbs_CN)
          : surface.VIntervals(ends, GeomAbs_CN);
  const int wanted = std::max(kPerSpan, 2 * degree_along(surface, along_u) - 1);
  const int per_span = std::clamp(wanted, 1, std::max(1, kMost / spans));
  std::vector<double> all;
  for (int s = 1; s <= spans; ++s) {
    for (int k = 0; k < per_span; ++k) {
      all.push_back(std::lerp(ends(s), ends(s + 1), double(k) / per_span));
    }
  }
  all.push_back(ends(spans + 1));
  std::erase_if(all, [&](double t) {
    return t < from || t > to;
  });
  for (int k = 0; k < kFewest; ++k) {
    all.push_back(std::lerp(from, to, double(k) / (kFewest - 1)));
  }
  std::ranges::sort(all);
  const double same = 1e-9 * (to - from);
  all.erase(std::unique(all.begin(), all.end(),
                        [&](double a, double b) {
                          return b - a <= same;
                        }),
            all.end());
  return all;
}

class FaceLook {
 public:
  FaceLook(const TopoDS_Face& face, double turn, double largest)
      : surface_(face), outline_(face, 1e-7), turn_(turn), largest_(largest) {
    double u0{}, u1{}, v0{}, v1{};
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    const auto us = parameters(surface_, true, u0, u1);
    const auto vs = parameters(surface_, false, v0, v1);
    std::vector<Look> before;
    for (const double u : us) {
      std::vector<Look> row;
      for (const double v : vs) row.push_back(look(u, v));
      for (const Look& one : row) take(one);
      for (std::size_t k = 1; k < row.size(); ++k) {
        fill(row[k - 1], row[k], kHalvings);
      }
      for (std::size_t k = 0; k < before.size(); ++k) {
        fill(before[k], row[k], kHalvings);
      }
      before = std::move(row);
    }
    found_.coarsest = std::min(largest_, coarsest_ > 0.0 ? coarsest_ : kFar);
  }

  BendSizes found() { return std::move(found_); }

 private:
  struct Look {
    double u{}, v{};
    /// Nothing: outside of the face, or the surface has no normal there.
    std::optional<BendSize> bend;
  };

  Look look(double u, double v) {
    Look here{u, v, std::nullopt};
    if (outline_.Perform(gp_Pnt2d(u, v)) == TopAbs_OUT) return here;
    BRepLProp_SLProps local(surface_, u, v, 2, 1e-9);
    if (!local.IsNormalDefined()) return here;
    double bend = 0.0;
    if (local.IsCurvatureDefined()) {
      bend = std::max(std::abs(local.MaxCurvature()),
                      std::abs(local.MinCurvature()));
    }
    here.bend = {local.Value(), bend > 1e-9 ? turn_ / bend : kFar};
    return here;
  }

  void take(const Look& look) {
    if (!look.bend) return;
    coarsest_ = std::max(coarsest_, look.bend->size);
    if (look.bend->size < largest_) found_.places.push_back(*look.bend);
  }

  /// Between two places, as long as a cell could step over them.
  void fill(const Look& a, const Look& b, int depth) {
    if (depth == 0 || !a.bend || !b.bend) return;
    const double size = std::max(a.bend->size, b.bend->size);
    if (!(size < largest_) || a.bend->at.Distance(b.bend->at) <= size) return;
    const Look middle = look(0.5 * (a.u + b.u), 0.5 * (a.v + b.v));
    take(middle);
    fill(a, middle, depth - 1);
    fill(middle, b, depth - 1);
  }

  BRepAdaptor_Surface surface_;
  BRepTopAdaptor_FClass2d outline_;
  double turn_, largest_;
  double coarsest_{};
  BendSizes found_;
};

}  // namespace

BendSizes bend_sizes(const TopoDS_Face& face, double turn, double largest) {
  return FaceLook(face, turn, largest).found();
}

}  // namespace clevis::mesher
