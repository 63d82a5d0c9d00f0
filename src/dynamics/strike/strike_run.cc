#include "dynamics/strike/strike_run.h"

#include <algorithm>
#include <cmath>

#include "dynamics/struck_body/contact_law.h"

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Striker {
  double position{}, speed{}, impulse{};
};

void resize(int samples, StrikeRun& run) {
  for (VectorXd* values : {&run.time, &run.force, &run.impulse, &run.contact,
                           &run.position, &run.speed, &run.strain_energy}) {
    *values = VectorXd::Zero(samples + 1);
  }
}

void sample(Index at, double time, const StruckBody& body,
            const loads::Strike& strike, const Striker& striker,
            StrikeRun& run) {
  const ContactLaw law(strike.contact);
  const double approach = striker.position - body.contact();
  run.time[at] = time;
  run.force[at] = law.force(approach);
  run.impulse[at] = striker.impulse;
  run.contact[at] = body.contact();
  run.position[at] = striker.position;
  run.speed[at] = striker.speed;
  run.strain_energy[at] = body.strain_energy();
  run.states.col(at) = body.state();
  const double before = 0.5 * strike.mass * strike.speed * strike.speed;
  const double work = strike.force * striker.position;
  const double energy = body.energy() + law.potential(approach) +
                        0.5 * strike.mass * striker.speed * striker.speed;
  const double scale = before + std::abs(work);
  if (scale > 0.0) {
    run.energy_error =
        std::max(run.energy_error, std::abs(energy - before - work) / scale);
  }
}

void watch_force(double force, double time, double& before, StrikeRun& run) {
  if (force > run.peak_force) {
    run.peak_force = force;
    run.peak_force_time = time;
  }
  if (before == 0.0 && force > 0.0) ++run.touches;
  if (before != 0.0 && force == 0.0) run.release_time = time;
  if (force != 0.0) run.release_time = -1.0;
  before = force;
}

}  // namespace

StrikeRun run_strike(StruckBody& body, const loads::Strike& strike,
                     double duration, int samples, int stride) {
  const ContactLaw law(strike.contact);
  StrikeRun run;
  run.step = duration / samples / stride;
  const double h = run.step;
  body.rest();
  body.set_step(h);
  resize(samples, run);
  run.states.resize(body.state().size(), samples + 1);
  Striker striker{0.0, strike.speed, 0.0};
  sample(0, 0.0, body, strike, striker, run);
  const double compliance = body.compliance() + h * h / (2.0 * strike.mass);
  double force_before = 0.0;
  for (int step = 1; step <= samples * stride; ++step) {
    const double approach = striker.position - body.contact();
    const double free_position = striker.position + h * striker.speed +
                                 h * h / (2.0 * strike.mass) * strike.force;
    const double free_approach = free_position - body.free_contact();
    const double force = law.solve_step(approach, free_approach, compliance);
    body.advance(force);
    striker.position = free_position - h * h / (2.0 * strike.mass) * force;
    striker.speed += h / strike.mass * (strike.force - force);
    striker.impulse += h * force;
    const double time = step * h;
    watch_force(law.force(striker.position - body.contact()), time,
                force_before, run);
    if (body.contact() > run.peak_contact) {
      run.peak_contact = body.contact();
      run.peak_contact_time = time;
    }
    if (step % stride == 0) {
      sample(step / stride, time, body, strike, striker, run);
    }
  }
  return run;
}

double difference(const StrikeRun& a, const StrikeRun& b) {
  const auto apart = [](const VectorXd& x, const VectorXd& y) {
    const double size =
        std::max(x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff());
    return size > 0.0 ? (x - y).cwiseAbs().maxCoeff() / size : 0.0;
  };
  const double peak = std::max(a.peak_force, b.peak_force);
  return std::max(
      {apart(a.contact, b.contact), apart(a.impulse, b.impulse),
       apart(a.strain_energy, b.strain_energy),
       peak > 0.0 ? std::abs(a.peak_force - b.peak_force) / peak : 0.0});
}

}  // namespace clevis::dynamics
