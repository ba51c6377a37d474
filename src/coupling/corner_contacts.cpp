#include "coupling/corner_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vug {

namespace {

using Contact = std::array<std::size_t, 2>;  ///< two fluid nodes, or the two pieces that they belong to

/// All places where two fluid nodes touch only at a corner.
std::vector<Contact> find_contacts(const FluidPicture& picture) {
  std::vector<Contact> contacts;
  for (std::size_t n = 0; n < picture.size(); ++n) {
    const auto right = picture.from(n, 1, 0), above = picture.from(n, 0, 1), across = picture.from(n, 1, 1);
    if (!across) continue;
    const bool a = picture.is_fluid(n), b = picture.is_fluid(*right);
    if (a == b || picture.is_fluid(*above) != b || picture.is_fluid(*across) != a) continue;
    contacts.push_back(a ? Contact{n, *across} : Contact{*right, *above});
  }
  return contacts;
}

/// Which pieces, joined by corners, have a flow: through two mouths, or by what drives it everywhere.
std::vector<bool> pieces_with_flow(const Scene& scene, const std::vector<Mouth>& mouths,
                                   const std::vector<int>& piece) {
  const FlowSection& flow = *scene.flow;
  bool driven = flow.body_force[0] != 0 || flow.body_force[1] != 0 || flow.buoyant();
  for (const Mouth& mouth : mouths)
    driven =
        driven || (mouth.conditions->flow.kind == FlowBoundaryKind::wall && mouth.conditions->flow.peak_speed() != 0);
  const auto pieces = static_cast<std::size_t>(1 + *std::max_element(piece.begin(), piece.end()));
  std::vector<bool> flows(pieces, driven);
  std::vector<const Mouth*> first(pieces, nullptr);
  for (const Mouth& mouth : mouths)
    for (const std::size_t n : mouth.nodes) {
      if (!mouth.lets_fluid_through()) continue;
      const Mouth*& of_piece = first[piece[n]];
      if (!of_piece) of_piece = &mouth;
      if (of_piece->key != mouth.key) flows[piece[n]] = true;
    }
  return flows;
}

/// Removes the contacts of dead ends: of pieces, joined by faces, that have no mouth and a single contact left.
void remove_dead_ends(const std::vector<int>& piece, const std::vector<Mouth>& mouths, std::vector<Contact>& contacts) {
  std::vector<int> ways(static_cast<std::size_t>(1 + *std::max_element(piece.begin(), piece.end())), 0);
  for (const Mouth& mouth : mouths)
    for (const std::size_t n : mouth.nodes)
      if (mouth.lets_fluid_through()) ways[piece[n]] = 1;
  for (const Contact& contact : contacts)
    for (const std::size_t n : contact) ++ways[piece[n]];
  for (bool removed = true; removed;) {
    const auto is_last_of_one = [&](const Contact& contact) {
      if (ways[piece[contact[0]]] > 1 && ways[piece[contact[1]]] > 1) return false;
      for (const std::size_t n : contact) --ways[piece[n]];
      return true;
    };
    const auto kept = std::remove_if(contacts.begin(), contacts.end(), is_last_of_one);
    removed = kept != contacts.end();
    contacts.erase(kept, contacts.end());
  }
}

/// A warning where pores lead from one side to the opposite one through such places only.
std::string remark_on_sides_joined_by_corners(const Scene& scene, const FluidPicture& picture, bool solutes) {
  if (!scene.flow && !solutes) return {};
  const JoinedPores by_corners = joined_pores(picture), by_faces = joined_pores(picture, JoinedBy::faces);
  const bool x = by_corners.along_x > 0 && by_faces.along_x == 0, y = by_corners.along_y > 0 && by_faces.along_y == 0;
  if (!x && !y) return {};
  return fmt::format(
      "pores lead from {} only through places where they touch at a corner between two rock nodes: {}; close the "
      "corners, or draw the rock finer",
      x && y ? "side to side"
      : x    ? "left to right"
             : "bottom to top",
      scene.flow ? "passages without a width, through which the flow passes" : "solutes on d2q5 do not pass them");
}

}  // namespace

std::size_t corner_contacts(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths) {
  std::vector<Contact> contacts = find_contacts(picture);
  if (contacts.empty() || !scene.flow) return 0;
  remove_dead_ends(pieces_of(picture, JoinedBy::faces), mouths, contacts);
  const std::vector<int> piece = pieces_of(picture);
  const std::vector<bool> flows = pieces_with_flow(scene, mouths, piece);
  return static_cast<std::size_t>(std::count_if(contacts.begin(), contacts.end(),
                                                [&](const Contact& contact) { return flows[piece[contact[0]]]; }));
}

std::string remark_on_corners(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths) {
  const bool heat = scene.heat && scene.heat->velocity_set == ScalarVelocitySet::d2q5;
  const bool solutes = scene.solute && scene.solute->velocity_set == ScalarVelocitySet::d2q5;
  // pathways are joined by faces wherever they are meant to join
  if (scene.geometry.kind == GeometryKind::rock) return {};
  if (!scene.flow || (!heat && !solutes)) return remark_on_sides_joined_by_corners(scene, picture, solutes);
  const std::size_t places = corner_contacts(scene, picture, mouths);
  if (places == 0) return {};
  const char* const carried = heat && solutes ? "heat and solutes" : heat ? "heat" : "solutes";
  const char* const keys = heat && solutes ? "heat.velocity_set and solute.velocity_set"
                           : heat          ? "heat.velocity_set"
                                           : "solute.velocity_set";
  return fmt::format(
      "in {} {} pores touch only at a corner between two rock nodes: the flow passes there, {} on d2q5 {} not, and "
      "what the flow carries is lost (advective_form of the balance); close the corners, use geometry.coarsen, or "
      "{} = \"d2q9\"",
      places, places == 1 ? "place" : "places", carried, solutes ? "do" : "does", keys);
}

}  // namespace vug
