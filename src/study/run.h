#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_result.h"

namespace clevis::study {

/// The load that all runs of a study are compared at.
struct Governing {
  std::size_t set{};  ///< of PartJob::load_sets
  int instant{};      ///< of its history
  std::string label;  ///< "t = 0 s" or the case
};

/// One model of a part with one resolution: what it says and what it costs.
struct Run {
  std::string series;   ///< "plane stress", "3-D", "CalculiX C3D20R"
  std::string setting;  ///< what differs within the series: "p = 3", "1 %"
  int dofs{};
  double peak{};               ///< von Mises at the governing load [Pa]
  double energy{};             ///< strain energy there [J]
  std::vector<double> probes;  ///< SI, case after case
  /// Of the part's check, where the run is one [Pa].
  std::optional<assessment::PeakStress> checked;
  assessment::PartSeconds seconds;  ///< total: reading to stress
  double cpu_seconds{};             ///< user and system
  double memory{};                  ///< peak of its process [byte]
  /// Largest difference to clevis's displacements over the largest of these,
  /// rigid motion apart [1]; only of other programs.
  std::optional<double> displacement_difference;
  std::string left_out;  ///< why there are no values; else empty
};

/// Reference of the runs.
struct Reference {
  double value{};        ///< SI
  double uncertainty{};  ///< half-width [same]
};

/// All runs of one part.
struct PartStudy {
  std::string name;
  std::string load;           ///< the governing one
  std::string reference_run;  ///< in words: "3-D, cells halved, p = 4"
  Reference peak, energy;
  std::vector<std::string> probe_names;  ///< "D stress_yy"
  std::vector<bool> is_stress;           ///< per probe: Pa, else m
  std::vector<Reference> probes;
  std::vector<Run> runs;
  int instants{};  ///< in the load set that clevis's runs solve
};

/// |value − reference| / |reference| [1]; the value itself if the reference
/// is 0.
double relative_error(double value, const Reference& reference);

}  // namespace clevis::study
