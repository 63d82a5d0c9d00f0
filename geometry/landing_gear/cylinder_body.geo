// Body FE1 of the landing gear's cylinder: an eye, a closed end with a domed
// bottom and the tube.
//
// Unit mm. Frame L: origin at bore F, x along the tube towards its open end, z
// along the bore. Hexahedra of order 3, so that the loft and the dome keep
// their curvature.
//
// The cross-section is a core of 2 x 2 cells within two rings of 8. The same
// pattern runs from the wall of the bore through the neck between the fillets
// to a rectangle, and through the loft to the closed end, where core and inner
// ring end on the dome; the outer ring goes on as the wall of the tube. The
// rest of the eye has two layers of cells in z and meets the neck's sides.

// ---- dimensions (edit here, or give `parameters` in the scene) -----------
DefineConstant[
  bore_radius = 7.5,
  boss_radius = 12,
  eye_thickness = 10,
  neck_width = 19,        // of the eye at the end of its fillets
  fillet_radius = 10,
  cylinder_radius = 7.5,  // bore of the tube
  tube_radius = 9.5,      // outside of the tube
  tube_start = 19,        // x from which bore and outside are cylinders
  tube_end = 150,         // open end
  dome_depth = 4          // of the half ellipsoid that closes the bore
];

// ---- mesh density ---------------------------------------------------------
n_wall = 3;    // cells from the eye's bore outwards
n_fillet = 2;  // cells along a fillet; fewer do not determine its cylinder
n_boss = 5;    // cells along half of the free boss
n_tube = 8;    // cells along the tube
tube_progression = 1.5;

// ---- mesh layout ----------------------------------------------------------
rings = 2;
core_share = 0.4;     // of core and inner ring in the section
share[] = {0.7, 1};
section_x = 12.6;     // of the section between eye and dome
dome_ring = 4.3;      // radius at which the inner ring ends on the dome
dome_rim_x = 15.2;    // where the outer ring's section there meets the outside

// ---- derived --------------------------------------------------------------
half_width = neck_width / 2;
zt = eye_thickness / 2;
fillet_x = Sqrt((boss_radius + fillet_radius)^2 - (half_width + fillet_radius)^2);
tangent_angle = Atan2(half_width + fillet_radius, fillet_x);
corner_angle = Atan2(half_width, fillet_x);

// ---- section pattern ------------------------------------------------------
// A section has a core of 2 x 2 cells and `rings` rings of 8. Points 0-8:
// core, y = -, 0, + fastest, then z; ring g (0, 1, ..): points 9 + 8 g + j
// from (-, -) counter-clockwise seen against x. Edges 0-5: core along y; 6-11:
// core along z; 12 + 16 g + j: to ring g from inside; 20 + 16 g + j: around
// ring g. Faces 0-3: core; 4 + 8 g + j: ring g.
around[] = {0, 1, 2, 5, 8, 7, 6, 3};          // core points inside ring 0
around_edge[] = {0, 1, 8, 11, 5, 4, 9, 6};    // core edges between them
around_sign[] = {1, 1, 1, 1, -1, -1, -1, -1};
ring_y[] = {-1, 0, 1, 1, 1, 0, -1, -1};
ring_z[] = {-1, -1, -1, 0, 1, 1, 1, 0};
n_points = 9 + 8 * rings;
n_edges = 12 + 16 * rings;
n_faces = 4 + 8 * rings;
edge_from[] = {0, 1, 3, 4, 6, 7, 0, 1, 2, 3, 4, 5};
edge_to[] = {1, 2, 4, 5, 7, 8, 3, 4, 5, 6, 7, 8};
below[] = around[];             // point below each ring point
below_edge[] = around_edge[];   // edge below each ring edge, with its sign
below_sign[] = around_sign[];
For g In {0 : rings - 1}
  For j In {0 : 7}
    edge_from[] += below[8 * g + j];
    edge_to[] += 9 + 8 * g + j;
  EndFor
  For j In {0 : 7}
    edge_from[] += 9 + 8 * g + j;
    edge_to[] += 9 + 8 * g + (j + 1) % 8;
    below[] += 9 + 8 * g + j;
    below_edge[] += 20 + 16 * g + j;
    below_sign[] += 1;
  EndFor
EndFor
volumes[] = {};

