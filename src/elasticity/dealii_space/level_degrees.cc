#include "elasticity/dealii_space/level_degrees.h"

#include <cmath>

namespace clevis::elasticity {

std::vector<int> level_degrees(int degree, int dim, double nodes) {
  const double quadratic = dim * nodes * std::pow(2.0 / degree, dim);
  const int lowest = quadratic <= kMostOfDegree2 ? 2 : 1;
  std::vector<int> degrees{degree};
  while (degrees.back() > lowest) {
    const int last = degrees.back();
    degrees.push_back(last % 2 == 0 ? last / 2 : last - 1);
  }
  return degrees;
}

}  // namespace clevis::elasticity
