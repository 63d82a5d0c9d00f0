// Events of paths that are given in closed form instead of integrated.
#include "mechanism/events/event_finder.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/mass_matrix/centre_frame.h"
#include "support/reference_motions.h"

namespace clevis::mechanism {
namespace {

using Eigen::VectorXd;
using testing::on_joint;
using testing::sliders;

constexpr double kRoundOff = 1e-9;  // over the rate at which zero is passed
constexpr double kStop = 0.5;       // [m]
constexpr int kUpper = 1;           // end of a stop

/// Positions of sliders over time [m].
using Path = std::function<std::vector<double>(double t)>;

/// A step whose dense output is a given path.
class GivenStep final : public numerics::Integrator {
 public:
  GivenStep(double from, double to, std::function<VectorXd(double)> state)
      : from_(from), to_(to), state_(std::move(state)), y_(state_(to)) {}

  void restart(double, const VectorXd&, double) override {}
  bool step(double) override { return true; }
  double t_start() const override { return from_; }
  double t() const override { return to_; }
  const VectorXd& y() const override { return y_; }
  void interpolate(double t, VectorXd& y) override { y = state_(t); }
  void correct(const VectorXd& y) override { y_ = y; }
  bool wants_change() const override { return false; }
  double next_step() const override { return to_ - from_; }

 private:
  double from_, to_;
  std::function<VectorXd(double)> state_;
  VectorXd y_;
};

/// Sliders along x, each an event finder's view of a given path.
class Sliders {
 public:
  explicit Sliders(MechanismDefinition definition)
      : m_(std::move(definition)),
        frame_(frame_at_centres(m_)),
        equations_(m_, frame_),
        start_(equations_.start(closed_joints(m_, frame_, 1e-12))),
        finder_(equations_, m_) {}

  ForceModel& forces() { return equations_.forces(); }

  EventFinder::Event find(double from, double to, const Path& path) {
    const auto state = [this, &path](double t) {
      VectorXd y = start_;
      const std::vector<double> x = path(t);
      for (std::size_t i = 0; i < x.size(); ++i) {
        y[3 * static_cast<Eigen::Index>(i)] = x[i];
      }
      return y;
    };
    GivenStep step(from, to, state);
    finder_.start(from, state(from));
    return finder_.find(step);
  }

