// Box 4 x 2 x 1 (mm) of tetrahedra.
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 2, 1};
Mesh.CharacteristicLengthMin = 0.9;
Mesh.CharacteristicLengthMax = 0.9;
Mesh.MshFileVersion = 4.1;
Physical Volume("body") = {1};
Physical Surface("root") = {1};
Physical Surface("tip") = {2};
