// NAFEMS LE1: quarter of an elliptic membrane, thickness 100 mm. Unit mm.
// A (0,1000) B (0,2750) C (3250,0) D (2000,0); ellipses 2000 x 1000 and
// 3250 x 2750. Order 3, so that the ellipses keep their curvature.

radial = 8;   // cells from the inner to the outer ellipse
around = 10;  // cells along the ellipses
thickness = 100;

Point(1) = {0, 0, 0};
Point(2) = {2000, 0, 0};
Point(3) = {3250, 0, 0};
Point(4) = {0, 2750, 0};
Point(5) = {0, 1000, 0};
Line(1) = {2, 3};
Ellipse(2) = {3, 1, 3, 4};
Line(3) = {4, 5};
Ellipse(4) = {5, 1, 2, 2};
Transfinite Curve {1, 3} = radial + 1;
Transfinite Curve {2, 4} = around + 1;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};
swept[] = Extrude {0, 0, thickness} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("body") = {swept[1]};
Physical Surface("CD") = {swept[2]};
Physical Surface("outer") = {swept[3]};
Physical Surface("AB") = {swept[4]};
Mesh.ElementOrder = 3;
