#pragma once

#include "study/run.h"

namespace clevis::study {

inline Run run_of(const std::string& series, const std::string& setting,
                  double peak, double cpu_seconds) {
  Run run;
  run.series = series;
  run.setting = setting;
  run.dofs = 1000;
  run.peak = peak;
  run.energy = 2e-3;
  run.seconds.total = 2.0 * cpu_seconds;
  run.cpu_seconds = cpu_seconds;
  run.memory = 5e7;
  return run;
}

/// Reference 100 MPa. 3-D crosses it by chance at p = 2.
inline PartStudy sample_study() {
  PartStudy study;
  study.name = "AB";
  study.load = "t = 0 s";
  study.instants = 201;
  study.reference_run = "3-D, p = 4";
  study.peak = {100e6, 1e4};
  study.energy = {2e-3, 0.0};
  study.runs = {run_of("plane stress", "p = 2", 99.5e6, 0.01),
                run_of("plane stress", "p = 3", 99.6e6, 0.02),
                run_of("3-D", "p = 2", 100e6, 0.005),
                run_of("3-D", "p = 3", 97e6, 0.1),
                run_of("3-D", "p = 4", 99.95e6, 1.0),
                run_of("CalculiX C3D20R", "h", 103e6, 0.2),
                run_of("CalculiX C3D20R", "h/2", 100.8e6, 2.0)};
  return study;
}

}  // namespace clevis::study
