#include "dynamics/strike/strike.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "dynamics/strike/strike_steps.h"
#include "dynamics/struck_body/damped_body.h"
#include "dynamics/struck_body/damped_scheme.h"
#include "dynamics/struck_body/excited_shapes.h"

namespace clevis::dynamics {
namespace {

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
      "Mass, stiffness and duration must be above zero, the exponent 1 or "
      "more (1 where the contact is bilateral), and the striker needs a speed "
      "or a force towards the part.");
}

double first_elastic(const ReducedModel& model, Eigen::Index rigid) {
  return model.squares[std::min(rigid, model.squares.size() - 1)];
}

/// Waves up to half of the shapes' median frequency are theirs; of the highest
/// shapes a space has only traces.
double damping_time(const ReducedModel& model, Eigen::Index rigid) {
  constexpr double kPart = 0.5;
  std::vector<double> squares(model.squares.begin() + rigid,
                              model.squares.end());
  const auto middle =
      squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
  std::ranges::nth_element(squares, middle);
  return kPart / std::sqrt(*middle);
}

class Solver {
 public:
  Solver(const LinearSystem& system, const VectorXd& contact,
         ExcitedShapes& shapes, const loads::Strike& strike,
         const StrikeOptions& options)
      : system_(system),
        contact_(contact),
        strike_(strike),
        options_(options),
        shapes_(shapes),
        solves_before_(shapes.solves()) {
    solution_.contact_compliance = shapes_.compliance();
    if (!std::isfinite(strike_.contact.stiffness)) {
      solution_.is_ideal = true;
      strike_.contact.exponent = 1.0;
      strike_.contact.stiffness = kIdealStiffness / shapes_.compliance();
    }
    solution_.contact_stiffness = strike_.contact.stiffness;
    const auto model = shapes_.model(options.fewest_modes);
    duration_ = strike_duration(strike_, shapes_.compliance(),
                                first_elastic(model, system.rigid.cols()));
    stride_ = contact_stride(strike_, duration_, options.samples);
  }

  StrikeSolution solve() {
    const bool damped =
        options_.damping == Damping::kFronts ||
        (options_.damping == Damping::kAuto && solution_.is_ideal);
    const std::string fronts =
        solution_.is_ideal ? "an ideal step makes fronts: " : "";
    if (options_.route == Route::kDirect) {
      if (options_.modal_damping > 0.0) {
        throw Error("F006", "strike", "the direct route has no modal damping",
                    "Take the modal route, or no damping.");
      }
      solution_.reason = fronts + "direct was asked for";
      if (!damped && options_.damping == Damping::kAuto && needs_damping()) {
        solution_.reason += "; the rise of its force would take too many steps";
        direct_damped();
      } else {
        damped ? direct_damped() : direct();
      }
      return std::move(solution_);
    }
    damped ? modal_damped() : modal();
    solution_.reason =
        fronts + (options_.route == Route::kModal ? "modal was asked for"
                                                  : reason_for_shapes());
    if (!damped && solution_.mode_error >= 0.5 * options_.tolerance &&
        options_.damping == Damping::kAuto) {
      const std::string left = fmt::format(
          "{} shapes leave an error of {:.2g} %: waves shorter "
          "than theirs damped",
          solution_.modes, 100.0 * solution_.error());
      modal_damped();
      solution_.reason = left;
    }
    return std::move(solution_);
  }

 private:
  StepPlan plan(int stride) const {
    return {.tolerance = options_.tolerance,
            .duration = duration_,
            .samples = options_.samples,
            .stride = stride,
            .most_steps = options_.most_modal_steps};
  }

  std::string reason_for_shapes() const {
    return fmt::format(
        "{} shapes that the contact excites settle within {:.2g} %; the "
        "direct route would solve with a factor {} times or more, this one "
        "did {} times",
        solution_.modes, 100.0 * solution_.error(), direct_steps_,
        solution_.solves);
  }

  void take_modal(Refined&& refined, const ReducedModel& model) {
    solution_.is_modal = true;
    solution_.modes = static_cast<int>(model.squares.size());
    solution_.shape_frequency =
        std::sqrt(model.squares.maxCoeff()) / (2.0 * std::numbers::pi);
    solution_.columns = shapes_.shapes(model);
    solution_.time_error = refined.error;
    solution_.steps = refined.steps;
    solution_.solves = shapes_.solves() - solves_before_ + 1;
    solution_.within_tolerance =
        solution_.mode_error < 0.5 * options_.tolerance && refined.settled;
    direct_steps_ = refined.all_steps;
    solution_.run = std::move(refined.run);
  }

