// A bracket: a foot with four bolt holes, an upright wall with a bearing boss,
// two side ribs and two ribs on the foot. Millimetres; the boss runs along x.
SetFactory("OpenCASCADE");
Box(1) = {-60, -45, 0, 120, 90, 12};
Box(2) = {-8, -30, 12, 16, 60, 78};
Cylinder(3) = {-20, 0, 75, 40, 0, 0, 24};
// Ribs: triangles before and behind the wall, 10 mm thick.
For i In {0 : 3}
  side = (i < 2) ? 1 : -1;
  y = (i % 2) ? 18 : -28;
  p = newp;
  Point(p) = {side * 8, y, 12}; Point(p + 1) = {side * 50, y, 12};
  Point(p + 2) = {side * 8, y, 62};
  c = newl;
  Line(c) = {p, p + 1}; Line(c + 1) = {p + 1, p + 2}; Line(c + 2) = {p + 2, p};
  k = newll; Curve Loop(k) = {c : c + 2};
  f = news; Plane Surface(f) = {k};
  e() = Extrude {0, 10, 0} { Surface{f}; };
  ribs(i) = e(1);
EndFor
u() = BooleanUnion{ Volume{1}; Delete; }{ Volume{2, 3, ribs()}; Delete; };
// Bearing bore and bolt holes.
Cylinder(401) = {-50, 0, 75, 100, 0, 0, 15};
For i In {0 : 3}
  Cylinder(402 + i) = {(i % 2) ? 48 : -48, (i < 2) ? 36 : -36, -5, 0, 0, 30, 5.5};
EndFor
BooleanDifference(500) = { Volume{u()}; Delete; }{ Volume{401 : 405}; Delete; };
