// A hollow shaft with a shoulder, filleted, and a cross bore. Millimetres; the
// axis is x.
SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 60, 0, 0, 20};
Cylinder(2) = {60, 0, 0, 80, 0, 0, 15};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
shoulder() = Curve In BoundingBox {59.9, -15.1, -15.1, 60.1, 15.1, 15.1};
f() = Fillet{3}{shoulder()}{4};
Cylinder(4) = {-10, 0, 0, 160, 0, 0, 9};
Cylinder(5) = {105, 0, -30, 0, 0, 60, 4};
BooleanDifference(6) = { Volume{f()}; Delete; }{ Volume{4, 5}; Delete; };
