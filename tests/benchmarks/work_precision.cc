// Work against precision of integrated motions: for each problem, method and
// tolerance the processor time of simulate() (least of several), steps,
// evaluations of the accelerations, and the errors against reference values.
//
//     cmake --build --preset release --target work_precision
//     build/release/tests/benchmarks/work_precision [NAME]... > table.csv
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "mechanism/simulate.h"
#include "support/benchmark_mechanisms.h"

using namespace clevis;
using namespace clevis::mechanism;
using namespace clevis::mechanism::testing;

namespace {

struct Problem {
  std::string name;
  MechanismDefinition definition;
  double duration{};
  int instants{};
  /// Error of positions against the reference [m], and of what is known of
  /// reactions or branches; < 0: not known.
  std::function<double(const Motion&)> position, reaction, branch;
};

double none(const Motion&) {
  return -1.0;
}

Eigen::Vector2d tip(const Instant& instant) {
  const Pose& pose = instant.bodies[0].pose;
  return (pose.p_WL + pose.R_WL.col(0)).head<2>();
}

std::function<double(const Motion&)> tip_error(
    const std::vector<Eigen::Vector2d>& known) {
  return [known](const Motion& motion) {
    const std::size_t at[] = {1, 5, 10};
    double error = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      error = std::max(error, (tip(motion.instants[at[i]]) - known[i]).norm());
    }
    return error;
  };
}

double pin_error(const Motion& motion) {
  double error = 0.0;
  for (const Instant& i : motion.instants) {
    error = std::max(error, std::abs(i.joints[0].f_W.norm() -
                                     3.0 * 9.81 * std::abs(tip(i).y())));
  }
  return error;
}

double branch_error(const Motion& motion) {
  double error = 0.0;
  for (const Instant& i : motion.instants) {
    for (std::size_t k = 1; k < 3; ++k) {
      error = std::max(
          error,
          (i.bodies[k].pose.R_WL - i.bodies[0].pose.R_WL).norm() / M_SQRT2);
    }
  }
  return error;
}

double slider_error(const Motion& motion) {
  const double known[] = {0.226787189, 0.184952630, 0.211721661, 0.240719574};
  const std::size_t at[] = {1, 5, 10, 50};
  double error = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    error = std::max(
        error,
        std::abs(motion.instants[at[i]].bodies[2].pose.p_WL.x() - known[i]));
  }
  return error;
}

/// Depth of the sleeve every two seconds, against equations of its own.
double sleeve_error(const Motion& motion) {
  static const std::vector<double> known = [] {
    GovernorEquations equations({});
    std::vector<double> depths;
    for (int i = 0; i < 5; ++i) {
      equations.advance(2.0, 400000);
      depths.push_back(equations.depth());
    }
    return depths;
  }();
  double error = 0.0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const Instant& at = motion.instants[2 * (i + 1)];
    error = std::max(error, std::abs(-at.bodies[1].pose.p_WL.z() - known[i]));
  }
  return error;
}

/// Residual of Bricard's closed form cos θ + cos φ + cos θ cos φ = 0, θ and φ
/// between bars that follow one another.
double bricard_error(const Motion& motion) {
  double error = 0.0;
  for (const Instant& i : motion.instants) {
    const auto along = [&i](std::size_t bar) {
      return Eigen::Vector3d(i.bodies[bar].pose.R_WL.col(0));
    };
    const double a = along(0).dot(along(1)), b = along(1).dot(along(2));
    error = std::max(error, std::abs(a + b + a * b));
  }
  return error;
}

double event_error(const Motion& motion, const std::vector<double>& known) {
  double error = 0.0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (i >= motion.events.size()) return 1.0;
    error = std::max(error, std::abs(motion.events[i].t - known[i]));
  }
  return error;
}

