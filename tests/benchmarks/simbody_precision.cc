// The mechanisms of work_precision.cc in Simbody 3.7, beside which it prints
// the same columns. Time is that of initialize() and of the motion, without
// building the system. Built where Simbody is installed (libsimbody-dev).
//
//     cmake --build --preset release --target simbody_precision
//     OPENBLAS_NUM_THREADS=1 \
//       build/release/tests/benchmarks/simbody_precision [NAME]... > table.csv
//
// precision_row.h says what else it takes.
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <Simbody.h>

#include "benchmarks/limited_run.h"
#include "benchmarks/precision_row.h"
#include "benchmarks/reference_trajectories.h"
#include "benchmarks/simbody_linkage.h"
#include "benchmarks/simbody_mechanisms.h"
#include "support/planar_linkages.h"

using namespace clevis::benchmarks;

namespace {

constexpr int kMostSeconds = 10;

enum class Method {
  kMerson,          ///< explicit, order 4, constraints projected every step
  kMersonDefaults,  ///< the same as it comes
  kBdf              ///< CPodes: implicit, constraints projected every step
};

const char* name_of(Method method) {
  switch (method) {
    case Method::kMerson:
      return "Simbody 3.7 Merson";
    case Method::kMersonDefaults:
      return "Simbody 3.7 Merson (defaults)";
    case Method::kBdf:
      return "Simbody 3.7 CPodes BDF";
  }
  return "";
}

std::unique_ptr<SimTK::Integrator> integrator_of(
    Method method, double accuracy, const SimTK::MultibodySystem& system) {
  std::unique_ptr<SimTK::Integrator> integrator;
  if (method == Method::kBdf) {
    integrator = std::make_unique<SimTK::CPodesIntegrator>(
        system, SimTK::CPodes::BDF, SimTK::CPodes::Newton);
  } else {
    integrator = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  }
  integrator->setAccuracy(accuracy);
  if (method != Method::kMersonDefaults) {
    integrator->setConstraintTolerance(1e-3 * accuracy);
    integrator->setProjectEveryStep(true);
  }
  return integrator;
}

/// @returns samples; counts go to `row`.
std::vector<Sample> run(const SimbodyMechanism& mechanism, const Course& course,
                        Method method, double accuracy, PrecisionRow& row) {
  const auto integrator = integrator_of(method, accuracy, mechanism.system());
  SimTK::TimeStepper stepper(mechanism.system(), *integrator);
  stepper.initialize(mechanism.start());
  std::vector<Sample> samples{mechanism.sample(integrator->getState())};
  for (int i = 1; i < course.instants; ++i) {
    stepper.stepTo(course.duration * i / (course.instants - 1));
    samples.push_back(mechanism.sample(integrator->getState()));
  }
  row.steps = integrator->getNumStepsTaken();
  row.implicit_steps = method == Method::kBdf ? row.steps : 0;
  row.rejected = integrator->getNumStepsAttempted() - row.steps;
  row.evaluations = integrator->getNumRealizations();
  return samples;
}

/// Prints one row, or none where the processor time runs out.
void measure_one(const Request& request, const SimbodyMechanism& mechanism,
                 const Course& course, Method method, double accuracy) {
  PrecisionRow row;
  row.problem = course.name;
  row.method = name_of(method);
  row.setting = power_of_ten(accuracy);
  try {
    std::vector<Sample> samples;
    row.seconds = request.seconds([&] {
      samples = run(mechanism, course, method, accuracy, row);
    });
    row.errors = errors(course, samples);
    print(row);
  } catch (const std::exception&) {
    print_failure(row.problem, row.method, row.setting, "stopped");
  }
}

/// In a process of its own for each accuracy, as some runs do not end.
void measure(const Request& request, const SimbodyMechanism& mechanism,
             const Course& course, Method method) {
  for (int exponent = 3; exponent <= 10; ++exponent) {
    const double accuracy = std::pow(10.0, -exponent);
    if (!request.wants(name_of(method), power_of_ten(accuracy))) continue;
    const bool ended = finishes(kMostSeconds, [&] {
      measure_one(request, mechanism, course, method, accuracy);
    });
    if (!ended) {
      print_failure(course.name, name_of(method), power_of_ten(accuracy),
                    "over " + std::to_string(kMostSeconds) + " s");
      return;
    }
  }
}

template <class Mechanism, class... Values>
void measure_all(const Request& request, const Course& course,
                 const Values&... values) {
  if (!request.wants(course.name)) return;
  const Mechanism mechanism(values...);
  measure(request, mechanism, course, Method::kMerson);
  if (course.name == "two_window_four_bar") {
    measure(request, mechanism, course, Method::kMersonDefaults);
  }
  measure(request, mechanism, course, Method::kBdf);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace clevis::mechanism::testing;
  const Request request(argc, argv);
  print_header();
  measure_all<SimbodyPendulum>(request, pendulum_course());
  measure_all<SimbodyFourBar>(request, four_bar_course());
  measure_all<SimbodyLinkage>(request, crank_rocker_course(), crank_rocker());
  measure_all<SimbodySliderCrank>(request, slider_crank_course());
  measure_all<SimbodyGovernor>(request, governor_course());
  measure_all<SimbodyBricard>(request, bricard_course());
  measure_all<SimbodyLinkage>(request, andrews_course(), andrews());
  measure_all<SimbodyLinkage>(request, cart_pole_course(), light_cart_pole());
}
