// A clevis fork: a round shank with a cross bore, and two ears with a pin of
// 16 mm through both. Millimetres; the pin's axis is z, the shank runs along x.
SetFactory("OpenCASCADE");
gap = 18; ear = 9; width = 32; reach = 40;
// Cheek block, its slot rounded at the bottom.
Box(1) = {-14, -width / 2, -gap / 2 - ear, reach + 14, width, gap + 2 * ear};
Cylinder(2) = {reach, 0, -gap / 2 - ear, 0, 0, gap + 2 * ear, width / 2};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Box(4) = {10, -width, -gap / 2, 2 * reach, 2 * width, gap};
Cylinder(5) = {10, -width, 0, 0, 2 * width, 0, gap / 2};
BooleanUnion(6) = { Volume{4}; Delete; }{ Volume{5}; Delete; };
BooleanDifference(7) = { Volume{3}; Delete; }{ Volume{6}; Delete; };
// Shank, joined by a fillet.
Cylinder(8) = {-60, 0, 0, 50, 0, 0, 14};
BooleanUnion(9) = { Volume{7}; Delete; }{ Volume{8}; Delete; };
root() = Curve In BoundingBox {-14.01, -14.01, -14.01, -13.99, 14.01, 14.01};
filleted() = Fillet{9}{root()}{3};
// Pin's bore through both ears, cross bore of 12 mm in the shank.
Cylinder(10) = {reach, 0, -40, 0, 0, 80, 8};
Cylinder(11) = {-46, 0, -40, 0, 0, 80, 6};
BooleanDifference(12) = { Volume{filleted()}; Delete; }{ Volume{10, 11}; Delete; };
