// Rod FE2 of the landing gear's cylinder: an eye, a round rod and the piston.
//
// Unit mm. Frame L: origin at bore E, x along the rod towards the piston, z
// along the bore. Hexahedra of order 3, so that loft and flare keep their
// curvature.
//
// The cross-section is a core of 2 x 2 cells within a ring of 8. The same
// pattern runs from the wall of the bore (station 0) through the neck between
// the fillets to a rectangle (1), through the loft to the round rod (2, 3),
// through the flare to the piston (4, 5). The rest of the eye has two layers
// of cells in z and meets the neck's sides.

// ---- dimensions (edit here, or give `parameters` in the scene) -----------
DefineConstant[
  bore_radius = 7.5,
  boss_radius = 12,
  eye_thickness = 8,
  neck_width = 16,        // of the eye at the end of its fillets
  fillet_radius = 8,
  rod_radius = 4,
  loft_end = 36,          // x where the rod becomes round
  flare_start = 110,      // x where the rod begins to widen
  piston_radius = 7.5,
  piston_length = 12,
  piston_face_x = 140
];

// ---- mesh density ---------------------------------------------------------
n_wall = 3;    // cells from the bore outwards
n_fillet = 2;  // cells along a fillet; fewer do not determine its cylinder
n_boss = 5;    // cells along half of the free boss
n_loft = 3;
n_rod = 4;
n_flare = 5;
n_piston = 2;

// ---- derived --------------------------------------------------------------
half_width = neck_width / 2;
zt = eye_thickness / 2;
fillet_x = Sqrt((boss_radius + fillet_radius)^2 - (half_width + fillet_radius)^2);
tangent_angle = Atan2(half_width + fillet_radius, fillet_x);
corner_angle = Atan2(half_width, fillet_x);

// ---- section pattern ------------------------------------------------------
// Points 0-8: core, y = -, 0, + fastest, then z; 9-16: rim, from (-, -)
// counter-clockwise seen against x. Edges 0-5: core along y; 6-11: core along
// z; 12-19: core to rim; 20-27: rim. Faces 0-3: core; 4-11: ring.
around[] = {0, 1, 2, 5, 8, 7, 6, 3};          // core points below the rim's
around_edge[] = {0, 1, 8, 11, 5, 4, 9, 6};    // core edges between them
around_sign[] = {1, 1, 1, 1, -1, -1, -1, -1};
rim_y[] = {-1, 0, 1, 1, 1, 0, -1, -1};
rim_z[] = {-1, -1, -1, 0, 1, 1, 1, 0};
edge_from[] = {0, 1, 3, 4, 6, 7, 0, 1, 2, 3, 4, 5};
edge_to[] = {1, 2, 4, 5, 7, 8, 3, 4, 5, 6, 7, 8};
For j In {0 : 7}
  edge_from[] += around[j];
  edge_to[] += 9 + j;
EndFor
For j In {0 : 7}
  edge_from[] += 9 + j;
  edge_to[] += 9 + (j + 1) % 8;
EndFor
volumes[] = {};

// Makes the edges of a section that are still 0 in edges[] as straight lines,
// and the faces of the section. Leaves faces[].
Macro CloseSection
  For e In {0 : 27}
    If (edges[e] == 0)
      edges[e] = newl; Line(edges[e]) = {points[edge_from[e]], points[edge_to[e]]};
    EndIf
    Transfinite Curve {edges[e]} = 2;
  EndFor
  faces[] = {};
  For r In {0 : 1}
    For c In {0 : 1}
      loop = newll;
      Curve Loop(loop) = {edges[2 * r + c], edges[7 + 3 * r + c], -edges[2 * r + 2 + c], -edges[6 + 3 * r + c]};
      face = news; Surface(face) = {loop};
      faces[] += face;
    EndFor
  EndFor
  For j In {0 : 7}
    loop = newll;
    Curve Loop(loop) = {edges[12 + j], edges[20 + j], -edges[12 + (j + 1) % 8], -around_sign[j] * edges[around_edge[j]]};
    face = news; Surface(face) = {loop};
    faces[] += face;
  EndFor
  Transfinite Surface {faces[]};
  Recombine Surface {faces[]};
Return

