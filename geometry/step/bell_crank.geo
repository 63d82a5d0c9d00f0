// A bell crank: three bosses with bores on a plate whose arms stand at a right
// angle, tangent to round ends; fillets at the bosses and between the arms.
// Millimetres, axes along z.
SetFactory("OpenCASCADE");
web = 10;
arm[] = {90, 60};        // lengths along x and y
end[] = {18, 16};        // radii of the plate's ends
middle = 27;
For i In {0 : 1}
  // Tangent points of the circles: sine and cosine of the sides' slope.
  s = (middle - end[i]) / arm[i];
  c = Sqrt(1 - s * s);
  p = newp;
  Point(p) = {middle * s, middle * c, -web / 2};
  Point(p + 1) = {arm[i] + end[i] * s, end[i] * c, -web / 2};
  Point(p + 2) = {arm[i] + end[i] * s, -end[i] * c, -web / 2};
  Point(p + 3) = {middle * s, -middle * c, -web / 2};
  l = newl;
  Line(l) = {p, p + 1}; Line(l + 1) = {p + 1, p + 2};
  Line(l + 2) = {p + 2, p + 3}; Line(l + 3) = {p + 3, p};
  k = newll; Curve Loop(k) = {l : l + 3};
  f = news; Plane Surface(f) = {k};
  If (i == 1)
    Rotate {{0, 0, 1}, {0, 0, 0}, Pi / 2} { Surface{f}; }
  EndIf
  e() = Extrude {0, 0, web} { Surface{f}; };
  plate(i) = e(1);
EndFor
Cylinder(201) = {0, 0, -web / 2, 0, 0, web, middle};
Cylinder(202) = {arm[0], 0, -web / 2, 0, 0, web, end[0]};
Cylinder(203) = {0, arm[1], -web / 2, 0, 0, web, end[1]};
u() = BooleanUnion{ Volume{plate(0)}; Delete; }{ Volume{plate(1), 201 : 203}; Delete; };
inner() = Curve In BoundingBox {15, 15, -web, 30, 30, web};
v() = Fillet{u()}{inner()}{15};
Cylinder(204) = {0, 0, -15, 0, 0, 30, 20};
Cylinder(205) = {arm[0], 0, -12, 0, 0, 24, 12};
Cylinder(206) = {0, arm[1], -11, 0, 0, 22, 11};
w() = BooleanUnion{ Volume{v()}; Delete; }{ Volume{204 : 206}; Delete; };
// Circles where the bosses stand on the plate.
For z In {-1 : 1 : 2}
  h = z * web / 2;
  feet() += Curve In BoundingBox {-20.1, -20.1, h - 0.1, 20.1, 20.1, h + 0.1};
  feet() += Curve In BoundingBox {arm[0] - 12.1, -12.1, h - 0.1, arm[0] + 12.1, 12.1, h + 0.1};
  feet() += Curve In BoundingBox {-11.1, arm[1] - 11.1, h - 0.1, 11.1, arm[1] + 11.1, h + 0.1};
EndFor
g() = Fillet{w()}{feet()}{3};
Cylinder(301) = {0, 0, -40, 0, 0, 80, 12};
Cylinder(302) = {arm[0], 0, -40, 0, 0, 80, 7};
Cylinder(303) = {0, arm[1], -40, 0, 0, 80, 6};
BooleanDifference(400) = { Volume{g()}; Delete; }{ Volume{301 : 303}; Delete; };
