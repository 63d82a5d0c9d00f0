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

#include "benchmarks/mujoco_linkage.h"
#include "benchmarks/mujoco_mechanisms.h"
#include "benchmarks/precision_row.h"
#include "benchmarks/reference_trajectories.h"
#include "support/planar_linkages.h"

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

void measure(const Request& request, const MujocoMechanism& mechanism,
             const Course& course, const Method& method) {
  const double between = course.duration / (course.instants - 1);
  // as many steps as take some seconds
  const long most = mechanism.model().neq > 0 ? 400000 : 1000000;
  for (const double h : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    if (h > 0.1 * between) continue;
    const long steps_between = std::lround(between / h);
    PrecisionRow row;
    row.problem = course.name;
    row.method = method.name;
    row.setting = "h = " + power_of_ten(h) + " s";
    if (!request.wants(row.method, row.setting)) continue;
    row.steps = steps_between * (course.instants - 1);
    row.implicit_steps = method.integrator == mjINT_IMPLICIT ? row.steps : 0;
    row.evaluations = row.steps * (method.integrator == mjINT_RK4 ? 4 : 1);
    if (row.evaluations > most) return;
    prepare(mechanism.model(), method, h);
    std::vector<Sample> samples;
    row.seconds = request.seconds([&] {
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

template <class Mechanism, class... Values>
void measure_all(const Request& request, const Course& course,
                 const Values&... values) {
  if (!request.wants(course.name)) return;
  const Mechanism mechanism(values...);
  for (const Method& method : kMethods) {
    const bool loops = mechanism.model().neq > 0;
    if (!loops && !method.stiff) continue;  // nothing to soften
    measure(request, mechanism, course, method);
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace clevis::mechanism::testing;
  const Request request(argc, argv);
  print_header();
  mju_user_warning = [](const char*) {};
  measure_all<MujocoPendulum>(request, pendulum_course());
  measure_all<MujocoFourBar>(request, four_bar_course());
  measure_all<MujocoLinkage>(request, crank_rocker_course(), crank_rocker());
  measure_all<MujocoSliderCrank>(request, slider_crank_course());
  measure_all<MujocoGovernor>(request, governor_course());
  measure_all<MujocoBricard>(request, bricard_course());
  measure_all<MujocoLinkage>(request, andrews_course(), andrews());
  measure_all<MujocoLinkage>(request, cart_pole_course(), light_cart_pole());
}
