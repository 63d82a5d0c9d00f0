#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/group_geometry.h"
#include "loads/history/load_history.h"
#include "part/mass_properties.h"

namespace clevis::loads {

/// Reactions of pins on the part that they hold, each in five components: force
/// along three axes, the last the pin's own, moment about the first two. None
/// takes a moment about its own axis.
class PinReactions {
 public:
  /// @param size  of the part, over which moments count as forces [m].
  PinReactions(std::vector<part::Bore> pins, double size);

  /// One per pin about the middle of its bore; least in size of those that
  /// balance `rest` (moment about Lo) as far as pins can.
  std::vector<Wrench> balancing(const Wrench& rest) const;

  /// Reactions that balance one another: what balance leaves open; orthonormal.
  std::vector<std::vector<Wrench>> open() const;

  /// Components of one pin in the patterns of open() [1]: rows of the pin's
  /// five components (moments over the size), columns of the patterns.
  Eigen::MatrixXd open_components(std::size_t pin) const;
  /// The five components of a pin's wrench about the middle of its bore,
  /// moments over the size [N].
  Eigen::VectorXd components(std::size_t pin, const Wrench& wrench) const;
  std::size_t size() const { return pins_.size(); }

  /// Whether balance alone determines all reactions of a pin.
  bool is_unique(std::size_t pin) const;

 private:
  std::vector<Wrench> wrenches(const Eigen::VectorXd& components) const;

  std::vector<part::Bore> pins_;
  double size_{};
  Eigen::MatrixXd acting_;  ///< 3 n + 2 n components to pins' wrenches, scaled
  Eigen::MatrixXd sum_;     ///< the same to force and moment about the middle
  Eigen::Vector3d middle_;
};

/// The pins in these bores. @param size  of the part [m]. @throws Error L002,
/// M003.
PinReactions pins_in(const std::vector<std::string>& bores,
                     const std::vector<GroupGeometry>& groups, double size,
                     const std::string& place);

/// Supports the part by pins: adds a bearing seat for each, whose reaction
/// balances the loads; of those that balance leaves open the least.
/// @param size     of the part [m].
/// @param history  its seats so far; those of the pins are appended.
/// @throws Error L001 if the loads turn the part about the axis of its pins,
///   L002, M003.
void hold_by_pins(const std::vector<std::string>& bores,
                  const std::vector<GroupGeometry>& groups,
                  const part::MassProperties& mass, double size,
                  const std::string& place, LoadHistory& history,
                  InstantLoad& instant);

/// The part is held by pins whose loads are among the history's.
/// @param bores  groups of bearing seats of the history. @throws Error L002.
void hold_by_loaded_pins(const std::vector<std::string>& bores,
                         const std::vector<GroupGeometry>& groups,
                         const std::string& place, LoadHistory& history);

/// Reactions of the pins that hold a part where balance leaves some open.
struct SharedPins {
  LoadHistory history;  ///< shared by the part's compliance, pins rigid
  /// Each pin alone gives way as well, by as much as the part between them.
  std::vector<LoadHistory> others;
};

/// Takes of all reactions in balance those of least energy.
/// @param history   one instant; its last seats are the pins'.
/// @param patterns  PinReactions::open() times `unit` [N].
/// @param A, b      strain energy U0 + bᵀ z + ½ zᵀ A z by amounts of them [J].
SharedPins share(const PinReactions& pins, const LoadHistory& history,
                 const part::MassProperties& mass, double size, double unit,
                 const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace clevis::loads
