#pragma once
// Pieces of the rock: triangles that bonds still join to one another, and the pieces that nothing holds any more.
#include "dem/bonds.hpp"

#include <vector>

namespace vug {

/// (triangle) The lowest number of a triangle of its piece. Two triangles are of one piece where a chain of bonds leads
/// from one to the other that have not failed and whose triangles are not gone (is_gone); a triangle that is gone is a
/// piece of its own. Copies the states of the bonds to the host.
std::vector<int> find_pieces(const Particles& particles, const Bonds& bonds);

/// (triangle) The same for triangles of loose pieces, and -1 for all others. A piece is loose where no support holds
/// any triangle of it, unless it is the heaviest piece (of several, that with the lowest number): rock that nothing
/// holds at all is still the rock.
std::vector<int> find_loose_pieces(const Particles& particles, const Bonds& bonds);

/// Whether no support holds any triangle of some piece, be it the only one.
bool has_unsupported_piece(const Particles& particles, const Bonds& bonds);

/// The loose pieces of a rock whose bonds fail and whose triangles dissolve, found anew only when that has happened:
/// neither is ever undone, so that their numbers tell.
class LoosePieces {
 public:
  /// (triangle) find_loose_pieces of the present state. Waits for the device, and allocates where pieces have changed.
  const IndexList& find(const Exec& exec, const Particles& particles, const Bonds& bonds);

 private:
  IndexList piece_;
  int failed_ = -1, gone_ = -1;  ///< bonds and triangles when pieces were last found
};

}  // namespace vug