// Empties points[] and edges[] before a new section; slope_y and slope_z are
// dy/dx and dz/dx of the lines that pass through its points.
Macro NewSection
  points[] = {}; edges[] = {}; slope_y[] = {}; slope_z[] = {};
  For e In {1 : n_edges}
    edges[] += 0;
  EndFor
  For i In {1 : n_points}
    slope_y[] += 0;
    slope_z[] += 0;
  EndFor
Return

// Makes the edges of a section that are still 0 as straight lines, and its
// faces from first_face on. Leaves faces[].
Macro CloseSection
  For e In {first_edge : n_edges - 1}
    If (edges[e] == 0)
      edges[e] = newl; Line(edges[e]) = {points[edge_from[e]], points[edge_to[e]]};
    EndIf
    Transfinite Curve {edges[e]} = 2;
  EndFor
  faces[] = {};
  For k In {0 : n_faces - 1}
    If (k < first_face)
      faces[] += 0;
    Else
      If (k < 4)
        r = (k - k % 2) / 2; c = k % 2;
        border[] = {edges[2 * r + c], edges[7 + 3 * r + c], -edges[2 * r + 2 + c], -edges[6 + 3 * r + c]};
      Else
        j = (k - 4) % 8;
        g = (k - 4 - j) / 8;
        e = 12 + 16 * g;
        border[] = {edges[e + j], edges[e + 8 + j], -edges[e + (j + 1) % 8], -below_sign[8 * g + j] * edges[below_edge[8 * g + j]]};
      EndIf
      loop = newll; Curve Loop(loop) = {border[]};
      face = news; Surface(face) = {loop};
      Transfinite Surface {face};
      Recombine Surface {face};
      faces[] += face;
    EndIf
  EndFor
Return

// Remembers the section as the start of the next span.
Macro StartSpan
  points_a[] = points[]; edges_a[] = edges[]; faces_a[] = faces[];
  slope_y_a[] = slope_y[]; slope_z_a[] = slope_z[];
Return

// Hexahedra from the remembered section to the current one, n_span cells
// long, graded by `progression`; only the faces from first_face on (with
// their edges from first_edge and points from first_point on). The lines
// between the points are those of given[] where it is not 0, cubics with the
// sections' slopes from point first_cubic on, else straight. Leaves the lines
// in along[], the faces that the edges sweep in swept[].
Macro Span
  along[] = {};
  For i In {0 : n_points - 1}
    curve = 0;
    If (i >= first_point)
      curve = given[i];
      If (curve == 0)
        curve = newl;
        If (i >= first_cubic)
          from[] = Point{points_a[i]};
          to[] = Point{points[i]};
          third = (to[0] - from[0]) / 3;
          p = newp; Point(p) = {from[0] + third, from[1] + third * slope_y_a[i], from[2] + third * slope_z_a[i]};
          q = newp; Point(q) = {to[0] - third, to[1] - third * slope_y[i], to[2] - third * slope_z[i]};
          Bezier(curve) = {points_a[i], p, q, points[i]};
        Else
          Line(curve) = {points_a[i], points[i]};
        EndIf
      EndIf
      Transfinite Curve {curve} = n_span + 1 Using Progression progression;
    EndIf
    along[] += curve;
  EndFor
  swept[] = {};
  For e In {0 : n_edges - 1}
    face = 0;
    If (e >= first_edge)
      loop = newll;
      Curve Loop(loop) = {edges_a[e], along[edge_to[e]], -edges[e], -along[edge_from[e]]};
      face = news; Surface(face) = {loop};
      Transfinite Surface {face};
      Recombine Surface {face};
    EndIf
    swept[] += face;
  EndFor
  For k In {first_face : n_faces - 1}
    If (k < 4)
      r = (k - k % 2) / 2; c = k % 2;
      sides[] = {swept[2 * r + c], swept[7 + 3 * r + c], swept[2 * r + 2 + c], swept[6 + 3 * r + c]};
    Else
      j = (k - 4) % 8;
      g = (k - 4 - j) / 8;
      e = 12 + 16 * g;
      sides[] = {swept[e + j], swept[e + 8 + j], swept[e + (j + 1) % 8], swept[below_edge[8 * g + j]]};
    EndIf
    loop = newsl; Surface Loop(loop) = {faces_a[k], faces[k], sides[]};
    v = newv; Volume(v) = {loop};
    Transfinite Volume {v};
    volumes[] += v;
  EndFor
Return

