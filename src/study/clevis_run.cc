#include "study/clevis_run.h"

#include <algorithm>
#include <variant>

#include <fmt/format.h>
#include <sys/resource.h>

#include "assessment/models/level.h"
#include "assessment/models/model_list.h"
#include "assessment/part_check.h"
#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "mesh/derived/split_cells.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::study {
namespace {

using assessment::PartJob;

/// Above it a study would wait for minutes for one point, unless asked to.
constexpr double kMostDofs = 4.5e5;

/// A quick run is repeated until this time is spent, or so often.
constexpr double kRepeatSeconds = 0.3;
constexpr int kMostRepeats = 5;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Degrees of freedom of continuous hexahedra, from Euler's V − E + F − C = 1
/// of a body without holes: close enough to decide by.
double forecast_dofs(const mesh::PartMesh<3>& mesh, int degree) {
  const double cells = static_cast<double>(mesh.cells.size());
  const double vertices = static_cast<double>(mesh.vertices.size());
  const double faces =
      0.5 * (6.0 * cells + static_cast<double>(mesh.boundary.size()));
  const double edges = vertices + faces - cells - 1.0;
  const double inner = degree - 1;
  return 3.0 * (vertices + inner * (edges + inner * (faces + inner * cells)));
}

template <int dim>
Run take(const assessment::Level<dim>& level, int instant) {
  Run run;
  run.dofs = level.member.dofs;
  run.peak = level.history().peak[instant];
  run.energy = level.governing->strain_energy[instant];
  for (const auto& probe : level.probes) run.probes.push_back(probe.value);
  return run;
}

assessment::AnyFeModel model_of(const assessment::PartShape& shape,
                                const Series& series) {
  constexpr int kSubdivisions = 6;  // of layered models' lattice
  return assessment::entry_of(series.model)
      .make(shape, {.terms = series.terms, .subdivisions = kSubdivisions});
}

/// @throws Error F004 if the cells of a model in space are too many.
template <int dim>
void forbid_long_runs(const PartJob& job, const assessment::FeModel<dim>& model,
                      int degree) {
  if (job.max_dofs || dim == 2 || model.cells_in_plane) return;
  const double dofs = forecast_dofs(job.mesh, degree);
  if (dofs <= kMostDofs) return;
  throw Error("F004", "part " + job.part.name,
              fmt::format("{:.2g} degrees of freedom", dofs),
              "A study solves no more than 450 000 without --max-dofs.");
}

/// From the mesh file to the stresses, once.
/// @param job  whose mesh is read.
Run run_once(PartJob job, const Series& series, int degree, int instant) {
  const double cpu = cpu_seconds();
  Stopwatch total;
  Stopwatch watch;
  assessment::PartSeconds seconds;
  job.engine = series.engine;
  job.mesh = mesh::read_part_mesh(job.part.mesh, job.part.length_unit,
                                  job.part.thickness);
  if (series.is_halved) job.mesh = mesh::split_cells(job.mesh, 2);
  const assessment::PartShape shape(job);
  const auto solve = [&]<int dim>(const assessment::FeModel<dim>& model) {
    forbid_long_runs(job, model, degree);
    seconds.mesh = watch.lap();
    return take<dim>(
        assessment::solve_level<dim>(job, job.load_sets, *model.mesh, model,
                                     degree, seconds),
        instant);
  };
  Run run = std::visit(solve, model_of(shape, series));
  run.seconds = seconds;
  run.seconds.total = total.lap();
  run.cpu_seconds = cpu_seconds() - cpu;
  return run;
}

/// Each number of terms of a model; one series of a model without, and one by
/// deal.II where that has it.
std::vector<Series> series_of(const assessment::ModelTraits& model,
                              mesh::CellShape shape) {
  std::vector<Series> series;
  if (model.on_dealii && shape == mesh::CellShape::kTensor) {
    series.push_back(
        {.model = model.kind, .engine = elasticity::Engine::kDealii});
  }
  for (int terms = model.fewest_terms; terms <= model.most_terms; ++terms) {
    series.push_back({.model = model.kind, .terms = terms});
  }
  return series;
}

/// Whether the part has plane models only.
bool is_plane_problem(const PartJob& job,
                      const std::vector<const assessment::Model*>& models) {
  return assessment::leaves_plane_free(job) && models.front()->traits.dim == 2;
}

/// The fastest of a few repetitions.
template <class Once>
Run fastest(Once once) {
  Stopwatch watch;
  Run best = once();
  double spent = watch.lap();
  for (int k = 1; k < kMostRepeats && spent < kRepeatSeconds; ++k) {
    Run again = once();
    spent += watch.lap();
    if (again.cpu_seconds < best.cpu_seconds) best = std::move(again);
  }
  best.memory = peak_memory();
  return best;
}

}  // namespace

