#include "assessment/models/solid_model.h"

#include "elasticity/solid/solid_solve.h"

namespace clevis::assessment {

std::optional<std::string> why_not_solid(const PartShape& shape) {
  if (shape.job().model != ModelKind::kSolid &&
      leaves_plane_free(shape.job())) {
    return "supports leave the part free to leave its plane";
  }
  return std::nullopt;
}

FeModel<3> solid_model(const mesh::PartMesh<3>& mesh) {
  constexpr const ModelTraits& kSolid = traits_of(ModelKind::kSolid);
  FeModel<3> model;
  model.name = kSolid.name;
  if (mesh.shape == mesh::CellShape::kSimplex) model.name += " tetrahedra";
  model.mesh = &mesh;
  model.solve = elasticity::solve<3>;
  model.highest_degree = kSolid.highest_degree;
  // In 3-D three degrees up to 3 are cheaper than 4 alone.
  model.first_degree = unfolded(mesh, 1, model.highest_degree);
  model.subdivisions = 4;
  model.looks_at_places = true;
  return model;
}

AnyFeModel solid_model(const PartShape& shape, const ModelSettings&) {
  const PartJob& job = shape.job();
  FeModel<3> model = solid_model(job.mesh);
  model.zones = [&job](const LoadSet& set) {
    return stress::singular_zones<3>(job.mesh, job.part.material, set.fixed);
  };
  return model;
}

}  // namespace clevis::assessment