// ---- eye ------------------------------------------------------------------
// The section on the wall of the bore, a patch of its cylinder: the shares
// core_share and share[ring] of the angle +-corner_angle and of z = +-zt.
Macro BoreSection
  Call NewSection;
  position_a[] = {}; position_z[] = {};
  For i In {0 : n_points - 1}
    If (i < 9)
      position_a[] += (i % 3 - 1) * core_share * corner_angle;
      position_z[] += ((i - i % 3) / 3 - 1) * core_share * zt;
    Else
      j = (i - 9) % 8; g = (i - 9 - j) / 8;
      position_a[] += ring_y[j] * share[g] * corner_angle;
      position_z[] += ring_z[j] * share[g] * zt;
    EndIf
    p = newp; Point(p) = {bore_radius * Cos(position_a[i]), bore_radius * Sin(position_a[i]), position_z[i]};
    points[] += p;
  EndFor
  For e In {0 : n_edges - 1}
    i = edge_from[e]; j = edge_to[e];
    turn = position_a[j] - position_a[i];
    rise = position_z[j] - position_z[i];
    If (Fabs(turn) > 1e-9 && Fabs(rise) < 1e-9)
      p = newp; Point(p) = {0, 0, position_z[i]};
      edges[e] = newl; Circle(edges[e]) = {points[i], p, points[j]};
    EndIf
    If (Fabs(turn) > 1e-9 && Fabs(rise) > 1e-9)  // a helix
      through[] = {points[i]};
      For k In {1 : 15}
        a = position_a[i] + turn * k / 16;
        p = newp; Point(p) = {bore_radius * Cos(a), bore_radius * Sin(a), position_z[i] + rise * k / 16};
        through[] += p;
      EndFor
      through[] += points[j];
      edges[e] = newl; Spline(edges[e]) = {through[]};
    EndIf
  EndFor
  Call CloseSection;
Return

// The rectangle where the neck ends, divided in the same shares.
Macro RectangleSection
  Call NewSection;
  For i In {0 : n_points - 1}
    If (i < 9)
      y = (i % 3 - 1) * core_share; z = ((i - i % 3) / 3 - 1) * core_share;
    Else
      j = (i - 9) % 8; g = (i - 9 - j) / 8;
      y = ring_y[j] * share[g]; z = ring_z[j] * share[g];
    EndIf
    p = newp; Point(p) = {fillet_x, y * half_width, z * zt};
    points[] += p;
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
    q = newp; Point(q) = {0, 0, (i - 1) * zt};
    curve = newl; Circle(curve) = {inner_a[i], q, inner_b[i]};
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
given[] = {};
For i In {1 : n_points}
  given[] += 0;
EndFor
first_point = 0; first_edge = 0; first_face = 0;
wall_progression = 1.3;
Call BoreSection;
bore[] = faces[];
edges_bore[] = edges[]; points_bore[] = points[];
Call StartSpan;
Call RectangleSection;
n_span = n_wall; progression = wall_progression; first_cubic = n_points;
Call Span;
r = n_points - 8;  // the rim's first point and edge
e = n_edges - 8;
bottom_faces[] = {swept[e], swept[e + 1]};
top_faces[] = {swept[e + 4], swept[e + 5]};
points_neck[] = points[]; edges_neck[] = edges[]; faces_neck[] = faces[];
slope_y_neck[] = slope_y[]; slope_z_neck[] = slope_z[];

// Around the eye from the neck's side y > 0 to its side y < 0.
inner_a[] = {points_bore[r + 2], points_bore[r + 3], points_bore[r + 4]};
outer_a[] = {points[r + 2], points[r + 3], points[r + 4]};
radial_a[] = {along[r + 2], along[r + 3], along[r + 4]};
in_a[] = {edges_bore[e + 2], edges_bore[e + 3]};
out_a[] = {edges[e + 2], edges[e + 3]};
cut_a[] = {swept[e + 2], swept[e + 3]};
inner_end[] = {points_bore[r], points_bore[r + 7], points_bore[r + 6]};
outer_end[] = {points[r], points[r + 7], points[r + 6]};
radial_end[] = {along[r], along[r + 7], along[r + 6]};
in_end[] = {-edges_bore[e + 7], -edges_bore[e + 6]};
out_end[] = {-edges[e + 7], -edges[e + 6]};
cut_end[] = {swept[e + 7], swept[e + 6]};

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

points[] = points_neck[]; edges[] = edges_neck[]; faces[] = faces_neck[];
slope_y[] = slope_y_neck[]; slope_z[] = slope_z_neck[];
Call StartSpan;

