#include "dynamics/strike.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "base/errors.h"
#include "dynamics/contact_law.h"
#include "dynamics/excited_shapes.h"

namespace clevis::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kIdealStiffness = 1000.0;  // times the body's own

void require(const loads::Strike& strike, const std::string& place) {
  const bool has_spring =
      strike.contact.stiffness > 0.0 && strike.contact.exponent >= 1.0 &&
      (strike.contact.exponent == 1.0 || !strike.contact.bilateral);
  const bool moves = strike.speed > 0.0 || strike.force > 0.0;
  if (strike.mass > 0.0 && std::isfinite(strike.mass) && has_spring && moves &&
      std::isfinite(strike.speed) && std::isfinite(strike.force) &&
      (!strike.duration || *strike.duration > 0.0)) {
    return;
  }
  throw Error(
      "F006", place,
      fmt::format("strike \"{}\": mass {:.4g} kg, speed {:.4g} m/s, force "
                  "{:.4g} N, contact {:.4g} N/m^{:.3g}",
                  strike.name, strike.mass, strike.speed, strike.force,
                  strike.contact.stiffness, strike.contact.exponent),
      "mass, stiffness and duration must be above zero, the exponent 1 or "
      "more (1 where the contact is bilateral), and the striker needs a speed "
      "or a force towards the part");
}

/// Stiffness of the contact where it is pressed most [N/m].
double stiffest(const loads::Strike& strike) {
  const double energy = 0.5 * strike.mass * strike.speed * strike.speed;
  const double approach =
      std::max(head_on(strike.contact, energy).approach,
               std::pow(strike.force / strike.contact.stiffness,
                        1.0 / strike.contact.exponent));
  return ContactLaw(strike.contact).slope(approach);
}

/// What the contact force changes by its own doing within one step [1].
double change_within_step(const StruckBody& body, const loads::Strike& strike,
                          double step) {
  return stiffest(strike) *
         (body.compliance() + step * step / (2.0 * strike.mass));
}

/// Whether steps carry the rise of the contact force. Longer ones keep the
/// energy too, and impulse and deflection may look settled, but waves in the
/// body ring with up to 20 % more stress: of the direct route also because
/// the midpoint rule delays what oscillates with ω by ω T (ω h)²/12 in all.
bool carries_rise(double change, int steps, bool is_modal) {
  constexpr double kResolved = 0.1, kDelay = 0.1;
  return change < kResolved &&
         (is_modal || std::pow(change, 3) * steps / 12.0 < kDelay);
}

/// Runs with ever halved steps until two of them agree.
struct Refined {
  StrikeRun run;
  double error{};  ///< estimated: the scheme is of second order
  int steps{};     ///< of the last run
  int all_steps{};
  bool settled = false;
};
Refined refine_steps(StruckBody& body, const loads::Strike& strike,
                     const StrikeOptions& options, double duration, int stride,
                     Route route) {
  const bool is_modal = route == Route::kModal;
  const int most_steps =
      is_modal ? options.most_modal_steps : options.most_direct_steps;
  Refined result;
  std::optional<StrikeRun> before;
  for (;; stride *= 2) {
    StrikeRun run = run_strike(body, strike, duration, options.samples, stride);
    result.steps = options.samples * stride;
    result.all_steps += result.steps;
    if (before) result.error = difference(*before, run) / 3.0;
    result.settled = before && result.error < 0.5 * options.tolerance &&
                     carries_rise(change_within_step(body, strike, run.step),
                                  result.steps, is_modal);
    before = std::move(run);
    if (result.settled || 2 * result.steps > most_steps) break;
  }
  result.run = std::move(*before);
  return result;
}

/// One period of the striker on the springs of contact and body, and one of the
/// body's first vibration.
double duration_of(const loads::Strike& strike, double compliance,
                   double first_square) {
  if (strike.duration) return *strike.duration;
  const double energy = 0.5 * strike.mass * strike.speed * strike.speed;
  const double contact = strike.speed > 0.0
                             ? 1.0 / head_on(strike.contact, energy).stiffness
                         : strike.contact.exponent == 1.0
                             ? 1.0 / strike.contact.stiffness
                             : std::pow(strike.force / strike.contact.stiffness,
                                        1.0 / strike.contact.exponent) /
                                   strike.force;
  return 2.0 * std::numbers::pi *
         (std::sqrt(strike.mass * (compliance + contact)) +
          1.0 / std::sqrt(first_square));
}

/// Steps per sample so that the striker alone on its contact is resolved.
int first_stride(const loads::Strike& strike, double duration, int samples) {
  constexpr double kStepsPerContact = 16.0;
  const double energy = 0.5 * strike.mass * strike.speed * strike.speed;
  if (!(energy > 0.0)) return 1;
  const double contact =
      std::numbers::pi *
      std::sqrt(strike.mass / head_on(strike.contact, energy).stiffness);
  const double steps = duration / contact * kStepsPerContact / samples;
  return static_cast<int>(
      std::exp2(std::ceil(std::log2(std::clamp(steps, 1.0, 4096.0)))));
}

