// SPDX-License-Identifier: BSD-3-Clause
// An office table: keys that look alike, an arm and a pot that cover things for moments, a screen that covers them for
// seconds, and planes from half a metre to five metres.
#include "world.inc"
#declare Grain = Picture("grain");
#declare Leaves = Picture("leaves");
#declare Card = Picture("carton");
#declare Label = Picture("label");
#declare Page0 = Picture("page0");
#declare Page1 = Picture("page1");
#declare Cover = array[6];
#declare Spine = array[6];
#declare I = 0;
#while (I < 6)
  #declare Cover[I] = Picture(concat("cover", str(I, 0, 0)))
  #declare Spine[I] = Picture(concat("spine", str(I, 0, 0)))
  #declare I = I + 1;
#end
#macro Books(CX, CY, Z, Width, Seed)
  #local R = seed(Seed);
  #local X = CX - Width / 2;
  #local K = Seed;
  #while (X < CX + Width / 2)
    #local W = 0.026 + 0.028 * rand(R);
    #local H = 0.15 + 0.09 * rand(R);
    Block(<X + W / 2, CY + 0.02 * rand(R), Z>, <W - 0.001, 0.16, H>, 0, Leaves, Spine[mod(K, 6)], Cover[mod(K, 6)])
    #local X = X + W;
    #local K = K + 1;
  #end
#end

// room: checker floor, a near partition at the right, a far wall, a shelf
Floor(-0.75, 0.25)
Quad(<-3.2, 3.6, -0.75>, 6.4 * x, 3.0 * z, Picture("wall"))
Quad(<-3.2, -2.5, -0.75>, 6.1 * y, 3.0 * z, Picture("wall"))
Quad(<3.2, 3.6, -0.75>, -6.1 * y, 3.0 * z, Picture("wall"))
#declare I = 0;
#while (I < 5)
  Quad(<-2.6 + 1.1 * I, 3.59, -0.25 + 0.2 * mod(I, 2)>, 0.8 * x, 1.0 * z, Picture(concat("poster", str(mod(I, 3), 0, 0))))
  #declare I = I + 1;
#end
Block(<1.15, 1.55, -0.75>, <1.3, 0.05, 1.35>, 0, Grain, Picture("poster1"), Grain)
Sheet(0.9, 1.2, -0.748, 0.8, 0.6, 20, Picture("poster0"))
Board(<-1.0, 1.5, -0.05>, <1.2, 0.30, 0.03>, Grain, Grain)
Board(<-1.0, 1.5, 0.30>, <1.2, 0.30, 0.03>, Grain, Grain)
Block(<-1.58, 1.5, -0.75>, <0.04, 0.30, 1.5>, 0, Grain, Grain, Grain)
Block(<-0.42, 1.5, -0.75>, <0.04, 0.30, 1.5>, 0, Grain, Grain, Grain)
Books(-1.0, 1.45, -0.02, 1.0, 3)
Books(-1.05, 1.45, 0.33, 0.7, 8)
// chair behind the table, cartons on the floor
Block(<0.55, 1.10, -0.75>, <0.05, 0.05, 0.45>, 0, Grain, Grain, Grain)
Block(<0.55, 1.10, -0.30>, <0.44, 0.44, 0.06>, 12, Cover[5], Grain, Grain)
Block(<0.58, 1.30, -0.24>, <0.42, 0.05, 0.50>, 12, Grain, Cover[3], Grain)
Block(<-0.35, 2.3, -0.75>, <0.6, 0.5, 0.5>, 25, Card, Card, Picture("parcel"))
Block(<-0.3, 2.3, -0.25>, <0.4, 0.3, 0.3>, -10, Label, Picture("parcel"), Card)
Block(<1.0, 2.6, -0.75>, <0.5, 0.5, 0.9>, -15, Cover[0], Cover[1], Cover[2])

#include "office_table.inc"
