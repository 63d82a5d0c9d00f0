#include "app/parts/part_modes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "assessment/models/model_list.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/eigenmodes.h"
#include "report/text/atomic_file.h"
#include "stress/field/stress_history.h"
#include "stress/output/field_output.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using elasticity::Eigenmodes;
using nlohmann::ordered_json;

constexpr double kAmplitude = 1e-3;  // [m]
constexpr int kSubdivisions = 2;

/// Modes of the degree at which they settled, with the relative change of each
/// from the degree before.
template <int dim>
struct Climbed {
  Eigenmodes<dim> modes;
  Eigen::VectorXd change;  ///< [1]; 0 of rigid modes
  int degree{};
  bool settled = false;
};

template <int dim>
Climbed<dim> climb(const mesh::PartMesh<dim>& mesh,
                   const part::PartDefinition& part,
                   const ModesRequest& request) {
  static const loads::LoadHistory kNoLoads;
  const elasticity::ElasticProblem<dim> problem{mesh,
                                                part.material,
                                                kNoLoads,
                                                request.fixed,
                                                part.name,
                                                elasticity::LinearSolver::kAuto,
                                                request.foundations};
  constexpr int kFirst = 2, kHighest = 4;  // degree 1 locks
  Climbed<dim> result;
  for (int degree = kFirst; degree <= kHighest; ++degree) {
    std::optional<Eigenmodes<dim>> found;
    try {
      elasticity::require_dofs(elasticity::discretize<dim>(mesh, degree).dofs(),
                               request.max_dofs, "part " + part.name);
      found = elasticity::eigenmodes<dim>(problem, degree, request.count);
    } catch (const Error& error) {
      const bool is_too_large =
          error.code() == "F004" || error.code() == "F007";
      if (!is_too_large || degree == kFirst) throw;
      break;  // those of the degree before, not settled
    }
    Eigenmodes<dim>& modes = *found;
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

template <int dim>
std::string write_shape(const part::PartDefinition& part,
                        const ModesRequest& request,
                        const Eigenmodes<dim>& modes, Eigen::Index mode,
                        const fs::path& folder) {
  elasticity::DisplacementBasis<dim> basis;
  basis.discretization = modes.discretization;
  basis.columns = modes.shapes.col(mode);
  double largest = 0.0;
  for (Eigen::Index row = 0; row < basis.columns.rows(); row += dim) {
    largest = std::max(largest,
                       basis.columns.col(0).template segment<dim>(row).norm());
  }
  basis.coefficients = Eigen::MatrixXd::Constant(1, 1, kAmplitude / largest);
  const auto field =
      stress::instant_field<dim>(basis, part.material, kSubdivisions, 0);
  const stress::FieldOutput output(dim, modes.discretization.shape, field, {});
  const std::string set =
      request.number > 1 ? fmt::format("_{}", request.number) : "";
  const std::string name =
      fmt::format("{}{}_mode_{}.vtu", part.name, set, mode + 1);
  report::write_file(folder / name, [&](const report::TextSink& sink) {
    output.write(stress::CellOrder::kLagrange, sink);
  });
  return name;
}

template <int dim>
ordered_json modes_of(const mesh::PartMesh<dim>& mesh, std::string_view model,
                      const part::PartDefinition& part,
                      const ModesRequest& request, const fs::path& folder) {
  Stopwatch watch;
  const auto climbed = climb<dim>(mesh, part, request);
  const Eigenmodes<dim>& modes = climbed.modes;
  ordered_json rows = ordered_json::array();
  for (Eigen::Index k = 0; k < modes.frequencies.size(); ++k) {
    const bool rigid = k < modes.rigid;
    ordered_json row{
        {"mode", k + 1},
        {"kind", rigid ? "rigid" : "elastic"},
        {"frequency_hz", modes.frequencies[k]},
        {"change", climbed.change[k]},
        {"participation_x", modes.participation(k, 0)},
        {"participation_y", modes.participation(k, 1)},
        {"participation_z", dim == 3 ? modes.participation(k, dim - 1) : 0.0},
        {"residual", modes.residual[k]}};
    if (!rigid) row["file"] = write_shape<dim>(part, request, modes, k, folder);
    rows.push_back(std::move(row));
  }
  return {{"part", part.name},
          {"supports", request.supports},
          {"model", model},
          {"mass_kg", modes.mass},
          {"degree", climbed.degree},
          {"equations", modes.equations},
          {"converged", climbed.settled},
          {"seconds", watch.lap()},
          {"modes", std::move(rows)}};
}

/// The part with the supports that are asked for, without loads.
assessment::PartJob held_part(const LoadedPart& part,
                              const ModesRequest& request) {
  assessment::PartJob job;
  job.part = part.definition;
  job.mesh = part.mesh;
  job.load_sets.push_back({.history = {},
                           .fixed = request.fixed,
                           .foundations = request.foundations});
  return job;
}

}  // namespace

ordered_json part_modes(const LoadedPart& part, const ModesRequest& request,
                        const fs::path& folder) {
  const assessment::PartJob job = held_part(part, request);
  const assessment::PartShape shape(job);
  const assessment::Model& entry = assessment::finest_in_time(shape);
  const auto modes = [&]<int dim>(const assessment::FeModel<dim>& model) {
    return modes_of<dim>(*model.mesh, entry.traits.name, part.definition,
                         request, folder);
  };
  return std::visit(modes, entry.make(shape, {}));
}

std::vector<ModesRequest> modes_requests(const LoadedPart& part, bool moves,
                                         int count, double tolerance) {
  std::vector<ModesRequest> requests;
  const auto add = [&](const std::string& name, const auto& fixed,
                       const part::Foundations& foundations = {}) {
    const auto same = std::ranges::find_if(requests, [&](const auto& request) {
      return request.fixed == fixed && request.foundations == foundations;
    });
    if (same != requests.end()) return;
    const bool is_free = fixed.empty() && foundations.empty();
    requests.push_back({is_free ? "free" : name,
                        static_cast<int>(requests.size()) + 1, fixed, count,
                        tolerance, foundations});
  };
  const part::PartDefinition& given = part.definition;
  if (moves ||
      (given.cases.empty() && given.series.empty() && given.impacts.empty())) {
    add("free", decltype(ModesRequest::fixed){});
  }
  for (const auto& load_case : given.cases) {
    add(load_case.name, load_case.fixed, load_case.foundations);
  }
  for (const auto& series : given.series) {
    add(series.name, series.fixed, series.foundations);
  }
  for (const auto& impact : given.impacts) add(impact.name, impact.fixed);
  return requests;
}

}  // namespace clevis::app
