#include "elasticity/solid/energy_form.h"

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd energy_form(const VectorXd& single, const VectorXd& pairs) {
  const Index n = single.size();
  MatrixXd form(n, n);
  Index pair = 0;
  for (Index i = 0; i < n; ++i) {
    form(i, i) = 2.0 * single[i];
    for (Index j = i + 1; j < n; ++j) {
      form(i, j) = form(j, i) = pairs[pair++] - single[i] - single[j];
    }
  }
  return form;
}

}  // namespace clevis::elasticity
