#include "coupling/mechanics_module.hpp"

#include "base/require.hpp"
#include "coupling/force_change.hpp"
#include "coupling/handed_push.hpp"
#include "coupling/rock_loads.hpp"
#include "dem/soundness.hpp"
#include "io/named_temperatures.hpp"
#include "io/rock_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <utility>

namespace vug {

namespace {

constexpr double most_substeps = 1e6;  // in a lattice step, as for mechanics.substeps
// Owed sub-steps from which on they are taken without waiting for further lattice steps: a stop would have to wait.
constexpr int many_substeps = 100000;
constexpr int most_owed =
    16;  // lattice steps; more would not use the caches better, and a stop would have to wait longer

}  // namespace

template <class T>
MechanicsModule<T>::MechanicsModule(const Exec& exec, const Scene& scene, const LatticeUnits& units,
                                    const Geometry& geometry, const Rock& rock, const FlowModule<T>* flow,
                                    const HeatModule<T>* heat)
    : section_(*scene.mechanics),
      units_(units),
      geometry_(geometry),
      flow_(flow),
      heat_(heat),
      update_interval_(scene.accuracy.update_interval),
      exchange_interval_(scene.accuracy.exchange_interval),
      guard_interval_(scene.accuracy.guard_interval),
      warming_(scene.heat ? largest_named_change(scene) : 0),
      holds_forces_(flow && (exchange_interval_ > 1 || scene.accuracy.chooses_intervals())),
      neighbours_(rock.neighbours),
      thermal_(heat ? thermal_nodes(scene, rock, geometry.lattice) : ThermalNodes{}),
      mechanics_(rock.assembly, section_.parameters, boundary_loads(scene)),
      gauges_(scene, rock.assembly, mechanics_),
      fields_asked_for_(scene.output.fields) {
  for (std::size_t n = 0; n < section_.initial_velocities.size(); ++n) {
    const InitialVelocity& start = section_.initial_velocities[n];
    const std::string what = fmt::format("{}: mechanics.initial_velocity.{}", scene.path, n);
    initial_velocities_.emplace_back(triangles_of_region(start.region, scene.minerals, what, rock.assembly),
                                     start.velocity);
  }
  KOKKOS_ASSERT(mechanics_.bonds().count == rock.bonds);
  const bool dissolves = rock_dissolves(scene);
  if (flow_ || dissolves) wet_.emplace(geometry.lattice, rock.nodes_of_sector);
  if (dissolves) dissolved_.emplace(exec, rock.nodes_of_sector, rock.sectors_of_bond, geometry.volume);
  if (section_.lets_fragments_go) dissolved_->follow_fragments();
  mechanics_.share(geometry.split.ranks());
  if (heat_ && !geometry.split.alone()) share_temperatures();
  if (flow_ && scene.accuracy.chooses_intervals())
    watched_ = VectorField<double>("vug::mechanics::watched", mechanics_.particles().force.extent(0));
  find_links(exec);
  choose_substeps();
  if (substeps_ > most_substeps)
    throw InputError(fmt::format(
        "{}: lattice.time_step = {:g} s needs {:.3g} mechanical steps of {:.3g} s; at most {:g} are possible: lower "
        "lattice.time_step, or raise rock.element_size or mechanics.mass_scaling",
        scene.path, units_.time_step, static_cast<double>(substeps_), units_.time_step / substeps_, most_substeps));
}

template <class T>
void MechanicsModule<T>::choose_substeps() {
  const double critical = mechanics_.critical_step();
  if (section_.substeps) {
    substeps_ = *section_.substeps;
    if (units_.time_step / substeps_ > critical && !section_.force_unstable)
      throw InputError(fmt::format(
          "mechanics.substeps = {} gives a mechanical time step of {:.3g} s above the critical {:.3g} s; use at least "
          "{} sub-steps, leave the key out, or set mechanics.force_unstable = true",
          substeps_, units_.time_step / substeps_, critical, std::ceil(units_.time_step / critical)));
  } else {
    const double wanted = std::ceil(units_.time_step / (section_.critical_fraction * critical));
    substeps_ = static_cast<int>(std::clamp(wanted, 1.0, double{std::numeric_limits<int>::max()}));
  }
}

template <class T>
void MechanicsModule<T>::begin(const Exec& exec) {
  if (!section_.static_preload || !mechanics_.preload_statically(exec))
    mechanics_.preload(exec, section_.preload_time, section_.preload_damping);
  for (const auto& [triangles, velocity] : initial_velocities_) mechanics_.set_velocity(triangles, velocity);
}

template <class T>
void MechanicsModule<T>::find_links(const Exec& exec) {
  if (wet_) wet_->find(exec, geometry_.surface);
  if (flow_)
    find_wall_links(exec, geometry_.fluid, wet_->of_triangle(), wet_->node(), mechanics_.particles().x0,
                    geometry_.spacing, links_);
  if (flow_ && !geometry_.split.alone()) share_links();
}

template <class T>
void MechanicsModule<T>::warm(const Exec& exec, double time) {
  const ScalarField<double>& change = mechanics_.particles().temperature_change;
  warm_particles(exec, thermal_.of_particle, heat_->temperature(exec, temperatures_), heat_->initial_theta(), change,
                 our_warmed_);
  geometry_.split.make_whole(of_warmed_, change);
  for (std::size_t o = 0; o < thermal_.in_opening.size(); ++o) {
    const HeatBoundary& heat = geometry_.openings[o].conditions.heat;
    if (heat.kind == HeatCondition::temperature)  // the given one, which a resumed run knows as well
      warm_particles_to(exec, thermal_.in_opening[o],
                        units_.lattice_temperature(heat.temperature.at(time)) - heat_->initial_theta(), change);
  }
}

template <class T>
void MechanicsModule<T>::step(const Exec& exec, const Clock& clock) {
  const Particles& particles = mechanics_.particles();
  const bool pushed = flow_ && clock.step % exchange_interval_ == 0, updated = clock.step % update_interval_ == 0;
  if (pushed || updated) catch_up(exec);
  if (pushed) {
    walls_.exchange<T, 1>(exec, {flow_->flow().f});
    exchange_momentum(exec, flow_->flow(), links_, units_.force(), units_.force() * geometry_.spacing, particles.force,
                      particles.torque, our_triangles_);
    const auto [x, y] = components(particles.force);
    forces_.exchange<double, 3>(exec, {x, y, particles.torque});
    flow_->add_slit_drag(exec, particles.x0, particles.force, particles.torque);
    if (dissolved_) hand_on_push(exec, neighbours_, particles);
  }
  if (updated) {
    rock_ = RockIs::changed;
    if (heat_) warm(exec, clock.time());
    if (dissolved_) {
      dissolved_->update(exec, *wet_, geometry_.dissolved);
      mechanics_.dissolve(exec, units_.time_step / substeps_, dissolved_->solid_fraction(), dissolved_->d_c());
    }
  }
  const bool looked_at = (clock.step + 1) % update_interval_ == 0;
  if (++owed_ == most_owed || looked_at || owed_ >= many_substeps / substeps_) catch_up(exec);
  if (!looked_at) return;
  mechanics_.make_positions_whole(exec);
  if (dissolved_) dissolved_->let_go(exec, particles, mechanics_.bonds());
}

/// Takes all owed sub-steps together: if the rock moved in every lattice step, it would find lattice data in the
/// caches.
template <class T>
void MechanicsModule<T>::catch_up(const Exec& exec) {
  if (owed_ == 0) return;
  mechanics_.advance(exec, units_.time_step / substeps_, substeps_, rock_, owed_);
  rock_ = RockIs::the_same;
  owed_ = 0;
}

template <class T>
void MechanicsModule<T>::births(const Exec& exec, const Births& births) {
  if (dissolved_ && births.solid_moved) dissolved_->solid_moved(exec, *wet_, geometry_.dissolved, geometry_.volume);
  if (dissolved_) dissolved_->settle(exec, *wet_, geometry_.type, geometry_.dissolved);
  find_links(exec);
}

template <class T>
void MechanicsModule<T>::guard(const Exec& exec, const Clock& clock) {
  mechanics_.make_whole(exec);  // rows of the history are written after the guard, too
  if (const std::string wrong = what_is_unsound(exec, mechanics_, flow_ != nullptr); !wrong.empty())
    throw StabilityError(fmt::format("mechanics diverged at step {}: {}", clock.step, wrong));
  // Dissolving particles become lighter. Done only at fixed steps, so that a checkpoint does not change results.
  if (!section_.substeps && clock.step % guard_interval_ == 0) choose_substeps();
}

template <class T>
void MechanicsModule<T>::watch(const Exec& exec, const Clock&, Changes& changes) {
  if (!flow_) return;
  catch_up(exec);
  mechanics_.make_whole(exec);
  const ForceChange seen = largest_force_change(exec, mechanics_.particles().force, watched_);
  changes.force = share_of(seen.change, seen.force);
}

template <class T>
void MechanicsModule<T>::take(const Exec&, const Intervals& intervals) {
  exchange_interval_ = intervals.exchange;
  update_interval_ = intervals.update;
}

template <class T>
void MechanicsModule<T>::state(StateList& list) {
  mechanics_.visit_state([&](const char* name, const auto& view, auto... range) {
    list.add(std::string("mechanics/") + name, view, StateRange{static_cast<double>(range)...});
  });
  if (dissolved_)
    dissolved_->visit_state(
        [&](const std::string& name, const auto& view) { list.add("mechanics/dissolved_shares/" + name, view); });
  if (watched_.extent(0) > 0) list.add("mechanics/watched", watched_);
  if (holds_forces_) {  // a resumed run needs them until the next exchange
    list.add("mechanics/force", mechanics_.particles().force);
    list.add("mechanics/torque", mechanics_.particles().torque);
  }
  struct Progress {
    double time;
    long steps, all_due;
  };
  list.add(StateBlock{"mechanics/progress", sizeof(Progress),
                      [this](const TakeBytes& take) {
                        const Progress progress{mechanics_.time(), mechanics_.steps(), mechanics_.all_due()};
                        take(std::as_bytes(std::span(&progress, 1)));
                      },
                      [this](const GiveBytes& give) {
                        std::array<std::byte, sizeof(Progress)> bytes;
                        give(0, bytes);
                        detail::require_range<double>("mechanics/time", std::span(bytes).first(sizeof(double)), {});
                        const auto numbers = std::span(bytes).last(2 * sizeof(long));
                        detail::require_range<long>("mechanics/steps", numbers.first(sizeof(long)), {0, 1e18});
                        detail::require_range<long>("mechanics/all_due", numbers.last(sizeof(long)), {0, 1});
                        Progress progress;
                        std::memcpy(static_cast<void*>(&progress), bytes.data(), sizeof progress);
                        mechanics_.set_time(progress.time);
                        mechanics_.set_steps(progress.steps);
                        mechanics_.set_all_due(progress.all_due != 0);
                      }});
  // the lightest particles need 2.2 times as many as intact ones
  list.add_value("mechanics/substeps", substeps_, {1, 10.0 * substeps_});
}

template class MechanicsModule<float>;
template class MechanicsModule<double>;

}  // namespace vug
