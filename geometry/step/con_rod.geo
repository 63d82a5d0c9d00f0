// A connecting rod as if forged: I-section shank between a big and a small eye,
// fillets in the pockets
// and between shank and eyes. Millimetres; eyes along z, 120 mm apart along x.
SetFactory("OpenCASCADE");
l = 120; thick = 18; web = 6;
// Shank: tapers from 32 to 22 mm.
Point(1) = {0, 16, -thick / 2}; Point(2) = {l, 11, -thick / 2};
Point(3) = {l, -11, -thick / 2}; Point(4) = {0, -16, -thick / 2};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
s() = Extrude {0, 0, thick} { Surface{1}; };
// Eyes.
Cylinder(201) = {0, 0, -thick / 2, 0, 0, thick, 30};
Cylinder(202) = {l, 0, -thick / 2, 0, 0, thick, 18};
t() = BooleanUnion{ Volume{s(1)}; Delete; }{ Volume{201, 202}; Delete; };
// The corners between shank and eyes.
For y In {-1 : 1 : 2}
  corners() += Curve In BoundingBox
      {20, y * 13 - 4, -thick, 30, y * 13 + 4, thick};
  corners() += Curve In BoundingBox
      {100, y * 12 - 2.5, -thick, 112, y * 12 + 2.5, thick};
EndFor
u() = Fillet{t()}{corners()}{12};
// Pockets above and below, rounded all over by a fillet of 3 mm.
For z In {-1 : 1 : 2}
  p = newp;
  Point(p) = {38, 10.5, z * web / 2}; Point(p + 1) = {l - 25, 7.5, z * web / 2};
  Point(p + 2) = {l - 25, -7.5, z * web / 2}; Point(p + 3) = {38, -10.5, z * web / 2};
  c = newl;
  Line(c) = {p, p + 1}; Line(c + 1) = {p + 1, p + 2};
  Line(c + 2) = {p + 2, p + 3}; Line(c + 3) = {p + 3, p};
  k = newll; Curve Loop(k) = {c : c + 3};
  f = news; Plane Surface(f) = {k};
  e() = Extrude {0, 0, z * thick} { Surface{f}; };
  // Edges along z first, then those of the bottom.
  upright() = {};
  around() = Abs(Boundary{ Surface{e(2) : e(5)}; });
  around() = Unique(around());
  For i In {0 : #around() - 1}
    box() = BoundingBox Curve{around(i)};
    If (Abs(box(5) - box(2)) > 1)
      upright() += {around(i)};
    EndIf
  EndFor
  v() = Fillet{e(1)}{upright()}{6};
  bottom() = Curve In BoundingBox
      {30, -20, z * web / 2 - 0.01, l, 20, z * web / 2 + 0.01};
  If (z < 0)
    lower() = Fillet{v()}{bottom()}{2.5};
  Else
    upper() = Fillet{v()}{bottom()}{2.5};
  EndIf
EndFor
Cylinder(301) = {0, 0, -40, 0, 0, 80, 20};
Cylinder(302) = {l, 0, -40, 0, 0, 80, 11};
BooleanDifference(400) = { Volume{u()}; Delete; }
                       { Volume{301, 302, lower(), upper()}; Delete; };
