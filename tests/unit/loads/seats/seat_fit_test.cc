// Joints against the cylinders that they should lie in.
#include "loads/seats/seat_fit.h"

#include <functional>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "base/messages/errors.h"
#include "loads/holds/seat_hold.h"
#include "loads/seats/part_seats.h"

namespace clevis::loads {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::JointType;

/// A plate in x, y with three bores of 8 mm length; the joints lie in their
/// middles.
struct Plate {
  mechanism::MechanismDefinition definition;
  part::PartDefinition part;
  std::vector<GroupGeometry> groups;

  explicit Plate(JointType type = JointType::kRevolute) {
    definition.bodies.resize(1);
    part.name = "plate";
    const std::vector<Vector3d> at = {
        {0.0, 0.0, 0.0}, {0.08, 0.0, 0.0}, {0.03, 0.05, 0.0}};
    for (std::size_t k = 0; k < at.size(); ++k) {
      mechanism::JointDefinition joint;
      joint.name = std::string(1, static_cast<char>('A' + k));
      joint.type = type;
      joint.body_b = 0;
      joint.frame_b.p_LJ = at[k];
      definition.joints.push_back(joint);
      part.seats.push_back({joint.name, "bore_" + joint.name});
      GroupGeometry bore;
      bore.name = "bore_" + joint.name;
      bore.is_cylinder = true;
      bore.cylinder = {.p_LC = at[k],
                       .axis_L = Vector3d::UnitZ(),
                       .radius = 5e-3,
                       .length = 8e-3};
      groups.push_back(bore);
    }
  }

  void move_mesh(const std::function<Vector3d(const Vector3d&)>& map,
                 double scale = 1.0) {
    for (GroupGeometry& group : groups) {
      const Vector3d tip = group.cylinder.p_LC + group.cylinder.axis_L;
      const Vector3d axis = map(tip) - map(group.cylinder.p_LC);
      group.cylinder.p_LC = map(group.cylinder.p_LC);
      group.cylinder.axis_L = axis.normalized();
      group.cylinder.radius *= scale;
      group.cylinder.length *= scale;
    }
    for (GroupGeometry& group : groups) {
      const part::Bore& c = group.cylinder;
      group.area = 2.0 * std::numbers::pi * c.radius * c.length;
    }
  }

  SeatContext context() const { return {definition, 0, part, groups, 0.1}; }

