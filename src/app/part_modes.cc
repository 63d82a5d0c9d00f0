#include "app/part_modes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/stopwatch.h"
#include "elasticity/eigenmodes.h"
#include "report/atomic_file.h"
#include "stress/field_output.h"
#include "stress/stress_history.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using elasticity::Eigenmodes;
using nlohmann::ordered_json;

constexpr double kAmplitude = 1e-3;  // [m]
constexpr int kSubdivisions = 2;

/// Modes of the degree at which they settled, with the relative change of each
/// from the degree before.
struct Climbed {
  Eigenmodes<3> modes;
  Eigen::VectorXd change;  ///< [1]; 0 of rigid modes
  int degree{};
  bool settled = false;
};

Climbed climb(const LoadedPart& part, const ModesRequest& request) {
  static const loads::LoadHistory kNoLoads;
  const elasticity::ElasticProblem<3> problem{
      part.mesh, part.definition.material, kNoLoads, request.fixed,
      part.definition.name};
  const int highest = part.mesh.shape == mesh::CellShape::kTensor ? 4 : 2;
  Climbed result;
  const int first = highest > 2 ? 2 : 1;  // degree 1 locks
  for (int degree = first; degree <= highest; ++degree) {
    auto modes = elasticity::eigenmodes<3>(problem, degree, request.count);
    const Eigen::Index n = modes.frequencies.size();
    result.change = Eigen::VectorXd::Zero(n);
    const bool has_before = result.modes.frequencies.size() == n;
    for (Eigen::Index k = modes.rigid; has_before && k < n; ++k) {
      result.change[k] =
          std::abs(result.modes.frequencies[k] / modes.frequencies[k] - 1.0);
    }
    result.modes = std::move(modes);
    result.degree = degree;
    result.settled =
        has_before && !(result.change.maxCoeff() > request.tolerance);
    if (result.settled) break;
  }
  return result;
}

std::string write_shape(const LoadedPart& part, const ModesRequest& request,
                        const Eigenmodes<3>& modes, Eigen::Index mode,
                        const fs::path& folder) {
  elasticity::DisplacementBasis<3> basis;
  basis.discretization = modes.discretization;
  basis.columns = modes.shapes.col(mode);
  double largest = 0.0;
  for (Eigen::Index row = 0; row < basis.columns.rows(); row += 3) {
    largest = std::max(largest, basis.columns.col(0).segment<3>(row).norm());
  }
  basis.coefficients = Eigen::MatrixXd::Constant(1, 1, kAmplitude / largest);
  const auto field = stress::instant_field<3>(basis, part.definition.material,
                                              kSubdivisions, 0);
  std::ostringstream text;
  stress::write_vtu<3>(text, part.mesh.shape, field, {},
                       stress::CellOrder::kLagrange);
  const std::string set =
      request.number > 1 ? fmt::format("_{}", request.number) : "";
  const std::string name =
      fmt::format("{}{}_mode_{}.vtu", part.definition.name, set, mode + 1);
  report::write_file(folder / name, text.view());
  return name;
}

}  // namespace

ordered_json part_modes(const LoadedPart& part, const ModesRequest& request,
                        const fs::path& folder) {
  Stopwatch watch;
  const Climbed climbed = climb(part, request);
  const Eigenmodes<3>& modes = climbed.modes;
  ordered_json rows = ordered_json::array();
  for (Eigen::Index k = 0; k < modes.frequencies.size(); ++k) {
    const bool rigid = k < modes.rigid;
    ordered_json row{{"mode", k + 1},
                     {"kind", rigid ? "rigid" : "elastic"},
                     {"frequency_hz", modes.frequencies[k]},
                     {"change", climbed.change[k]},
                     {"participation_x", modes.participation(k, 0)},
                     {"participation_y", modes.participation(k, 1)},
                     {"participation_z", modes.participation(k, 2)},
                     {"residual", modes.residual[k]}};
    if (!rigid) row["file"] = write_shape(part, request, modes, k, folder);
    rows.push_back(std::move(row));
  }
  return {{"part", part.definition.name}, {"supports", request.supports},
          {"mass_kg", modes.mass},        {"degree", climbed.degree},
          {"equations", modes.equations}, {"converged", climbed.settled},
          {"seconds", watch.lap()},       {"modes", std::move(rows)}};
}

std::vector<ModesRequest> modes_requests(const LoadedPart& part, bool moves,
                                         int count, double tolerance) {
  std::vector<ModesRequest> requests;
  if (moves || part.definition.cases.empty()) {
    requests.push_back({"free", 1, {}, count, tolerance});
  }
  for (const auto& load_case : part.definition.cases) {
    const auto same =
        std::ranges::find(requests, load_case.fixed, &ModesRequest::fixed);
    if (same != requests.end()) continue;
    requests.push_back({load_case.fixed.empty() ? "free" : load_case.name,
                        static_cast<int>(requests.size()) + 1, load_case.fixed,
                        count, tolerance});
  }
  return requests;
}

}  // namespace clevis::app
