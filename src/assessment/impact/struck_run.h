#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "dynamics/strike/strike.h"
#include "elasticity/vibration/strike_response.h"
#include "stress/displacement/deflection.h"
#include "stress/sections/support_face.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// Instants at which blows of the default duration are judged.
constexpr int kBlowSamples = 1200;

/// How blows are integrated.
dynamics::StrikeOptions strike_options(const PartJob& job,
                                       dynamics::Route route,
                                       const ImpactJob& impact);

/// @throws Error M003 if the mesh has no group of that name.
const loads::GroupGeometry& group_of(const PartJob& job,
                                     const std::string& name);

/// The blow as a static case of a force [N] along its direction.
part::LoadCaseDefinition static_case(const PartJob& job,
                                     const ImpactJob& impact, double force);

/// F_eq: what at rest deflects a spring without mass as the blow does [N].
/// @param stiffness  of the struck face [N/m].
double equivalent_force(const loads::Strike& strike, double stiffness);

/// The struck faces of a part, of each degree that of the last blow: blows on
/// one face share matrices and shapes.
template <int dim>
class StruckFaces {
 public:
  /// @param mesh  outlives the object: the part's, or a plate's mid-plane.
  explicit StruckFaces(const mesh::PartMesh<dim>& mesh) : mesh_(mesh) {}

  const mesh::PartMesh<dim>& mesh() const { return mesh_; }
  elasticity::StruckFace<dim>& get(const PartJob& job, const ImpactJob& impact,
                                   int degree);

 private:
  struct Entry {
    std::string key;
    std::unique_ptr<elasticity::StruckFace<dim>> face;
  };
  const mesh::PartMesh<dim>& mesh_;
  std::map<int, Entry> of_degree_;
};

/// Largest nominal stress of the plane faces that hold the part.
struct SupportPeak {
  Eigen::VectorXd of_sample;  ///< [Pa]; empty: there is no such face
  double value{};             ///< [Pa]
  int sample{};
  std::string name;
};

template <int dim>
SupportPeak support_peak(const elasticity::DisplacementBasis<dim>& basis,
                         const PartJob& job, const ImpactJob& impact);

/// One blow by one route and degree.
template <int dim>
struct StruckRun {
  elasticity::StrikeResponse<dim> response;
  double stress{};         ///< [Pa]
  double static_stress{};  ///< by the static force of 1 N [Pa]
  SupportPeak root;
  double static_root{};           ///< by the static force of 1 N [Pa]
  double sampling_error{};        ///< of the stress [1]
  std::vector<int> candidates;    ///< samples at which peaks may stand, rising
  stress::Deflection deflection;  ///< largest over part and times
  double deflection_sampling{};   ///< what lies between the samples [m]
  double static_deflection{};     ///< by the static force of 1 N [m]
  double factor{};                ///< of F_eq, with the elements' stiffness [1]
  double seconds{}, static_seconds{};

  /// Of the steps, the shapes and the samples [1].
  double error_in_time() const {
    return response.solution.error() + sampling_error;
  }
};

/// The samples of a basis at these instants.
template <int dim>
elasticity::DisplacementBasis<dim> at_samples(
    const elasticity::DisplacementBasis<dim>& basis,
    const std::vector<int>& samples);

/// The blow in time, and the static force beside it.
/// @param zones  left out where the stress is judged.
/// @throws Error of StruckFace.
template <int dim>
StruckRun<dim> run_struck(const PartJob& job, const ImpactJob& impact,
                          const std::vector<stress::SingularZone>& zones,
                          int degree, dynamics::Route route,
                          StruckFaces<dim>& faces);

/// Largest von Mises of each sample outside the singular zones [Pa].
template <int dim>
Eigen::VectorXd judged_peaks(const elasticity::DisplacementBasis<dim>& basis,
                             const PartJob& job,
                             const std::vector<stress::SingularZone>& zones);

/// Largest von Mises outside the singular zones [Pa].
template <int dim>
double judged_stress(const elasticity::DisplacementBasis<dim>& basis,
                     const PartJob& job,
                     const std::vector<stress::SingularZone>& zones);

}  // namespace clevis::assessment
