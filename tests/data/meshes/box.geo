// Box 2 x 1 x 1 (mm) of two cells; order by the command line.
Point(1) = {0, 0, 0};
l[] = Extrude {2, 0, 0} { Point{1}; Layers{2}; };
s[] = Extrude {0, 1, 0} { Curve{l[1]}; Layers{1}; Recombine; };
v[] = Extrude {0, 0, 1} { Surface{s[1]}; Layers{1}; Recombine; };
Physical Volume("body") = v[1];
Physical Surface("bottom") = s[1];
Physical Surface("top") = v[0];