// A round section of radius `radius` in the plane x = section_x. Leaves
// points[], edges[] and faces[].
Macro RoundSection
  middle = newp; Point(middle) = {section_x, 0, 0};
  points[] = {};
  For r In {-1 : 1}
    For c In {-1 : 1}
      // Corners of the core at 0.6 of the radius, its mid-sides at 0.5.
      If (r == 0 || c == 0)
        size = 0.5 * radius;
      Else
        size = 0.6 * Sqrt(0.5) * radius;
      EndIf
      p = newp; Point(p) = {section_x, c * size, r * size};
      points[] += p;
    EndFor
  EndFor
  For j In {0 : 7}
    size = radius / Sqrt(Fabs(rim_y[j]) + Fabs(rim_z[j]));
    p = newp; Point(p) = {section_x, rim_y[j] * size, rim_z[j] * size};
    points[] += p;
  EndFor
  edges[] = {};
  For e In {0 : 27}
    edges[] += 0;
  EndFor
  For j In {0 : 7}
    edges[20 + j] = newl;
    Circle(edges[20 + j]) = {points[9 + j], middle, points[9 + (j + 1) % 8]};
  EndFor
  Call CloseSection;
Return

// Remembers the section as the start of the next span.
Macro StartSpan
  points_a[] = points[];
  edges_a[] = edges[];
  faces_a[] = faces[];
Return

// Hexahedra from the remembered section to the current one, n_span cells
// long, graded by `progression`. smooth = 1: the lines between them leave and
// arrive along x. Leaves the swept curves in along[], the faces that the
// edges sweep in swept[].
Macro Span
  along[] = {};
  For i In {0 : 16}
    curve = newl;
    If (smooth == 1)
      from[] = Point{points_a[i]};
      to[] = Point{points[i]};
      third = (to[0] - from[0]) / 3;
      p = newp; Point(p) = {from[0] + third, from[1], from[2]};
      q = newp; Point(q) = {to[0] - third, to[1], to[2]};
      Bezier(curve) = {points_a[i], p, q, points[i]};
    Else
      Line(curve) = {points_a[i], points[i]};
    EndIf
    along[] += curve;
    Transfinite Curve {curve} = n_span + 1 Using Progression progression;
  EndFor
  swept[] = {};
  For e In {0 : 27}
    loop = newll;
    Curve Loop(loop) = {edges_a[e], along[edge_to[e]], -edges[e], -along[edge_from[e]]};
    face = news; Surface(face) = {loop};
    Transfinite Surface {face};
    Recombine Surface {face};
    swept[] += face;
  EndFor
  For k In {0 : 11}
    If (k < 4)
      r = (k - k % 2) / 2; c = k % 2;
      sides[] = {swept[2 * r + c], swept[7 + 3 * r + c], swept[2 * r + 2 + c], swept[6 + 3 * r + c]};
    Else
      j = k - 4;
      sides[] = {swept[12 + j], swept[20 + j], swept[12 + (j + 1) % 8], swept[around_edge[j]]};
    EndIf
    loop = newsl; Surface Loop(loop) = {faces_a[k], faces[k], sides[]};
    v = newv; Volume(v) = {loop};
    Transfinite Volume {v};
    volumes[] += v;
  EndFor
Return

// The section on the wall of the bore, a patch of its cylinder.
Macro BoreSection
  core_angle = 0.6 * corner_angle;
  zc = 0.5 * zt;
  level[] = {-zt, -zc, 0, zc, zt};
  axis[] = {};
  For i In {0 : 4}
    p = newp; Point(p) = {0, 0, level[i]};
    axis[] += p;
  EndFor
  points[] = {};
  For r In {-1 : 1}
    For c In {-1 : 1}
      p = newp; Point(p) = {bore_radius * Cos(c * core_angle), bore_radius * Sin(c * core_angle), r * zc};
      points[] += p;
    EndFor
  EndFor
  For j In {0 : 7}
    a = rim_y[j] * corner_angle;
    p = newp; Point(p) = {bore_radius * Cos(a), bore_radius * Sin(a), rim_z[j] * zt};
    points[] += p;
  EndFor
  edges[] = {};
  For e In {0 : 27}
    edges[] += 0;
  EndFor
  For e In {0 : 5}  // arcs of the core
    edges[e] = newl;
    Circle(edges[e]) = {points[edge_from[e]], axis[1 + (e - e % 2) / 2], points[edge_to[e]]};
  EndFor
  For j In {0 : 6 : 2}  // diagonals: helices
    through[] = {points[around[j]]};
    For i In {1 : 15}
      a = rim_y[j] * (core_angle + (corner_angle - core_angle) * i / 16);
      p = newp; Point(p) = {bore_radius * Cos(a), bore_radius * Sin(a), rim_z[j] * (zc + (zt - zc) * i / 16)};
      through[] += p;
    EndFor
    through[] += points[9 + j];
    edges[12 + j] = newl; Spline(edges[12 + j]) = {through[]};
  EndFor
  For j In {3 : 7 : 4}
    edges[12 + j] = newl; Circle(edges[12 + j]) = {points[around[j]], axis[2], points[9 + j]};
  EndFor
  For j In {0 : 1}  // rim
    edges[20 + j] = newl; Circle(edges[20 + j]) = {points[9 + j], axis[0], points[10 + j]};
    edges[24 + j] = newl; Circle(edges[24 + j]) = {points[13 + j], axis[4], points[14 + j]};
  EndFor
  Call CloseSection;
