// A ribbed bracket: a foot with four bolt holes, an upright wall with a bearing
// boss, two ribs on either side. Every inner corner is filleted. Millimetres;
// the boss runs along x.
SetFactory("OpenCASCADE");
Box(1) = {-60, -45, 0, 120, 90, 12};
Box(2) = {-8, -30, 12, 16, 60, 63};
Cylinder(3) = {-8, 0, 75, 16, 0, 0, 30};
Cylinder(4) = {-20, 0, 75, 40, 0, 0, 22};
// Ribs: triangles before and behind the wall, 10 mm thick.
For i In {0 : 3}
  side = (i < 2) ? 1 : -1;
  y = (i % 2) ? 14 : -24;
  p = newp;
  Point(p) = {side * 8, y, 12}; Point(p + 1) = {side * 50, y, 12};
  Point(p + 2) = {side * 8, y, 48};
  c = newl;
  Line(c) = {p, p + 1}; Line(c + 1) = {p + 1, p + 2}; Line(c + 2) = {p + 2, p};
  k = newll; Curve Loop(k) = {c : c + 2};
  f = news; Plane Surface(f) = {k};
  e() = Extrude {0, 10, 0} { Surface{f}; };
  ribs(i) = e(1);
EndFor
u() = BooleanUnion{ Volume{1}; Delete; }{ Volume{2, 3, 4, ribs()}; Delete; };
// Inner corners: on the foot, up the wall beside the ribs, round the boss.
foot() = Curve In BoundingBox {-50.1, -30.1, 11.9, 50.1, 30.1, 12.1};
For s In {-1 : 1 : 2}
  wall() += Curve In BoundingBox {s * 8 - 0.1, -24.1, 11.9, s * 8 + 0.1, 24.1, 48.1};
  boss() += Curve In BoundingBox {s * 8 - 0.1, -22.1, 52.9, s * 8 + 0.1, 22.1, 97.1};
EndFor
inner() = {foot(), wall(), boss()};
inner() = Unique(inner());
v() = Fillet{u()}{inner()}{3};
Cylinder(401) = {-50, 0, 75, 100, 0, 0, 14};
For i In {0 : 3}
  Cylinder(402 + i) = {(i % 2) ? 48 : -48, (i < 2) ? 36 : -36, -5, 0, 0, 30, 5.5};
EndFor
BooleanDifference(500) = { Volume{v()}; Delete; }{ Volume{401 : 405}; Delete; };
