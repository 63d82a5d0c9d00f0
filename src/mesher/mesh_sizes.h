#pragma once

#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Pnt.hxx>

#include "cad/exchange.h"

namespace clevis::mesher {

/// Size of cells where it is known; it grows with the distance.
struct SizeSource {
  gp_Pnt at;       ///< [mm]
  double size{};   ///< [mm]
  double reach{};  ///< from where on it grows [mm]
};

/// How large cells are to be over a solid: as the walls are thick and the
/// surfaces curved, growing slowly in between.
class MeshSizes {
 public:
  /// @param solid  in millimetres.
  MeshSizes(const TopoDS_Solid& solid, const cad::Request& request);

  /// @return the size wanted at a point [mm].
  double at(const gp_Pnt& point) const;
  /// @param face  its number. @return the largest size on it [mm].
  double on_face(int face) const {
    return on_face_[static_cast<std::size_t>(face) - 1];
  }
  double largest() const { return largest_; }

 private:
  void add_faces(const TopoDS_Solid& solid, double fineness,
                 const cad::Request& request);
  double add_bends(const TopoDS_Face& face, double turn);
  void thin_out();
  void refine(const TopoDS_Solid& solid, const cad::Request& request);

  double largest_{};  ///< [mm]
  std::vector<double> on_face_;
  std::vector<SizeSource> sources_;
};

}  // namespace clevis::mesher