Return

// The rectangle where the neck ends.
Macro RectangleSection
  points[] = {};
  For r In {-1 : 1}
    For c In {-1 : 1}
      p = newp; Point(p) = {fillet_x, c * 0.6 * half_width, r * 0.5 * zt};
      points[] += p;
    EndFor
  EndFor
  For j In {0 : 7}
    p = newp; Point(p) = {fillet_x, rim_y[j] * half_width, rim_z[j] * zt};
    points[] += p;
  EndFor
  edges[] = {};
  For e In {0 : 27}
    edges[] += 0;
  EndFor
  Call CloseSection;
Return

// ---- the rest of the eye --------------------------------------------------
// A radial cut through the eye has the points inner[] and outer[] at z = -zt,
// 0, zt, the edges radial[] (3), upright_in[] and upright_out[] (2 each) and
// two faces cut[]. EyeSpan fills the sector between the cut *_a and the cut
// *_b with n_arc cells; the outer wall is an arc around (x_arc, y_arc).

// A cut in the direction `angle`, from the bore to the boss.
Macro EyeCut
  inner_b[] = {}; outer_b[] = {}; radial_b[] = {}; in_b[] = {}; out_b[] = {}; cut_b[] = {};
  For i In {-1 : 1}
    p = newp; Point(p) = {bore_radius * Cos(angle), bore_radius * Sin(angle), i * zt};
    q = newp; Point(q) = {boss_radius * Cos(angle), boss_radius * Sin(angle), i * zt};
    inner_b[] += p;
    outer_b[] += q;
    curve = newl; Line(curve) = {p, q};
    Transfinite Curve {curve} = n_wall + 1 Using Progression wall_progression;
    radial_b[] += curve;
  EndFor
  For i In {0 : 1}
    curve = newl; Line(curve) = {inner_b[i], inner_b[i + 1]};
    in_b[] += curve;
    curve = newl; Line(curve) = {outer_b[i], outer_b[i + 1]};
    out_b[] += curve;
    Transfinite Curve {in_b[i], out_b[i]} = 2;
    loop = newll; Curve Loop(loop) = {radial_b[i], out_b[i], -radial_b[i + 1], -in_b[i]};
    face = news; Surface(face) = {loop};
    cut_b[] += face;
  EndFor
  Transfinite Surface {cut_b[]};
  Recombine Surface {cut_b[]};
Return

Macro EyeSpan
  arc_in[] = {}; arc_out[] = {}; flat[] = {}; wall_in[] = {}; wall_out[] = {};
  For i In {0 : 2}
    p = newp; Point(p) = {x_arc, y_arc, (i - 1) * zt};
    curve = newl; Circle(curve) = {inner_a[i], axis[2 * i], inner_b[i]};
    arc_in[] += curve;
    curve = newl; Circle(curve) = {outer_a[i], p, outer_b[i]};
    arc_out[] += curve;
    Transfinite Curve {arc_in[i], arc_out[i]} = n_arc + 1;
    loop = newll; Curve Loop(loop) = {radial_a[i], arc_out[i], -radial_b[i], -arc_in[i]};
    face = news; Surface(face) = {loop};
    flat[] += face;
  EndFor
  For i In {0 : 1}
    loop = newll; Curve Loop(loop) = {in_a[i], arc_in[i + 1], -in_b[i], -arc_in[i]};
    face = news; Surface(face) = {loop};
    wall_in[] += face;
    loop = newll; Curve Loop(loop) = {out_a[i], arc_out[i + 1], -out_b[i], -arc_out[i]};
    face = news; Surface(face) = {loop};
    wall_out[] += face;
  EndFor
  Transfinite Surface {flat[], wall_in[], wall_out[]};
  Recombine Surface {flat[], wall_in[], wall_out[]};
  For i In {0 : 1}
    loop = newsl; Surface Loop(loop) = {cut_a[i], cut_b[i], flat[i], flat[i + 1], wall_in[i], wall_out[i]};
    v = newv; Volume(v) = {loop};
    Transfinite Volume {v};
    volumes[] += v;
  EndFor
  bore[] += wall_in[];
  outside[] += wall_out[];
  bottom_faces[] += flat[0];
  top_faces[] += flat[2];
  inner_a[] = inner_b[]; outer_a[] = outer_b[]; radial_a[] = radial_b[];
  in_a[] = in_b[]; out_a[] = out_b[]; cut_a[] = cut_b[];
