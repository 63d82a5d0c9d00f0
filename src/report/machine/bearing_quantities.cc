#include "report/machine/bearing_quantities.h"

#include "part/verdict.h"

namespace clevis::report {
namespace {

using machine::BearingResult;

constexpr Rule kLoadRule = like_reactions(1e-6);
constexpr Rule kLifeRule = {
    compare_within(1e-5, 0.0),
    "goes with the third power of the load, or nearly the fourth"};

template <class Value>
auto of_result(Value BearingResult::*member) {
  return [member](const BearingReport& bearing) {
    return bearing.result.*member;
  };
}

Quantities<BearingReport> head_rows() {
  using S = BearingReport;
  return {
      quantity<S>({"name", "/name"}, of_result(&BearingResult::name)),
      quantity<S>({"joint", "/joint"}, &S::joint),
      quantity<S>({"kind", "/kind"},
                  [](const S& bearing) {
                    return machine::name_of(bearing.result.kind);
                  }),
      quantity<S>({"verdict", "/verdict", "", "", kVerdictRule},
                  [](const S& bearing) {
                    return part::text(bearing.result.verdict);
                  }),
      quantity<S>({"why", "/why"}, of_result(&BearingResult::why)),
  };
}

Quantities<BearingReport> load_rows() {
  using S = BearingReport;
  using R = BearingResult;
  return {
      quantity<S>({"dynamic_rating", "/dynamic_rating_N", "N"},
                  of_result(&R::dynamic_rating)),
      quantity<S>({"static_rating", "/static_rating_N", "N"},
                  of_result(&R::static_rating)),
      quantity<S>({"bearing_load", "/mean_load_N", "N", "", kLoadRule},
                  of_result(&R::mean_load)),
      quantity<S>({"peak_load", "/peak_load_N", "N"}, of_result(&R::peak_load)),
      quantity<S>({"static_load", "/static_load_N", "N", "", kLoadRule},
                  of_result(&R::static_load)),
      quantity<S>({"static_load_instant", "/static_load_at_s", "s"},
                  of_result(&R::static_load_at)),
      quantity<S>({"peak_radial", "/peak_radial_N", "N"},
                  of_result(&R::peak_radial)),
      quantity<S>({"peak_axial", "/peak_axial_N", "N"},
                  of_result(&R::peak_axial)),
      quantity<S>({"peak_tilt", "/peak_tilt_N_m", "Nm"},
                  of_result(&R::peak_tilt)),
      quantity<S>(
          {"static_safety", "/static_safety", "1", "", like_reactions(0.0)},
          of_result(&R::static_safety)),
      quantity<S>({"static_safety_wanted", "/static_safety_wanted", "1"},
                  of_result(&R::static_safety_wanted)),
  };
}

Quantities<BearingReport> life_rows() {
  using S = BearingReport;
  using R = BearingResult;
  return {
      quantity<S>({"swing", "/swing_deg", "deg"}, of_result(&R::swing)),
      quantity<S>({"travel", "/travel_deg", "deg"}, of_result(&R::travel)),
      quantity<S>({"mean_speed", "/mean_speed_rad_per_s", "rad/s"},
                  of_result(&R::mean_speed)),
      quantity<S>({"life", "/life_revolutions", "1"}, of_result(&R::life)),
      quantity<S>({"life_cycles", "/life_cycles", "1"},
                  of_result(&R::life_cycles)),
      quantity<S>({"bearing_life", "/life_h", "h", "", kLifeRule},
                  of_result(&R::life_seconds)),
      quantity<S>({"life_wanted", "/life_wanted_h", "h"},
                  of_result(&R::life_wanted)),
      quantity<S>({"mean_load_error", "/mean_load_error_percent", "%"},
                  of_result(&R::mean_load_error)),
      quantity<S>({"travel_error", "/travel_error_percent", "%"},
                  of_result(&R::travel_error)),
      quantity<S>({"life_error", "/life_error_percent", "%"},
                  of_result(&R::life_error)),
  };
}

}  // namespace

const Quantities<BearingReport>& bearing_quantities() {
  static const Quantities<BearingReport> rows = [] {
    Quantities<BearingReport> all = head_rows();
    append(load_rows(), all);
    append(life_rows(), all);
    return all;
  }();
  return rows;
}

}  // namespace clevis::report
