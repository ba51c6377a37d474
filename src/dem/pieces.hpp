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

}  // namespace vug