Return

// ---- eye and neck ---------------------------------------------------------
wall_progression = 1.3;
Call BoreSection;
bore[] = faces[];
edges_bore[] = edges[]; points_bore[] = points[];
Call StartSpan;
Call RectangleSection;
n_span = n_wall; progression = wall_progression; smooth = 0;
Call Span;
bottom_faces[] = {swept[20], swept[21]};
top_faces[] = {swept[24], swept[25]};
points_neck[] = points[]; edges_neck[] = edges[]; faces_neck[] = faces[];

// Around the eye from the neck's side y > 0 to its side y < 0.
inner_a[] = {points_bore[11], points_bore[12], points_bore[13]};
outer_a[] = {points[11], points[12], points[13]};
radial_a[] = {along[11], along[12], along[13]};
in_a[] = {edges_bore[22], edges_bore[23]};
out_a[] = {edges[22], edges[23]};
cut_a[] = {swept[22], swept[23]};
inner_end[] = {points_bore[9], points_bore[16], points_bore[15]};
outer_end[] = {points[9], points[16], points[15]};
radial_end[] = {along[9], along[16], along[15]};
in_end[] = {-edges_bore[27], -edges_bore[26]};
out_end[] = {-edges[27], -edges[26]};
cut_end[] = {swept[27], swept[26]};

outside[] = {};
n_arc = n_fillet; x_arc = fillet_x; y_arc = half_width + fillet_radius;
angle = tangent_angle;
Call EyeCut;
Call EyeSpan;
fillet_1[] = outside[];
outside[] = {};
n_arc = n_boss; x_arc = 0; y_arc = 0;
angle = Pi;
Call EyeCut;
Call EyeSpan;
angle = -tangent_angle;
Call EyeCut;
Call EyeSpan;
boss[] = outside[];
outside[] = {};
n_arc = n_fillet; x_arc = fillet_x; y_arc = -half_width - fillet_radius;
inner_b[] = inner_end[]; outer_b[] = outer_end[]; radial_b[] = radial_end[];
in_b[] = in_end[]; out_b[] = out_end[]; cut_b[] = cut_end[];
Call EyeSpan;
fillet_2[] = outside[];

// ---- rod and piston -------------------------------------------------------
points[] = points_neck[]; edges[] = edges_neck[]; faces[] = faces_neck[];
Call StartSpan;
section_x = loft_end; radius = rod_radius;
Call RoundSection;
n_span = n_loft; progression = 1; smooth = 1;
Call Span;
loft[] = swept[{20 : 27}];
Call StartSpan;
section_x = flare_start;
Call RoundSection;
n_span = n_rod; smooth = 0;
Call Span;
rod[] = swept[{20 : 27}];
Call StartSpan;
section_x = piston_face_x - piston_length; radius = piston_radius;
Call RoundSection;
n_span = n_flare; smooth = 1;
Call Span;
flare[] = swept[{20 : 27}];
Call StartSpan;
section_x = piston_face_x;
Call RoundSection;
n_span = n_piston; smooth = 0;
Call Span;
piston[] = swept[{20 : 27}];

// ---- groups ---------------------------------------------------------------
// round_* are exact cylinders; loft and flare are not.
Physical Surface("bore_E") = {bore[]};
Physical Surface("round_boss_E") = {boss[]};
Physical Surface("round_fillet_1") = {fillet_1[]};
Physical Surface("round_fillet_2") = {fillet_2[]};
Physical Surface("round_rod") = {rod[]};
Physical Surface("round_piston") = {piston[]};
Physical Surface("piston_face") = {faces[]};
Physical Surface("loft") = {loft[]};
Physical Surface("flare") = {flare[]};
Physical Surface("top") = {top_faces[]};
Physical Surface("bottom") = {bottom_faces[]};
Physical Volume("body") = {volumes[]};

Mesh.ElementOrder = 3;
Mesh.HighOrderOptimize = 0;
