#include "study/clevis_run.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <sys/resource.h>

#include "assessment/models/level.h"
#include "assessment/models/model_choice.h"
#include "assessment/models/rung.h"
#include "assessment/part_check.h"
#include "base/errors.h"
#include "base/stopwatch.h"
#include "mesh/derived/split_cells.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::study {
namespace {

using assessment::PartJob;

/// Above it a study would wait for minutes for one point.
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

mesh::PartMesh<2> mid_plane(const mesh::PartMesh<3>& mesh) {
  auto plate = mesh::plate_mid_plane(mesh);
  if (!plate) {
    throw Error("X001", "study", "the mesh is no plate any more",
                "please report this scene");
  }
  return *plate;
}

/// Legendre terms of each field; 0 of the other rungs.
int terms_of(Rung rung) {
  switch (rung) {
    case Rung::kTwoTerms:
      return 2;
    case Rung::kThreeTerms:
      return 3;
    case Rung::kFourTerms:
      return 4;
    default:
      return 0;
  }
}

bool is_plane(Rung rung) {
  return rung == Rung::kPlaneStress || rung == Rung::kPlaneStressHalved;
}

/// Whether nothing but the plane keeps the part in its plane.
bool is_held_in_plane_only(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const auto& set) {
    return !set.fixed.empty() &&
           std::ranges::none_of(set.fixed, [](const auto& f) {
             return f.second[2];
           });
  });
}

template <int dim>
Governing governing_of(const PartJob& job, const mesh::PartMesh<dim>& mesh,
                       const assessment::Rung<dim>& model) {
  constexpr int kDegree = 2;
  assessment::PartSeconds seconds;
  const auto level = assessment::solve_level<dim>(job, job.load_sets, mesh,
                                                  model, kDegree, seconds);
  const int instant = level.history().peak_instant;
  return {level.set, instant,
          job.load_sets[level.set]
              .history.instants[static_cast<std::size_t>(instant)]
              .label};
}

/// From the mesh file to the stresses, once.
Run run_once(const PartJob& job, Rung rung, int degree, int instant) {
  const double cpu = cpu_seconds();
  Stopwatch total;
  Stopwatch watch;
  assessment::PartSeconds seconds;
  const auto mesh = mesh::read_part_mesh(job.part.mesh, job.part.length_unit,
                                         job.part.thickness);
  Run run;
  const bool is_halved =
      rung == Rung::kSolidHalved || rung == Rung::kPlaneStressHalved;
  const auto cells = is_halved ? mesh::split_cells(mesh, 2) : mesh;
  if (is_plane(rung)) {
    const auto plate = mid_plane(cells);
    seconds.mesh = watch.lap();
    run = take<2>(assessment::solve_level<2>(
                      job, job.load_sets, plate,
                      assessment::plane_stress_rung(plate), degree, seconds),
                  instant);
  } else if (terms_of(rung) > 0) {
    const auto plate = mid_plane(mesh);
    seconds.mesh = watch.lap();
    constexpr int kSubdivisions = 6;  // of the lattice that peaks are sought on
    run = take<3>(
        assessment::solve_level<3>(
            job, job.load_sets, mesh,
            assessment::layered_rung(plate, terms_of(rung), kSubdivisions),
            degree, seconds),
        instant);
  } else {
    seconds.mesh = watch.lap();
    const double dofs = forecast_dofs(cells, degree);
    if (dofs > kMostDofs) {
      throw Error("F004", "part " + job.part.name,
                  fmt::format("{:.2g} degrees of freedom", dofs),
                  "a study solves no more than 450 000");
    }
    run = take<3>(assessment::solve_level<3>(job, job.load_sets, cells,
                                             assessment::solid_rung(cells),
                                             degree, seconds),
                  instant);
  }
  run.seconds = seconds;
  run.seconds.total = total.lap();
  run.cpu_seconds = cpu_seconds() - cpu;
  return run;
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

std::string series_name(Rung rung) {
  switch (rung) {
    case Rung::kPlaneStress:
      return "plane stress";
    case Rung::kPlaneStressHalved:
      return "plane stress, cells halved";
    case Rung::kTwoTerms:
    case Rung::kThreeTerms:
    case Rung::kFourTerms:
      return fmt::format("2-D x {0}+{0} terms", terms_of(rung));
    case Rung::kSolid:
      return "3-D";
    case Rung::kSolidHalved:
      break;
  }
  return "3-D, cells halved";
}

std::vector<Rung> rungs_of(const PartJob& job) {
  std::vector<Rung> rungs;
  PartJob free_choice = job;
  free_choice.model = assessment::ModelChoice::kAuto;
  const auto plate = assessment::plate_model(free_choice);
  if (plate && plate->suits_plane_stress) rungs.push_back(Rung::kPlaneStress);
  if (!rungs.empty() && is_held_in_plane_only(job)) {
    rungs.push_back(Rung::kPlaneStressHalved);
    return rungs;
  }
  if (plate && plate->suits_layers) {
    rungs.insert(rungs.end(),
                 {Rung::kTwoTerms, Rung::kThreeTerms, Rung::kFourTerms});
  }
  rungs.push_back(Rung::kSolid);
  if (job.mesh.shape == mesh::CellShape::kTensor) {
    rungs.push_back(Rung::kSolidHalved);
  }
  return rungs;
}

int highest_degree(const PartJob& job, Rung rung) {
  constexpr int kLayered = 5, kTensor = 4, kSimplex = 4;
  if (terms_of(rung) > 0) return kLayered;
  return job.mesh.shape == mesh::CellShape::kTensor ? kTensor : kSimplex;
}

Governing find_governing(const PartJob& job) {
  if (!is_plane(rungs_of(job).back())) {
    return governing_of<3>(job, job.mesh, assessment::solid_rung(job.mesh));
  }
  const auto plate = mid_plane(job.mesh);
  return governing_of<2>(job, plate, assessment::plane_stress_rung(plate));
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

Run run_rung(const PartJob& job, Rung rung, int degree, int instant) {
  Run run = fastest([&] {
    return run_once(job, rung, degree, instant);
  });
  run.series = series_name(rung);
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
    checked.model = assessment::ModelChoice::kAuto;
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
