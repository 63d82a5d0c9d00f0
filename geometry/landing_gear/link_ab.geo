// Link AB of the landing gear: a flat bar with an eye at each end.
//
// Unit mm. Frame L: origin at bore A, x towards bore B, z along the bores,
// mid-plane z = 0. All cells are hexahedra, one layer through the thickness.

// ---- dimensions (edit here, or give `parameters` in the scene) -----------
DefineConstant[
  length_ab = 140,
  bore_radius = 7.5,
  boss_radius = 12,
  bar_width = 18,
  fillet_radius = 10,     // tangent to the bar and to the boss
  thickness = 5
];

// ---- mesh density ---------------------------------------------------------
h = 1;         // 1: as committed, 0.5: twice as fine in the plane
bore_cell = 20;  // angle of a cell at the bore [degrees]
rings = 3;       // cells from the bore to the boss
bar_cell = 10;   // length of a cell along the bar

// ---- derived --------------------------------------------------------------
half_width = bar_width / 2;
z = -thickness / 2;
// The fillet's centre lies fillet_x beside the eye and half_width +
// fillet_radius above the axis; the bar is straight from fillet_x on.
fillet_x = Sqrt((boss_radius + fillet_radius)^2 -
                (half_width + fillet_radius)^2);
tangent_angle = Atan2(half_width + fillet_radius, fillet_x);
corner_angle = Atan2(half_width, fillet_x);
cell_angle = h * bore_cell * Pi / 180;
n_bar = 2 * Ceil(corner_angle / cell_angle - 0.2);
n_fillet = Ceil((tangent_angle - corner_angle) / cell_angle - 0.2);
n_boss = Ceil((Pi - tangent_angle) / cell_angle - 0.2);
n_ring = Ceil(rings / h);
n_length = Ceil((length_ab - 2 * fillet_x) / (h * bar_cell));

bottom_faces[] = {};
top_faces[] = {};
side_faces[] = {};
volumes[] = {};
fillets[] = {};

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
  bottom_faces[] += face;
  top_faces[] += swept[0];
  volumes[] += swept[1];
  wall[] = {swept[2], swept[3], swept[4], swept[5]};
Return

// The part of an eye that faces a bar: two fillet blocks and the block between
// them, which ends at the cut across the bar. The eye's centre is at x = cx
// (point centre), the bar leaves towards +x (s = 1) or -x (s = -1; turned by 180 degrees).
// Leaves bore walls in bore[], the end points and radial lines in *_first
// and *_last (counter-clockwise), the cut in cut and its points.
Macro FacingBar
  b0 = newp; Point(b0) = {cx + s * bore_radius * Cos(tangent_angle), -s * bore_radius * Sin(tangent_angle), z};
  b1 = newp; Point(b1) = {cx + s * bore_radius * Cos(corner_angle), -s * bore_radius * Sin(corner_angle), z};
  b2 = newp; Point(b2) = {cx + s * bore_radius * Cos(corner_angle), s * bore_radius * Sin(corner_angle), z};
  b3 = newp; Point(b3) = {cx + s * bore_radius * Cos(tangent_angle), s * bore_radius * Sin(tangent_angle), z};
  t0 = newp; Point(t0) = {cx + s * boss_radius * Cos(tangent_angle), -s * boss_radius * Sin(tangent_angle), z};
  t1 = newp; Point(t1) = {cx + s * fillet_x, -s * half_width, z};
  t2 = newp; Point(t2) = {cx + s * fillet_x, s * half_width, z};
  t3 = newp; Point(t3) = {cx + s * boss_radius * Cos(tangent_angle), s * boss_radius * Sin(tangent_angle), z};
  f0 = newp; Point(f0) = {cx + s * fillet_x, -s * (half_width + fillet_radius), z};
  f1 = newp; Point(f1) = {cx + s * fillet_x, s * (half_width + fillet_radius), z};
  a0 = newl; Circle(a0) = {b0, centre, b1};
  a1 = newl; Circle(a1) = {b1, centre, b2};
  a2 = newl; Circle(a2) = {b2, centre, b3};
  o0 = newl; Circle(o0) = {t0, f0, t1};
  cut = newl; Line(cut) = {t1, t2};
  o2 = newl; Circle(o2) = {t2, f1, t3};
  r0 = newl; Line(r0) = {b0, t0};
  r1 = newl; Line(r1) = {b1, t1};
  r2 = newl; Line(r2) = {b2, t2};
  r3 = newl; Line(r3) = {b3, t3};
  Transfinite Curve {a0, a2, o0, o2} = n_fillet + 1;
  Transfinite Curve {a1, cut} = n_bar + 1;
  Transfinite Curve {r0, r1, r2, r3} = n_ring + 1 Using Progression 1.3^h;
  c1 = -a0; c2 = r0; c3 = o0; c4 = -r1; Call MeshBlock;
  bore[] += wall[0]; fillets[] += wall[2];
  c1 = -a1; c2 = r1; c3 = cut; c4 = -r2; Call MeshBlock;
  bore[] += wall[0];
  c1 = -a2; c2 = r2; c3 = o2; c4 = -r3; Call MeshBlock;
  bore[] += wall[0]; fillets[] += wall[2];
  bore_first = b0; boss_first = t0; radial_first = r0;
  bore_last = b3; boss_last = t3; radial_last = r3;
  cut_first = t1; cut_last = t2;
