#include "app/solving/check_run.h"

#include <algorithm>
#include <functional>
#include <future>
#include <iostream>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "app/joined/joined_verdicts.h"
#include "app/parts/finer_part.h"
#include "app/parts/link_compliance.h"
#include "app/parts/part_jobs.h"
#include "app/parts/solver_jobs.h"
#include "app/processes/folder_lock.h"
#include "app/processes/shared_text.h"
#include "app/processes/worker_pool.h"
#include "app/ranks/rank_jobs.h"
#include "app/request/error_output.h"
#include "app/request/error_text.h"
#include "app/request/output_folder.h"
#include "app/scenes/load_scene.h"
#include "app/scenes/motion_of_scene.h"
#include "app/scenes/view_inputs.h"
#include "app/solving/part_files.h"
#include "app/solving/part_loads.h"
#include "app/solving/surface_view.h"
#include "app/variants/check_inputs.h"
#include "base/system/interrupts.h"
#include "base/system/mpi_run.h"
#include "base/system/processor_share.h"
#include "base/system/system_failure.h"
#include "base/values/stopwatch.h"
#include "elasticity/algebra/blas_space.h"
#include "loads/parts/part_loads.h"
#include "machine/bearings/bearing_life.h"
#include "mechanism/structure/structure.h"
#include "report/check/check_table.h"
#include "report/check/result_files.h"
#include "report/check/result_json.h"
#include "report/motion/motion_csv.h"
#include "report/page/report_page.h"
#include "report/parts/part_result_json.h"
#include "report/picture/part_picture.h"
#include "report/summary/motion_report.h"
#include "report/text/atomic_file.h"
#include "report/text/progress.h"
#include "report/text/terminal.h"
#include "report/view/view_files.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using assessment::PartJob;

constexpr char kResult = 'R';
constexpr char kRefusal = 'E';

/// Runs in a worker process or a rank: checks the part and writes its fields.
std::string check_one(const PartJob& job,
                      const std::function<CheckedPart()>& checked_part,
                      const FieldFiles& files, const elasticity::RankTeam* team,
                      const std::string& body, const fs::path& folder) {
  try {
    auto [last_job, assessment] = checked_part();
    Stopwatch watch;
    // Its fields pack while the picture is drawn, where memory suffices.
    const auto when = elasticity::take_blas_space(2) ? std::launch::async
                                                     : std::launch::deferred;
    auto fields = std::async(when, [&] {
      write_part_files(assessment, files, job.part.material.yield_strength,
                       folder);
    });
    if (files.moving) {
      report::write_file(folder / (job.part.name + "_loads.csv"),
                         loads_csv(job.load_sets.front().history));
    }
    const auto view = surface_view(last_job, assessment, files.moving, body);
    report::write_part_view(view, folder);
    report::write_part_picture(view, assessment.result, folder);
    fields.get();
    assessment.result.seconds.write = watch.lap();
    assessment.result.seconds.total += assessment.result.seconds.write;
    return kResult + report::encode(assessment.result);
  } catch (const Error& error) {
    return kRefusal + encode_error(error);
  } catch (const std::exception& failure) {
    const Error error = system_failure(failure, "part " + job.part.name);
    if (job.is_shared) {  // others may wait for this rank in a sum
      print_error(error, ErrorFormat::kText);
      team->abort(static_cast<int>(error.exit_code()));
    }
    return kRefusal + encode_error(error);
  }
}

/// Of a part whose check failed, so that a report shows it as it is and no bare
/// line between its joints.
void write_shape(const PartJob& job, const std::string& body,
                 const fs::path& folder) {
  try {
    report::write_part_view(shape_view(job, body), folder);
  } catch (const std::exception&) {  // a picture less; the failure is told
  }
}

/// Solid parts first: they take longest, and the last one to start decides
/// when all are done.
void longest_first(std::vector<PartJob>& jobs) {
  std::ranges::stable_sort(jobs, std::ranges::greater{}, [](const PartJob& j) {
    return j.mesh.cells.size() * j.mesh.degree;
  });
}

void take_outcome(const WorkerOutcome& outcome, const std::string& part,
                  report::CheckReport& report) {
  using enum WorkerOutcome::Kind;
  if (outcome.kind == kInterrupted) {
    report.complete = false;
  } else if (outcome.kind == kDied || outcome.text.empty()) {
    report.failures.push_back({part, error_of(outcome, "part " + part)});
  } else if (outcome.text.front() == kResult) {
    report.parts.push_back(
        report::decode_part_result(std::string_view(outcome.text).substr(1)));
  } else {
    report.failures.push_back(
        {part, decode_error(std::string_view(outcome.text).substr(1))});
  }
}

