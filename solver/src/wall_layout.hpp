// Wall (dummy) points of every face, laid out in the face's own frame.
#pragma once

#include <vector>

#include "geometry.hpp"

namespace parapet::solver {

// A wall point belongs to one face and is seen only by fluid whose line of sight enters the solid
// through that face. Thin plates therefore carry a set for either side, each as deep as the kernel
// needs, and neither side ever feels the other.
struct WallPoints {
  std::vector<double> x, z;                         // [n] (m)
  std::vector<double> volume;                       // [n] (m2)
  std::vector<double> u, w;                         // [n] velocity of the wall (m/s)
  std::vector<double> normal_x, normal_z;           // [n] of the owner, into the fluid
  std::vector<double> depth;                        // [n] below the owner's surface (m)
  std::vector<int> face;                            // [n] owner
  std::size_t size() const { return face.size(); }  // without the ghost that may follow
};

// Rows of points every `spacing` along each face, `reach` deep (rounded up to whole layers). The
// last point of a row stands for the fraction of a spacing that is left, so that the layout varies
// continuously with the face's length.
WallPoints lay_out_walls(const Solids& solids, double spacing, double reach);

}  // namespace parapet::solver
