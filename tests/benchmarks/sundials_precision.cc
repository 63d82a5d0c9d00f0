// The mechanisms of work_precision.cc by SUNDIALS 6.4, which integrates
// equations that someone else writes: planar mechanisms in their bodies'
// coordinates with all joints as constraints (sundials_problems.h), the
// governor and Bricard's loop in the few coordinates of their closed forms.
// Prints the same columns. Built where it is installed (libsundials-dev).
//
//     cmake --build --preset release --target sundials_precision
//     build/release/tests/benchmarks/sundials_precision [NAME]... > table.csv
//
// precision_row.h says what else it takes.
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "benchmarks/limited_run.h"
#include "benchmarks/precision_row.h"
#include "benchmarks/sundials_problems.h"
#include "support/planar_linkages.h"

using namespace clevis::benchmarks;

namespace {

constexpr int kMostSeconds = 10;
constexpr long kMostSteps = 10'000'000;  // between outputs

using Vector = Eigen::VectorXd;
using Samples = std::vector<Sample>;

void check(int flag, const char* what) {
  if (flag < 0) throw std::runtime_error(what);
}

Eigen::Map<Vector> view(N_Vector v) {
  return {N_VGetArrayPointer(v), Eigen::Index(N_VGetLength(v))};
}

/// What every run needs of the library.
struct Workspace {
  explicit Workspace(const Vector& start) {
    SUNContext_Create(nullptr, &context);
    y = N_VNew_Serial(start.size(), context);
    view(y) = start;
    matrix = SUNDenseMatrix(start.size(), start.size(), context);
    solver = SUNLinSol_Dense(y, matrix, context);
  }
  ~Workspace() {
    SUNLinSolFree(solver);
    SUNMatDestroy(matrix);
    N_VDestroy(y);
    SUNContext_Free(&context);
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  SUNContext context{};
  N_Vector y{};
  SUNMatrix matrix{};
  SUNLinearSolver solver{};
};

const Equations& of(void* data) {
  return *static_cast<Equations*>(data);
}

int rates(realtype, N_Vector y, N_Vector dy, void* data) {
  view(dy) = of(data).rates(view(y));
  return view(dy).allFinite() ? 0 : 1;
}

/// For CVODE: the way back to the constraints.
int project(realtype, N_Vector y, N_Vector correction, realtype, N_Vector,
            void* data) {
  view(correction) = of(data).projected(view(y)) - view(y);
  return 0;
}

/// For ARKODE: after every step.
int put_back(realtype, N_Vector y, void* data) {
  view(y) = of(data).projected(view(y));
  return 0;
}

/// A run that fails says so in the table.
void be_quiet(int, const char*, const char*, char*, void*) {}

Samples follow(const Course& course, const Equations& equations, N_Vector y,
               const std::function<int(double)>& advance) {
  Samples samples{equations.sample(view(y))};
  for (int i = 1; i < course.instants; ++i) {
    check(advance(course.duration * i / (course.instants - 1)), "stopped");
    samples.push_back(equations.sample(view(y)));
  }
  return samples;
}

Samples run_cvode(Equations& equations, const Course& course, double tolerance,
                  int kind, PrecisionRow& row) {
  Workspace w(equations.start());
  const std::unique_ptr<void, void (*)(void*)> memory(
      CVodeCreate(kind, w.context), [](void* m) {
        CVodeFree(&m);
      });
  void* m = memory.get();
  check(CVodeInit(m, rates, 0.0, w.y), "CVodeInit");
  CVodeSetErrHandlerFn(m, be_quiet, nullptr);
  CVodeSetUserData(m, &equations);
  CVodeSStolerances(m, tolerance, tolerance);
  CVodeSetMaxNumSteps(m, kMostSteps);
  const std::unique_ptr<_generic_SUNNonlinearSolver,
                        int (*)(SUNNonlinearSolver)>
      fixed_point(kind == CV_ADAMS ? SUNNonlinSol_FixedPoint(w.y, 0, w.context)
                                   : nullptr,
                  SUNNonlinSolFree);
  if (kind == CV_ADAMS) {
    CVodeSetNonlinearSolver(m, fixed_point.get());
  } else {
    CVodeSetLinearSolver(m, w.solver, w.matrix);
    if (equations.constrained()) CVodeSetProjFn(m, project);
  }
  double t = 0.0;
  const Samples samples = follow(course, equations, w.y, [&](double until) {
    CVodeSetStopTime(m, until);
    return CVode(m, until, w.y, &t, CV_NORMAL);
  });
  long linear = 0;
  CVodeGetNumSteps(m, &row.steps);
  CVodeGetNumRhsEvals(m, &row.evaluations);
  if (kind == CV_BDF) CVodeGetNumLinRhsEvals(m, &linear);
  CVodeGetNumErrTestFails(m, &row.rejected);
  row.evaluations += linear;
  row.implicit_steps = kind == CV_BDF ? row.steps : 0;
  return samples;
}

Samples run_erk(Equations& equations, const Course& course, double tolerance,
                PrecisionRow& row) {
  Workspace w(equations.start());
  const std::unique_ptr<void, void (*)(void*)> memory(
      ERKStepCreate(rates, 0.0, w.y, w.context), [](void* m) {
        ERKStepFree(&m);
      });
  void* m = memory.get();
  ERKStepSetErrHandlerFn(m, be_quiet, nullptr);
  ERKStepSetUserData(m, &equations);
  ERKStepSetTableNum(m, ARKODE_FEHLBERG_13_7_8);
  ERKStepSStolerances(m, tolerance, tolerance);
  ERKStepSetMaxNumSteps(m, kMostSteps);
  if (equations.constrained()) ERKStepSetPostprocessStepFn(m, put_back);
  double t = 0.0;
  const Samples samples = follow(course, equations, w.y, [&](double until) {
    ERKStepSetStopTime(m, until);
    return ERKStepEvolve(m, until, w.y, &t, ARK_NORMAL);
  });
  ERKStepGetNumSteps(m, &row.steps);
  ERKStepGetNumRhsEvals(m, &row.evaluations);
  ERKStepGetNumErrTestFails(m, &row.rejected);
  row.implicit_steps = 0;
  return samples;
}

Samples run_dirk(Equations& equations, const Course& course, double tolerance,
                 PrecisionRow& row) {
  Workspace w(equations.start());
  const std::unique_ptr<void, void (*)(void*)> memory(
      ARKStepCreate(nullptr, rates, 0.0, w.y, w.context), [](void* m) {
        ARKStepFree(&m);
      });
  void* m = memory.get();
  ARKStepSetErrHandlerFn(m, be_quiet, nullptr);
  ARKStepSetUserData(m, &equations);
  ARKStepSetTableNum(m, ARKODE_KVAERNO_7_4_5, ARKODE_ERK_NONE);
  ARKStepSStolerances(m, tolerance, tolerance);
  ARKStepSetMaxNumSteps(m, kMostSteps);
  ARKStepSetLinearSolver(m, w.solver, w.matrix);
  double t = 0.0;
  const Samples samples = follow(course, equations, w.y, [&](double until) {
    ARKStepSetStopTime(m, until);
    return ARKStepEvolve(m, until, w.y, &t, ARK_NORMAL);
  });
  long explicit_ones = 0, linear = 0;
  ARKStepGetNumSteps(m, &row.steps);
  ARKStepGetNumRhsEvals(m, &explicit_ones, &row.evaluations);
  ARKStepGetNumLinRhsEvals(m, &linear);
  ARKStepGetNumErrTestFails(m, &row.rejected);
  row.evaluations += linear;
  row.implicit_steps = row.steps;
  return samples;
}

/// Unknowns q, v, forces of the joints λ, and μ, by which velocities keep off
/// what opens the joints (index 2, after Gear, Gupta and Leimkuhler).
int residual(realtype, N_Vector y, N_Vector dy, N_Vector r, void* data) {
  const auto& m = *static_cast<LinkageEquations*>(data);
  const Eigen::Index n = m.coordinates(), k = m.rows();
  const Vector q = view(y).head(n), v = view(y).segment(n, n);
  const Eigen::MatrixXd J = m.jacobian(q);
  const auto lifted = [&](const Vector& force) {
    return Vector(m.weight().cwiseProduct(force));
  };
  auto out = view(r);
  out.head(n) = view(dy).head(n) - v - lifted(J.transpose() * view(y).tail(k));
  out.segment(n, n) =
      view(dy).segment(n, n) -
      lifted(m.forces(q) + J.transpose() * view(y).segment(2 * n, k));
  out.segment(2 * n, k) = m.gaps(q);
  out.tail(k) = J * v;
  return out.allFinite() ? 0 : 1;
}

Samples run_ida(LinkageEquations& equations, const Course& course,
                double tolerance, PrecisionRow& row) {
  const Eigen::Index n = equations.coordinates(), k = equations.rows();
  const Vector start = equations.start();
  const auto answer = equations.solve(start);
  Vector y(2 * n + 2 * k), dy = Vector::Zero(2 * n + 2 * k);
  y << start, answer.force, Vector::Zero(k);
  dy.head(2 * n) << start.tail(n), answer.acceleration;
  Workspace w(y), slopes(dy), kinds(Vector::Zero(y.size()));
  view(kinds.y).head(2 * n).setOnes();
  // forces are known to a small part of 1/h² only: none of Newton's business
  Workspace least(Vector::Constant(y.size(), tolerance));
  view(least.y).tail(2 * k).setConstant(1e10);
  const std::unique_ptr<void, void (*)(void*)> memory(IDACreate(w.context),
                                                      [](void* m) {
                                                        IDAFree(&m);
                                                      });
  void* m = memory.get();
  check(IDAInit(m, residual, 0.0, w.y, slopes.y), "IDAInit");
  IDASetErrHandlerFn(m, be_quiet, nullptr);
  IDASetUserData(m, &equations);
  IDASVtolerances(m, tolerance, least.y);
  IDASetInitStep(m, 1e-5 * course.duration);
  IDASetId(m, kinds.y);
  IDASetSuppressAlg(m, SUNTRUE);
  IDASetMaxNumSteps(m, kMostSteps);
  IDASetLinearSolver(m, w.solver, w.matrix);
  double t = 0.0;
  Samples samples{equations.sample(start)};
  for (int i = 1; i < course.instants; ++i) {
    const double until = course.duration * i / (course.instants - 1);
    IDASetStopTime(m, until);
    check(IDASolve(m, until, &t, w.y, slopes.y, IDA_NORMAL), "stopped");
    samples.push_back(equations.sample(Vector(view(w.y).head(2 * n))));
  }
  long linear = 0;
  IDAGetNumSteps(m, &row.steps);
  IDAGetNumResEvals(m, &row.evaluations);
  IDAGetNumLinResEvals(m, &linear);
  IDAGetNumErrTestFails(m, &row.rejected);
  row.evaluations += linear;
  row.implicit_steps = row.steps;
  return samples;
}

using Run = std::function<Samples(double tolerance, PrecisionRow& row)>;

void measure_one(const Request& request, const Course& course,
                 PrecisionRow& row, const Run& run, double tolerance) {
  try {
    Samples samples;
    row.seconds = request.seconds([&] {
      samples = run(tolerance, row);
    });
    row.errors = errors(course, samples);
    print(row);
  } catch (const std::exception&) {
    print_failure(row.problem, row.method, row.setting, "stopped");
  }
}

/// In a process of its own for each tolerance, as some runs do not end.
void measure(const Request& request, const Course& course,
             const std::string& method, const Run& run) {
  int over = 0;
  for (int exponent = 3; exponent <= 12 && over < 2; ++exponent) {
    const double tolerance = std::pow(10.0, -exponent);
    PrecisionRow row;
    row.problem = course.name;
    row.method = "SUNDIALS 6.4 " + method;
    row.setting = power_of_ten(tolerance);
    if (!request.wants(row.method, row.setting)) continue;
    const bool ended = finishes(kMostSeconds, [&] {
      measure_one(request, course, row, run, tolerance);
    });
    if (!ended) {
      print_failure(row.problem, row.method, row.setting,
                    "over " + std::to_string(kMostSeconds) + " s");
      ++over;
    }
  }
}

void measure_ode(const Request& request, const Course& course,
                 Equations& equations) {
  const auto cvode = [&](int kind) {
    return [&, kind](double tolerance, PrecisionRow& row) {
      return run_cvode(equations, course, tolerance, kind, row);
    };
  };
  measure(request, course, "CVODE BDF", cvode(CV_BDF));
  measure(request, course, "CVODE Adams", cvode(CV_ADAMS));
  measure(request, course, "ARKODE ERK 8", [&](double t, PrecisionRow& row) {
    return run_erk(equations, course, t, row);
  });
  if (course.name == "governor") {
    measure(request, course, "ARKODE DIRK 5", [&](double t, PrecisionRow& row) {
      return run_dirk(equations, course, t, row);
    });
  }
}

void measure_linkage(const Request& request, const Course& course,
                     const clevis::mechanism::testing::PlanarLinkage& linkage) {
  if (!request.wants(course.name)) return;
  LinkageEquations equations(linkage);
  measure_ode(request, course, equations);
  measure(request, course, "IDA", [&](double t, PrecisionRow& row) {
    return run_ida(equations, course, t, row);
  });
}

}  // namespace

int main(int argc, char** argv) {
  using namespace clevis::mechanism::testing;
  const Request request(argc, argv);
  print_header();
  measure_linkage(request, four_bar_course(), planar_two_window_four_bar());
  measure_linkage(request, crank_rocker_course(), crank_rocker());
  if (request.wants("governor")) {
    GovernorOde governor;
    measure_ode(request, governor_course(), governor);
  }
  if (request.wants("bricard")) {
    BricardOde bricard;
    measure_ode(request, bricard_course(), bricard);
  }
  measure_linkage(request, andrews_course(), andrews());
  measure_linkage(request, cart_pole_course(), light_cart_pole());
}
