// The membrane of geometry/nafems_le1 as a flat mesh in its mid-plane, order 2;
// triangles, or with `quads` quadrangles.
DefineConstant[ quads = 0 ];
radial = 6;   // cells from the inner to the outer ellipse
around = 8;   // cells along the ellipses
Point(1) = {0, 0, 50};
Point(2) = {2000, 0, 50};
Point(3) = {3250, 0, 50};
Point(4) = {0, 2750, 50};
Point(5) = {0, 1000, 50};
Line(1) = {2, 3};
Ellipse(2) = {3, 1, 3, 4};
Line(3) = {4, 5};
Ellipse(4) = {5, 1, 2, 2};
Transfinite Curve {1} = radial + 1 Using Progression 1.2;
Transfinite Curve {3} = radial + 1 Using Progression 1 / 1.2;
Transfinite Curve {2} = around + 1 Using Progression 1.1;
Transfinite Curve {4} = around + 1 Using Progression 1 / 1.1;
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Transfinite Surface {1};
If (quads)
  Recombine Surface {1};
EndIf
Physical Surface("body") = {1};
Physical Curve("CD") = {1};
Physical Curve("outer") = {2};
Physical Curve("AB") = {3};
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
