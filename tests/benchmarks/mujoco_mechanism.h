#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <mujoco/mujoco.h>

#include "benchmarks/reference_trajectories.h"

/// What the mechanisms in MuJoCo share.
namespace clevis::benchmarks {

inline std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

inline std::string text(const Eigen::Vector3d& v) {
  return text(v.x()) + " " + text(v.y()) + " " + text(v.z());
}

/// Attribute of a body turned by R.
inline std::string turned(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return " quat=\"" + text(q.w()) + " " + text(Eigen::Vector3d(q.vec())) + "\"";
}

inline std::string inertial(double mass, const Eigen::Vector3d& centre,
                            const Eigen::Vector3d& inertia) {
  return "<inertial mass=\"" + text(mass) + "\" pos=\"" + text(centre) +
         "\" diaginertia=\"" + text(inertia) + "\"/>";
}

inline std::string hinge(const Eigen::Vector3d& axis) {
  return "<joint type=\"hinge\" axis=\"" + text(axis) + "\"/>";
}

inline std::string uniform_bar() {
  return inertial(1.0, {0.5, 0.0, 0.0}, {1e-4, 1.0 / 12.0, 1.0 / 12.0});
}

/// A scene in MuJoCo's XML, with what makes a Sample of its state.
class MujocoMechanism {
 public:
  /// @param world      what stands in <worldbody>.
  /// @param conditions what stands beside it.
  MujocoMechanism(const Eigen::Vector3d& gravity, const std::string& world,
                  const std::string& conditions) {
    const std::string xml =
        "<mujoco><compiler angle=\"radian\"/><option gravity=\"" +
        text(gravity) + "\" solver=\"Newton\"/><worldbody>" + world +
        "</worldbody>" + conditions + "</mujoco>";
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
    std::copy(xml.begin(), xml.end(), static_cast<char*>(files->filedata[0]));
    char error[1000] = "";
    model_.reset(mj_loadXML("scene.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (model_ == nullptr) throw std::runtime_error(error);
    data_.reset(mj_makeData(model_.get()));
    q_.assign(model_->qpos0, model_->qpos0 + model_->nq);
    u_.assign(static_cast<std::size_t>(model_->nv), 0.0);
  }
  virtual ~MujocoMechanism() = default;
  MujocoMechanism(const MujocoMechanism&) = delete;
  MujocoMechanism& operator=(const MujocoMechanism&) = delete;

  mjModel& model() const { return *model_; }
  mjData& data() const { return *data_; }

  void reset() const {
    mj_resetData(model_.get(), data_.get());
    std::copy(q_.begin(), q_.end(), data_->qpos);
    std::copy(u_.begin(), u_.end(), data_->qvel);
    apply();
  }

  /// Every value at the present state, with reactions.
  Sample sample() const {
    model_->opt.enableflags |= mjENBL_ENERGY;  // here, not in every step
    mj_forward(model_.get(), data_.get());
    model_->opt.enableflags &= ~mjENBL_ENERGY;
    mj_rnePostConstraint(model_.get(), data_.get());
    Sample sample;
    if (conservative_) sample.energy = data_->energy[0] + data_->energy[1];
    for (int i = 0; i < data_->nefc; ++i) {
      sample.gap = std::max(sample.gap, std::abs(data_->efc_pos[i]));
    }
    // of the first body on the ground: moment, then force
    sample.pin =
        Eigen::Map<const Eigen::Vector3d>(data_->cfrc_int + 6 + 3).norm();
    look(sample);
    return sample;
  }

 protected:
  virtual void look(Sample& sample) const = 0;
  /// Loads that stay through a motion.
  virtual void apply() const {}

  /// Origin and axes of a body, 1 the first.
  Eigen::Vector3d origin(int body) const {
    return Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
  }
  Eigen::Matrix3d axes(int body) const {
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(
        data_->xmat + 9 * body);
  }

  /// Rates that keep the constraints, the first one given.
  void make_consistent(double first_rate) {
    reset();
    mj_forward(model_.get(), data_.get());
    const Eigen::MatrixXd J =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic,
                                       Eigen::RowMajor>>(
            data_->efc_J, data_->nefc, model_->nv);
    const Eigen::VectorXd others = J.rightCols(model_->nv - 1)
                                       .colPivHouseholderQr()
                                       .solve(-first_rate * J.col(0));
    u_[0] = first_rate;
    std::copy(others.begin(), others.end(), u_.begin() + 1);
  }

  struct Free {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  std::vector<double> q_, u_;
  bool conservative_ = true;
};

}  // namespace clevis::benchmarks