// ---- loft and closed end --------------------------------------------------
// The outside goes from the rectangle at fillet_x to the circle at tube_start;
// the weight of the circle is the cubic 3 s^2 - 2 s^3, so it leaves and
// arrives along x.

// Rim points of the loft at x = rim_x with their slopes: rim_y[], rim_z[],
// rim_dy[], rim_dz[].
Macro LoftRim
  s = (rim_x - fillet_x) / (tube_start - fillet_x);
  weight = 3 * s^2 - 2 * s^3;
  rate = 6 * s * (1 - s) / (tube_start - fillet_x);
  rim_y[] = {}; rim_z[] = {}; rim_dy[] = {}; rim_dz[] = {};
  For j In {0 : 7}
    size = tube_radius / Sqrt(Fabs(ring_y[j]) + Fabs(ring_z[j]));
    rim_y[] += ring_y[j] * ((1 - weight) * half_width + weight * size);
    rim_z[] += ring_z[j] * ((1 - weight) * zt + weight * size);
    rim_dy[] += ring_y[j] * rate * (size - half_width);
    rim_dz[] += ring_z[j] * rate * (size - zt);
  EndFor
Return

// Rim edges of the loft at x = rim_x: the same mix of straight lines and of
// arcs, each as a cubic.
Macro LoftRimEdges
  handle = 4 / 3 * Tan(Pi / 16) * tube_radius;  // of the cubic of a 45 degree arc
  For j In {0 : 7}
    i = (j + 1) % 8;
    // Tangents of the circle, counter-clockwise, at both ends of the arc.
    size_j = Sqrt(Fabs(ring_y[j]) + Fabs(ring_z[j]));
    size_i = Sqrt(Fabs(ring_y[i]) + Fabs(ring_z[i]));
    line_y = ring_y[i] * half_width - ring_y[j] * half_width;
    line_z = ring_z[i] * zt - ring_z[j] * zt;
    p = newp;
    Point(p) = {rim_x, rim_y[j] + (1 - weight) * line_y / 3 - weight * handle * ring_z[j] / size_j,
                rim_z[j] + (1 - weight) * line_z / 3 + weight * handle * ring_y[j] / size_j};
    q = newp;
    Point(q) = {rim_x, rim_y[i] - (1 - weight) * line_y / 3 + weight * handle * ring_z[i] / size_i,
                rim_z[i] - (1 - weight) * line_z / 3 - weight * handle * ring_y[i] / size_i};
    edges[n_edges - 8 + j] = newl;
    Bezier(edges[n_edges - 8 + j]) = {points[n_points - 8 + j], p, q, points[n_points - 8 + i]};
  EndFor
Return

// The full section between eye and dome: shares of the loft's outline.
Call NewSection;
rim_x = section_x;
Call LoftRim;
For i In {0 : 8}
  y = i % 3 - 1; z = (i - i % 3) / 3 - 1;
  j = 0;
  For k In {0 : 7}
    If (ring_y[k] == y && ring_z[k] == z)
      j = k;
    EndIf
  EndFor
  If (i == 4)
    p = newp; Point(p) = {section_x, 0, 0};
  Else
    p = newp; Point(p) = {section_x, core_share * rim_y[j], core_share * rim_z[j]};
  EndIf
  points[] += p;
EndFor
For i In {9 : n_points - 1}
  j = (i - 9) % 8; g = (i - 9 - j) / 8;
  p = newp; Point(p) = {section_x, share[g] * rim_y[j], share[g] * rim_z[j]};
  points[] += p;
  slope_y[i] = rim_dy[j];
  slope_z[i] = rim_dz[j];
EndFor
Call LoftRimEdges;
Call CloseSection;
n_span = 1; progression = 1; first_cubic = n_points - 8;
Call Span;
loft[] = swept[{n_edges - 8 : n_edges - 1}];
Call StartSpan;

// The dome, x = tube_start - dome_depth Sqrt(1 - (r / cylinder_radius)^2), for
// core and inner ring; the outer ring's section from there to the outside.
Call NewSection;
rim_x = dome_rim_x;
Call LoftRim;
dome_y[] = {}; dome_z[] = {};
For i In {0 : 16}
  If (i < 9)
    y = i % 3 - 1; z = (i - i % 3) / 3 - 1;
    size = (y == 0 || z == 0) ? 0.52 : 0.6 * Sqrt(0.5);
  Else
    y = ring_y[i - 9]; z = ring_z[i - 9];
    size = 1 / Sqrt(Fabs(y) + Fabs(z));
  EndIf
  dome_y[] += y * size * dome_ring;
  dome_z[] += z * size * dome_ring;
  p = newp;
  Point(p) = {tube_start - dome_depth * Sqrt(1 - (dome_y[i]^2 + dome_z[i]^2) / cylinder_radius^2), dome_y[i], dome_z[i]};
  points[] += p;