  /// Message of the refusal with its remedy; empty: none.
  std::string refusal() {
    move_mesh([](const Vector3d& p) {
      return p;
    });
    try {
      joint_seats(context());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "L003");
      return error.problem() + " | " + error.remedy();
    }
    return "";
  }
  std::vector<std::string> notes() {
    move_mesh([](const Vector3d& p) {
      return p;
    });
    return off_middle_notes(context(), joint_seats(context()));
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(SeatFit, NothingIsSaidOfJointsInTheMiddle) {
  Plate plate;
  EXPECT_EQ(plate.refusal(), "");
  EXPECT_TRUE(plate.notes().empty());
}

// Extruded from z = 0 instead of about the middle plane.
TEST(SeatFit, OffsetAlongThePinIsTold) {
  Plate plate;
  plate.move_mesh([](const Vector3d& p) -> Vector3d {
    return p + Vector3d(0.0, 0.0, 4e-3);
  });
  EXPECT_EQ(plate.refusal(), "");  // on the bore's end, still inside
  const auto notes = plate.notes();
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_TRUE(contains(notes[0],
                       "joint A stands 4 mm from the middle of "
                       "\"bore_A\""))
      << notes[0];
  Plate close;
  close.move_mesh([](const Vector3d& p) -> Vector3d {
    return p + Vector3d(0.0, 0.0, 0.015 * 8e-3);
  });
  EXPECT_TRUE(close.notes().empty());
}

TEST(SeatFit, JointBeyondTheBoreIsRefused) {
  Plate plate;
  plate.move_mesh([](const Vector3d& p) -> Vector3d {
    return p + Vector3d(0.0, 0.0, 4.5e-3);
  });
  const std::string text = plate.refusal();
  EXPECT_TRUE(contains(text,
                       "4.5 mm from the middle of \"bore_A\", beyond its "
                       "end: the cylinder is 8 mm long"))
      << text;
  EXPECT_TRUE(contains(text, "Move the mesh by (0, 0, -4.5) mm")) << text;
  // Along a slide the joint's point may lie anywhere.
  Plate slide(JointType::kPrismatic);
  slide.move_mesh([](const Vector3d& p) -> Vector3d {
    return p + Vector3d(0.0, 0.0, 0.2);
  });
  EXPECT_EQ(slide.refusal(), "");
  EXPECT_TRUE(slide.notes().empty());
}

TEST(SeatFit, MirroredMeshIsNamed) {
  Plate plate;
  plate.move_mesh([](const Vector3d& p) -> Vector3d {
    return {p.x(), -p.y(), p.z()};
  });
  EXPECT_TRUE(contains(plate.refusal(), "Mirrored along y, all cylinders"))
      << plate.refusal();
}

TEST(SeatFit, TurnedMeshIsNamed) {
  Plate plate;
  plate.move_mesh([](const Vector3d& p) -> Vector3d {
    return {-p.y(), p.x(), p.z()};  // by 90 deg about z: 270 undo it
  });
  EXPECT_TRUE(contains(plate.refusal(), "Turned by 270 deg about z"))
      << plate.refusal();
  Plate upright;
  upright.move_mesh([](const Vector3d& p) -> Vector3d {
    return {p.x(), -p.z(), p.y()};
  });
  EXPECT_TRUE(contains(upright.refusal(), "Turned by 270 deg about x"))
      << upright.refusal();
}

TEST(SeatFit, WrongUnitOfLengthIsNamed) {
  for (const double slip : {10.0, 25.4, 1000.0, 1.0 / 25.4}) {
    Plate plate;
    plate.move_mesh(
        [&](const Vector3d& p) -> Vector3d {
          return slip * p;
        },
        slip);
    EXPECT_TRUE(contains(plate.refusal(), "length_unit")) << slip;
  }
  Plate wrong;  // another length is no unit
  wrong.move_mesh([](const Vector3d& p) -> Vector3d {
    return 1.5 * p;
  });
  EXPECT_FALSE(contains(wrong.refusal(), "correct the part's length_unit"))
      << wrong.refusal();
}

// As drawings round 95.2627944 to 95.263.
TEST(SeatFit, AThousandthOfTheDiameterIsAllowedAndTold) {
  for (const double offset : {9.9e-6, 10.1e-6}) {
    Plate plate;
    plate.definition.bodies[0].name = "plate";
    plate.definition.joints[1].frame_b.p_LJ += Vector3d(0.0, offset, 0.0);
    const std::string refusal = plate.refusal();
    if (offset < 10e-6) {
      EXPECT_EQ(refusal, "");
      const auto notes =
          off_axis_notes(plate.context(), joint_seats(plate.context()));
      ASSERT_EQ(notes.size(), 1u);
      EXPECT_TRUE(contains(notes[0],
                           "joint B stands 0.0099 mm off the axis of "
                           "\"bore_B\", by (0, 0.0099, 0) mm"))
          << notes[0];
    } else {
      EXPECT_TRUE(contains(refusal,
                           "0.0101 mm off the axis of \"bore_B\", 0.01 mm are "
                           "allowed: joint at (80, 0.0101, 0) mm, off by (0, "
                           "0.0101, 0) mm"))
          << refusal;
      EXPECT_TRUE(contains(refusal,
                           "at.plate = [\"80 mm\", \"0 mm\", \"0 mm\"] instead "
                           "of [\"80 mm\", \"0.0101 mm\", \"0 mm\"]"))
          << refusal;
    }
  }
  Plate slide(JointType::kPrismatic);
  slide.definition.joints[1].frame_b.p_LJ += Vector3d(0.0, 1e-6, 0.0);
  EXPECT_TRUE(contains(slide.refusal(), "off the axis"));
}

TEST(SeatFit, ATiltedAxisIsToldWithTheOneToWrite) {
  Plate plate;
  plate.groups[2].cylinder.axis_L = -Vector3d(0.6e-5, 0.0, 1.0).normalized();
  const std::string refusal = plate.refusal();
  EXPECT_TRUE(contains(refusal, "an angle of 0.000343775 deg")) << refusal;
  EXPECT_TRUE(contains(refusal,
                       "Give joint C the cylinder's axis, in the "
                       "body's frame (6e-06, 0, 1)"))
      << refusal;
}

TEST(SeatFit, ShiftedMeshIsNamed) {
  Plate plate;
  plate.move_mesh([](const Vector3d& p) -> Vector3d {
    return p + Vector3d(2e-3, -1e-3, 0.0);
  });
  EXPECT_TRUE(contains(plate.refusal(), "Move the mesh by (-2, 1, 0) mm"))
      << plate.refusal();
}

// No face can take a tooth force that is not resolved.
TEST(JointSeats, RefuseACoupling) {
  Plate plate;
  plate.definition.bodies.resize(2);
  mechanism::JointDefinition axle = plate.definition.joints[0];
  axle.name = "axle";
  axle.body_b = 1;
  plate.definition.joints.push_back(axle);
  plate.definition.couplings = {
      {.name = "gear", .joint_1 = 3, .joint_2 = 0, .ratio = 2.0}};
  try {
    require_seats(plate.context());
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "L004");
    EXPECT_TRUE(contains(error.problem(), "coupling \"gear\""));
    EXPECT_TRUE(contains(error.problem(), "joint \"A\""));
  }
  plate.definition.couplings[0].joint_2 = 3;
  EXPECT_NO_THROW(require_seats(plate.context()));
}

// A pin of the ground holds its place and its axis, a ball its place, a slide
// all but its way and turn; another body is held and weighs what it does.
TEST(SeatHold, IsWhatTheMechanismDoesAtTheSeats) {
  const auto hold = [](Plate plate) {
    plate.definition.joints.resize(1);
    plate.part.seats.resize(1);
    mechanism::Instant instant;
    instant.t = 0.7;
    instant.bodies.resize(plate.definition.bodies.size());
    std::vector<Seat> seats;
    for (const JointSeat& seat : joint_seats(plate.context())) {
      seats.push_back(seat.seat);
    }
    return seat_hold(mechanism::Neighbours(plate.definition, 0), instant,
                     seats);
  };
  Plate plate;
  plate.definition.joints[0].frame_b.R_LJ =
      Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
  const SeatHold pin = hold(plate);
  EXPECT_EQ(pin.time, 0.7);
  ASSERT_EQ(pin.held.cols(), 5);
  Eigen::MatrixXd exact = Eigen::MatrixXd::Identity(6, 6);
  exact(5, 5) = 0.0;  // turns freely
  EXPECT_LT(
      (pin.held * pin.held.transpose() - exact).topLeftCorner(3, 3).norm(),
      1e-9);
  EXPECT_LT(pin.held.row(5).norm(), 1e-9);
  EXPECT_EQ(hold(Plate(JointType::kSpherical)).held.cols(), 3);
  EXPECT_EQ(hold(Plate(JointType::kCylindrical)).held.cols(), 4);

  plate.definition.bodies.resize(2);
  plate.definition.bodies[1].mass_properties.mass = 2.0;
  plate.definition.bodies[1].mass_properties.inertia_LCm =
      1e9 * Eigen::Matrix3d::Identity();
  plate.definition.joints[0].body_a = 1;
  const SeatHold other = hold(plate);
  EXPECT_EQ(other.held.cols(), 0);
  const Eigen::MatrixXd mass = other.weighed * other.weighed.transpose();
  EXPECT_LT(
      (mass.topLeftCorner(3, 3) - 2.0 * Eigen::Matrix3d::Identity()).norm(),
      1e-6);
}

}  // namespace
}  // namespace clevis::loads
