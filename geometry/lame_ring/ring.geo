// Quarter of a ring, radii 10 and 20, thickness 2. Unit mm. The walls are
// exact cylinders by their names.

around = 4;   // cells over 90 degrees
radial = 3;   // cells through the wall
thickness = 2;

Point(1) = {0, 0, 0};
Point(2) = {10, 0, 0};
Point(3) = {20, 0, 0};
Point(4) = {0, 20, 0};
Point(5) = {0, 10, 0};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Transfinite Curve {1} = radial + 1 Using Progression 1.3;
Transfinite Curve {3} = radial + 1 Using Progression 1 / 1.3;
Transfinite Curve {2, 4} = around + 1;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};
swept[] = Extrude {0, 0, thickness} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("body") = {swept[1]};
Physical Surface("along_x") = {swept[2]};
Physical Surface("round_rim") = {swept[3]};
Physical Surface("along_y") = {swept[4]};
Physical Surface("bore_wall") = {swept[5]};
