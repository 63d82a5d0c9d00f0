// Cook's membrane: (0,0) (48,44) (48,60) (0,44), thickness 1. Unit mm.

cells = 6;  // along each side

Point(1) = {0, 0, 0};
Point(2) = {48, 44, 0};
Point(3) = {48, 60, 0};
Point(4) = {0, 44, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Transfinite Curve {1:4} = cells + 1;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};
swept[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("body") = {swept[1]};
Physical Surface("tip") = {swept[3]};
Physical Surface("root") = {swept[5]};
