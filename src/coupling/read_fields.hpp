#pragma once
// Reads fields on the device into plain arrays over the lattice for output: row by row, without halo, in SI units.
// Where several ranks share a field, the first rank gets all values (io/field_list.hpp).
#include "coupling/geometry.hpp"
#include "io/field_list.hpp"

#include <span>
#include <utility>
#include <vector>

namespace vug {

/// Conversion of stored values to SI units, scale * value + shift, and the value where nothing is stored.
struct Conversion {
  double scale = 1;
  double shift = 0;
  double elsewhere = 0;
};

namespace detail {

/// Calls visit(k, node) for `count` items of a picture from `first` on, with their nodes of the lattice.
template <class Visit>
void visit_items(const Lattice& lattice, std::size_t first, std::size_t count, const Visit& visit) {
  int x = static_cast<int>(first % lattice.nx), y = static_cast<int>(first / lattice.nx);
  for (std::size_t k = 0; k < count; ++k) {
    visit(k, lattice.node(x, y));
    if (++x < lattice.nx) continue;
    x = 0;
    ++y;
  }
}

/// value(node) that all ranks have.
template <class Value>
ReadItems read_nodes(const Lattice& lattice, Value value) {
  return [lattice, value = std::move(value)](std::size_t first, std::span<double> out) {
    visit_items(lattice, first, out.size(), [&](std::size_t k, int node) { out[k] = value(node); });
  };
}

/// value(node, component) that rank owner(node) has.
template <class Value, class Owner>
ReadItems read_shared(const Geometry& geometry, int components, Value value, Owner owner) {
  return [=, &geometry](std::size_t first, std::span<double> out) {
    const std::size_t items = out.size() / components;
    visit_items(geometry.lattice, first, items, [&](std::size_t k, int node) {
      for (int c = 0; c < components; ++c) out[k * components + c] = value(node, c);
    });
    const Ranks& ranks = geometry.split.ranks();
    if (ranks.alone()) return;
    std::vector<int> owners(items);
    visit_items(geometry.lattice, first, items, [&](std::size_t k, int node) { owners[k] = owner(node); });
    ranks.bring(owners_of(owners, ranks.size()), 0, static_cast<int>(items), components * sizeof(double), out.data(),
                out.data());
  };
}

}  // namespace detail

/// Distributes values of the fluid nodes, one View per component, over the lattice.
template <class ViewType, std::size_t components>
ReadItems read_fluid(const Geometry& geometry, const std::array<ViewType, components>& values,
                     const Conversion& conversion) {
  std::vector<decltype(on_host(values[0]))> host;
  host.reserve(components);
  for (const ViewType& component : values) host.push_back(on_host(component));
  const auto index = on_host(geometry.fluid.index);
  const auto value = [=](int node, int c) {
    const int i = index(node);
    return i < 0 ? conversion.elsewhere : conversion.scale * static_cast<double>(host[c](i)) + conversion.shift;
  };
  const auto owner = [&geometry, index](int node) {
    const int i = index(node);
    return i < 0 ? 0 : geometry.split.owner_of(i);
  };
  return detail::read_shared(geometry, components, value, owner);
}

/// The interior of a dense field.
template <class ViewType>
ReadItems read_dense(const Geometry& geometry, const ViewType& values, const Conversion& conversion) {
  const auto value = [host = on_host(values), conversion](int node, int) {
    return conversion.scale * static_cast<double>(host(node)) + conversion.shift;
  };
  const auto owner = [&geometry](int node) { return geometry.split.rows().part_of(geometry.lattice.y(node)); };
  return detail::read_shared(geometry, 1, value, owner);
}

/// The number of a node's type (NodeType).
inline ReadItems read_type(const Geometry& geometry) {
  return detail::read_nodes(geometry.lattice,
                            [type = on_host(geometry.type)](int node) { return static_cast<double>(type(node)); });
}

/// Number of the mineral of every rock node, from 1; 0 in rock that is no mineral, -1 elsewhere.
inline ReadItems read_mineral(const Geometry& geometry) {
  return detail::read_nodes(geometry.lattice,
                            [type = on_host(geometry.type), mineral = on_host(geometry.mineral)](int node) {
                              return type(node) == NodeType::solid ? static_cast<double>(mineral(node)) : -1.0;
                            });
}

/// 1 in rock, 0 elsewhere.
inline ReadItems read_solid(const Geometry& geometry) {
  return detail::read_nodes(geometry.lattice, [type = on_host(geometry.type)](int node) {
    return type(node) == NodeType::solid ? 1.0 : 0.0;
  });
}

/// share(V, dissolved) of every rock node that can dissolve.
template <class Share>
ReadItems read_solid(const Geometry& geometry, const Share& share) {
  return detail::read_nodes(
      geometry.lattice, [share, volume = on_host(geometry.volume), dissolved = on_host(geometry.dissolved)](int node) {
        return static_cast<double>(share(volume(node), dissolved(node)));
      });
}

}  // namespace vug
