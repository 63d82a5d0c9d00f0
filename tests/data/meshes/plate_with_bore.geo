// Plate 40 x 40 x 4 (mm) with a bore of radius 5 at the origin: O-grid of
// eight facets of 45 deg per quarter-pair, two layers; all sides named.
SetFactory("Built-in");
DefineConstant[ n = 2 ];   // facets per 45 deg
r = 5; h = 20; t = 4; s = r*Sqrt(0.5);
Point(1) = {0,0,0};
For i In {0:7}
  a = i*Pi/4;
  c = Cos(a); d = Sin(a); m = (i % 2 == 0) ? h : h*Sqrt(2);
  Point(10+i) = {r*c, r*d, 0};
  Point(20+i) = {m*c, m*d, 0};
  Line(20+i) = {10+i, 20+i};
EndFor
For i In {0:7}
  j = (i+1) % 8;
  Circle(10+i) = {10+i, 1, 10+j};
  Line(30+i) = {20+i, 20+j};
  Curve Loop(i+1) = {20+i, 30+i, -(20+j), -(10+i)};
  Plane Surface(i+1) = {i+1};
EndFor
Transfinite Curve {10:17, 30:37} = n + 1;
Transfinite Curve {20:27} = 3 Using Progression 1.6;
Transfinite Surface {1:8};
Recombine Surface {1:8};
out[] = {};
bore[] = {}; side[] = {}; top[] = {}; vol[] = {};
For i In {1:8}
  e[] = Extrude {0,0,t} { Surface{i}; Layers{2}; Recombine; };
  top[] += e[0]; vol[] += e[1]; side[] += e[3]; bore[] += e[5];
EndFor
Physical Volume("body") = vol[];
Physical Surface("bore_A") = bore[];
Physical Surface("right") = {side[0], side[7]};
Physical Surface("left") = {side[3], side[4]};
Physical Surface("top") = top[];
