// Work against precision of integrated motions: for each problem, method and
// tolerance the processor time of simulate() (least of several), steps,
// evaluations of the accelerations, and the errors against reference values.
// A method's tolerances end where a run takes longer than three seconds.
//
//     cmake --build --preset release --target work_precision
//     build/release/tests/benchmarks/work_precision [NAME]... > table.csv
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/messages/errors.h"
#include "benchmarks/precision_row.h"
#include "benchmarks/reference_trajectories.h"
#include "mechanism/simulate.h"
#include "support/benchmark_mechanisms.h"
#include "support/landing_gear.h"
#include "support/planar_definition.h"
#include "support/planar_linkages.h"

using namespace clevis;
using namespace clevis::benchmarks;
using namespace clevis::mechanism;
using namespace clevis::mechanism::testing;

namespace {

struct Problem {
  std::string name;
  MechanismDefinition definition;
  double duration{};
  int instants{};
  std::function<TrajectoryErrors(const Motion&)> errors;
};

/// A problem whose errors follow from what `sample` takes from each instant.
Problem followed(const Course& course, const MechanismDefinition& definition,
                 const std::function<void(const Instant&, Sample&)>& sample) {
  return {course.name, definition, course.duration, course.instants,
          [course, sample](const Motion& motion) {
            std::vector<Sample> samples(motion.instants.size());
            for (std::size_t i = 0; i < samples.size(); ++i) {
              samples[i].gap = motion.instants[i].closure_error;
              sample(motion.instants[i], samples[i]);
            }
            return errors(course, samples);
          }};
}

/// End of the first bar, force in its pin.
void sample_tip(const Instant& at, Sample& sample) {
  const Pose& pose = at.bodies[0].pose;
  sample.point = pose.p_WL + pose.R_WL.col(0);
  sample.pin = at.joints[0].f_W.norm();
}

/// Largest angle between upright bars.
void sample_four_bar(const Instant& at, Sample& sample) {
  sample_tip(at, sample);
  for (std::size_t k = 1; k < 3; ++k) {
    const double apart =
        (at.bodies[k].pose.R_WL - at.bodies[0].pose.R_WL).norm();
    sample.branch = std::max(sample.branch, apart / M_SQRT2);
  }
}

/// Residual of the closed form cos θ + cos φ + cos θ cos φ = 0, θ and φ
/// between bars that follow one another.
void sample_bricard(const Instant& at, Sample& sample) {
  const auto along = [&at](std::size_t bar) {
    return Eigen::Vector3d(at.bodies[bar].pose.R_WL.col(0));
  };
  const double a = along(0).dot(along(1)), b = along(1).dot(along(2));
  sample.point = at.bodies[3].pose.p_WL;
  sample.branch = std::abs(a + b + a * b);
}

/// Where `linkage` says what is compared.
Problem planar(const Course& course, const PlanarLinkage& linkage) {
  return followed(
      course, definition_of(linkage),
      [linkage](const Instant& at, Sample& sample) {
        const auto body = [&at](int i) {
          return at.bodies[static_cast<std::size_t>(i)].pose;
        };
        sample.point = body(linkage.pointer).R_WL.col(0);
        if (linkage.slider >= 0) {
          sample.point.z() = body(linkage.slider).p_WL.x();
        }
        sample.pin =
            at.joints[static_cast<std::size_t>(linkage.watched)].f_W.norm();
      });
}

/// A problem known by its events [s].
Problem timed(const std::string& name, const MechanismDefinition& definition,
              double duration, int instants, const std::vector<double>& known) {
  return {name, definition, duration, instants, [known](const Motion& motion) {
            TrajectoryErrors worst;
            for (std::size_t i = 0; i < known.size(); ++i) {
              const double t =
                  i < motion.events.size() ? motion.events[i].t : INFINITY;
              worst.position = std::max(worst.position, std::abs(t - known[i]));
            }
            return worst;
          }};
}

/// First touch; then the closed form of contact and flight.
std::vector<double> wall_events() {
  const double w = std::sqrt(100.0), wc = std::sqrt(1e8 + 100.0);
  double t = M_PI / (2.0 * w);
  std::vector<double> known;
  for (int i = 0; i < 9; ++i) {
    known.push_back(t);
    known.push_back(t += M_PI / wc);
    t += M_PI / w;
  }
  return known;
}

std::vector<Problem> problems() {
  const double slip = 2.611259254101;
  return {followed(pendulum_course(), simple_pendulum(1.0), sample_tip),
          followed(four_bar_course(), two_window_four_bar(), sample_four_bar),
          followed(slider_crank_course(), spatial_slider_crank(),
                   [](const Instant& at, Sample& sample) {
                     sample.point.x() = at.bodies[2].pose.p_WL.x();
                   }),
          followed(governor_course(), governor(),
                   [](const Instant& at, Sample& sample) {
                     sample.point.z() = at.bodies[1].pose.p_WL.z();
                   }),
          followed(bricard_course(), bricard(), sample_bricard),
          planar(andrews_course(), andrews()),
          planar(cart_pole_course(), light_cart_pole()),
          planar(crank_rocker_course(), crank_rocker()),
          timed("stick_slip", pulled({.breakaway = 1.5, .kinetic = 1.0}), 25.0,
                251, {7.5, 7.5 + slip, 12.5 + slip}),
          {"lugre", pulled(bristles()), 25.0, 26,
           [](const Motion& motion) {
             TrajectoryErrors worst;
             worst.position = std::abs(
                 motion.instants.back().bodies[1].pose.p_WL.x() - 1.908839199);
             return worst;
           }},
          timed("wall_1e8", against_a_wall({.stiffness = 1e8}), 3.0, 31,
                wall_events())};
}

void measure(const Request& request, const Problem& problem,
             numerics::IntegratorChoice choice, const char* name) {
  const int last = choice == numerics::IntegratorChoice::kAuto ? 12 : 10;
  for (int exponent = 3; exponent <= last; ++exponent) {
    SimulationSettings settings;
    settings.duration = problem.duration;
    settings.instants = problem.instants;
    settings.tolerance = std::pow(10.0, -exponent);
    settings.motion = MotionKind::kDynamic;
    settings.integrator = choice;
    const std::string setting = power_of_ten(settings.tolerance);
    if (!request.wants(name, setting)) continue;
    try {
      Motion motion;
      const double time = request.seconds([&] {
        motion = simulate(problem.definition, settings);
      });
      const IntegrationSummary& run = *motion.integration;
      PrecisionRow row{problem.name,
                       name,
                       setting,
                       time,
                       run.steps,
                       run.implicit_steps,
                       run.rejected,
                       run.evaluations,
                       problem.errors(motion)};
      row.errors.energy = run.energy_error;
      print(row);
      if (time > 3.0) return;
    } catch (const Error& error) {
      print_failure(problem.name, name, setting, error.code());
    }
  }
}

/// The landing gear's stroke by kinematics and inverse dynamics: time of one
/// of 2001 instants, with all its reactions and output.
void measure_stroke(const Request& request) {
  SimulationSettings settings;
  settings.duration = 2.0;
  settings.instants = 2001;
  Motion motion;
  const double time = request.seconds([&] {
    motion = simulate(landing_gear(), settings);
  });
  const auto count = static_cast<double>(motion.instants.size());
  PrecisionRow row{"landing_gear_stroke",
                   "clevis inverse dynamics",
                   std::to_string(motion.instants.size()) + " instants",
                   time / count,
                   -1,
                   -1,
                   -1,
                   -1,
                   {}};
  for (const Instant& at : motion.instants) {
    row.errors.gap = std::max(row.errors.gap, at.closure_error);
  }
  print(row);
}

}  // namespace

int main(int argc, char** argv) {
  const Request request(argc, argv);
  print_header();
  for (const Problem& problem : problems()) {
    if (!request.wants(problem.name)) continue;
    measure(request, problem, numerics::IntegratorChoice::kAuto, "clevis");
    measure(request, problem, numerics::IntegratorChoice::kExplicit,
            "clevis DOP853");
    measure(request, problem, numerics::IntegratorChoice::kImplicit,
            "clevis Radau IIA");
  }
  if (request.wants("landing_gear_stroke")) measure_stroke(request);
}