std::vector<Problem> problems() {
  std::vector<Problem> all;
  all.push_back({"pendulum", simple_pendulum(1.0), 10.0, 11,
                 tip_error({{0.986291751131875, -0.165010853125541},
                            {-0.942305435043757, -0.334754338414001},
                            {-0.275087462576117, -0.961419205099125}}),
                 pin_error, none});
  all.push_back({"two_window_four_bar", two_window_four_bar(), 10.0, 11,
                 tip_error({{-0.195020301949, -0.980799205662},
                            {-0.811310461004, -0.584615545351},
                            {0.328458111539, 0.944518538179}}),
                 none, branch_error});
  all.push_back({"spatial_slider_crank", spatial_slider_crank(), 5.0, 51,
                 slider_error, none, none});
  all.push_back({"governor", governor(), 10.0, 11, sleeve_error, none, none});
  all.push_back({"bricard", bricard(), 10.0, 11, none, none, bricard_error});
  all.push_back({"stick_slip", pulled({.breakaway = 1.5, .kinetic = 1.0}), 25.0,
                 251,
                 [](const Motion& m) {
                   return event_error(
                       m, {7.5, 7.5 + 2.611259254101, 12.5 + 2.611259254101});
                 },
                 none, none});
  all.push_back({"lugre", pulled(bristles()), 25.0, 26,
                 [](const Motion& m) {
                   return std::abs(m.instants.back().bodies[1].pose.p_WL.x() -
                                   1.908839199);
                 },
                 none, none});
  // first touch; then the closed form of contact and flight
  all.push_back({"wall_1e8", against_a_wall({.stiffness = 1e8}), 3.0, 31,
                 [](const Motion& m) {
                   const double w = std::sqrt(100.0),
                                wc = std::sqrt(1e8 + 100.0);
                   double t = M_PI / (2.0 * w);
                   std::vector<double> known;
                   for (int i = 0; i < 9; ++i) {
                     known.push_back(t);
                     known.push_back(t += M_PI / wc);
                     t += M_PI / w;
                   }
                   return event_error(m, known);
                 },
                 none, none});
  return all;
}

double seconds(const std::function<void()>& run, int repeats) {
  double least = 1e300;
  for (int i = 0; i < repeats; ++i) {
    timespec a{}, b{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &a);
    run();
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &b);
    least =
        std::min(least, static_cast<double>(b.tv_sec - a.tv_sec) +
                            1e-9 * static_cast<double>(b.tv_nsec - a.tv_nsec));
  }
  return least;
}

void print(double value) {
  if (value < 0.0) {
    std::printf(",");
  } else {
    std::printf(",%.2e", value);
  }
}

void measure(const Problem& problem, IntegratorChoice choice,
             const char* name) {
  for (const double tolerance :
       {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    SimulationSettings settings;
    settings.duration = problem.duration;
    settings.instants = problem.instants;
    settings.tolerance = tolerance;
    settings.motion = MotionKind::kDynamic;
    settings.integrator = choice;
    try {
      Motion motion;
      double time = seconds(
          [&] {
            motion = simulate(problem.definition, settings);
          },
          1);
      const int repeats = time < 0.05 ? 10 : 2;
      time = std::min(time, seconds(
                                [&] {
                                  motion =
                                      simulate(problem.definition, settings);
                                },
                                repeats));
      double gap = 0.0;
      for (const Instant& i : motion.instants) {
        gap = std::max(gap, i.closure_error);
      }
      const IntegrationSummary& run = *motion.integration;
      std::printf("%s,%s,%.0e,%.3f,%ld,%ld,%ld,%ld", problem.name.c_str(), name,
                  tolerance, 1e3 * time, run.steps, run.implicit_steps,
                  run.rejected, run.evaluations);
      print(problem.position(motion));
      print(run.energy_error);
      print(gap);
      print(problem.reaction(motion));
      print(problem.branch(motion));
      std::printf("\n");
    } catch (const Error& error) {
      std::printf("%s,%s,%.0e,%s\n", problem.name.c_str(), name, tolerance,
                  error.code().c_str());
    }
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::printf(
      "problem,method,tolerance,cpu_ms,steps,implicit_steps,rejected,"
      "evaluations,position_or_time_error,energy_error_J,gap_m,"
      "reaction_error_N,branch_error_rad\n");
  for (const Problem& problem : problems()) {
    bool wanted = argc == 1;
    for (int i = 1; i < argc; ++i) wanted = wanted || problem.name == argv[i];
    if (!wanted) continue;
    measure(problem, IntegratorChoice::kAuto, "auto");
    measure(problem, IntegratorChoice::kExplicit, "DOP853");
    measure(problem, IntegratorChoice::kImplicit, "Radau IIA");
  }
}
