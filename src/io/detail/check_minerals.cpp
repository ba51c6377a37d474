// Checks of the minerals of a case: where they are, and their rates against the reaction.
#include "io/detail/case_checks.hpp"
#include "io/detail/toml_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {
namespace {

std::string further_table(std::size_t i) {
  return fmt::format("reaction.further.{}", i);
}

/// Checks what needs a product, and which of an order other than one, a finite equilibrium constant and the paper's
/// wall may be combined. `key` is the table of the rate, `reaction` that of the reaction, which names the product.
void check_rate(const TomlDocument& document, const std::string& key, const RateLaw& rate, const std::string& reaction,
                bool has_product, ReactiveWallLaw wall) {
  if (rate.inverse_equilibrium_constant > 0 && !has_product)
    document.fail(key + ".equilibrium_constant",
                  fmt::format("needs {}.product: a reversible reaction runs back from its product", reaction));
  if (!has_product && document.find(key + ".product_stoichiometry") != nullptr)
    document.fail(key + ".product_stoichiometry", fmt::format("needs {}.product", reaction));
  if (rate.order == 1) return;
  if (rate.inverse_equilibrium_constant > 0)
    document.fail(key + ".order", "is not 1; that is only for reactions without an equilibrium_constant");
  if (wall == ReactiveWallLaw::paper)
    document.fail(key + ".order", "is not 1; that is only for reaction.wall = \"kinetic\"");
}

/// The table in which the case gives the rate of the further reaction `i` on mineral `m`: one of [[mineral.further]],
/// or that of the rock.
std::string table_of_rate(const TomlDocument& document, std::size_t m, std::size_t i, const std::string& reactant) {
  for (int element = 0;; ++element) {
    const std::string key = fmt::format("mineral.{}.further.{}", m, element);
    const toml::node* given = document.find(key + ".reactant");
    if (given == nullptr) return further_table(i);
    if (given->value_or(std::string()) == reactant) return key;
  }
}

/// A label must be one of rock pixels, and belong to one mineral only.
void check_labels(const TomlDocument& document, Scene& scene, std::size_t m) {
  ImageSection& image = scene.geometry.image;
  const std::string key = fmt::format("mineral.{}.labels", m);
  const MineralSection& mineral = scene.minerals[m];
  if (mineral.labels.empty()) return;
  if (scene.geometry.kind != GeometryKind::image || !image.labelled())
    document.fail(key, "are of a label map: they need geometry.type = \"image\" with geometry.solid_labels");
  for (const std::int64_t label : mineral.labels) {
    const auto& solid = image.solid_labels;
    if (std::find(solid.begin(), solid.end(), label) == solid.end())
      document.fail(key, fmt::format("holds {}, which is not in geometry.solid_labels", label));
    const auto number = static_cast<std::uint8_t>(m + 1);
    const auto [entry, is_new] = image.minerals.emplace(label, number);
    if (!is_new && entry->second != number)
      document.fail(key, fmt::format("holds {}, which is of the mineral \"{}\" as well", label,
                                     scene.minerals[entry->second - 1u].name));
  }
}

/// No species may have the name of a history column of this mineral.
void check_columns(const TomlDocument& document, const Scene& scene, std::size_t m) {
  if (!scene.solute) return;
  for (const Species& species : scene.solute->species)
    for (const char* what : {"_volume", "_dissolved"})
      if (species.name == scene.minerals[m].name + what)
        document.fail(fmt::format("mineral.{}.name", m),
                      fmt::format("gives columns of the history the name of the species \"{}\"", species.name));
}

}  // namespace

void check_minerals(const TomlDocument& document, Scene& scene) {
  if (!scene.minerals.empty() && scene.geometry.kind == GeometryKind::open)
    document.fail_at("mineral", "[[mineral]] needs rock, and geometry.type = \"open\" has none");
  const auto* reaction = scene.reaction ? &*scene.reaction : nullptr;
  if (reaction) {
    if (!reaction->further.empty() && reaction->wall == ReactiveWallLaw::paper)
      document.fail("reaction.wall", "is of one reactant; with [[reaction.further]] it must be \"kinetic\"");
    if (scene.heat && document.find("reaction.temperature"))
      document.fail("reaction.temperature", "stands beside [heat], whose temperatures are those of the walls");
    check_rate(document, "reaction", *reaction, "reaction", reaction->product.has_value(), reaction->wall);
    for (std::size_t i = 0; i < reaction->further.size(); ++i)
      check_rate(document, further_table(i), reaction->further[i], further_table(i),
                 reaction->further[i].product.has_value(), reaction->wall);
  }
  for (std::size_t m = 0; m < scene.minerals.size(); ++m) {
    check_labels(document, scene, m);
    check_columns(document, scene, m);
    for (std::size_t r = 0; r < scene.minerals[m].rates.size(); ++r) {
      const RateLaw& rate = scene.minerals[m].rates[r];
      if (r == 0) {
        check_rate(document, fmt::format("mineral.{}", m), rate, "reaction", reaction->product.has_value(),
                   reaction->wall);
        continue;
      }
      const FurtherReactant& further = reaction->further[r - 1];
      check_rate(document, table_of_rate(document, m, r - 1, further.reactant), rate, further_table(r - 1),
                 further.product.has_value(), reaction->wall);
    }
  }
}

}  // namespace vug
