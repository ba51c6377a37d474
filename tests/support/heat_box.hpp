#pragma once
// A box of conducting nodes for tests: geometry and start from functions of (x, y), steps, and reading back.
#include "kernels/heat/heat.hpp"
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/heat/heat_sums.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "support/host_copy.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace vug::test {

inline constexpr std::array velocity_sets{ScalarVelocitySet::d2q5, ScalarVelocitySet::d2q9};
inline const char* name_of(ScalarVelocitySet set) {
  return set == ScalarVelocitySet::d2q5 ? "D2Q5" : "D2Q9";
}

inline HeatSide whole_side(const Lattice& lattice, Side side, HeatCondition condition, double value) {
  return make_heat_side(side, 0, side_length(lattice, side) - 1, condition, value);
}

/// Temperature along a whole side: in = -A + 2 w theta_wall, as HeatCondition::temperature has it for one value.
/// profile(k): theta_wall at k/2 nodes from the beginning of the side. Corners are left to the side filled last.
template <class T>
struct FillProfile {
  Lattice lattice;
  int first, stride, outward, directions;
  ScalarField<T> profile, g;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int node = first + item * stride, plane = lattice.size(), along = D2Q9::c(outward, 0) == 0 ? 0 : 1;
    for (int q = 1; q < directions; ++q) {
      if (D2Q9::c(q, 0) * D2Q9::c(outward, 0) + D2Q9::c(q, 1) * D2Q9::c(outward, 1) != 1) continue;
      const int back = D2Q9::opposite(q);
      const double weight = directions == D2Q5::Q ? D2Q5::w(q) : D2Q9::w(q);
      g(back * plane + node + lattice.offset(q)) =
          T(2 * weight) * profile(2 * item + 1 + D2Q9::c(q, along)) - g(q * plane + node);
    }
  }
};

template <class T>
class HeatBox {
 public:
  using IsSolid = std::function<bool(int, int)>;
  using Value = std::function<double(int, int)>;

  HeatBox(int nx, int ny, const HeatParameters& parameters, const IsSolid& is_solid, const Value& theta,
          std::array<bool, 2> periodic = {false, false})
      : lattice(nx, ny), periodic_(periodic), type("type", lattice.size()) {
    set_type(is_solid);
    fields = make_heat_fields<T>(exec, lattice, parameters, type, periodic, 0.0);
    edit(fields.g, [&](const auto& g) {
      for_all([&](int x, int y) {
        for (int q = 0; q < directions(); ++q)
          g(q * lattice.size() + lattice.node(x, y)) =
              T(directions() == D2Q5::Q ? D2Q5::w(q) : D2Q9::w(q)) * static_cast<T>(theta(x, y));
      });
    });
  }

  void set_type(const IsSolid& is_solid) {
    const auto host = Kokkos::create_mirror_view(type);
    for_all([&](int x, int y) { host(lattice.node(x, y)) = is_solid(x, y) ? NodeType::solid : NodeType::fluid; });
    Kokkos::deep_copy(type, host);
  }

  /// Adds a whole side or a stretch; sides of which nothing is added and that are not periodic are adiabatic.
  void side(Side which, HeatCondition condition, double value) { side(whole_side(lattice, which, condition, value)); }
  void side(const HeatSide& stretch) {
    sides.push_back(stretch);
    given_.push_back(stretch.side);
  }

  /// Sets the temperature along the wall of a whole side, by the distance in nodes from its lower or left end.
  void profile(Side which, const std::function<double(double)>& theta) {
    ScalarField<T> values("profile", 2 * side_length(lattice, which) + 1);
    const auto host = Kokkos::create_mirror_view(values);
    for (std::size_t k = 0; k < values.extent(0); ++k) host(k) = static_cast<T>(theta(0.5 * static_cast<double>(k)));
    Kokkos::deep_copy(values, host);
    const int corner = lattice.node(which == Side::right ? lattice.nx - 1 : 0, which == Side::top ? lattice.ny - 1 : 0);
    profiles_.push_back(
        {lattice, corner, is_upright(which) ? lattice.pitch : 1, static_cast<int>(which), directions(), values, {}});
    given_.push_back(which);
  }

