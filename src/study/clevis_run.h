#pragma once

#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "study/run.h"

namespace clevis::study {

/// A model of the ladder, forced.
enum class Rung {
  kPlaneStress,
  kPlaneStressHalved,  ///< every quadrilateral cut into four
  kTwoTerms,           ///< plate by 2 + 2 Legendre terms through the thickness
  kThreeTerms,         ///< 3 + 3
  kFourTerms,          ///< 4 + 4
  kSolid,              ///< 3-D on the mesh as it is
  kSolidHalved,        ///< 3-D, every hexahedron cut into eight
};

/// What the series of a rung is called in tables and plots.
std::string series_name(Rung rung);

/// The rungs that suit a part, the finest last. A part whose supports leave
/// it free across its plane has plane stress only, and that on halved cells
/// too.
std::vector<Rung> rungs_of(const assessment::PartJob& job);

/// Highest degree that a rung can take on the part's cells.
int highest_degree(const assessment::PartJob& job, Rung rung);

/// The load set and instant of the highest peak by a quick look (degree 2 of
/// the finest model).
Governing find_governing(const assessment::PartJob& job);

/// The job with this load set alone, and the cases that belong to it.
assessment::PartJob governed_job(const assessment::PartJob& job,
                                 const Governing& governing);

/// Solves a part with one rung and degree, its mesh file read anew; repeated
/// while that is quick, the fastest counts.
/// @param job  of governed_job(): the first load set is solved.
/// @throws Error of the modules below; F004 above kMostDofs.
Run run_rung(const assessment::PartJob& job, Rung rung, int degree,
             int instant);

/// Runs `check` on a part with a tolerance: the model and degree that clevis
/// itself chooses, with the band.
Run run_check(const assessment::PartJob& job, double tolerance);

/// Peak memory of this process so far [byte].
double peak_memory();

}  // namespace clevis::study
