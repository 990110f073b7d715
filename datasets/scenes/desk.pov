// SPDX-License-Identifier: BSD-3-Clause
// An office desk. Metres, z up, RIGHT-handed: POV-Ray only does vector algebra, so with the camera's
// three axes given as they are (right = x_c, up = -y_c, direction = z_c) nothing is ever mirrored.
// The known target is the dark rectangle (+-0.105, +-0.07425, 0).
// Declared by render.py: Depth (0 grey image, 1 z-depth / Far), Far [m], camera Xx..Zz (columns of R_wc)
// and Tx Ty Tz, BoxX (x of the sliding box [m]).
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 2 }
#default { finish { ambient 0 diffuse 1 } }
#declare Pos = <Tx, Ty, Tz>;
#declare Fwd = <Zx, Zy, Zz>;
camera {
  perspective location Pos
  right <Xx, Xy, Xz> * (640 / 481.2) up -<Yx, Yy, Yz> * (480 / 480.0) direction Fwd
}
background { rgb 0 }

// ---- skins: an image of the texture folder, or the depth along the optical axis -------------------
#declare Light = finish { ambient 0.32 diffuse 0.75 }
#declare Reach = function { (Zx * (x - Tx) + Zy * (y - Ty) + Zz * (z - Tz)) / Far }
#declare DepthSkin = texture {
  pigment {
    function { select(Reach(x, y, z) - 1, Reach(x, y, z), 0) }  // 0 stands for none
    color_map { [0 rgb 0] [1 rgb 1] }
  }
  finish { ambient 1 diffuse 0 }
}
#macro Picture(Name) pigment { #if (Depth) rgb 0 #else image_map { pgm Name gamma srgb interpolate 2 } #end } #end
#macro Plain(Grey) pigment { rgb Grey } #end
#macro Lit(Pig) texture { pigment { Pig } finish { Light } } #end

// A parallelogram; the picture's lower edge runs along U from O, its left edge along V.
#macro Quad(O, U, V, Pig)
  #local N = vnormalize(vcross(U, V));
  polygon {
    5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>
    #if (!Depth) Lit(Pig) #end
    matrix <U.x, U.y, U.z, V.x, V.y, V.z, N.x, N.y, N.z, O.x, O.y, O.z>
    #if (Depth) texture { DepthSkin } #end
  }
#end
// A box standing on C (middle of its base), turned by Deg about z.
#macro Block(C, Size, Deg, Top, Front, Side)
  #local A = vrotate(x, Deg * z) * Size.x;
  #local B = vrotate(y, Deg * z) * Size.y;
  #local H = z * Size.z;
  #local O = C - A / 2 - B / 2;
  Quad(O + H, A, B, Top)
  Quad(O, A, H, Front)
  Quad(O + A, B, H, Side)
  Quad(O + A + B, -A, H, Front)
  Quad(O + B, -B, H, Side)
#end
// A sheet lying at height Z (sheets that overlap need different heights).
#macro Sheet(CX, CY, Z, W, L, Deg, Pig)
  #local A = vrotate(x, Deg * z) * W;
  #local B = vrotate(y, Deg * z) * L;
  Quad(<CX, CY, Z> - A / 2 - B / 2, A, B, Pig)
#end
#macro Skin(Pig) #if (Depth) texture { DepthSkin } #else Lit(Pig) #end #end

#include "objects.inc"

light_source { <-1.2, -1.0, 2.6> rgb 0.75 }
light_source { <1.6, 0.1, 2.2> rgb 0.35 }
