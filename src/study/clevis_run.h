#pragma once

#include <string>
#include <vector>

#include "assessment/job/model_traits.h"
#include "assessment/job/part_job.h"
#include "elasticity/problem/engine.h"
#include "study/run.h"

namespace clevis::study {

/// Runs of rising degree that are compared: a model, set up in one way.
struct Series {
  assessment::ModelKind model{};
  int terms{};             ///< through the thickness; 0 of a model without
  bool is_halved = false;  ///< every cell's edges cut in two
  elasticity::Engine engine = elasticity::Engine::kOwn;
};

/// Name of a series in tables and plots.
std::string series_name(const Series& series);

/// The series of a part: each model that suits it, with each number of terms,
/// the finest last, plane stress and 3-D by either engine; of a mesh of
/// hexahedra the finest on halved cells too. A part whose supports leave it
/// free across its plane has plane models only.
/// @param engine  kAuto: both; else only what this one solves.
std::vector<Series> series_of(
    const assessment::PartJob& job,
    elasticity::Engine engine = elasticity::Engine::kAuto);

/// The names of those series that tend to what the part's loads truly do: of
/// models without an error of their own; of a plane problem all.
std::vector<std::string> exact_series(const assessment::PartJob& job);

/// The load set and instant of the highest peak by a quick look (degree 2 of
/// the finest model).
Governing find_governing(const assessment::PartJob& job);

/// The job with this load set alone, and the cases that belong to it.
assessment::PartJob governed_job(const assessment::PartJob& job,
                                 const Governing& governing);

/// Solves a part with one model and degree, its mesh file read anew; repeated
/// while that is quick, the fastest counts.
/// @param job  of governed_job(): the first load set is solved.
/// @throws Error of the modules below; F004 above kMostDofs, F007 above
/// --max-dofs.
Run solve_model(const assessment::PartJob& job, const Series& series,
                int degree, int instant);

/// Runs `check` on a part with a tolerance: the model and degree that clevis
/// itself chooses, with the band.
/// @param tolerance  of the peak, relative [1].
Run run_check(const assessment::PartJob& job, double tolerance);

/// Peak memory of this process so far [byte].
double peak_memory();

}  // namespace clevis::study
