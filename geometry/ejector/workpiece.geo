// Rod of 10 mm, 60 mm free; clamped at z = 0, struck at z = 60. Unit mm.

radius = 5;
length = 60;
core = 2.3;     // half the width of the square in the middle
around = 2;     // cells along a quarter
layers = 10;    // along the rod,
growth = 1.4;  // from the clamp outwards

Point(1) = {0, 0, 0};
Point(2) = {core, core, 0};
Point(3) = {-core, core, 0};
Point(4) = {-core, -core, 0};
Point(5) = {core, -core, 0};
d = radius / Sqrt(2);
Point(6) = {d, d, 0};
Point(7) = {-d, d, 0};
Point(8) = {-d, -d, 0};
Point(9) = {d, -d, 0};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 2};
Circle(5) = {6, 1, 7};
Circle(6) = {7, 1, 8};
Circle(7) = {8, 1, 9};
Circle(8) = {9, 1, 6};
Line(9) = {2, 6};
Line(10) = {3, 7};
Line(11) = {4, 8};
Line(12) = {5, 9};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {9, 5, -10, -1};
Curve Loop(3) = {10, 6, -11, -2};
Curve Loop(4) = {11, 7, -12, -3};
Curve Loop(5) = {12, 8, -9, -4};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};
Plane Surface(5) = {5};
Transfinite Curve {1:8} = around + 1;
Transfinite Curve {9:12} = 2;
Transfinite Surface {1:5};
Recombine Surface {1:5};

// ends of the layers over the length
ends[] = {};
cells[] = {};
sum = 0;
For i In {1:layers}
  sum += growth^(i - 1);
EndFor
at = 0;
For i In {1:layers}
  at += growth^(i - 1) / sum;
  ends[i - 1] = at;
  cells[i - 1] = 1;
EndFor
ends[layers - 1] = 1;
rod[] = Extrude {0, 0, length} {
  Surface{1:5};
  Layers{cells[], ends[]};
  Recombine;
};
Physical Volume("body") = {rod[1], rod[7], rod[13], rod[19], rod[25]};
Physical Surface("root") = {1:5};
Physical Surface("tip") = {rod[0], rod[6], rod[12], rod[18], rod[24]};
Physical Surface("round_rod") = {rod[9], rod[15], rod[21], rod[27]};
Mesh.ElementOrder = 1;