EndFor
For j In {0 : 7}
  p = newp; Point(p) = {dome_rim_x, rim_y[j], rim_z[j]};
  points[] += p;
  slope_y[17 + j] = rim_dy[j];
  slope_z[17 + j] = rim_dz[j];
EndFor
For e In {0 : 19}  // on the dome, straight as seen along x
  i = edge_from[e]; j = edge_to[e];
  through[] = {points[i]};
  For k In {1 : 15}
    y = dome_y[i] + (dome_y[j] - dome_y[i]) * k / 16;
    z = dome_z[i] + (dome_z[j] - dome_z[i]) * k / 16;
    p = newp; Point(p) = {tube_start - dome_depth * Sqrt(1 - (y^2 + z^2) / cylinder_radius^2), y, z};
    through[] += p;
  EndFor
  through[] += points[j];
  edges[e] = newl; Spline(edges[e]) = {through[]};
EndFor
xyz[] = Point{points[9]};
middle = newp; Point(middle) = {xyz[0], 0, 0};
For j In {0 : 7}
  edges[20 + j] = newl; Circle(edges[20 + j]) = {points[9 + j], middle, points[9 + (j + 1) % 8]};
EndFor
Call LoftRimEdges;
Call CloseSection;
Call Span;
loft[] += swept[{n_edges - 8 : n_edges - 1}];
cap[] = faces[{0 : 11}];
Call StartSpan;

// ---- tube -----------------------------------------------------------------
// Only the outer ring: its points, edges and faces.
first_point = 9; first_edge = 20; first_face = 12;

// The section of the tube at x = tube_x.
Macro TubeSection
  Call NewSection;
  middle = newp; Point(middle) = {tube_x, 0, 0};
  For i In {0 : 8}
    points[] += 0;
  EndFor
  For i In {9 : 24}
    j = (i - 9) % 8;
    size = (i < 17 ? cylinder_radius : tube_radius) / Sqrt(Fabs(ring_y[j]) + Fabs(ring_z[j]));
    p = newp; Point(p) = {tube_x, size * ring_y[j], size * ring_z[j]};
    points[] += p;
  EndFor
  For j In {0 : 7}
    i = (j + 1) % 8;
    edges[20 + j] = newl; Circle(edges[20 + j]) = {points[9 + j], middle, points[9 + i]};
    edges[36 + j] = newl; Circle(edges[36 + j]) = {points[17 + j], middle, points[17 + i]};
  EndFor
  Call CloseSection;
Return

tube_x = tube_start;
Call TubeSection;
For j In {0 : 7}  // meridians of the dome
  given[9 + j] = newl;
  Ellipse(given[9 + j]) = {points_a[9 + j], middle, points[9 + j], points[9 + j]};
EndFor
Call Span;
loft[] += swept[{36 : 43}];
cap[] += swept[{20 : 27}];
Call StartSpan;
For j In {0 : 7}
  given[9 + j] = 0;
EndFor
tube_x = tube_end;
Call TubeSection;
n_span = n_tube; progression = tube_progression; first_cubic = n_points;
Call Span;

// ---- groups ---------------------------------------------------------------
// round_* and bore_* are exact cylinders; the loft is not.
Physical Surface("bore_F") = {bore[]};
Physical Surface("round_boss_F") = {boss[]};
Physical Surface("round_fillet_1") = {fillet_1[]};
Physical Surface("round_fillet_2") = {fillet_2[]};
Physical Surface("bore_cylinder") = swept[{20 : 27}];
Physical Surface("round_tube") = swept[{36 : 43}];
Physical Surface("cap") = {cap[]};
Physical Surface("open_end") = faces[{12 : 19}];
Physical Surface("loft") = {loft[]};
Physical Surface("top") = {top_faces[]};
Physical Surface("bottom") = {bottom_faces[]};
Physical Volume("body") = {volumes[]};

Mesh.ElementOrder = 3;
Mesh.HighOrderOptimize = 0;