Return

// The free part of an end eye, from the last to the first radial line of
// FacingBar. Leaves the outer walls in boss[].
Macro FreeBoss
  bm = newp; Point(bm) = {cx - s * bore_radius, 0, z};
  tm = newp; Point(tm) = {cx - s * boss_radius, 0, z};
  rm = newl; Line(rm) = {bm, tm};
  a0 = newl; Circle(a0) = {bore_last, centre, bm};
  a1 = newl; Circle(a1) = {bm, centre, bore_first};
  o0 = newl; Circle(o0) = {boss_last, centre, tm};
  o1 = newl; Circle(o1) = {tm, centre, boss_first};
  Transfinite Curve {a0, a1, o0, o1} = n_boss + 1;
  Transfinite Curve {rm} = n_ring + 1 Using Progression 1.3^h;
  c1 = -a0; c2 = radial_last; c3 = o0; c4 = -rm; Call MeshBlock;
  bore[] += wall[0]; boss[] = {wall[2]};
  c1 = -a1; c2 = rm; c3 = o1; c4 = -radial_first; Call MeshBlock;
  bore[] += wall[0]; boss[] += wall[2];
Return

// ---- eyes -----------------------------------------------------------------
bore[] = {};
cx = 0; s = 1;
centre = newp; Point(centre) = {cx, 0, z};
Call FacingBar;
Call FreeBoss;
Physical Surface("bore_A") = {bore[]};
Physical Surface("round_boss_A") = {boss[]};
cut_A = cut; bottom_A = cut_first; top_A = cut_last;

bore[] = {};
cx = length_ab; s = -1;
centre = newp; Point(centre) = {cx, 0, z};
Call FacingBar;
Call FreeBoss;
Physical Surface("bore_B") = {bore[]};
Physical Surface("round_boss_B") = {boss[]};
cut_B = cut; top_B = cut_first; bottom_B = cut_last;

// ---- bar ------------------------------------------------------------------
lower = newl; Line(lower) = {bottom_A, bottom_B};
upper = newl; Line(upper) = {top_B, top_A};
Transfinite Curve {lower, upper} = n_length + 1 Using Bump 0.4;
c1 = lower; c2 = -cut_B; c3 = upper; c4 = -cut_A; Call MeshBlock;
side_faces[] += {wall[0], wall[2]};

// ---- groups ---------------------------------------------------------------
// Each fillet is a cylinder of its own.
For i In {0 : #fillets[] - 1}
  Physical Surface(Sprintf("round_fillet_%g", i + 1)) = {fillets[i]};
EndFor
Physical Surface("side") = {side_faces[]};
Physical Surface("top") = {top_faces[]};
Physical Surface("bottom") = {bottom_faces[]};
Physical Volume("body") = {volumes[]};
