// Link AB of Bennett's linkage, and DC: a flat bar with an eye at each end, the far
// eye turned about the bar by the link's twist.
//
// Unit mm. Frame L: origin in bore A, x towards bore B, z along bore A, mid-plane
// of eye A at z = 0. All cells are hexahedra of order 2.

// ---- dimensions (edit here) ----------------------------------------------
length_ab = 100;
twist = 30;  // of bore B about x [degrees], less than 180
width = 12;  // of the bar and of its square eyes
thickness = 8;
bore_radius = 2.5;

// ---- mesh density ---------------------------------------------------------
quadrant = 4;  // cells round a quarter of a bore, also across the bar
rings = 3;     // cells from the bore to the eye's side
layers = 2;    // cells through the thickness
bar_cell = 20;  // length of a cell along the bar

// ---- derived --------------------------------------------------------------
half = width / 2;
bar_length = length_ab - width;
n_bar = Ceil(bar_length / bar_cell);

bore[] = {};
sides[] = {};
flats[] = {};
volumes[] = {};

// An eye about x = cx, turned about x: four blocks from the bore to the sides.
// Leaves the side towards the bar, at the angle facing, in cut, all else in the
// lists.
Macro Eye
  s = Sin(turned * Pi / 180); c = Cos(turned * Pi / 180);
  z = -thickness / 2;
  centre = newp; Point(centre) = {cx, -z * s, z * c};
  For i In {0 : 3}
    at = facing + (2 * i - 1) * Pi / 4;
    x = bore_radius * Cos(at); y = bore_radius * Sin(at);
    inner[i] = newp; Point(inner[i]) = {cx + x, y * c - z * s, y * s + z * c};
    x = half * Sqrt(2) * Cos(at); y = half * Sqrt(2) * Sin(at);
    outer[i] = newp; Point(outer[i]) = {cx + x, y * c - z * s, y * s + z * c};
    ray[i] = newl; Line(ray[i]) = {inner[i], outer[i]};
    Transfinite Curve {ray[i]} = rings + 1 Using Progression 1.2;
  EndFor
  bore[] = {};
  For i In {0 : 3}
    j = (i + 1) % 4;
    arc = newl; Circle(arc) = {inner[i], centre, inner[j]};
    side = newl; Line(side) = {outer[i], outer[j]};
    Transfinite Curve {arc, side} = quadrant + 1;
    loop = newll; Curve Loop(loop) = {-arc, ray[i], side, -ray[j]};
    face = news; Surface(face) = {loop};
    Transfinite Surface {face};
    Recombine Surface {face};
    swept[] = Extrude {0, -thickness * s, thickness * c} { Surface{face}; Layers{layers}; Recombine; };
    flats[] += {face, swept[0]};
    volumes[] += swept[1];
    bore[] += swept[2];
    If (i == 0)
      cut = swept[4];
    Else
      sides[] += swept[4];
    EndIf
  EndFor
Return

// ---- eyes -----------------------------------------------------------------
cx = 0; facing = 0; turned = 0;
Call Eye;
Physical Surface("bore_A") = {bore[]};
cut_A = cut;
cx = length_ab; facing = Pi; turned = twist;
Call Eye;
Physical Surface("bore_B") = {bore[]};

// ---- bar ------------------------------------------------------------------
swept[] = Extrude { {bar_length, 0, 0}, {1, 0, 0}, {0, 0, 0}, twist * Pi / 180 } {
  Surface{cut_A}; Layers{n_bar}; Recombine;
};
volumes[] += swept[1];
sides[] += {swept[2], swept[3], swept[4], swept[5]};
Coherence;

// ---- groups ---------------------------------------------------------------
Physical Surface("side") = {sides[]};
Physical Surface("flat") = {flats[]};
Physical Volume("body") = {volumes[]};
Mesh.ElementOrder = 2;
