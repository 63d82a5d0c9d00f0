#include "machine/transmissions/transmission.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace clevis::machine {
namespace {

/// u of each stage to the output.
std::vector<double> ratios_to_output(
    const std::vector<TransmissionStage>& stages) {
  std::vector<double> ratios(stages.size(), 1.0);
  for (std::size_t i = stages.size() - 1; i > 0; --i) {
    ratios[i - 1] = ratios[i] * stages[i - 1].ratio;
  }
  return ratios;
}

std::string name_of(const CompliantElement& element, std::size_t number) {
  return element.name.empty()
             ? fmt::format("{}_{}", type_name(element), number + 1)
             : element.name;
}

/// Adds a stage's elements to the sums.
void add_stage(const TransmissionDefinition& transmission, std::size_t s,
               double ratio, TransmissionResult& result) {
  const TransmissionStage& stage = transmission.stages[s];
  const bool corrected =
      transmission.ball_screw_unit == BallScrewUnit::kCorrected;
  const std::size_t last = transmission.stages.size() - 1;
  for (std::size_t k = 0; k < stage.elements.size(); ++k) {
    const CompliantElement& element = stage.elements[k];
    const double own = compliance(element, transmission.ball_screw_unit);
    const double other =
        compliance(element, corrected ? BallScrewUnit::kPublished
                                      : BallScrewUnit::kCorrected);
    const double reduced = own / (ratio * ratio);
    result.elements.push_back({stage.name, name_of(element, k),
                               type_name(element), formula(element),
                               stage.angular, own, ratio, reduced});
    result.compliance += reduced;
    result.compliance_other_unit += other / (ratio * ratio);
    const bool drives_last =
        s + 1 == last && std::holds_alternative<GearTeeth>(element.law);
    if (s == last || drives_last) {
      result.last_stage += reduced;
      result.last_stage_published += own;
    }
  }
}

/// Motor, then the wheels between each two stages, and the load.
ChainModel chain_of(const TransmissionDefinition& transmission,
                    const std::vector<double>& ratios) {
  std::vector<double> inertias{*transmission.motor_inertia * ratios.front() *
                               ratios.front()};
  std::vector<double> compliances;
  for (std::size_t s = 0; s < transmission.stages.size(); ++s) {
    const double square = ratios[s] * ratios[s];
    inertias.back() += transmission.stages[s].wheel_inertia * square;
    double own = 0.0;
    for (const CompliantElement& element : transmission.stages[s].elements) {
      own += compliance(element, transmission.ball_screw_unit);
    }
    compliances.push_back(own / square);
    inertias.push_back(transmission.stages[s].pinion_inertia * square);
  }
  inertias.back() += *transmission.load_inertia;
  return chain_model(inertias, compliances);
}

}  // namespace

TwoMassModel two_mass_model(double motor_inertia, double load_inertia,
                            double compliance) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  TwoMassModel model;
  model.motor_inertia = motor_inertia;
  model.load_inertia = load_inertia;
  model.antiresonance = 1.0 / (kTurn * std::sqrt(load_inertia * compliance));
  model.resonance = std::sqrt((motor_inertia + load_inertia) /
                              (motor_inertia * load_inertia * compliance)) /
                    kTurn;
  return model;
}

TransmissionResult analyse_transmission(
    const TransmissionDefinition& transmission) {
  TransmissionResult result;
  result.name = transmission.name;
  result.ball_screw_unit = transmission.ball_screw_unit;
  result.angular = transmission.stages.back().angular;
  const std::vector<double> ratios = ratios_to_output(transmission.stages);
  result.ratio = ratios.front();
  for (std::size_t s = 0; s < transmission.stages.size(); ++s) {
    add_stage(transmission, s, ratios[s], result);
  }
  if (transmission.motor_inertia && transmission.load_inertia) {
    result.two_mass = two_mass_model(
        *transmission.motor_inertia * result.ratio * result.ratio,
        *transmission.load_inertia, result.compliance);
    const bool has_wheels = std::ranges::any_of(
        transmission.stages, [](const TransmissionStage& stage) {
          return stage.wheel_inertia > 0.0 || stage.pinion_inertia > 0.0;
        });
    if (has_wheels) result.chain = chain_of(transmission, ratios);
  }
  if (transmission.errors) {
    result.error = module_error(*transmission.errors, transmission.load,
                                result.compliance);
    if (result.two_mass && transmission.errors->friction > 0.0) {
      result.error->reversal_run = run_reversal(
          {result.two_mass->motor_inertia, result.two_mass->load_inertia,
           result.compliance, transmission.errors->backlash,
           transmission.errors->friction});
    }
  }
  return result;
}

}  // namespace clevis::machine
