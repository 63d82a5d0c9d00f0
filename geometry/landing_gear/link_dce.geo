// Link DCE of the landing gear: a triangular plate, the convex hull of three
// bosses, so every outer edge is tangent to its bosses.
//
// Unit mm. Frame L: origin at bore D, x towards bore C, z along the bores,
// mid-plane z = 0; E lies at y > 0. All cells are hexahedra, one layer
// through the thickness.

// ---- dimensions (edit here, or give `parameters` in the scene) -----------
DefineConstant[
  length_dc = 140,
  length_de = 60,
  length_ce = 145,
  bore_radius = 7.5,
  boss_radius = 12,
  thickness = 8
];

// ---- mesh density ---------------------------------------------------------
h = 1;           // 1: as committed, 0.5: twice as fine in the plane
bore_cell = 22;  // angle of a cell at the bore [degrees]
rings = 3;       // cells across the block around a bore
web_short = 2;   // cells of the web along D-E and near C: 2 * web_short
web_long = 5;    // further cells of the web along D-C and E-C

// ---- derived --------------------------------------------------------------
x_D = 0; y_D = 0;
x_C = length_dc; y_C = 0;
x_E = (length_dc^2 + length_de^2 - length_ce^2) / (2 * length_dc);
y_E = Sqrt(length_de^2 - x_E^2);
// Outward normals of the three edges, angles from x; D, C, E run
// counter-clockwise, so the angles increase.
normal_DC = -Pi / 2;
normal_CE = Atan2(y_E - y_C, x_E - x_C) - Pi / 2;
normal_ED = Atan2(y_D - y_E, x_D - x_E) + 3 * Pi / 2;
cell_angle = h * bore_cell * Pi / 180;
n_ring = Ceil(rings / h);
n_half = Ceil(4 / h);  // from an edge's cut to the block's inner corner
p = Ceil(web_short / h);
q = Ceil(web_long / h);
z = -thickness / 2;

bottom_faces[] = {};
top_faces[] = {};
side_faces[] = {};
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
  bottom_faces[] += face;
  top_faces[] += swept[0];
  volumes[] += swept[1];
  wall[] = {swept[2], swept[3], swept[4], swept[5]};
Return

// The surroundings of one bore with centre (cx, cy): the boss between the
// edges with normals normal_in and normal_out, a stretch `reach` of both
// edges, and two cuts that meet at the inner corner, `depth` from the centre
// on the bisector. Leaves the walls in bore[], boss[], side_faces[], the cuts
// (edge to corner in cut_out, corner to edge in cut_in) and their points.
Macro Corner
  centre = newp; Point(centre) = {cx, cy, z};
  spread = Atan2(reach, boss_radius);
  inward = (normal_in + normal_out) / 2 + Pi;
  edge_distance = Sqrt(boss_radius^2 + reach^2);
  angle[] = {normal_in, normal_out, normal_out + spread, inward, normal_in - spread};
  distance[] = {boss_radius, boss_radius, edge_distance, depth, edge_distance};
  cells[] = {Ceil((normal_out - normal_in) / cell_angle - 0.2),
             Ceil(spread / cell_angle - 0.2), n_half, n_half,
             Ceil(spread / cell_angle - 0.2)};
  For i In {0 : 4}
    bp[i] = newp; Point(bp[i]) = {cx + bore_radius * Cos(angle[i]), cy + bore_radius * Sin(angle[i]), z};
    op[i] = newp; Point(op[i]) = {cx + distance[i] * Cos(angle[i]), cy + distance[i] * Sin(angle[i]), z};
    radial[i] = newl; Line(radial[i]) = {bp[i], op[i]};
    Transfinite Curve {radial[i]} = n_ring + 1 Using Progression 1.35^h;
  EndFor
  bore[] = {};
  For i In {0 : 4}
    j = (i + 1) % 5;
    arc = newl; Circle(arc) = {bp[i], centre, bp[j]};
    outer[i] = newl;
    If (i == 0)
      Circle(outer[i]) = {op[i], centre, op[j]};
    Else
      Line(outer[i]) = {op[i], op[j]};
    EndIf
    Transfinite Curve {arc, outer[i]} = cells[i] + 1;
    c1 = -arc; c2 = radial[i]; c3 = outer[i]; c4 = -radial[j];
    Call MeshBlock;
    bore[] += wall[0];
    If (i == 0)
      boss[] = {wall[2]};
    EndIf
    If (i == 1 || i == 4)
      side_faces[] += wall[2];
    EndIf
  EndFor
  p_out = op[2]; p_corner = op[3]; p_in = op[4];
  cut_out = outer[2]; cut_in = outer[3];
Return

