#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "calculix/bed_springs.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "part/material.h"

namespace clevis::calculix {

/// The elements that clevis exports: 20-node hexahedra with full or reduced
/// integration; tetrahedra always become C3D10.
enum class Hexahedron { kFull, kReduced };

/// A face of an element in CalculiX's numbering: face 1 is "S1".
struct ElementFace {
  int element{}, face{};
};

/// A named surface of the part.
struct Group {
  std::string name;
  std::vector<int> nodes;
  std::vector<ElementFace> faces;
};

/// A component of a node's displacement that is held at zero.
struct Support {
  int node{}, component{};
};

/// A linear static model as CalculiX takes it; SI, all indices from 0.
struct Model {
  std::string name;     ///< of the part
  std::string element;  ///< "C3D20", "C3D20R", "C3D10"
  part::Material material;
  Eigen::Matrix3Xd nodes;                  ///< [m]
  std::vector<std::vector<int>> elements;  ///< in CalculiX's node order
  std::vector<Group> groups;
  std::vector<Support> supports;
  std::vector<Spring> springs;      ///< of elastic beds
  Eigen::MatrixXd loads;            ///< 3 × nodes rows, a column per step [N]
  std::vector<std::string> labels;  ///< of the steps: instant or case

  int dofs() const { return static_cast<int>(3 * nodes.cols()); }
};

/// The part as CalculiX sees it: its hexahedra with the geometry of 20 nodes
/// (mid nodes on the exact surfaces), tetrahedra with 10. Loads are clevis's
/// own, integrated consistently with the elements' shape functions, body loads
/// included; a free part is put in balance. Elastic beds become springs of the
/// same stiffness. Rigid modes that nothing holds and no load drives are held
/// at determinate components.
/// Source: docs/theory.md, "Export to CalculiX".
/// @throws Error F001 if a load drives a free mode; M003, L002 of groups.
Model make_model(const elasticity::ElasticProblem<3>& problem,
                 Hexahedron hexahedron);

/// ½ fᵀu of a step [J].
/// @param displacement  3 × nodes [m].
double strain_energy(const Model& model, int step,
                     const Eigen::Matrix3Xd& displacement);

}  // namespace clevis::calculix
