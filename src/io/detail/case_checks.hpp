#pragma once
// Checks between the tables of a case. Each function throws InputError at the first contradiction.
#include "io/detail/toml_document.hpp"
#include "io/scene.hpp"

namespace vug {

/// Every key and table of the document must be one that the reader knows.
void check_names(const TomlDocument& document);

void check_modules(const TomlDocument& document, const Scene& scene);  ///< which table needs which other
void check_places(const TomlDocument& document, Scene& scene);         ///< everything drawn lies on the lattice
/// Everything drawn lies in the specimen of [laboratory].
void check_places_of_specimen(const TomlDocument& document, const Scene& scene);
void check_ageing(const TomlDocument& document, const Scene& scene);      ///< rock that ages faster than the fluid
void check_times(const TomlDocument& document, const Scene& scene);       ///< end, intervals, ramps
void check_scales(const TomlDocument& document, const Scene& scene);      ///< diffusivities in lattice units
void check_species(const TomlDocument& document, const Scene& scene);     ///< names of species
void check_minerals(const TomlDocument& document, Scene& scene);          ///< where minerals are, and their rates
void check_boundaries(const TomlDocument& document, Scene& scene);        ///< conditions against modules and each other
void check_traction(const TomlDocument& document, const Scene& scene);    ///< supports and loads of the rock
void check_laboratory(const TomlDocument& document, const Scene& scene);  ///< [laboratory] against all others
void check_groups(const TomlDocument& document, const Scene& scene);      ///< named surfaces need a mesh
void check_files(const TomlDocument& document, Scene& scene);             ///< meshes and images exist; resolves paths

/// Rock whose temperature changes by up to `change` (K) must not shrink to nothing.
void check_thermal_strain(const TomlDocument& document, const Scene& scene, double change);

/// The generator must not make more than `most_triangles` on `area` (m2).
void check_triangles(const TomlDocument& document, const RockSection& rock, double area);

/// Adds the warnings about what is allowed but probably not meant.
void collect_warnings(Scene& scene);
/// The one about reactions that feed each other and make more than they take.
void warn_about_circles(Scene& scene);
/// Those about the fluid in the pores.
void warn_about_pores(Scene& scene);
/// Those about numbers that are probably meant in another unit, or from another zero.
void warn_about_units(Scene& scene);

}  // namespace vug
