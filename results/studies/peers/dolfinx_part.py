"""A part by dolfinx 0.5: displacements of one degree, von Mises stress at its nodes.

    dolfinx_part.py REQUEST

REQUEST is JSON: mesh (.msh, mm, named groups), degree, young [MPa], poisson, and what
loads and holds it: pins (group, force [N], centre, radius, thickness [mm]: cosine
pressure over the loaded half), pressure {group: MPa}, fixed {group: axis}, held (three
places of a free part whose motion is taken away: three directions, two, one). Prints
peak [MPa], equations and the processor seconds from mesh to stress.
"""
import json
import math
import sys
import time

import gmsh
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import gmshio
from mpi4py import MPI
from petsc4py import PETSc


def named_groups(file):
    """{name: tag} of the surfaces of a .msh."""
    names, inside = {}, False
    with open(file, errors="replace") as lines:
        for line in lines:
            if line.startswith("$PhysicalNames"):
                inside = True
            elif line.startswith("$EndPhysicalNames"):
                return names
            elif inside and line.count('"') == 2:
                dimension, tag = line.split()[:2]
                if dimension == "2":
                    names[line.split('"')[1]] = int(tag)
    return names


def read(file):
    """The cells and the tags of their faces. (read_from_msh() of 0.5.2 does not return.)"""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    domain, _, facets = gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=3)
    gmsh.finalize()
    return domain, facets


def loads(request, domain, ds, groups, v):
    x, n = ufl.SpatialCoordinate(domain), ufl.FacetNormal(domain)
    work = 0
    for pin in request.get("pins", []):
        size = math.hypot(*pin["force"])
        way = [component / size for component in pin["force"]]
        r = ufl.as_vector([x[0] - pin["centre"][0], x[1] - pin["centre"][1], 0.0])
        e = r / ufl.sqrt(ufl.dot(r, r))
        most = 2.0 * size / (math.pi * pin["radius"] * pin["thickness"])
        cosine = e[0] * way[0] + e[1] * way[1]
        press = most * ufl.max_value(cosine, 0.0)
        work += press * ufl.dot(e, v) * ds(groups[pin["group"]])
    for group, pressure in request.get("pressure", {}).items():
        work += -pressure * ufl.dot(n, v) * ds(groups[group])
    return work


def supports(request, domain, facets, groups, V):
    zero, found = PETSc.ScalarType(0), []
    for group, axis in request.get("fixed", {}).items():
        dofs = fem.locate_dofs_topological(V.sub(axis), 2, facets.find(groups[group]))
        found.append(fem.dirichletbc(zero, dofs, V.sub(axis)))
    places = V.tabulate_dof_coordinates()
    # x along the part, the third place across it: all rigid motions and no more
    for place, axes in zip(request.get("held", []), ((0, 1, 2), (1, 2), (1,))):
        node = int(np.argmin(np.linalg.norm(places - np.array(place), axis=1)))
        for axis in axes:
            found.append(fem.dirichletbc(
                zero, np.array([3 * node + axis], dtype=np.int32), V.sub(axis)))
    return found


def stress(u, young, poisson):
    mu = young / (2.0 * (1.0 + poisson))
    lam = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
    strain = ufl.sym(ufl.grad(u))
    return lam * ufl.tr(strain) * ufl.Identity(3) + 2.0 * mu * strain


def main():
    request = json.loads(sys.argv[1])
    started = time.process_time()
    groups = named_groups(request["mesh"])
    domain, facets = read(request["mesh"])
    degree = request["degree"]
    V = fem.VectorFunctionSpace(domain, ("CG", degree))
    u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
    # curved cells and the cosine's edge ask for more points than the product's degree
    dx = ufl.Measure("dx", domain, metadata={"quadrature_degree": 2 * degree + 1})
    ds = ufl.Measure("ds", domain, subdomain_data=facets,
                     metadata={"quadrature_degree": 2 * degree + 8})
    material = request["young"], request["poisson"]
    problem = LinearProblem(
        ufl.inner(stress(u, *material), ufl.sym(ufl.grad(v))) * dx,
        loads(request, domain, ds, groups, v), supports(request, domain, facets, groups, V),
        petsc_options={"ksp_type": "preonly", "pc_type": "cholesky",
                       "pc_factor_mat_solver_type": "mumps"})
    solution = problem.solve()
    s = stress(solution, *material)
    deviator = s - ufl.tr(s) / 3.0 * ufl.Identity(3)
    mises = ufl.sqrt(1.5 * ufl.inner(deviator, deviator))
    W = fem.FunctionSpace(domain, ("DG", degree))
    points = W.element.interpolation_points
    at_nodes = fem.Function(W)
    at_nodes.interpolate(fem.Expression(mises, points() if callable(points) else points))
    print(json.dumps({"peak": float(at_nodes.x.array.max()),
                      "equations": V.dofmap.index_map.size_global * 3,
                      "seconds": time.process_time() - started}))


if __name__ == "__main__":
    main()
