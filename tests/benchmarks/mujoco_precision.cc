// The mechanisms of work_precision.cc in MuJoCo 2.2.2, beside which it prints
// the same columns, over its fixed steps. Its constraints are soft: as stiff as
// it allows with solref = "2h 1", solimp 0.9999, and as they come ("defaults").
// Time is that of the motion, without compiling the scene. Built where MuJoCo
// is installed (libmujoco-dev).
//
//     cmake --build --preset release --target mujoco_precision
//     build/release/tests/benchmarks/mujoco_precision [NAME]... > table.csv
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/mujoco_mechanisms.h"
#include "benchmarks/precision_row.h"
#include "benchmarks/reference_trajectories.h"

using namespace clevis::benchmarks;

namespace {

struct Method {
  const char* name;
  int integrator;
  bool stiff;  ///< constraints as stiff as they can be
};

const Method kMethods[] = {
    {"MuJoCo 2.2.2 RK4 (2h)", mjINT_RK4, true},
    {"MuJoCo 2.2.2 RK4 (defaults)", mjINT_RK4, false},
    {"MuJoCo 2.2.2 Euler (2h)", mjINT_EULER, true},
    {"MuJoCo 2.2.2 implicit (2h)", mjINT_IMPLICIT, true}};

void prepare(mjModel& model, const Method& method, double h) {
  model.opt.timestep = h;
  model.opt.integrator = method.integrator;
  mjtNum reference[mjNREF], impedance[mjNIMP];
  mj_defaultSolRefImp(reference, impedance);
  if (method.stiff) {
    reference[0] = 2.0 * h;
    reference[1] = 1.0;
    impedance[0] = impedance[1] = 0.9999;
  }
  for (int i = 0; i < model.neq; ++i) {
    std::copy(reference, reference + mjNREF, model.eq_solref + mjNREF * i);
    std::copy(impedance, impedance + mjNIMP, model.eq_solimp + mjNIMP * i);
  }
}

std::vector<Sample> run(const MujocoMechanism& mechanism, const Course& course,
                        long steps_between) {
  mechanism.reset();
  std::vector<Sample> samples{mechanism.sample()};
  for (int i = 1; i < course.instants; ++i) {
    for (long k = 0; k < steps_between; ++k) {
      mj_step(&mechanism.model(), &mechanism.data());
    }
    samples.push_back(mechanism.sample());
  }
  return samples;
}

void measure(const MujocoMechanism& mechanism, const Course& course,
             const Method& method) {
  const double between = course.duration / (course.instants - 1);
  // as many steps as take some seconds
  const long most = mechanism.model().neq > 0 ? 400000 : 1000000;
  for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const long steps_between = std::lround(between / h);
    PrecisionRow row;
    row.problem = course.name;
    row.method = method.name;
    row.setting = "h = " + power_of_ten(h) + " s";
    row.steps = steps_between * (course.instants - 1);
    row.implicit_steps = method.integrator == mjINT_IMPLICIT ? row.steps : 0;
    row.evaluations = row.steps * (method.integrator == mjINT_RK4 ? 4 : 1);
    if (row.evaluations > most) return;
    prepare(mechanism.model(), method, h);
    std::vector<Sample> samples;
    row.seconds = least_seconds([&] {
      samples = run(mechanism, course, steps_between);
    });
    if (mechanism.data().warning[mjWARN_BADQACC].number > 0 ||
        mechanism.data().warning[mjWARN_BADQVEL].number > 0 ||
        mechanism.data().warning[mjWARN_BADQPOS].number > 0) {
      print_failure(row.problem, row.method, row.setting, "unstable");
    } else {
      row.errors = errors(course, samples);
      print(row);
    }
  }
}

void measure_all(const MujocoMechanism& mechanism, const Course& course) {
  for (const Method& method : kMethods) {
    const bool loops = mechanism.model().neq > 0;
    if (!loops && !method.stiff) continue;  // nothing to soften
    measure(mechanism, course, method);
  }
}

}  // namespace

int main(int argc, char** argv) {
  print_header();
  mju_user_warning = [](const char*) {};
  if (wanted("pendulum", argc, argv)) {
    measure_all(MujocoPendulum(), pendulum_course());
  }
  if (wanted("two_window_four_bar", argc, argv)) {
    measure_all(MujocoFourBar(), four_bar_course());
  }
  if (wanted("spatial_slider_crank", argc, argv)) {
    measure_all(MujocoSliderCrank(), slider_crank_course());
  }
  if (wanted("governor", argc, argv)) {
    measure_all(MujocoGovernor(), governor_course());
  }
  if (wanted("bricard", argc, argv)) {
    measure_all(MujocoBricard(), bricard_course());
  }
}
