// Ring of radii 10 and 20 (mm) about (3, 4) in the plane z = 5, 16 facets
// around and two cells through the wall; element type and order by the command
// line.
DefineConstant[ quads = 0 ];
cx = 3; cy = 4; z = 5;
Point(1) = {cx, cy, z};
For i In {0:3}
  Point(10+i) = {cx + 10*Cos(i*Pi/2), cy + 10*Sin(i*Pi/2), z};
  Point(20+i) = {cx + 20*Cos(i*Pi/2), cy + 20*Sin(i*Pi/2), z};
  Line(30+i) = {10+i, 20+i};
EndFor
For i In {0:3}
  j = (i+1) % 4;
  Circle(10+i) = {10+i, 1, 10+j};
  Circle(20+i) = {20+i, 1, 20+j};
  Curve Loop(i+1) = {30+i, 20+i, -(30+j), -(10+i)};
  Plane Surface(i+1) = {i+1};
EndFor
Transfinite Curve {10:13, 20:23} = 5;
Transfinite Curve {30:33} = 3;
Transfinite Surface {1:4};
If (quads)
  Recombine Surface {1:4};
EndIf
Physical Surface("plate") = {1:4};
Physical Curve("bore_A") = {10:13};
Physical Curve("rim") = {20:23};
