// A flat link with round ends, 120 mm from bore A to bore B, drawn in its mid-plane.
// Unit mm; origin at bore A, x towards bore B.
length = 120;
end_radius = 18;
bore_radius = 8;

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
For i In {0 : 1}  // a bore and its end
  x = i * length;
  s = 1 - 2 * i;
  p = 10 * (i + 1);
  Point(p + 1) = {x, -s * end_radius, 0};
  Point(p + 2) = {x - s * end_radius, 0, 0};
  Point(p + 3) = {x, s * end_radius, 0};
  Circle(p + 1) = {p + 1, i + 1, p + 2};
  Circle(p + 2) = {p + 2, i + 1, p + 3};
  Point(p + 4) = {x + bore_radius, 0, 0};
  Point(p + 5) = {x - bore_radius, 0, 0};
  Circle(p + 4) = {p + 4, i + 1, p + 5};
  Circle(p + 5) = {p + 5, i + 1, p + 4};
  Curve Loop(i + 2) = {p + 4, p + 5};
EndFor
Line(1) = {13, 21};
Line(2) = {23, 11};
Curve Loop(1) = {11, 12, 1, 21, 22, 2};
Plane Surface(1) = {1, 2, 3};

Physical Curve("bore_A") = {14, 15};
Physical Curve("bore_B") = {24, 25};
Physical Surface("body") = {1};

MeshSize {:} = 5;
Transfinite Curve {14, 15, 24, 25} = 13;  // 12 cells round half a bore
Mesh.RecombineAll = 1;
Mesh.ElementOrder = 2;
