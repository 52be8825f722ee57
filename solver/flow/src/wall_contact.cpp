#include "wall_contact.hpp"

#include <algorithm>

namespace parapet::solver {

int WallContact::apply(ParticleMotion& motion, std::span<const int> candidates) const {
  int touched = -1;
  // a corner may need one contact with either face, and a last one for the slide between them
  for (int attempt = 0; attempt < 3; ++attempt) {
    const int index = first_crossed(faces, candidates, motion.before, motion.after);
    if (index < 0) return touched;
    touched = index;
    const Face& face = faces[static_cast<std::size_t>(index)];
    const double depth = dot(motion.after - face.a, face.normal);
    const double start = dot(motion.before - face.a, face.normal);
    // slide along the face at the clearance, or at the old distance when that was closer
    motion.after = motion.after + (std::min(clearance, start) - depth) * face.normal;
    const double approach = dot(motion.velocity - face.velocity, face.normal);
    if (approach < 0.0) motion.velocity = motion.velocity - approach * face.normal;
  }
  if (first_crossed(faces, candidates, motion.before, motion.after) >= 0) {
    motion.after = motion.before;  // wedged in a corner: it stays where it was
  }
  return touched;
}

}  // namespace parapet::solver