 private:
  MechanismDefinition m_;
  SolvingFrame frame_;
  EquationsOfMotion equations_;
  VectorXd start_;
  EventFinder finder_;
};

/// Sliders that meet a stop each.
MechanismDefinition with_stops(int count) {
  MechanismDefinition m =
      sliders(std::vector<double>(static_cast<std::size_t>(count), 1.0));
  for (int i = 0; i < count; ++i) {
    m.elements.push_back(on_joint(
        i,
        StopLaw{.lower = {}, .upper = kStop, .contact = {.stiffness = 1e5}}));
  }
  return m;
}

TEST(EventFinder, FindsTheZeroOfAStraightPath) {
  Sliders slider(with_stops(1));
  for (const double t : {0.01, 0.25, 0.6, 0.999}) {
    const auto event = slider.find(0.0, 1.0, [t](double time) {
      return std::vector{kStop + 2.0 * (time - t)};
    });
    EXPECT_EQ(event.index, kUpper);
    EXPECT_NEAR(event.t, t, kRoundOff);
  }
  EXPECT_EQ(slider
                .find(0.0, 1.0,
                      [](double t) {
                        return std::vector{0.9 * kStop * t};
                      })
                .index,
            -1);
}

// Beyond the stop for a thousandth of the step, between two samples: the root
// is √depth before the top. As near on this side: nothing.
TEST(EventFinder, FindsADipBetweenSamples) {
  Sliders slider(with_stops(1));
  for (const double top : {0.1, 0.37, 0.61803}) {
    for (const double depth : {1e-3, 1e-5, 2.5e-7}) {
      const auto over = [top, depth](double sense) {
        return [=](double t) {
          return std::vector{kStop + sense * depth - (t - top) * (t - top)};
        };
      };
      const auto event = slider.find(0.0, 1.0, over(1.0));
      EXPECT_EQ(event.index, kUpper) << top << ' ' << depth;
      EXPECT_NEAR(event.t, top - std::sqrt(depth),
                  kRoundOff / std::sqrt(depth));
      EXPECT_EQ(slider.find(0.0, 1.0, over(-1.0)).index, -1);
    }
  }
}

// Both within one piece of the step, in either order.
TEST(EventFinder, TellsWhichIsFirst) {
  Sliders pair(with_stops(2));
  for (const double first : {0.60, 0.62}) {
    const double second = 1.22 - first;
    const auto event = pair.find(0.0, 1.0, [=](double t) {
      return std::vector{kStop + t - first, kStop + 3.0 * (t - second)};
    });
    EXPECT_EQ(event.index, first < second ? kUpper : 2 + kUpper);
    EXPECT_NEAR(event.t, 0.60, kRoundOff);
  }
}

// A piece of a law begins where its event function is zero: that is no end of
// it, the next zero is.
TEST(EventFinder, LeavesTheZeroFromWhichItStarts) {
  Sliders slider(with_stops(1));
  for (const double back : {0.4, 0.02}) {
    const auto event = slider.find(0.0, 1.0, [back](double t) {
      return std::vector{kStop + t * (t - back)};
    });
    EXPECT_EQ(event.index, kUpper) << back;
    EXPECT_NEAR(event.t, back, kRoundOff / back);
  }
}

// Between two samples what has come to zero goes on within round-off.
TEST(EventFinder, DoesNotTakeRoundOffForAnEvent) {
  Sliders slider(with_stops(1));
  const auto creeping = [](double speed) {
    return [speed](double t) {
      return std::vector{kStop + (t < 0.25 ? 1.0 : speed) * (t - 0.25)};
    };
  };
  EXPECT_EQ(slider.find(0.0, 1.0, creeping(1e-12)).index, -1);
  EXPECT_EQ(slider.find(0.0, 1.0, creeping(1e-6)).index, kUpper);
}

/// A driven slider pulls a resting one by a spring; friction holds that.
struct Pulled {
  static constexpr double kStiffness = 1000.0, kAmplitude = 0.01;
  static constexpr double kBreakaway = 6.0;

  explicit Pulled(double frequency) {
    m = sliders({1.0, 1.0});
    LineElement spring;
    spring.name = "spring";
    spring.line.kind = ElementLine::Kind::kSlide;
    spring.line.a.body = 0;
    spring.line.b.body = 1;
    spring.law = SpringLaw{.stiffness = kStiffness};
    m.elements = {spring, on_joint(1, FrictionLaw{.breakaway = kBreakaway,
                                                  .kinetic = 5.0})};
    DriveDefinition drive;
    drive.law = DriveLaw::kSine;
    drive.amplitude = kAmplitude;
    drive.frequency = frequency;
    m.drives = {drive};
    path = [frequency](double t) {
      const double angle = 2.0 * std::numbers::pi * frequency * t;
      return std::vector{kAmplitude * std::sin(angle), 0.0};
    };
  }

  MechanismDefinition m;
  Path path;
};

// Ten periods in a step of what rests, whose samples are all zeros of the sine:
// the spring's force reaches the breakaway within the first quarter.
TEST(EventFinder, LooksAtWhatRestsByThePeriodOfItsDrive) {
  const Pulled pulled(10.0);
  Sliders pair(pulled.m);
  pair.forces().element(1).modes[0] = 0;
  const auto event = pair.find(0.0, 1.0, pulled.path);
  EXPECT_EQ(event.index, 2);  // of the second element
  const double angle =
      std::asin(Pulled::kBreakaway / (Pulled::kStiffness * Pulled::kAmplitude));
  EXPECT_NEAR(event.t, angle / (20.0 * std::numbers::pi), kRoundOff);
}

TEST(EventFinder, RefusesMorePeriodsThanItCanLookAt) {
  const Pulled pulled(1e9);
  Sliders pair(pulled.m);
  pair.forces().element(1).modes[0] = 0;
  try {
    pair.find(0.0, 10.0, [](double) {
      return std::vector{0.0, 0.0};
    });
    FAIL() << "nothing refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "K008");
  }
}

}  // namespace
}  // namespace clevis::mechanism
