// Crank of the braiding mechanism: a short web with a square eye at each end, from
// the shaft of the gear (A) to the pin of the coupler (B).
//
// Unit mm. Frame L: origin in bore A, x towards bore B, z along the bores,
// mid-plane z = 0. All cells are hexahedra, one layer through the thickness.

// ---- dimensions (edit here) ----------------------------------------------
length_ab = 10;
width = 8;  // of web and eyes
thickness = 5;
bore_radius = 2;

// ---- mesh density ---------------------------------------------------------
quadrant = 4;  // cells round a quarter of a bore, also across the web
rings = 3;     // cells from the bore to the eye's side
n_web = 1;     // cells along the web

// ---- derived --------------------------------------------------------------
half = width / 2;
z = -thickness / 2;

bore[] = {};
sides[] = {};
bottom[] = {};
top[] = {};
volumes[] = {};

// Meshes the four-sided block of the curves c1..c4 and extrudes it. The walls
// that c1..c4 sweep are left in wall[0..3].
Macro MeshBlock
  loop = newll;
  Curve Loop(loop) = {c1, c2, c3, c4};
  face = news;
  Surface(face) = {loop};
  Transfinite Surface {face};
  Recombine Surface {face};
  swept[] = Extrude {0, 0, thickness} { Surface{face}; Layers{1}; Recombine; };
  bottom[] += face;
  top[] += swept[0];
  volumes[] += swept[1];
  wall[] = {swept[2], swept[3], swept[4], swept[5]};
Return

// An eye about x = cx: four blocks from the bore to the sides. Leaves the side
// towards the web, at the angle facing, in cut and its ends in cut_from, cut_to.
Macro Eye
  centre = newp; Point(centre) = {cx, 0, z};
  For i In {0 : 3}
    at = facing + (2 * i - 1) * Pi / 4;
    inner[i] = newp; Point(inner[i]) = {cx + bore_radius * Cos(at), bore_radius * Sin(at), z};
    outer[i] = newp; Point(outer[i]) = {cx + half * Sqrt(2) * Cos(at), half * Sqrt(2) * Sin(at), z};
    ray[i] = newl; Line(ray[i]) = {inner[i], outer[i]};
    Transfinite Curve {ray[i]} = rings + 1 Using Progression 1.2;
  EndFor
  bore[] = {};
  For i In {0 : 3}
    j = (i + 1) % 4;
    arc = newl; Circle(arc) = {inner[i], centre, inner[j]};
    side = newl; Line(side) = {outer[i], outer[j]};
    Transfinite Curve {arc, side} = quadrant + 1;
    c1 = -arc; c2 = ray[i]; c3 = side; c4 = -ray[j]; Call MeshBlock;
    bore[] += wall[0];
    If (i == 0)
      cut = side; cut_from = outer[0]; cut_to = outer[1];
    Else
      sides[] += wall[2];
    EndIf
  EndFor
Return

// ---- eyes -----------------------------------------------------------------
cx = 0; facing = 0;
Call Eye;
Physical Surface("bore_A") = {bore[]};
cut_A = cut; bottom_A = cut_from; top_A = cut_to;
cx = length_ab; facing = Pi;
Call Eye;
Physical Surface("bore_B") = {bore[]};

// ---- web ------------------------------------------------------------------
lower = newl; Line(lower) = {bottom_A, cut_to};
upper = newl; Line(upper) = {cut_from, top_A};
Transfinite Curve {lower, upper} = n_web + 1;
c1 = lower; c2 = -cut; c3 = upper; c4 = -cut_A; Call MeshBlock;
sides[] += {wall[0], wall[2]};

// ---- groups ---------------------------------------------------------------
Physical Surface("side") = {sides[]};
Physical Surface("top") = {top[]};
Physical Surface("bottom") = {bottom[]};
Physical Volume("body") = {volumes[]};
