// An eighth of a ball of radius 10 (mm) about the origin, in curved tetrahedra
// of order 2.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 10, 0, Pi/2, Pi/2};
Mesh.MeshSizeMin = 4; Mesh.MeshSizeMax = 4;
Mesh.ElementOrder = 2;
Physical Volume("body") = {1};
Physical Surface("all") = Surface{:};
