// The mechanisms of work_precision.cc in Simbody 3.7, beside which it prints
// the same columns. Time is that of initialize() and of the motion, without
// building the system. Built where Simbody is installed (libsimbody-dev).
//
//     cmake --build --preset release --target simbody_precision
//     OPENBLAS_NUM_THREADS=1 \
//       build/release/tests/benchmarks/simbody_precision [NAME]... > table.csv
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <Simbody.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "benchmarks/precision_row.h"
#include "benchmarks/reference_trajectories.h"
#include "benchmarks/simbody_mechanisms.h"

using namespace clevis::benchmarks;

namespace {

constexpr rlim_t kMostSeconds = 10;

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
void measure_one(const SimbodyMechanism& mechanism, const Course& course,
                 Method method, double accuracy) {
  PrecisionRow row;
  row.problem = course.name;
  row.method = name_of(method);
  row.setting = power_of_ten(accuracy);
  try {
    std::vector<Sample> samples;
    row.seconds = least_seconds([&] {
      samples = run(mechanism, course, method, accuracy, row);
    });
    row.errors = errors(course, samples);
    print(row);
  } catch (const std::exception&) {
    print_failure(row.problem, row.method, row.setting, "stopped");
  }
}

/// In a process of its own for each accuracy, as some runs do not end.
void measure(const SimbodyMechanism& mechanism, const Course& course,
             Method method) {
  for (int exponent = 3; exponent <= 10; ++exponent) {
    const double accuracy = std::pow(10.0, -exponent);
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
      const rlimit most{kMostSeconds, kMostSeconds};
      setrlimit(RLIMIT_CPU, &most);
      measure_one(mechanism, course, method, accuracy);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFEXITED(status)) {
      print_failure(course.name, name_of(method), power_of_ten(accuracy),
                    "over " + std::to_string(kMostSeconds) + " s");
      return;
    }
  }
}

void measure_all(const SimbodyMechanism& mechanism, const Course& course) {
  measure(mechanism, course, Method::kMerson);
  if (course.name == "two_window_four_bar") {
    measure(mechanism, course, Method::kMersonDefaults);
  }
  measure(mechanism, course, Method::kBdf);
}

}  // namespace

int main(int argc, char** argv) {
  print_header();
  if (wanted("pendulum", argc, argv)) {
    measure_all(SimbodyPendulum(), pendulum_course());
  }
  if (wanted("two_window_four_bar", argc, argv)) {
    measure_all(SimbodyFourBar(), four_bar_course());
  }
  if (wanted("spatial_slider_crank", argc, argv)) {
    measure_all(SimbodySliderCrank(), slider_crank_course());
  }
  if (wanted("governor", argc, argv)) {
    measure_all(SimbodyGovernor(), governor_course());
  }
  if (wanted("bricard", argc, argv)) {
    measure_all(SimbodyBricard(), bricard_course());
  }
}