/// Processors that parts are checked on: `--jobs`, else all.
int processors(const Options& options) {
  const auto cores = std::max(1U, std::thread::hardware_concurrency());
  return options.jobs > 0 ? options.jobs : static_cast<int>(cores);
}

/// By processes, `--jobs` at a time, with progress on stderr.
/// @param at_work  processes that check a part.
/// @param stages   what each job's process is doing.
std::vector<WorkerOutcome> run_on_processes(
    const std::vector<PartJob>& jobs, const Options& options,
    const std::function<std::string(std::size_t)>& check, SharedCount& at_work,
    const std::vector<SharedText>& stages) {
  report::Progress progress;
  auto outcomes = run_workers(
      jobs.size(), processors(options), check,
      [&](std::size_t done, const std::vector<std::size_t>& running) {
        at_work.set(static_cast<int>(running.size()));
        std::string what;
        for (const std::size_t index : running) {
          const std::string stage = stages[index].get();
          what += (what.empty() ? "" : "; ") + jobs[index].part.name +
                  (stage.empty() ? "" : ": ") + stage;
        }
        progress.update(static_cast<int>(done), static_cast<int>(jobs.size()),
                        what);
      });
  progress.clear();
  return outcomes;
}

/// Progress of rank 0: what it is at itself, and how many parts all have done.
class RankProgress {
 public:
  void listen(std::vector<PartJob>& jobs) {
    total_ = static_cast<int>(jobs.size());
    for (PartJob& job : jobs) {
      job.listener = [this, name = job.part.name](const std::string& what) {
        progress_.update(done_, total_, name + ": " + what);
      };
    }
  }
  void finished(std::size_t parts) {
    done_ = static_cast<int>(parts);
    if (done_ == total_) progress_.clear();
  }

 private:
  report::Progress progress_;
  int done_ = 0, total_ = 0;
};

/// Checks all parts, on the ranks of a team if there is one; results in the
/// scene's order.
/// @return parts whose verdict what they are joined to has changed.
std::vector<std::string> check_parts(LoadedScene& loaded,
                                     const mechanism::Motion& motion,
                                     std::vector<PartJob> jobs,
                                     const Options& options,
                                     const elasticity::RankTeam* team,
                                     const fs::path& folder,
                                     report::CheckReport& report) {
  std::vector<std::string> order;
  for (const auto& job : jobs) order.push_back(job.part.name);
  longest_first(jobs);
  std::vector<SharedText> stages(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].listener = [&stage = stages[i]](const std::string& what) {
      stage.set(what);
    };
  }
  const auto carrier_of = [&](const PartJob& job) {
    const auto body = loaded.body_of(job.part.name);
    return body == mechanism::kGround
               ? ""
               : loaded.scene.mechanism.bodies[static_cast<std::size_t>(body)]
                     .name;
  };
  const auto check = [&](std::size_t index) {
    const auto checked_part = [&] {
      return check_on_finer_meshes(loaded, motion, jobs[index],
                                   {options.mesh_rounds, options.max_time});
    };
    const auto body = loaded.body_of(jobs[index].part.name);
    if (body == mechanism::kGround) {
      return check_one(jobs[index], checked_part,
                       {std::nullopt, options.linear_vtu}, team, "", folder);
    }
    return check_one(jobs[index], checked_part,
                     {MovingPart{&motion, body}, options.linear_vtu}, team,
                     carrier_of(jobs[index]), folder);
  };
  RankProgress rank_progress;
  SharedCount at_work(
      std::min(processors(options), static_cast<int>(jobs.size())));
  if (team != nullptr) {
    choose_shared(jobs);
    if (mpi_rank() > 0) leave_to_first_rank(loaded, jobs);
    if (mpi_rank() == 0) rank_progress.listen(jobs);
  } else {
    share_processors(processors(options), at_work);
  }
  const auto outcomes =
      team != nullptr ? run_on_ranks(*team, jobs, check,
                                     [&](std::size_t done) {
                                       rank_progress.finished(done);
                                     })
                      : run_on_processes(jobs, options, check, at_work, stages);
  if (mpi_rank() > 0) return {};
  report::remove_unfinished(folder);  // of workers that were stopped or died
  for (const auto& name : order) {
    const auto job = std::ranges::find(jobs, name, [](const PartJob& j) {
      return j.part.name;
    });
    const std::size_t failed = report.failures.size();
    take_outcome(outcomes[static_cast<std::size_t>(job - jobs.begin())], name,
                 report);
    if (report.failures.size() > failed) {
      write_shape(*job, carrier_of(*job), folder);
    }
  }
  return doubt_joined_parts(loaded.scene.mechanism, jobs, report.parts);
}

