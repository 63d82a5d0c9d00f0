#include "elasticity/buckling/energy_coordinates.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/system/processor_share.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/foundation.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/direct/memory_forecast.h"
#include "elasticity/mirror_symmetry/folding.h"
#include "elasticity/mirror_symmetry/parity_classes.h"
#include "elasticity/plate/layered_equations.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The coordinates of one class among all.
struct ClassFactor {
  EquationNumbers numbers;
  FrontalCholesky factor;
  Index first;

  MatrixXd terms(const MatrixXd& all) const {
    return extend_rows(factor.solve_upper(all.middleRows(first, numbers.count)),
                       numbers);
  }
  void take(const MatrixXd& loads, MatrixXd& all) const {
    all.middleRows(first, numbers.count) =
        factor.solve_lower(restrict_rows(loads, numbers));
  }
};

Index size_of(const std::vector<ClassFactor>& classes) {
  return classes.empty() ? 0
                         : classes.back().first + classes.back().numbers.count;
}

class SolidCoordinates : public EnergyCoordinates {
 public:
  SolidCoordinates(const Discretization<3>& part,
                   const part::Material& material, const PartSupports& hold,
                   const std::string& name)
      : dofs_(part.dofs()) {
    const std::string place = "part " + name;
    const auto positions = node_positions(part);
    FoundationStiffness<3> bed(part, hold.foundations, name);
    const bool is_free = hold.fixed.empty() && bed.empty();
    const std::vector<int> fixed =
        is_free ? std::vector<int>{}
                : fixed_supports(part, positions, hold.fixed, place, &bed);
    folding_ = fold<3>(part, positions,
                       bed.empty() ? common_mirrors<3>(part, positions, fixed)
                                   : std::vector<Mirror>{});
    require_memory(1.1 * folding_.classes() * folding_.factor_bytes(),
                   part.dofs(), usable_memory(), place);
    auto stiffness = assemble_stiffness(folding_.part, material, place);
    bed.renumber(folding_.node);
    bed.add_to(stiffness);
    const auto folded_positions = node_positions(folding_.part);
    for (unsigned parity = 0; parity < folding_.classes(); ++parity) {
      ParityClass parity_class;
      parity_class.parity = parity;
      if (is_free || !fixed.empty()) {
        elasticity::hold<3>(folding_, fixed, folded_positions, parity_class);
      }
      auto numbers = number_equations(folding_.part.dofs(), parity_class.held);
      FrontalCholesky factor(
          free_rows(stiffness, numbers),
          front_tree(folding_.dissection, 3, numbers.equation), place,
          own_processors());
      const Index first = size_of(classes_);
      classes_.push_back({std::move(numbers), std::move(factor), first});
    }
  }

  Index size() const override { return size_of(classes_); }

  // The whole part has the energy of the folded one as often as it has images.
  MatrixXd displacements(const MatrixXd& y) const override {
    const double share = 1.0 / std::sqrt(folding_.classes());
    MatrixXd u = MatrixXd::Zero(dofs_, y.cols());
    for (unsigned parity = 0; parity < folding_.classes(); ++parity) {
      add_unfolded<3>(folding_, parity, share * classes_[parity].terms(y), u);
    }
    return u;
  }

  MatrixXd of_loads(const MatrixXd& loads) const override {
    const double images = std::sqrt(folding_.classes());
    MatrixXd y(size(), loads.cols());
    for (unsigned parity = 0; parity < folding_.classes(); ++parity) {
      classes_[parity].take(images * loads_of_class<3>(folding_, parity, loads),
                            y);
    }
    return y;
  }

 private:
  Index dofs_;
  Folding<3> folding_;
  std::vector<ClassFactor> classes_;  ///< by their parity
};

class PlateCoordinates : public EnergyCoordinates {
 public:
  PlateCoordinates(const Discretization<2>& plane,
                   const Discretization<3>& layer,
                   const part::Material& material, const part::Supports& fixed,
                   const std::string& name)
      : dofs_(layer.dofs()) {
    const std::string place = "part " + name;
    const int terms = (layer.thickness_degree + 1) / 2;
    const double unknowns = 3.0 * terms;
    const auto dissection = dissect(plane);
    require_memory(2.0 * 8.0 * dissection.entries * unknowns * unknowns,
                   static_cast<double>(dofs_), usable_memory(), place);
    const auto integrals = plane_integrals(plane, place);
    const Plate plate{plane, layer, integrals, material, fixed, name};
    for (const Parity parity : {Parity::kStretching, Parity::kBending}) {
      const ThicknessReduction& reduction =
          reductions_.emplace_back(parity, terms);
      auto equations = layered_equations(plate, reduction);
      auto factor = factored(equations, dissection, reduction, place);
      const Index first = size_of(classes_);
      classes_.push_back(
          {std::move(equations.numbers), std::move(factor), first});
    }
  }

  Index size() const override { return size_of(classes_); }

  MatrixXd displacements(const MatrixXd& y) const override {
    MatrixXd u = MatrixXd::Zero(dofs_, y.cols());
    for (std::size_t k = 0; k < classes_.size(); ++k) {
      u += reductions_[k].expand(classes_[k].terms(y));
    }
    return u;
  }

  MatrixXd of_loads(const MatrixXd& loads) const override {
    MatrixXd y(size(), loads.cols());
    for (std::size_t k = 0; k < classes_.size(); ++k) {
      classes_[k].take(reductions_[k].reduce(loads), y);
    }
    return y;
  }

 private:
  Index dofs_;
  std::vector<ThicknessReduction> reductions_;
  std::vector<ClassFactor> classes_;  ///< of each reduction
};

}  // namespace

std::unique_ptr<EnergyCoordinates> solid_coordinates(
    const Discretization<3>& part, const part::Material& material,
    const PartSupports& hold, const std::string& name) {
  return std::make_unique<SolidCoordinates>(part, material, hold, name);
}

std::unique_ptr<EnergyCoordinates> plate_coordinates(
    const Discretization<2>& plane, const Discretization<3>& layer,
    const part::Material& material, const part::Supports& fixed,
    const std::string& name) {
  return std::make_unique<PlateCoordinates>(plane, layer, material, fixed,
                                            name);
}

}  // namespace clevis::elasticity
