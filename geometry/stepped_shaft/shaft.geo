// Hollow shaft with a shoulder: diameters 40 and 60, fillet 4, bore 12; journals
// a, b on the neck and c, d on the collar. Unit mm, axis x. Quadrilaterals
// above the axis, turned round it in four quarters.

bore = 6; neck = 20; collar = 30; fillet = 4;
shoulder = 100; length = 200;
quarter = 2;     // cells round a quarter
around = 5;      // cells along the fillet
outwards = 3;    // cells from the fillet into the shaft

// Neck: stations at the journals' ends, on the bore, half-way and outside.
x[] = {0, 15, 25, 40, shoulder - fillet};
For i In {0 : 4}
  Point(100 + i) = {x[i], bore, 0};
  Point(110 + i) = {x[i], 12, 0};
  Point(120 + i) = {x[i], neck, 0};
EndFor
// Collar likewise; the first outer station lies behind the shoulder's face.
y[] = {116, 160, 175, 185, length};
For i In {0 : 4}
  Point(200 + i) = {y[i], bore, 0};
  Point(210 + i) = {i == 0 ? 110 : y[i], neck, 0};
  Point(220 + i) = {i == 0 ? 114 : y[i], collar, 0};
EndFor
Point(300) = {shoulder, neck + fillet, 0};
Point(301) = {shoulder, collar, 0};
Point(302) = {shoulder - fillet, neck + fillet, 0};

For i In {0 : 4}
  Line(1000 + i) = {100 + i, 110 + i};  // outwards
  Line(1010 + i) = {110 + i, 120 + i};
  Line(1020 + i) = {200 + i, 210 + i};
  Line(1030 + i) = {210 + i, 220 + i};
EndFor
For i In {0 : 3}
  Line(1100 + i) = {100 + i, 101 + i};  // along the axis
  Line(1110 + i) = {110 + i, 111 + i};
  Line(1120 + i) = {120 + i, 121 + i};
  Line(1200 + i) = {200 + i, 201 + i};
  Line(1210 + i) = {210 + i, 211 + i};
  Line(1220 + i) = {220 + i, 221 + i};
EndFor
Line(1300) = {104, 200};
Line(1301) = {114, 210};
Circle(1302) = {124, 302, 300};
Line(1303) = {300, 210};
Line(1304) = {300, 301};
Line(1305) = {301, 220};

For i In {0 : 3}
  Curve Loop(10 + i) = {1100 + i, 1001 + i, -(1110 + i), -(1000 + i)};
  Curve Loop(20 + i) = {1110 + i, 1011 + i, -(1120 + i), -(1010 + i)};
  Curve Loop(30 + i) = {1200 + i, 1021 + i, -(1210 + i), -(1020 + i)};
  Curve Loop(40 + i) = {1210 + i, 1031 + i, -(1220 + i), -(1030 + i)};
EndFor
Curve Loop(50) = {1300, 1020, -1301, -1004};
Curve Loop(51) = {1301, -1303, -1302, -1014};
Curve Loop(52) = {1303, 1030, -1305, -1304};
// 0-3 inner and 4-7 outer neck, 8-11 inner and 12-15 outer collar, 16-18 step.
loops[] = {10:13, 20:23, 30:33, 40:43, 50, 51, 52};
For i In {0 : #loops[] - 1}
  Plane Surface(loops[i]) = {loops[i]};
EndFor

Transfinite Curve {1000:1004, 1020:1024} = 2 + 1;
Transfinite Curve {1010:1014} = outwards + 1 Using Progression 0.7;
Transfinite Curve {1303} = outwards + 1 Using Progression 1 / 0.7;
Transfinite Curve {1030:1034, 1304} = 3 + 1;
Transfinite Curve {1305} = outwards + 1;
Transfinite Curve {1100:1102, 1110:1112, 1120:1122, 1201:1203, 1211:1213, 1221:1223} = 2 + 1;
Transfinite Curve {1103, 1113, 1123} = 5 + 1 Using Progression 0.7;
Transfinite Curve {1200, 1210, 1220} = 3 + 1;
Transfinite Curve {1300, 1301, 1302} = around + 1;
Transfinite Surface {loops[]};
Recombine Surface {loops[]};

// A quarter gives per surface: its end, the volume, the sides along its loop.
from[] = loops[];
solid[] = {}; axis[] = {}; a[] = {}; b[] = {}; c[] = {}; d[] = {};
on_neck[] = {}; on_collar[] = {}; on_fillet[] = {}; left[] = {}; right[] = {};
For q In {1 : 4}
  e[] = Extrude {{1, 0, 0}, {0, 0, 0}, Pi / 2} {
    Surface{from[]}; Layers{quarter}; Recombine;
  };
  from[] = {};
  For k In {0 : 18}
    from[] += e[6 * k];
    solid[] += e[6 * k + 1];
  EndFor
  For k In {0 : 3}
    axis[] += {e[6 * k + 2], e[6 * (k + 8) + 2]};
  EndFor
  axis[] += e[6 * 16 + 2];
  a[] += e[6 * 4 + 4];
  b[] += e[6 * 6 + 4];
  on_neck[] += {e[6 * 5 + 4], e[6 * 7 + 4]};
  c[] += e[6 * 13 + 4];
  d[] += e[6 * 15 + 4];
  on_collar[] += {e[6 * 12 + 4], e[6 * 14 + 4], e[6 * 18 + 4]};
  on_fillet[] += e[6 * 17 + 4];
  left[] += {e[6 * 0 + 5], e[6 * 4 + 5]};
  right[] += {e[6 * 11 + 3], e[6 * 15 + 3]};
EndFor

Physical Volume("body") = {solid[]};
Physical Surface("bore_axis") = {axis[]};
Physical Surface("round_a") = {a[]};
Physical Surface("round_b") = {b[]};
Physical Surface("round_c") = {c[]};
Physical Surface("round_d") = {d[]};
Physical Surface("round_neck") = {on_neck[]};
Physical Surface("round_collar") = {on_collar[]};
Physical Surface("fillet") = {on_fillet[]};
Physical Surface("left") = {left[]};
Physical Surface("right") = {right[]};
Mesh.ElementOrder = 2;
