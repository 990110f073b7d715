// SPDX-License-Identifier: BSD-3-Clause
// The laboratory: a cluttered table round which the camera turns, a long bench along the straight line, walls with
// posters and blinds. Table tops are z = 0. The clutter and all that moves comes with the frame (Things).
#include "world.inc"
#include "lab_skins.inc"
#declare ScreenPig = Picture("screen")

// room
Floor(-0.75, 0.3)
Quad(<-5.4, 3.1, -0.75>, 8.2 * x, 2.7 * z, Wall)
Quad(<2.8, -2.9, -0.75>, -8.2 * x, 2.7 * z, Wall)
Quad(<-5.4, -2.9, -0.75>, 6.0 * y, 2.7 * z, Wall)
Quad(<2.8, 3.1, -0.75>, -6.0 * y, 2.7 * z, Wall)
Quad(<-5.4, 3.1, 1.95>, 8.2 * x, -6.0 * y, Wall)
#declare I = 0;
#while (I < 7)
  Quad(<-5.2 + 1.15 * I, 3.09, 0.25 + 0.15 * mod(I, 3)>, 0.8 * x, 0.9 * z, #if (mod(I, 3) = 1) Blinds #else Cover[mod(I, 6)] #end)
  Quad(<-4.3 + 1.15 * I, -2.89, 0.10 + 0.15 * mod(I, 2)>, -0.8 * x, 1.0 * z, #if (mod(I, 3) = 2) Blinds #else Poster[mod(I, 3)] #end)
  Quad(<-4.3 + 1.15 * I, -2.885, -0.65>, -0.7 * x, 0.6 * z, Cover[mod(I + 3, 6)])
  #declare I = I + 1;
#end
#declare I = 0;
#while (I < 4)
  Quad(<-5.39, -2.5 + 1.4 * I, 0>, 0.9 * y, 1.0 * z, Poster[mod(I + 1, 3)])
  Quad(<2.79, -1.5 + 1.3 * I, -0.1>, -0.9 * y, 1.1 * z, #if (mod(I, 2)) Blinds #else Poster[mod(I, 3)] #end)
  #declare I = I + 1;
#end
Quad(<2.785, -1.9, -0.75>, -0.9 * y, 2.0 * z, Picture("door"))
// cupboards along the walls; equal folders stand on the northern one
Block(<-1.4, 2.85, -0.75>, <5.0, 0.4, 0.80>, 0, Grain, Poster[2], Grain)
#declare I = 0;
#while (I < 18)
  Block(<-3.4 + 0.11 * I, 2.85, 0.05>, <0.085, 0.24, 0.30>, 0, Leaves, Label, Leaves)
  #declare I = I + 1;
#end
Block(<-2.2, -2.72, -0.75>, <3.6, 0.3, 0.70>, 0, Grain, Poster[1], Grain)
Block(<2.5, 0.6, -0.75>, <0.5, 2.0, 0.85>, 0, Grain, Cover[2], Poster[0])
Block(<2.5, 0.9, 0.10>, <0.35, 0.4, 0.40>, 10, Card, Card, Card)
Block(<2.5, 0.2, 0.10>, <0.30, 0.3, 0.25>, -14, Label, Cover[5], Cover[1])
Block(<1.9, -2.2, -0.75>, <0.6, 0.5, 0.7>, 30, Card, Card, Cover[0])
Block(<-1.2, 2.3, -0.75>, <0.4, 0.4, 0.5>, 15, Card, Cover[4], Card)
// papers and a mat on the floor, a bin
Sheet(-1.28, 0.55, -0.747, 0.75, 0.55, 12, Poster[0])
Sheet(-1.25, -0.35, -0.747, 0.6, 0.8, -20, Poster[1])
Sheet(-1.9, 0.95, -0.747, 0.6, 0.5, 35, Cover[2])
Sheet(-3.2, 0.75, -0.747, 0.9, 0.4, -8, Poster[2])
Sheet(0.3, -0.75, -0.747, 0.8, 0.6, 5, Poster[1])
Sheet(1.3, 0.4, -0.747, 0.6, 0.8, 14, Poster[0])
Sheet(0.2, 1.5, -0.747, 0.9, 0.6, -7, Cover[4])
Block(<-1.32, 0.08, -0.75>, <0.24, 0.24, 0.34>, 24, Plain(0.05), Cover[0], Cover[3])

// the cluttered table with the target; at its northern side, things that hide the target from there
Board(<0, 0.22, -0.04>, <1.6, 1.0, 0.04>, Picture("wood"), Grain)
Block(<-0.7, 0.22, -0.75>, <0.08, 0.8, 0.71>, 0, Grain, Grain, Grain)
Block(<0.7, 0.22, -0.75>, <0.08, 0.8, 0.71>, 0, Grain, Grain, Grain)
Target()
Screen(<-0.42, 0.52, 0>, 6, ScreenPig)
Block(<0.03, 0.54, 0>, <0.30, 0.16, 0.36>, -8, Card, Picture("parcel"), Cover[1])
Keys(<-0.36, 0.10, 0.004>, 10, 4, <0.03, 0.03, 0>, <0.023, 0.023, 0.012>, 4, "key")
Line(<-0.77, 0.33, 0.33>, <0.76, 0.40, 0.17>)
Line(<-0.75, 0.68, 0.24>, <0.72, 0.68, 0.36>)

// the bench: three equal screens back to back with three equal cartons, wires on both sides
Board(<-3.2, -0.05, -0.04>, <2.9, 0.9, 0.04>, Picture("wood"), Grain)
#declare I = 0;
#while (I < 3)
  Screen(<-4.2 + 0.85 * I, -0.15, 0>, 0, ScreenPig)
  Block(<-4.0 + 0.85 * I, 0.10, 0>, <0.24, 0.16, 0.22>, 0, Card, Label, Card)
  Block(<-4.4 + 0.95 * I, -0.05, -0.75>, <0.5, 0.6, 0.60>, 0, Grain, Cover[I + 1], Grain)
  #declare I = I + 1;
#end
Line(<-4.55, 0.33, 0.30>, <-1.85, 0.30, 0.15>)
Line(<-4.55, -0.42, 0.17>, <-1.85, -0.42, 0.30>)
Things()
