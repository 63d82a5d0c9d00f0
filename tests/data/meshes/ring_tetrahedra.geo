// The ring of ring.geo in tetrahedra.
DefineConstant[ n = 4 ];
cx = 3; cy = 4; z = 2;
Point(1) = {cx, cy, z};
For i In {0:3}
  Point(10+i) = {cx + 10*Cos(i*Pi/2), cy + 10*Sin(i*Pi/2), z};
  Point(20+i) = {cx + 20*Cos(i*Pi/2), cy + 20*Sin(i*Pi/2), z};
  Line(30+i) = {10+i, 20+i};
EndFor
bore[] = {}; round[] = {}; ends[] = {}; vol[] = {};
For i In {0:3}
  j = (i+1) % 4;
  Circle(10+i) = {10+i, 1, 10+j};
  Circle(20+i) = {20+i, 1, 20+j};
  Curve Loop(i+1) = {30+i, 20+i, -(30+j), -(10+i)};
  Plane Surface(i+1) = {i+1};
EndFor
Transfinite Curve {10:13, 20:23} = n + 1;
Transfinite Curve {30:33} = 2;


For i In {1:4}
  e[] = Extrude {0, 0, 6} { Surface{i}; Layers{1};  };
  vol[] += e[1]; round[] += e[3]; bore[] += e[5]; ends[] += {i, e[0]};
EndFor
Physical Volume("body") = vol[];
Physical Surface("bore_A") = bore[];
Physical Surface("round_rim") = round[];
Physical Surface("ends") = ends[];