  void flow(const std::function<std::array<double, 2>(int, int)>& velocity) {
    nodes = make_fluid_nodes(exec, lattice, type, periodic_);
    u = VectorField<T>("u", nodes.capacity);
    defect = ScalarField<T>("defect", nodes.capacity);
    lagged = ScalarField<T>("lagged", nodes.capacity);
    const auto node = host_copy(nodes.node);
    const auto host = Kokkos::create_mirror_view(u);
    for (int i = 0; i < nodes.count; ++i) {
      const auto v = velocity(lattice.x(node(i)), lattice.y(node(i)));
      host(i, 0) = static_cast<T>(v[0]);
      host(i, 1) = static_cast<T>(v[1]);
    }
    Kokkos::deep_copy(u, host);
    created = ScalarField<double>("created", lattice.ny);
    rows = fluid_rows(exec, nodes);
  }

  /// Opens a side for the flow (its velocity passes).
  void open(Side which) {
    mark_open(exec, nodes, find_boundary_links(exec, nodes, which, 0, side_length(lattice, which) - 1, directions()));
    rows = fluid_rows(exec, nodes);
  }

  void run(int steps) {
    if (!closed_) close();
    for (int step = 0; step < steps; ++step) {
      fields.rounding = rounding_of_step<T>(++steps_done_);
      for (int axis = 0; axis < 2; ++axis)
        if (periodic_[axis]) join_heat_sides(exec, fields, axis);
      fill_heat_sides<T>(exec, fields, sides);
      for (FillProfile<T> p : profiles_) {
        p.g = fields.g;
        for_each_node(exec, "profile", static_cast<int>(p.profile.extent(0)) / 2, p);
      }
      if (nodes.count == 0) {
        conduct(exec, fields);
        continue;
      }
      conduct_and_advect(exec, nodes, rows, u, defect, lagged, fields, created);
      // of the velocity that the next step streams with
      if (directions() == D2Q5::Q)
        advective_defect<D2Q5>(exec, nodes, u, defect);
      else
        advective_defect<D2Q9>(exec, nodes, u, defect, even_defect_weight(fields));
    }
    exec.fence();
  }

  /// theta of all nodes, row by row.
  std::vector<double> theta() const {
    const auto host = host_copy(temperatures(exec, fields));
    std::vector<double> values;
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) values.push_back(host(lattice.node(x, y)));
    return values;
  }

  double energy() const {
    const ScalarField<double> total("total", lattice.ny);
    add_heat_energy(exec, fields, total);
    return sum_in_order(total);
  }

  double entered() const {
    double sum = 0;
    for (const HeatSide& s : sides) sum += sum_in_order(s.energy_in);
    return sum;
  }

  int directions() const { return fields.velocity_set == ScalarVelocitySet::d2q9 ? D2Q9::Q : D2Q5::Q; }

  Exec exec;
  Lattice lattice;

 private:
  std::array<bool, 2> periodic_;
  bool closed_ = false;
  std::int64_t steps_done_ = 0;
  std::vector<Side> given_;
  std::vector<FillProfile<T>> profiles_;

 public:
  Kokkos::View<NodeType*> type;
  HeatFields<T> fields;
  FluidNodes nodes;
  VectorField<T> u;
  ScalarField<T> defect, lagged;
  ScalarField<double> created;
  FluidRows rows;
  std::vector<HeatSide> sides;

 private:
  template <class Visit>
  void for_all(const Visit& visit) const {
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) visit(x, y);
  }

  void close() {
    closed_ = true;
    for (const Side which : all_sides) {
      const bool joined = periodic_[is_upright(which) ? 0 : 1];
      if (!joined && std::find(given_.begin(), given_.end(), which) == given_.end())
        sides.push_back(whole_side(lattice, which, HeatCondition::adiabatic, 0));
    }
    assign_corners(lattice, sides);
  }
};

}  // namespace vug::test
