#include "kernels/flow/slit_drag.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"

namespace vug {

/// Viscosity nu of a node.
template <class T>
struct SlitViscosity {
  double everywhere;
  Kokkos::View<const T*> spread;  ///< (fluid) 3 nu; empty: nu is the same everywhere
  SlitViscosity(double viscosity, const FlowStep<T>& step) : everywhere(viscosity), spread(step.spread) {}
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int i) const {
    return spread.extent(0) > 0 ? double(spread(i)) / 3 : everywhere;
  }
};

/// Applies the drag to the populations that slit node k has sent out, and to its velocity. Computed in double: between
/// walls that hardly let fluid pass these populations cancel except for a part in millions.
template <class T, class Slots>
struct DragInSlits {
  SlitNodes slits;
  SlitViscosity<T> viscosity;
  ScalarField<T> f;
  VectorField<T> u;
  Slots slots;
  Share share;
  KOKKOS_FUNCTION void operator()(int k) const {
    const int i = slits.fluid(k);
    if (!is_own(share, i)) return;
    const double half = viscosity(i) * slits.resistance(k) / 2, slower = 1 / (1 + half);
    const double fx = -2 * half * slower * double(u(i, 0)), fy = -2 * half * slower * double(u(i, 1));
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int slot = slots.leaving(q, i);
      f(slot) = T(double(f(slot)) + 3 * D2Q9::w(q) * (D2Q9::c(q, 0) * fx + D2Q9::c(q, 1) * fy));
    }
    u(i, 0) = T(slower * double(u(i, 0)));
    u(i, 1) = T(slower * double(u(i, 1)));
  }
};

template <class T>
void drag_in_slits(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, FlowFields<T>& fields) {
  visit_slots<D2Q9>(nodes, !fields.turned, [&](const auto& slots) {  // of the last sweep
    for_each_node(exec, "vug::flow::drag_in_slits", slits.count,
                  DragInSlits<T, std::decay_t<decltype(slots)>>{
                      slits, {viscosity, step}, fields.f, fields.u, slots, nodes.share()});
  });
}

template <class T>
struct AddSlitDrag {
  SlitNodes slits;
  SlitViscosity<T> viscosity;
  VectorField<T> u;
  IndexList node;
  Lattice lattice;
  VectorField<double> centre;
  double spacing, force_scale, torque_scale;
  VectorField<double> force;
  ScalarField<double> torque;
  KOKKOS_FUNCTION void operator()(int g) const {
    double fx = 0, fy = 0, turning = 0;
    for (int k = slits.first(g); k < slits.first(g + 1); ++k) {
      const int i = slits.fluid(k);
      const double drag = viscosity(i) * slits.resistance(k);
      const double x = drag * double(u(i, 0)), y = drag * double(u(i, 1));
      const double arm_x = lattice.x(node(i)) + 0.5 - centre(g, 0) / spacing;
      const double arm_y = lattice.y(node(i)) + 0.5 - centre(g, 1) / spacing;
      fx += x;
      fy += y;
      turning += arm_x * y - arm_y * x;
    }
    force(g, 0) += force_scale * fx;
    force(g, 1) += force_scale * fy;
    torque(g) += torque_scale * turning;
  }
};

template <class T>
void add_slit_drag(const Exec& exec, const FluidNodes& nodes, const SlitNodes& slits, double viscosity,
                   const FlowStep<T>& step, const FlowFields<T>& fields, const VectorField<double>& centre,
                   double spacing, double force_scale, double torque_scale, const VectorField<double>& force,
                   const ScalarField<double>& torque) {
  for_each_node(exec, "vug::flow::add_slit_drag", static_cast<int>(slits.first.extent(0)) - 1,
                AddSlitDrag<T>{slits,
                               {viscosity, step},
                               fields.u,
                               nodes.node,
                               nodes.lattice,
                               centre,
                               spacing,
                               force_scale,
                               torque_scale,
                               force,
                               torque});
}

VUG_COMPILE_FOR_NUMBERS(drag_in_slits)
VUG_COMPILE_FOR_NUMBERS(add_slit_drag)

}  // namespace vug
