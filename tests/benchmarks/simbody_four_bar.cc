// The two-window four-bar of work_precision.cc in Simbody 3.7, beside which it
// prints the same columns. Built where Simbody is installed (libsimbody-dev).
//
//     cmake --build --preset release --target simbody_four_bar
//     build/release/tests/benchmarks/simbody_four_bar > table.csv
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include <Simbody.h>

namespace {

using SimTK::Vec3;

/// Three upright bars on ground under two level ones, as there.
class FourBar {
 public:
  FourBar() : matter_(system_), forces_(system_) {
    SimTK::Force::UniformGravity(forces_, matter_, Vec3(0, -9.81, 0));
    const double turn = 1.0 / 12.0;
    const SimTK::Body::Rigid bar(
        SimTK::MassProperties(1.0, Vec3(0.5, 0, 0),
                              SimTK::Inertia(1e-4, turn, turn)
                                  .shiftFromMassCenter(Vec3(0.5, 0, 0), 1.0)));
    const auto pin = [&bar](SimTK::MobilizedBody& parent, const Vec3& at) {
      return SimTK::MobilizedBody::Pin(parent, SimTK::Transform(at), bar,
                                       SimTK::Transform());
    };
    for (int i = 0; i < 3; ++i) {
      upright_.push_back(pin(matter_.updGround(), Vec3(i, 0, 0)));
    }
    for (int i = 0; i < 2; ++i) {
      level_.push_back(
          pin(upright_[static_cast<std::size_t>(i)], Vec3(1, 0, 0)));
    }
    close(level_[0], upright_[1]);
    close(level_[1], upright_[2]);
    state_ = system_.realizeTopology();
    const double up = 0.5 * M_PI;
    for (auto& bar_up : upright_) {
      bar_up.setAngle(state_, up);
      bar_up.setRate(state_, -1.0);
    }
    for (auto& bar_level : level_) {
      bar_level.setAngle(state_, -up);
      bar_level.setRate(state_, 1.0);
    }
  }

  struct Run {
    double error{}, energy{}, branch{};
    int steps{}, evaluations{};
  };

  Run run(double accuracy, bool careful) {
    SimTK::RungeKuttaMersonIntegrator integrator(system_);
    integrator.setAccuracy(accuracy);
    if (careful) {
      integrator.setConstraintTolerance(1e-3 * accuracy);
      integrator.setProjectEveryStep(true);
    }
    SimTK::TimeStepper stepper(system_, integrator);
    stepper.initialize(state_);
    const double start = system_.calcEnergy(integrator.getState());
    const Vec3 known[] = {{-0.195020301949, -0.980799205662, 0},
                          {-0.811310461004, -0.584615545351, 0},
                          {0.328458111539, 0.944518538179, 0}};
    const double times[] = {1, 5, 10};
    Run result;
    for (int second = 1; second <= 10; ++second) {
      stepper.stepTo(second);
      const SimTK::State& now = integrator.getState();
      result.energy =
          std::max(result.energy, std::abs(system_.calcEnergy(now) - start));
      for (int k = 0; k < 3; ++k) {
        if (times[k] != second) continue;
        const Vec3 tip =
            upright_[0].findStationLocationInGround(now, Vec3(1, 0, 0));
        result.error = std::max(result.error, (tip - known[k]).norm());
      }
      for (int k = 1; k < 3; ++k) {
        result.branch =
            std::max(result.branch,
                     std::abs(std::remainder(
                         upright_[static_cast<std::size_t>(k)].getAngle(now) -
                             upright_[0].getAngle(now),
                         2.0 * M_PI)));
      }
    }
    result.steps = integrator.getNumStepsTaken();
    result.evaluations = integrator.getNumRealizations();
    return result;
  }

 private:
  /// The end of a level bar on the top of an upright one, in the plane.
  void close(SimTK::MobilizedBody& level, SimTK::MobilizedBody& upright) {
    SimTK::Constraint::PointInPlane(upright, SimTK::UnitVec3(SimTK::XAxis), 1.0,
                                    level, Vec3(1, 0, 0));
    SimTK::Constraint::PointInPlane(upright, SimTK::UnitVec3(SimTK::YAxis), 0.0,
                                    level, Vec3(1, 0, 0));
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<SimTK::MobilizedBody::Pin> upright_, level_;
  SimTK::State state_;
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int main() {
  std::printf(
      "problem,method,tolerance,cpu_ms,steps,implicit_steps,rejected,"
      "evaluations,position_or_time_error,energy_error_J,gap_m,"
      "reaction_error_N,branch_error_rad\n");
  for (const bool careful : {false, true}) {
    for (const double accuracy :
         {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      const char* name =
          careful ? "Simbody 3.7 (projected)" : "Simbody 3.7 (defaults)";
      try {
        FourBar bars;
        FourBar::Run run;
        double least = 1e300;
        for (int i = 0; i < 3; ++i) {
          const double start = cpu_seconds();
          run = bars.run(accuracy, careful);
          least = std::min(least, cpu_seconds() - start);
        }
        std::printf(
            "two_window_four_bar,%s,%.0e,%.3f,%d,0,,%d,%.2e,%.2e,,,%.2e\n",
            name, accuracy, 1e3 * least, run.steps, run.evaluations, run.error,
            run.energy, run.branch);
      } catch (const std::exception&) {
        std::printf("two_window_four_bar,%s,%.0e,stopped\n", name, accuracy);
      }
      std::fflush(stdout);
    }
  }
}
