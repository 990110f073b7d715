// SPDX-License-Identifier: BSD-3-Clause
// The corridor outside: equal doors, posters, cartons along the walls; it runs along y. The top of the cabinet with the
// target is z = 0. The cartons and all that moves comes with the frame (Things).
#include "world.inc"
#include "lab_skins.inc"
#declare Door = Picture("door")

Floor(-0.75, 0.3)
#declare I = 0;
#while (I < 4)
  Quad(<-0.6, -2 + 4 * I, -0.75>, 4 * y, 2.5 * z, Wall)
  Quad(<1.35, 2 + 4 * I, -0.75>, -4 * y, 2.5 * z, Wall)
  Quad(<-0.6, 2 + 4 * I, 1.75>, 1.95 * x, -4 * y, Wall)
  #declare I = I + 1;
#end
Quad(<-0.6, 14, -0.75>, 1.95 * x, 2.5 * z, Wall)
Quad(<1.35, -2, -0.75>, -1.95 * x, 2.5 * z, Wall)
Quad(<0.0, 13.98, -0.3>, 0.8 * x, 1.3 * z, Blinds)
#declare I = 0;
#while (I < 7)
  Quad(<-0.595, 0.9 + 2.0 * I, -0.75>, 0.8 * y, 2.0 * z, Door)
  Quad(<1.345, 0.7 + 2.0 * I, -0.75>, -0.8 * y, 2.0 * z, Door)
  Quad(<-0.595, -0.5 + 2.0 * I, 0.05 + 0.1 * mod(I, 3)>, 0.9 * y, 0.7 * z, Poster[mod(I, 3)])
  Quad(<1.345, 1.8 + 2.0 * I, 0.0 + 0.1 * mod(I, 2)>, -0.9 * y, 0.8 * z, Cover[mod(I, 6)])
  Quad(<1.345, 1.8 + 2.0 * I, -0.7>, -0.9 * y, 0.5 * z, Grain)
  Quad(<0.15, 1.0 + 2.0 * I, 1.745>, 0.4 * x, -0.9 * y, Plain(0.8))
  #declare I = I + 1;
#end
// cabinet with the target, a notice board that stands out from the wall, fire extinguishers
Block(<-0.2, 0.1, -0.75>, <0.8, 0.8, 0.75>, 0, Picture("wood"), Cover[1], Poster[2])
Target()
Keys(<-0.43, 0.26, 0.0>, 4, 5, <0.05, 0.05, 0>, <0.04, 0.04, 0.03>, 0, "key")
#declare I = 0;
#while (I < 3)
  Block(<1.25, 2.4 + 4 * I, 0.2>, <0.06, 0.9, 0.7>, 0, Grain, Grain, Poster[mod(I + 1, 3)])
  cylinder { <-0.48, 3.3 + 4 * I, -0.5>, <-0.48, 3.3 + 4 * I, 0.0>, 0.08 Skin(Plain(0.12), 0.8) }
  Block(<-0.48, 3.3 + 4 * I, -0.35>, <0.17, 0.17, 0.16>, 0, Label, Label, Label)
  Wire(<-0.42, 2.2 + 4 * I, 1.75>, <-0.30, 4.2 + 4 * I, -0.2>, 0.006, 0.03)
  Wire(<1.16, 3.2 + 4 * I, 1.75>, <1.14, 1.6 + 4 * I, -0.1>, 0.006, 0.03)
  #declare I = I + 1;
#end
Things()
