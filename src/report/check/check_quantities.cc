#include "report/check/check_quantities.h"

namespace clevis::report {

const Quantities<CheckReport>& check_quantities() {
  using S = CheckReport;
  static const Quantities<S> rows{
      quantity<S>({"version", "/version"}, &S::version),
      quantity<S>({"scene", "/scene"}, &S::scene),
      quantity<S>({"file", "/file"},
                  [](const S& report) {
                    return report.file.string();
                  }),
      quantity<S>({"verdict", "/verdict", "", "", kVerdictRule},
                  [](const S& report) {
                    return part::text(overall_verdict(report));
                  }),
      quantity<S>({"complete", "/complete", "", "",
                   exact("an interrupted check lacks parts")},
                  &S::complete),
  };
  return rows;
}

}  // namespace clevis::report
