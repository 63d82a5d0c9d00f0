#include "assessment/models/solid_model.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "assessment/job/part_zones.h"
#include "assessment/models/model_error.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::assessment {
namespace {

constexpr int kDegreesOfABand = 3;

/// Whether finer cells where the peak stands come before one degree more of all
/// of them, which takes five times as much. They do nothing for probes.
bool mesh_comes_first(const PartJob& job) {
  return job.may_be_meshed_finer &&
         job.mesh.shape == mesh::CellShape::kSimplex &&
         std::ranges::all_of(job.part.cases, [](const auto& load_case) {
           return load_case.probes.empty();
         });
}

/// Leaves out the highest degree of tetrahedra where its factorisation alone
/// would take more than about a minute, and says so where it is missed.
void leave_out_what_takes_minutes(FeModel<3>& model) {
  constexpr std::size_t kFewCells = 10000;  // of them no degree takes so long
  constexpr double kFlopsPerSecond = 3e10;  // one core of 2020
  constexpr double kMostSeconds = 60.0;
  constexpr double kUnknowns = 27.0;  // of a node, cubed
  const mesh::PartMesh<3>& mesh = *model.mesh;
  if (mesh.shape != mesh::CellShape::kSimplex ||
      mesh.cells.size() < kFewCells ||
      model.highest_degree - model.first_degree < kDegreesOfABand) {
    return;
  }
  // A face between parts has the square of the degree as many nodes as those
  // of degree 1; small fronts, the other 0.4, grow more slowly.
  constexpr double kOfFaces = 0.6;
  const double more = kOfFaces * std::pow(model.highest_degree, 6.0);
  const auto part = elasticity::discretize<3>(mesh, 1);
  const double seconds =
      kUnknowns * more * elasticity::dissect(part).flops / kFlopsPerSecond;
  if (seconds < kMostSeconds) return;
  model.remark = [degree = model.highest_degree, seconds](PartResult& result) {
    if (judged_peak(result).verdict == PeakVerdict::kConverged) return;
    result.stopped_because += fmt::format(
        "; degree {} is left out, its factorisation would take about {:.0f} s: "
        "give a larger mesh_size or tolerance",
        degree, seconds);
  };
  --model.highest_degree;
}

}  // namespace

std::optional<std::string> why_not_solid(const PartShape& shape) {
  if (shape.job().model != ModelKind::kSolid &&
      leaves_plane_free(shape.job())) {
    return "supports leave the part free to leave its plane";
  }
  return std::nullopt;
}

std::optional<ModelSettings> solid_settings(const PartShape& shape) {
  ModelSettings settings{.error = 0.0};
  const PartJob& job = shape.job();
  if (job.model != ModelKind::kSolid) return settings;
  PartJob free_choice = job;
  free_choice.model.reset();
  const PartShape as_plate(free_choice);
  const auto& plate = as_plate.plate();
  if (plate && !plate->is_pressed_through) {
    settings.error =
        kink_error(free_choice, plate->quadrangles, as_plate.governing(),
                   job.mesh.cells.size() / plate->mesh.cells.size());
  }
  return settings;
}

FeModel<3> solid_model(const mesh::PartMesh<3>& mesh) {
  constexpr const ModelTraits& kSolid = traits_of(ModelKind::kSolid);
  FeModel<3> model;
  model.name = kSolid.name;
  if (mesh.shape == mesh::CellShape::kSimplex) model.name += " tetrahedra";
  model.mesh = &mesh;
  model.solve = elasticity::solve<3>;
  model.highest_degree = kSolid.highest_degree;
  // In 3-D three degrees up to 3 are cheaper than 4 alone.
  model.first_degree = unfolded(mesh, 1, model.highest_degree);
  model.subdivisions = 4;
  model.looks_at_places = true;
  return model;
}

AnyFeModel solid_model(const PartShape& shape, const ModelSettings& settings) {
  const PartJob& job = shape.job();
  FeModel<3> model = solid_model(job.mesh);
  if (mesh_comes_first(job)) {
    model.highest_degree = std::min(model.highest_degree,
                                    model.first_degree + kDegreesOfABand - 1);
  } else {
    leave_out_what_takes_minutes(model);
  }
  model.model_error = settings.error.value_or(0.0);
  model.zones = [&job](const LoadSet& set) {
    return part_zones<3>(job, job.mesh, set);
  };
  return model;
}

}  // namespace clevis::assessment