  /// Ever more shapes until they settle.
  /// @param wave_front_time  waves shorter than it are damped; 0: none [s].
  void modal(double wave_front_time = 0.0) {
    std::optional<Refined> before;
    int shapes = options_.fewest_modes;
    solution_.damping_time = wave_front_time;
    for (;; shapes = shapes * 3 / 2) {
      const ReducedModel model = shapes_.model(shapes);
      const auto body = modal_body(model.squares, model.contact,
                                   wave_front_time, options_.modal_damping);
      StepPlan steps = plan(stride_);
      solution_.rise_time = rise_time(*modal_body(model.squares, model.contact),
                                      strike_, duration_);
      if (solution_.rise_time < wave_front_time) {
        steps.carry_rise = false;
        steps.stride = stride_for(wave_front_time);
      }
      Refined now = refine_steps(*body, strike_, steps);
      stride_ = std::max(stride_, now.steps / options_.samples / 2);
      solution_.mode_error = before ? difference(before->run, now.run) : 1.0;
      if (model.is_complete) solution_.mode_error = 0.0;
      const bool settled = solution_.mode_error < 0.5 * options_.tolerance;
      before = std::move(now);
      if (!settled && shapes * 3 / 2 <= options_.most_modes) continue;
      take_modal(std::move(*before), model);
      break;
    }
  }

  /// Two models, the smaller one for the error.
  void modal_damped() {
    if (options_.wave_front_time > 0.0) {
      modal(options_.wave_front_time);
      return;
    }
    const int most = std::max(options_.front_modes, solution_.modes);
    std::optional<StrikeRun> before;
    for (const int shapes : {most * 2 / 3, most}) {
      const ReducedModel model = shapes_.model(shapes);
      const double time = damping_time(model, system_.rigid.cols());
      const auto body = modal_body(model.squares, model.contact, time,
                                   options_.modal_damping);
      StepPlan steps = plan(stride_for(time));
      steps.carry_rise = false;
      Refined now = refine_steps(*body, strike_, steps);
      solution_.mode_error =
          before && !model.is_complete ? difference(*before, now.run) : 0.0;
      before = now.run;
      solution_.damping_time = time;
      take_modal(std::move(now), model);
    }
  }

  /// Whether steps that carry the rise of the force cost more solves than those
  /// of the damping scheme, halved runs counted.
  bool needs_damping() const {
    const auto model = shapes_.model(options_.front_modes * 2 / 3);
    const auto body = modal_body(model.squares, model.contact);
    StrikeRun run;
    int steps = options_.samples;
    for (; steps <= options_.most_direct_steps; steps *= 2) {
      run.step = duration_ / steps;
      body->set_step(run.step);
      if (carries_rise(*body, strike_, run, steps, true)) break;
    }
    const int damped = options_.samples *
                       stride_for(damping_time(model, system_.rigid.cols()));
    return 2.0 * steps > 1.5 * DampedScheme::kStages * damped;
  }

  int stride_for(double step) const {
    return static_cast<int>(
        std::clamp(std::ceil(duration_ / options_.samples / step), 1.0, 1e6));
  }

  void direct() {
    const auto body = direct_body(system_, contact_);
    StepPlan steps = plan(std::min(stride_, 16));
    steps.most_steps = options_.most_direct_steps;
    steps.is_direct = true;
    take_direct(refine_steps(*body, strike_, steps));
  }

  /// One step size, that of the damping; twice as long ones for the error.
  void direct_damped() {
    const auto model = shapes_.model(options_.front_modes * 2 / 3);
    const int stride = stride_for(damping_time(model, system_.rigid.cols()));
    const int half = (stride + 1) / 2;
    const auto body = damped_body(system_, contact_);
    StepPlan steps = plan(half);
    steps.carry_rise = false;
    steps.most_steps = 2 * options_.samples * half;
    take_direct(refine_steps(*body, strike_, steps));
    solution_.damping_time = solution_.run.step;
  }

  void take_direct(Refined&& refined) {
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
  ExcitedShapes& shapes_;
  int solves_before_;
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
  ExcitedShapes shapes(system, contact);
  return Solver(system, contact, shapes, strike, options).solve();
}

StrikeSolution solve_strike(const LinearSystem& system, const VectorXd& contact,
                            ExcitedShapes& shapes, const loads::Strike& strike,
                            const StrikeOptions& options,
                            const std::string& place) {
  require(strike, place);
  return Solver(system, contact, shapes, strike, options).solve();
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