std::vector<std::string> moving_parts(const LoadedScene& loaded,
                                      const report::CheckReport& report) {
  std::vector<std::string> names;
  for (const auto& part : report.parts) {
    if (loaded.body_of(part.name) != mechanism::kGround) {
      names.push_back(part.name);
    }
  }
  return names;
}

void write_reactions(const LoadedScene& loaded, const mechanism::Motion& motion,
                     const fs::path& folder) {
  report::MotionReport motion_report;
  motion_report.definition = loaded.scene.mechanism;
  motion_report.motion = motion;
  report::write_file(folder / "reactions.csv",
                     report::reactions_csv(motion_report));
}

/// Times at which parts are worst [s].
std::vector<double> worst_times(const report::CheckReport& report) {
  std::vector<double> times;
  for (const auto& part : report.parts) {
    times.push_back(judged_peak(part).instant);
    times.push_back(part.deflection_instant);
    times.push_back(part.buckling.instant);
  }
  return times;
}

}  // namespace

ExitCode run_check(const Options& options, scene::Scene scene) {
  Stopwatch total;
  Stopwatch watch;
  report::CheckReport report;
  report.version = CLEVIS_VERSION;
  report.inputs = check_inputs(options, scene);
  LoadedScene loaded = load_scene(std::move(scene));
  require_parts(loaded, options.parts);
  const fs::path folder = output_folder(options);
  std::optional<FolderLock> lock;
  if (mpi_rank() == 0) {
    lock.emplace(folder);
    // A browser that shows the report of a watched check would lose it.
    remove_previous_run(folder, options.watch_run && options.report
                                    ? OldReport::kKeep
                                    : OldReport::kRemove);
  }
  report.scene = loaded.scene.name;
  report.file = options.scene;
  report.seconds.emplace_back("scene_and_meshes", watch.lap());
  add_link_compliances(loaded);

  mechanism::Motion motion;
  if (loaded.scene.has_mechanism) {
    motion = motion_of_scene(loaded.scene, options);
    report.mechanism = report::summarise(
        loaded.scene.mechanism,
        mechanism::analyse_structure(loaded.scene.mechanism), motion);
    report.bearings = report::bearing_reports(
        machine::judge_bearings(loaded.scene.bearings, loaded.scene.mechanism,
                                motion),
        loaded.scene.mechanism);
  }
  report.seconds.emplace_back("mechanism", watch.lap());

  const mechanism::Motion loading = loads::loading_motion(motion);
  std::vector<PartJob> jobs =
      part_jobs(loaded, loading, options.parts,
                options.tolerance.value_or(loaded.scene.peak_stress_tolerance));
  for (auto& job : jobs) {
    job.model = assessment::find_model(options.model);
    job.engine = elasticity::find_engine(options.engine).value();
    job.max_dofs = options.max_dofs;
    report.limits.emplace(job.part.name, job.part.limits);
  }
  report.seconds.emplace_back("loads", watch.lap());

  std::optional<elasticity::RankTeam> team;
  if (mpi_ranks() > 1) team.emplace();
  std::optional<InterruptGuard> guard;  // ranks are mpirun's to end
  if (!team) guard.emplace();
  const auto changed = check_parts(loaded, loading, std::move(jobs), options,
                                   team ? &*team : nullptr, folder, report);
  if (mpi_rank() > 0) return ExitCode::kPass;  // the first one tells
  report.seconds.emplace_back("parts", watch.lap());

  const auto moving = moving_parts(loaded, report);
  if (!moving.empty()) write_mechanism_series(moving, loading, folder);
  if (loaded.scene.has_mechanism) {
    write_reactions(loaded, motion, folder);
  }
  report::write_motion_view({.version = CLEVIS_VERSION,
                             .scene = loaded.scene.name,
                             .inputs = view_inputs(loaded.scene),
                             .definition = loaded.scene.mechanism,
                             .motion = motion,
                             .worst_times = worst_times(report)},
                            folder, report::ResultKind::kCheck);
  report.seconds.emplace_back("total", total.lap());
  report::write_result_files(report, folder);
  draw_anew(changed, folder);
  if (!report.complete && options.watch_run) return kInterruptedExit;
  // A report that fails does not swallow the verdict; JSON is one document,
  // that of the failure.
  if (!options.json) {
    std::cout << report::check_table(report, report::colour_of(STDOUT_FILENO))
              << std::flush;
  }
  if (options.report) {
    tell_report(report::write_report(folder, report::ResultKind::kCheck,
                                     options.watch_run));
  }
  if (options.json) std::cout << report::result_json(report);
  if (!report.complete) return kInterruptedExit;
  return report::exit_code(report);
}

}  // namespace clevis::app