double first_elastic(const ReducedModel& model, Eigen::Index rigid) {
  return model.squares[std::min(rigid, model.squares.size() - 1)];
}

class Solver {
 public:
  Solver(const LinearSystem& system, const VectorXd& contact,
         const loads::Strike& strike, const StrikeOptions& options)
      : system_(system),
        contact_(contact),
        strike_(strike),
        options_(options),
        shapes_(system, contact) {
    solution_.contact_compliance = shapes_.compliance();
    if (!std::isfinite(strike_.contact.stiffness)) {
      solution_.is_ideal = true;
      strike_.contact.exponent = 1.0;
      strike_.contact.stiffness = kIdealStiffness / shapes_.compliance();
    }
    const auto model = shapes_.model(options.fewest_modes);
    duration_ = duration_of(strike_, shapes_.compliance(),
                            first_elastic(model, system.rigid.cols()));
    stride_ = first_stride(strike_, duration_, options.samples);
  }

  StrikeSolution solve() {
    if (options_.route == Route::kDirect) {
      direct("direct was asked for");
      return std::move(solution_);
    }
    modal();
    if (options_.route == Route::kModal) {
      solution_.reason = "modal was asked for";
    } else if (solution_.within_tolerance) {
      solution_.reason = fmt::format(
          "{} shapes that the contact excites settle within {:.2g} %; the "
          "direct route would solve with a factor {} times or more, this one "
          "did {} "
          "times",
          solution_.modes, 100.0 * solution_.error(), direct_steps_,
          solution_.solves);
    } else {
      const double error = solution_.error();
      direct(fmt::format("{} shapes leave an error of {:.2g} %",
                         solution_.modes, 100.0 * error));
    }
    return std::move(solution_);
  }

 private:
  void modal() {
    std::optional<Refined> before;
    int shapes = options_.fewest_modes;
    for (;; shapes = shapes * 3 / 2) {
      ReducedModel model = shapes_.model(shapes);
      const auto body = modal_body(model.squares, model.contact);
      Refined now = refine_steps(*body, strike_, options_, duration_, stride_,
                                 Route::kModal);
      stride_ = std::max(stride_, now.steps / options_.samples / 2);
      const bool is_all = model.squares.size() - system_.rigid.cols() < shapes;
      solution_.mode_error = before ? difference(before->run, now.run) : 1.0;
      if (is_all) solution_.mode_error = 0.0;
      const bool settled = solution_.mode_error < 0.5 * options_.tolerance;
      before = std::move(now);
      if (!settled && shapes * 3 / 2 <= options_.most_modes) continue;
      solution_.within_tolerance = settled && before->settled;
      solution_.modes = static_cast<int>(model.squares.size());
      solution_.shape_frequency =
          std::sqrt(model.squares.maxCoeff()) / (2.0 * std::numbers::pi);
      direct_steps_ = before->all_steps;
      solution_.columns = std::move(model.shapes);
      break;
    }
    solution_.is_modal = true;
    solution_.time_error = before->error;
    solution_.steps = before->steps;
    solution_.solves = shapes_.solves();
    solution_.run = std::move(before->run);
  }

  void direct(const std::string& reason) {
    const auto body = direct_body(system_, contact_);
    Refined refined = refine_steps(*body, strike_, options_, duration_,
                                   std::min(stride_, 16), Route::kDirect);
    solution_.reason = reason;
    solution_.is_modal = false;
    solution_.modes = 0;
    solution_.columns.resize(0, 0);
    solution_.mode_error = 0.0;
    solution_.time_error = refined.error;
    solution_.steps = refined.steps;
    solution_.solves += refined.all_steps;
    solution_.within_tolerance = refined.settled;
    solution_.run = std::move(refined.run);
  }

  const LinearSystem& system_;
  const VectorXd& contact_;
  loads::Strike strike_;
  StrikeOptions options_;
  ExcitedShapes shapes_;
  double duration_{};
  int stride_ = 1;
  int direct_steps_{};
  StrikeSolution solution_;
};

}  // namespace

StrikeSolution solve_strike(const LinearSystem& system, const VectorXd& contact,
                            const loads::Strike& strike,
                            const StrikeOptions& options,
                            const std::string& place) {
  require(strike, place);
  return Solver(system, contact, strike, options).solve();
}

bool grows_with_refinement(const std::vector<double>& values) {
  constexpr double kSmall = 0.01, kClearly = 0.6;
  const std::size_t n = values.size();
  if (n < 3) return false;
  const double last = std::abs(values[n - 1] - values[n - 2]);
  const double before = std::abs(values[n - 2] - values[n - 3]);
  return last > kSmall * std::abs(values[n - 1]) && last > kClearly * before;
}

}  // namespace clevis::dynamics
