#include "app/solving/study_run.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/figures/gnuplot_run.h"
#include "app/parts/solver_jobs.h"
#include "app/processes/calculix_run.h"
#include "app/processes/folder_lock.h"
#include "app/request/output_folder.h"
#include "base/system/interrupts.h"
#include "elasticity/problem/dof_limit.h"
#include "report/text/atomic_file.h"
#include "report/text/json_text.h"
#include "report/text/terminal.h"
#include "study/clevis_run.h"
#include "study/figure.h"
#include "study/output.h"
#include "study/reference.h"
#include "study/table.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using assessment::PartJob;
using study::PartStudy;
using study::Run;

/// Tolerances of the check's series.
constexpr double kTolerances[] = {0.1, 0.03, 0.01, 0.003, 0.001};

/// CalculiX's hexahedra are cut so often, while the deck stays below this.
constexpr int kMostCuts = 6;
constexpr double kMostCalculixDofs = 1.2e5;

/// A run that is planned: its names stand even if nothing comes of it.
struct PlannedRun {
  std::size_t part{};
  std::string series, setting;
  std::function<Run()> run;
};

/// The governing load of each part, found in processes of their own.
/// @return empty for a part that was not reached.
std::vector<std::optional<study::Governing>> governing_loads(
    const std::vector<PartJob>& jobs) {
  std::vector<SolverTask> tasks;
  for (const auto& job : jobs) {
    tasks.push_back(
        {"looking at " + job.part.name, [&job] {
           const auto found = study::find_governing(job);
           return nlohmann::json{found.set, found.instant, found.label}.dump();
         }});
  }
  std::vector<std::optional<study::Governing>> governing;
  for (const auto& answer : run_solver_tasks(tasks)) {
    if (answer.error) throw *answer.error;
    governing.emplace_back();
    if (!answer.text) continue;
    const auto json = nlohmann::json::parse(*answer.text);
    governing.back() = {json.at(0), json.at(1), json.at(2)};
  }
  return governing;
}

void plan_clevis(std::size_t part, const PartJob& job, int instant,
                 elasticity::Engine engine, std::vector<PlannedRun>& plan) {
  for (const study::Series& series : study::series_of(job, engine)) {
    const int highest = assessment::traits_of(series.model).highest_degree;
    for (int degree = 1; degree <= highest; ++degree) {
      plan.push_back({part, study::series_name(series),
                      fmt::format("p = {}", degree),
                      [&job, series, degree, instant] {
                        return study::solve_model(job, series, degree, instant);
                      }});
    }
  }
  for (const double tolerance : kTolerances) {
    plan.push_back({part, "clevis check",
                    fmt::format("{:.3g} %", 100.0 * tolerance),
                    [&job, tolerance] {
                      return study::run_check(job, tolerance);
                    }});
  }
}

void plan_calculix(std::size_t part, const PartJob& job, int instant,
                   const Options& options, std::vector<PlannedRun>& plan) {
  const bool is_tensor = job.mesh.shape == mesh::CellShape::kTensor;
  const int most = options.split > 0 ? options.split : kMostCuts;
  for (int split = 1; split <= (is_tensor ? most : 1); ++split) {
    const double dofs = calculix_dofs(job.mesh, split);
    if (split > 1 && dofs > options.max_dofs.value_or(kMostCalculixDofs)) break;
    const CalculixRequest request{hexahedron_of(options), split, instant,
                                  options.every_instant};
    plan.push_back({part,
                    "CalculiX " + (is_tensor ? options.elements : "C3D10"),
                    calculix_setting(split), [&job, request, dofs] {
                      elasticity::require_dofs(dofs, job.max_dofs,
                                               "part " + job.part.name);
                      return run_calculix(job, request);
                    }});
  }
}

/// Runs what is planned; false if an interrupt came between.
bool carry_out(const std::vector<PlannedRun>& plan,
               std::vector<PartStudy>& studies) {
  std::vector<SolverTask> tasks;
  for (const auto& planned : plan) {
    tasks.push_back({fmt::format("{}: {}, {}", studies[planned.part].name,
                                 planned.series, planned.setting),
                     [&planned] {
                       return study::encode(planned.run());
                     }});
  }
  bool is_complete = true;
  const auto answers = run_solver_tasks(tasks);
  for (std::size_t r = 0; r < plan.size(); ++r) {
    Run run;
    if (answers[r].text) {
      run = study::decode_run(*answers[r].text);
    } else if (answers[r].error) {
      run.series = plan[r].series;
      run.setting = plan[r].setting;
      run.left_out = fmt::format("{}: {}", answers[r].error->code(),
                                 answers[r].error->problem());
    } else {
      is_complete = false;
      continue;
    }
    studies[plan[r].part].runs.push_back(std::move(run));
  }
  return is_complete;
}

PartStudy empty_study(const PartJob& job, const study::Governing& governing) {
  PartStudy study;
  study.name = job.part.name;
  study.load = governing.label;
  study.instants =
      static_cast<int>(job.load_sets.front().history.instants.size());
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      study.probe_names.push_back(probe.name + " " + probe.quantity);
      study.is_stress.push_back(!part::is_displacement(probe.quantity));
    }
  }
  return study;
}

void find_references(const PartJob& job, PartStudy& study) {
  std::vector<std::optional<double>> published;
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      published.push_back(probe.reference);
    }
  }
  study::set_references(study::exact_series(job), published, study);
}

}  // namespace

ExitCode run_study(const Options& options, scene::Scene scene) {
  const fs::path folder =
      options.out.empty() ? output_folder(options) / "study" : options.out;
  const SolverJobs solver = load_solver_jobs(options, std::move(scene));
  const InterruptGuard guard;
  const FolderLock lock(folder);
  study::Study result;
  result.version = CLEVIS_VERSION;
  result.scene = solver.loaded.scene.name;
  const auto calculix = calculix_version();
  result.calculix = calculix.value_or("not found: its series is left out");

  const auto governing = governing_loads(solver.jobs);
  std::vector<PartJob> jobs;
  std::vector<PlannedRun> plan;
  jobs.reserve(solver.jobs.size());  // the plan refers to them
  for (std::size_t p = 0; p < solver.jobs.size(); ++p) {
    if (!governing[p]) {
      result.complete = false;
      continue;
    }
    const PartJob& job =
        jobs.emplace_back(study::governed_job(solver.jobs[p], *governing[p]));
    const std::size_t part = result.parts.size();
    result.parts.push_back(empty_study(job, *governing[p]));
    plan_clevis(part, job, governing[p]->instant,
                elasticity::find_engine(options.engine).value(), plan);
    if (calculix) {
      plan_calculix(part, job, governing[p]->instant, options, plan);
    }
  }
  result.complete = carry_out(plan, result.parts) && result.complete;
  std::vector<NamedFigure> figures;
  for (std::size_t p = 0; p < jobs.size(); ++p) {
    PartStudy& part = result.parts[p];
    find_references(jobs[p], part);
    report::write_file(folder / (part.name + "_study.csv"),
                       study::study_csv(part));
    figures.push_back({part.name + "_study", study::study_figure(part)});
    figures.push_back({part.name + "_peak", study::peak_against_seconds(part)});
  }
  draw_figures(figures, folder);
  const std::string document = report::json_text(study::study_json(result));
  report::write_file(folder / "study.json", document);
  if (options.json) {
    std::cout << document;
  } else {
    std::cout << study::study_table(result, report::colour_of(STDOUT_FILENO))
              << "\nfiles: " << folder.string() << "\n";
  }
  return result.complete ? ExitCode::kPass : kInterruptedExit;
}

}  // namespace clevis::app
