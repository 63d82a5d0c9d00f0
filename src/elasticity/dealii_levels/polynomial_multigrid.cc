#include "elasticity/dealii_levels/polynomial_multigrid.h"

#include <algorithm>
#include <cmath>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/multigrid/mg_coarse.h>
#include <deal.II/multigrid/mg_matrix.h>
#include <deal.II/multigrid/mg_smoother.h>
#include <deal.II/multigrid/mg_transfer_global_coarsening.h>
#include <deal.II/multigrid/multigrid.h>

#include "elasticity/dealii_space/level_degrees.h"

namespace clevis::elasticity {
namespace {

using Single = dealii::LinearAlgebra::distributed::Vector<float>;

/// A polynomial for the smoother, by the cells' aspect: stretched ones leave it
/// small eigenvalues that no coarser degree has. On cubes degree 4 takes least
/// time; on longer cells a higher degree takes as many products in fewer
/// cycles.
struct SmoothingPolynomial {
  explicit SmoothingPolynomial(double aspect)
      : degree(static_cast<unsigned>(
            std::lround(std::clamp(2.0 * aspect, 4.0, 20.0)))),
        range(1.5 * degree * degree) {}

  unsigned degree;
  double range;  ///< largest over smallest eigenvalue that it damps
};

template <int dim>
class Coarsest : public dealii::MGCoarseGridBase<Single> {
 public:
  explicit Coarsest(const CoarseSolver<dim>& solver) : solver_(solver) {}
  void operator()(unsigned, Single& x, const Single& b) const override {
    solver_.solve(x, b);
  }

 private:
  const CoarseSolver<dim>& solver_;
};

template <class Stiffness>
Single inverse_diagonal(const Stiffness& stiffness) {
  Single result = stiffness.diagonal();
  for (float& entry : result) entry = 1.0F / entry;
  return result;
}

}  // namespace

template <int dim>
struct PolynomialMultigrid<dim>::Levels {
  using Stiffness = StiffnessOperator<dim, float>;
  using Smoother =
      dealii::PreconditionChebyshev<Stiffness, Single,
                                    dealii::DiagonalMatrix<Single>>;
  using Transfer = dealii::MGTransferGlobalCoarsening<dim, Single>;

  std::vector<std::unique_ptr<DegreeSpace<dim>>> spaces;  // below the finest
  dealii::MGLevelObject<Stiffness> stiffness;
  dealii::MGLevelObject<dealii::MGTwoLevelTransfer<dim, Single>> steps;
  std::unique_ptr<Transfer> transfer;
  dealii::MGSmootherRelaxation<Stiffness, Smoother, Single> smoother;
  std::unique_ptr<CoarseSolver<dim>> solver;
  std::unique_ptr<Coarsest<dim>> coarsest;
  std::unique_ptr<dealii::mg::Matrix<Single>> matrix;
  std::unique_ptr<dealii::Multigrid<Single>> cycle;
  std::unique_ptr<dealii::PreconditionMG<dim, Single, Transfer>> whole;

  void smooth(unsigned top, const SmoothingPolynomial& polynomial);
};

template <int dim>
void PolynomialMultigrid<dim>::Levels::smooth(
    unsigned top, const SmoothingPolynomial& polynomial) {
  dealii::MGLevelObject<typename Smoother::AdditionalData> data(0, top);
  for (unsigned level = 0; level <= top; ++level) {
    auto inverse = std::make_shared<dealii::DiagonalMatrix<Single>>();
    if (level > 0) inverse->get_vector() = inverse_diagonal(stiffness[level]);
    data[level].preconditioner = inverse;
    data[level].smoothing_range = polynomial.range;
    data[level].degree = polynomial.degree;
    data[level].eig_cg_n_iterations = 15;
  }
  smoother.initialize(stiffness, data);
}

template <int dim>
PolynomialMultigrid<dim>::PolynomialMultigrid(const EnginePart& part,
                                              const DegreeSpace<dim>& finest)
    : levels_(std::make_unique<Levels>()) {
  Levels& l = *levels_;
  const auto degrees = level_degrees(finest.degree(), dim, part.nodes);
  const auto top = static_cast<unsigned>(degrees.size() - 1);
  std::vector<const DegreeSpace<dim>*> spaces(degrees.size(), &finest);
  std::vector<dealii::AffineConstraints<float>> held(degrees.size());
  l.stiffness.resize(0, top);
  l.steps.resize(0, top);
  for (unsigned level = 0; level <= top; ++level) {
    if (level < top) {
      l.spaces.push_back(std::make_unique<DegreeSpace<dim>>(
          finest.share(), degrees[top - level]));
      spaces[level] = l.spaces.back().get();
    }
    held[level].copy_from(spaces[level]->held());
    l.stiffness[level].reinit(*spaces[level], spaces[level]->degree() + 1,
                              part.stiffness, part.beds);
    if (level == 0) continue;
    l.steps[level].reinit_polynomial_transfer(spaces[level]->handler(),
                                              spaces[level - 1]->handler(),
                                              held[level], held[level - 1]);
  }
  l.transfer = std::make_unique<typename Levels::Transfer>(
      l.steps, [&l](unsigned level, Single& vector) {
        l.stiffness[level].initialize_dof_vector(vector);
      });
  l.smooth(top, SmoothingPolynomial(part.aspect));
  {
    StiffnessOperator<dim, double> coarse;
    coarse.reinit(*spaces[0], spaces[0]->degree() + 1, part.stiffness,
                  part.beds);
    const bool is_small = static_cast<double>(coarse.m()) <= part.most_factored;
    l.solver = std::make_unique<CoarseSolver<dim>>(
        *spaces[0], coarse,
        is_small ? CoarseMethod::kFactor : CoarseMethod::kMultigrid,
        part.place);
  }
  l.coarsest = std::make_unique<Coarsest<dim>>(*l.solver);
  l.matrix = std::make_unique<dealii::mg::Matrix<Single>>(l.stiffness);
  l.cycle = std::make_unique<dealii::Multigrid<Single>>(
      *l.matrix, *l.coarsest, *l.transfer, l.smoother, l.smoother, 0, top);
  l.whole = std::make_unique<
      dealii::PreconditionMG<dim, Single, typename Levels::Transfer>>(
      finest.handler(), *l.cycle, *l.transfer);
}

template <int dim>
PolynomialMultigrid<dim>::~PolynomialMultigrid() = default;

template <int dim>
void PolynomialMultigrid<dim>::vmult(Vector& solution,
                                     const Vector& residual) const {
  levels_->whole->vmult(solution, residual);
}

template <int dim>
std::size_t PolynomialMultigrid<dim>::levels() const {
  return levels_->spaces.size() + 1;
}

template class PolynomialMultigrid<2>;
template class PolynomialMultigrid<3>;

}  // namespace clevis::elasticity