// The strip of the web along one edge, from corner a to corner b, in two
// blocks that meet at the point m of the inner line. n_a, n_b: cells.
Macro Strip
  part = n_a / (n_a + n_b);
  xyz_a[] = Point{out_a};
  xyz_b[] = Point{in_b};
  m_edge = newp; Point(m_edge) = {xyz_a[0] + part * (xyz_b[0] - xyz_a[0]), xyz_a[1] + part * (xyz_b[1] - xyz_a[1]), z};
  xyz_a[] = Point{corner_a};
  xyz_b[] = Point{corner_b};
  x_m = xyz_a[0] + part * (xyz_b[0] - xyz_a[0]);
  y_m = xyz_a[1] + part * (xyz_b[1] - xyz_a[1]);
  m = newp; Point(m) = {x_m, y_m, z};
  edge_a = newl; Line(edge_a) = {out_a, m_edge};
  edge_b = newl; Line(edge_b) = {m_edge, in_b};
  inner_a = newl; Line(inner_a) = {corner_a, m};
  inner_b = newl; Line(inner_b) = {m, corner_b};
  across = newl; Line(across) = {m_edge, m};
  Transfinite Curve {edge_a, inner_a} = n_a + 1;
  Transfinite Curve {edge_b, inner_b} = n_b + 1;
  Transfinite Curve {across} = n_half + 1;
  c1 = edge_a; c2 = across; c3 = -inner_a; c4 = -cut_a;
  Call MeshBlock;
  side_faces[] += wall[0];
  c1 = edge_b; c2 = -cut_b; c3 = -inner_b; c4 = -across;
  Call MeshBlock;
  side_faces[] += wall[0];
Return

// ---- corners --------------------------------------------------------------
cx = x_D; cy = y_D; reach = 12; depth = 18;
normal_in = normal_ED - 2 * Pi; normal_out = normal_DC;
Call Corner;
Physical Surface("bore_D") = {bore[]};
Physical Surface("round_boss_D") = {boss[]};
out_D = p_out; in_D = p_in; corner_D = p_corner; cut_out_D = cut_out; cut_in_D = cut_in;

cx = x_C; cy = y_C; reach = 5; depth = 15;
normal_in = normal_DC; normal_out = normal_CE;
Call Corner;
Physical Surface("bore_C") = {bore[]};
Physical Surface("round_boss_C") = {boss[]};
out_C = p_out; in_C = p_in; corner_C = p_corner; cut_out_C = cut_out; cut_in_C = cut_in;

cx = x_E; cy = y_E; reach = 12; depth = 18;
normal_in = normal_CE; normal_out = normal_ED;
Call Corner;
Physical Surface("bore_E") = {bore[]};
Physical Surface("round_boss_E") = {boss[]};
out_E = p_out; in_E = p_in; corner_E = p_corner; cut_out_E = cut_out; cut_in_E = cut_in;

// ---- web ------------------------------------------------------------------
n_a = q; n_b = p;
out_a = out_D; corner_a = corner_D; cut_a = cut_out_D;
in_b = in_C; corner_b = corner_C; cut_b = cut_in_C;
Call Strip;
m_DC = m; x_DC = x_m; y_DC = y_m; D_DC = inner_a; DC_C = inner_b;

n_a = p; n_b = q;
out_a = out_C; corner_a = corner_C; cut_a = cut_out_C;
in_b = in_E; corner_b = corner_E; cut_b = cut_in_E;
Call Strip;
m_CE = m; x_CE = x_m; y_CE = y_m; C_CE = inner_a; CE_E = inner_b;

n_a = p; n_b = p;
out_a = out_E; corner_a = corner_E; cut_a = cut_out_E;
in_b = in_D; corner_b = corner_D; cut_b = cut_in_D;
Call Strip;
m_ED = m; x_ED = x_m; y_ED = y_m; E_ED = inner_a; ED_D = inner_b;

// The triangle between the strips: three blocks around a point near C.
hub = newp;
Point(hub) = {0.46 * (x_DC + x_CE) + 0.08 * x_ED, 0.46 * (y_DC + y_CE) + 0.08 * y_ED, z};
to_DC = newl; Line(to_DC) = {m_DC, hub};
to_CE = newl; Line(to_CE) = {m_CE, hub};
to_ED = newl; Line(to_ED) = {m_ED, hub};
Transfinite Curve {to_DC, to_CE} = p + 1;
Transfinite Curve {to_ED} = q + 1;
c1 = D_DC; c2 = to_DC; c3 = -to_ED; c4 = ED_D;
Call MeshBlock;
c1 = C_CE; c2 = to_CE; c3 = -to_DC; c4 = DC_C;
Call MeshBlock;
c1 = E_ED; c2 = to_ED; c3 = -to_CE; c4 = CE_E;
Call MeshBlock;

// ---- groups ---------------------------------------------------------------
Physical Surface("side") = {side_faces[]};
Physical Surface("top") = {top_faces[]};
Physical Surface("bottom") = {bottom_faces[]};
Physical Volume("body") = {volumes[]};