std::string series_name(const Series& series) {
  const std::string name =
      series.terms > 0 ? fmt::format("2-D x {0}+{0} terms", series.terms)
                       : std::string(traits_of(series.model).name);
  return name +
         (series.engine == elasticity::Engine::kDealii ? ", deal.II" : "") +
         (series.is_halved ? ", cells halved" : "");
}

std::vector<Series> series_of(const PartJob& job, elasticity::Engine engine) {
  PartJob free_choice = job;
  free_choice.model.reset();
  const assessment::PartShape shape(free_choice);
  auto models = assessment::models_for(shape);
  if (is_plane_problem(job, models)) {
    std::erase_if(models, [](const auto* model) {
      return model->traits.dim != 2;
    });
  }
  std::vector<Series> series;
  for (const auto* model : models) {
    for (const Series& each : series_of(model->traits, job.mesh.shape)) {
      series.push_back(each);
    }
  }
  if (job.mesh.shape == mesh::CellShape::kTensor) {
    series.push_back(series.back());
    series.back().is_halved = true;
  }
  if (engine != elasticity::Engine::kAuto) {
    std::erase_if(series, [&](const Series& each) {
      return each.engine != engine;
    });
  }
  return series;
}

std::vector<std::string> exact_series(const PartJob& job) {
  const auto all = series_of(job);
  const bool is_plane = traits_of(all.back().model).dim == 2;
  std::vector<std::string> names;
  for (const Series& series : all) {
    if (is_plane || traits_of(series.model).is_exact) {
      names.push_back(series_name(series));
    }
  }
  return names;
}

Governing find_governing(const PartJob& job) {
  constexpr int kDegree = 2;
  const assessment::PartShape shape(job);
  Series finest = series_of(job).back();
  finest.is_halved = false;
  const auto look = [&]<int dim>(const assessment::FeModel<dim>& model) {
    assessment::PartSeconds seconds;
    const auto level = assessment::solve_level<dim>(
        job, job.load_sets, *model.mesh, model, kDegree, seconds);
    const int instant = level.history().peak_instant;
    const auto& instants = job.load_sets[level.set].history.instants;
    return Governing{level.set, instant,
                     instants[static_cast<std::size_t>(instant)].label};
  };
  return std::visit(look, model_of(shape, finest));
}

PartJob governed_job(const PartJob& job, const Governing& governing) {
  PartJob result = job;
  result.load_sets = {job.load_sets[governing.set]};
  const auto& instants = result.load_sets.front().history.instants;
  std::erase_if(result.part.cases, [&](const auto& load_case) {
    return std::ranges::find(instants, load_case.name,
                             &loads::InstantLoad::label) == instants.end();
  });
  return result;
}

Run solve_model(const PartJob& job, const Series& series, int degree,
                int instant) {
  Run run = fastest([&] {
    return run_once(job, series, degree, instant);
  });
  run.series = series_name(series);
  run.setting = fmt::format("p = {}", degree);
  return run;
}

Run run_check(const PartJob& job, double tolerance) {
  Run run = fastest([&] {
    const double cpu = cpu_seconds();
    Stopwatch total;
    Stopwatch watch;
    PartJob checked = job;
    checked.tolerance = tolerance;
    checked.model.reset();
    checked.mesh = mesh::read_part_mesh(job.part.mesh, job.part.length_unit,
                                        job.part.thickness);
    const double reading = watch.lap();
    const auto result = assessment::check_part(checked).result;
    Run once;
    once.dofs = result.dofs;
    once.peak = result.peak.value;
    once.energy = result.peak.sequence.back().strain_energy;
    for (const auto& probe : result.probes) once.probes.push_back(probe.value);
    once.checked = result.peak;
    once.setting = fmt::format("{:.3g} %: {}", 100.0 * tolerance, result.model);
    once.seconds = result.seconds;
    once.seconds.mesh = reading;
    once.seconds.total = total.lap();
    once.cpu_seconds = cpu_seconds() - cpu;
    return once;
  });
  run.series = "clevis check";
  return run;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace clevis::study
