#include "assessment/models/plate_models.h"

#include <fmt/format.h>

#include "assessment/models/model_error.h"
#include "elasticity/plate/layered_solve.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::assessment {
namespace {

constexpr const ModelTraits& kPlaneStress = traits_of(ModelKind::kPlaneStress);
constexpr const ModelTraits& kLayered = traits_of(ModelKind::kLayered);
// Degree 1 says nothing of how the peak comes to rest.
constexpr int kFirstDegree = 2;

std::optional<std::string> why_no_plate(const PartShape& shape) {
  if (has_bed(shape.job())) {
    return "a face rests on a foundation, which these models do not know";
  }
  if (!shape.plate()) {
    return "the part is no plate along z that is loaded on its sides";
  }
  return std::nullopt;
}

/// Looks closer where that is cheap or asked for.
int lattice_for(const PartJob& job) {
  constexpr double kFine = 0.005;
  constexpr std::size_t kFew = 10;
  std::size_t instants = 0;
  for (const LoadSet& set : job.load_sets) {
    instants += set.history.instants.size();
  }
  return instants <= kFew || job.tolerance < kFine ? 8 : 4;
}

}  // namespace

std::optional<std::string> why_not_plane_stress(const PartShape& shape) {
  if (auto reason = why_no_plate(shape)) return reason;
  if (!shape.plate()->is_loaded_in_plane) {
    return "the part is no plate along z that is loaded in its plane";
  }
  return std::nullopt;
}

std::optional<ModelSettings> plane_stress_settings(const PartShape& shape) {
  const PartJob& job = shape.job();
  ModelSettings settings;
  settings.governing = shape.governing();
  // A held part is solved first: a stress without bound needs no better model.
  if (is_held(job) || job.model) return settings;
  const auto& quadrangles = shape.plate()->quadrangles;
  if (plane_stress_is_far(job, quadrangles, settings.governing)) {
    return std::nullopt;
  }
  settings.error = plane_stress_error(shape);
  if (*settings.error > job.tolerance) return std::nullopt;
  return settings;
}

AnyFeModel plane_stress_model(const PartShape& shape,
                              const ModelSettings& settings) {
  const auto& plate = shape.plate()->mesh;
  FeModel<2> model;
  model.name = kPlaneStress.name;
  model.mesh = &plate;
  model.solve = elasticity::solve<2>;
  model.zones = [&shape, &plate](const LoadSet& set) {
    return plate_zones<2>(shape.job(), plate, set);
  };
  model.highest_degree = kPlaneStress.highest_degree;
  model.first_degree = unfolded(plate, kFirstDegree, model.highest_degree);
  model.subdivisions = 8;
  model.model_error = settings.error.value_or(0.0);
  // Degrees far above that of the geometry see the kinks between its arcs.
  constexpr int kSmoothGeometry = 4;
  model.looks_nearby = plate.degree >= kSmoothGeometry;
  return model;
}

double plane_stress_error(const PartShape& shape) {
  return plane_stress_error(shape.job(), shape.plate()->quadrangles,
                            shape.governing());
}

std::optional<std::string> why_not_layered(const PartShape& shape) {
  if (auto reason = why_no_plate(shape)) return reason;
  // So many terms that hexahedra are the better choice, unless asked for.
  if (is_held_across(shape.job()) && shape.job().model != ModelKind::kLayered) {
    return "a side is held across the plate";
  }
  return std::nullopt;
}

std::optional<ModelSettings> layered_settings(const PartShape& shape) {
  constexpr double kShare = 0.5;  // of the tolerance, for the model
  const PartJob& job = shape.job();
  ModelSettings settings;
  settings.governing = shape.governing();
  const auto choice =
      choose_terms(job, shape.plate()->quadrangles, settings.governing,
                   shape.plate()->is_pressed_through, kShare * job.tolerance);
  settings.terms = choice.terms;
  settings.error = choice.model_error;
  return settings;
}

AnyFeModel layered_model(const PartShape& shape,
                         const ModelSettings& settings) {
  const auto& plate = shape.plate()->quadrangles;
  FeModel<3> model;
  model.name = fmt::format("{0} {1}+{1}", kLayered.name, settings.terms);
  model.mesh = &shape.job().mesh;
  model.cells_in_plane = static_cast<int>(plate.cells.size());
  model.solve = [&plate, terms = settings.terms](
                    const elasticity::ElasticProblem<3>& problem, int degree) {
    return elasticity::solve_layered(
        {.mesh = plate,
         .material = problem.material,
         .history = problem.history,
         .fixed = problem.fixed,
         .name = problem.name,
         .max_dofs = problem.max_dofs,
         .admitted_load_error = problem.admitted_load_error},
        degree, terms);
  };
  model.zones = [&shape, &plate](const LoadSet& set) {
    return plate_zones<3>(shape.job(), plate, set);
  };
  model.highest_degree = kLayered.highest_degree;
  model.first_degree = unfolded(plate, kFirstDegree, model.highest_degree);
  model.subdivisions = settings.subdivisions > 0 ? settings.subdivisions
                                                 : lattice_for(shape.job());
  model.model_error = settings.error.value_or(0.0);
  // A pin that tilts bends the wall of its bore within the thickness from its
  // edge: cells that are wider let the peak overshoot before it comes to rest.
  constexpr double kOvershoots = 0.5;
  if (!shape.plate()->is_pressed_through) {
    model.share_of_change_before = kOvershoots;
  }
  return model;
}

bool solid_may_help(const PartShape& shape, const PartResult& result) {
  // A plate's hexahedra follow a kink less than terms do.
  if (shape.plate() && !shape.plate()->is_pressed_through) return false;
  const PeakStress& peak = result.peak;
  return peak.verdict != PeakVerdict::kSingular &&
         !(peak.model_error < shape.job().tolerance * peak.value);
}

}  // namespace clevis::assessment
