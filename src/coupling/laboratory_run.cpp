#include "coupling/laboratory_run.hpp"

#include "base/require.hpp"
#include "coupling/laboratory_report.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/recorded_run.hpp"
#include "coupling/rock_fields.hpp"
#include "coupling/specimen.hpp"
#include "host/interruption.hpp"
#include "io/history_writer.hpp"
#include "io/require_fields.hpp"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <ostream>
#include <utility>
#include <vector>

namespace vug {

namespace {

constexpr double fit_tolerance =
    0.01;  // relative, of the mean strength: less than the scatter of the mean over five seeds

FieldList fields_of_rock(const Scene& scene, const Mechanics& rock) {
  FieldList fields;
  add_rock_fields(rock, fields, scene.output.fields);
  return fields;
}

/// Writes particles.h5 of the first specimen: at every interval and at the end.
class SpecimenPictures {
 public:
  SpecimenPictures(const Scene& scene, const Assembly& specimen, std::string directory)
      : scene_(scene), specimen_(specimen), directory_(std::move(directory)) {}

  void look(const Mechanics& rock, bool last) {
    const bool due = scene_.output.interval && rock.time() >= next_;
    if (!due && !last) return;
    if (due) next_ += *scene_.output.interval;
    if (!writer_) {
      writer_.emplace(directory_, fields_of_rock(scene_, rock),
                      SnapshotOptions{scene_.output.fields, scene_.output.compress, {}},
                      shape_of_rock(specimen_, rock.bonds()));
    }
    writer_->write(rock.time(), rock.steps());
  }

 private:
  const Scene& scene_;
  const Assembly& specimen_;
  std::string directory_;
  std::optional<SnapshotWriter> writer_;
  double next_ = 0;
};

/// How many of the bonds that the load has broken (without notches) have edges within 30 degrees of the direction of
/// the load: 1/3 for random directions, more where the rock splits.
int along_load(const Bonds& bonds) {
  const auto state = on_host(bonds.state);
  const auto normal = on_host(bonds.normal);
  int along = 0;
  for (int k = 0; k < bonds.count; ++k) along += has_broken(state(k)) && std::abs(normal(k, 0)) > std::sqrt(0.75);
  return along;
}

const char* name_of(LaboratoryTest test) {
  switch (test) {
    case LaboratoryTest::compression:
      return "compression";
    case LaboratoryTest::tension:
      return "direct tension";
    case LaboratoryTest::brazilian:
      return "Brazilian disc";
    case LaboratoryTest::heating:
      return "heating between fixed platens";
    default:
      return "quench of the upper face";
  }
}

LoadedSpecimen load_specimen(const Scene& scene, const Assembly& specimen, int number, const std::string& directory,
                             HistoryWriter& curve, std::ostream* progress) {
  MechanicsParameters parameters = scene.mechanics->parameters;
  parameters.bond.seed += static_cast<std::uint64_t>(number);
  parameters.energy_ledger = scene.laboratory->energies;
  SpecimenPictures pictures(scene, specimen, directory);
  const PlatenTest test = platen_test(scene, specimen);
  LoadedSpecimen loaded;
  double next_line = 0;
  loaded.result = load_between_platens(
      Exec(), specimen, parameters, test, [&](const Mechanics& rock, const PlatenResult& so_far, bool last) {
        const double strain = so_far.strain.back(), stress = so_far.stress.back();
        const BondCounts bonds = rock.bond_counts();
        std::vector<double> row{strain,
                                stress,
                                static_cast<double>(parameters.bond.seed),
                                static_cast<double>(bonds.failed_in_tension),
                                static_cast<double>(bonds.failed_in_shear),
                                so_far.confinement.back()};
        if (parameters.energy_ledger) {
          const std::vector<double> energies = values_of(rock.energies(Exec()));
          row.insert(row.end(), energies.begin(), energies.end());
        }
        curve.write(row);
        if (number == 0) pictures.look(rock, last);
        if (last) loaded.along_load = along_load(rock.bonds());
        if (progress && (last || strain >= next_line)) {
          *progress << fmt::format("seed {}: strain {:.4f} %, stress {:.2f} MPa, {} bonds failed\n",
                                   parameters.bond.seed, 100 * strain, stress / 1e6, bonds.failed());
          next_line += 0.02 * test.largest_strain;
        }
      });
  return loaded;
}

/// Reports and records a warning when the rock did not come to rest under the confinement, or when the confinement
/// broke bonds before the test.
void note_preload(const std::optional<PreloadReport>& preload, const LaboratoryOptions& options, RunRecord& record) {
  const auto note = [&](const std::string& what) {
    record.events.push_back("warning: " + what);
    if (std::ostream* log = options.progress ? options.progress : options.warnings)
      *log << record.events.back() << '\n';
  };
  if (!preload) return;
  if (!preload->settled) note(unrest_of(*preload));
  if (const int failed = broken(preload->bonds); failed > 0)
    note(fmt::format("{} failed while the confinement was put on, before the test",
                     failed == 1 ? "1 bond" : fmt::format("{} bonds", failed)));
}

/// Advice for a specimen whose stress passed no peak.
const char* what_breaks_more(LaboratoryTest test) {
  return test == LaboratoryTest::heating ? "raise laboratory.temperature_change" : "raise laboratory.largest_strain";
}

std::string load_all(const Scene& scene, const LaboratoryOptions& options, const Assembly& specimen,
                     const std::string& directory, RunRecord& record) {
  Results& results = record.results;
  std::vector<std::string> columns{"strain_1",          "stress_Pa",     "seed_1", "failed_in_tension_1",
                                   "failed_in_shear_1", "confinement_Pa"};
  if (scene.laboratory->energies) columns.insert(columns.end(), energy_columns.begin(), energy_columns.end());
  HistoryWriter curve(directory + "/stress_strain.csv", columns);
  std::vector<LoadedSpecimen> specimens;
  for (int s = 0; s < options.seeds; ++s) {
    specimens.push_back(load_specimen(scene, specimen, s, directory, curve, options.progress));
    note_preload(specimens.back().result.preload, options, record);
  }
  std::string text = report_of(specimens, what_breaks_more(scene.laboratory->test), results);
  if (scene.laboratory->energies) text += report_energies(specimens, results);
  return text;
}

std::string quench_specimen(const Scene& scene, const LaboratoryOptions& options, const Assembly& specimen,
                            const std::string& directory, Results& results) {
  SpecimenPictures pictures(scene, specimen, directory);
  int looks = 0;
  const QuenchTest test = quench_test(scene);
  const QuenchResult r =
      quench(Exec(), specimen, scene.mechanics->parameters, test, [&](const Mechanics& rock, double length, bool last) {
        pictures.look(rock, last);
        if (options.progress && ++looks % (test.samples / 10) == 0)
          *options.progress << fmt::format("cold to {:.3g} mm, {} bonds failed\n", 1e3 * length,
                                           rock.bond_counts().failed());
      });
  HistoryWriter table(directory + "/cracks.csv", {"depth_m", "cracks_1"});
  for (std::size_t i = 0; i < r.depth.size(); ++i) table.write(std::vector<double>{r.depth[i], r.cracks[i]});
  if (r.spacing > 0) results.emplace_back("spacing_m", r.spacing);
  results.insert(results.end(), {{"mean_depth_m", r.mean_depth},
                                 {"deepest_m", r.deepest},
                                 {"steps_1", static_cast<double>(r.steps)},
                                 {"time_step_s", r.time_step}});
  if (r.spacing == 0) return "no crack is deeper than two elements\n";
  return fmt::format(
      "crack spacing         {:.3g} mm at two elements' depth\nmean depth            {:.3g} mm\n"
      "deepest crack         {:.3g} mm\n",
      1e3 * r.spacing, 1e3 * r.mean_depth, 1e3 * r.deepest);
}

std::string fit(const Scene& scene, const LaboratoryOptions& options, const Assembly& specimen, RunRecord& record) {
  Scene tried = scene;
  const auto test = [&](const MechanicsParameters& rock) {
    tried.mechanics->parameters = rock;
    return platen_test(tried, specimen);
  };
  const CohesionFit found = fit_cohesion(Exec(), specimen, scene.mechanics->parameters, test, *options.fit_strength,
                                         options.seeds, fit_tolerance);
  note_preload(found.restless, options, record);
  record.results = {{"wanted_strength_Pa", *options.fit_strength},
                    {"specimens_1", static_cast<double>(options.seeds)},
                    {"rounds_1", static_cast<double>(found.rounds)},
                    {"cohesion_Pa", found.cohesion},
                    {"strength_Pa", found.strength.mean},
                    {"strength_deviation_Pa", found.strength.deviation}};
  return fmt::format(
      "cohesion              {:.2f} MPa (mechanics.bond.cohesion = {:.4g}{})\n"
      "{}wanted                {:.2f} MPa, of {} {}; {} {}\n",
      found.cohesion / 1e6, found.cohesion,
      scene.mechanics->parameters.materials.empty() ? "" : ", shared by materials that gave the same as the rock",
      line_of("strength", found.strength, 1e6, "MPa", 2), *options.fit_strength / 1e6, options.seeds,
      options.seeds == 1 ? "specimen" : "specimens in the mean", found.rounds, found.rounds == 1 ? "round" : "rounds");
}

}  // namespace

std::string run_laboratory(const Scene& scene, const LaboratoryOptions& options) {
  if (options.fit_strength && scene.laboratory->test == LaboratoryTest::quench)
    throw InputError(scene.path + ": a quench has no strength to fit");
  if (options.fit_strength && scene.mechanics->parameters.bond.cohesion == 0)
    throw InputError(scene.path + ": mechanics.bond.cohesion is 0, and a fit multiplies it; begin with the strength");
  if (options.seeds > 1 && scene.laboratory->test == LaboratoryTest::quench)
    throw InputError(scene.path + ": a quench is of one specimen; give others by mechanics.bond.seed");
  RecordedRun run(scene, options.directory, options.overwrite ? RunFolder::Use::overwrite : RunFolder::Use::fresh,
                  "--overwrite replaces it, -o DIR leaves it alone");
  const Assembly specimen = build_specimen(scene);
  const Mechanics unloaded(specimen, scene.mechanics->parameters, Loads{});
  age_chemically(scene, unloaded);
  require_fields(fields_of_rock(scene, unloaded), scene.output.fields);
  require_testable(scene, specimen, unloaded);
  const StopsInOrder in_order;
  run.begin();
  if (std::ostream* log = options.progress ? options.progress : options.warnings) {
    if (!run.warning().empty()) *log << "warning: " << run.warning() << '\n';
    for (const std::string& warning : scene.warnings) *log << "warning: " << warning << '\n';
    for (const Limit& limit : limits_of_specimen(scene, specimen, unloaded))
      if (!limit.inside()) *log << "warning: " << warning_of(limit) << '\n';
  }
  try {
    const std::string found = options.fit_strength ? fit(scene, options, specimen, run.record())
                              : scene.laboratory->test == LaboratoryTest::quench
                                  ? quench_specimen(scene, options, specimen, run.path(), run.record().results)
                                  : load_all(scene, options, specimen, run.path(), run.record());
    run.close_done("the test has ended");
    return fmt::format("{:<22}{}, {} triangles\n{}{:<22}{}\n", "test", name_of(scene.laboratory->test),
                       specimen.triangles.size(), found, "files", run.path());
  } catch (const std::exception& error) {  // for instance a fit that found nothing
    run.close_failed(error);
    throw;
  }
}

}  // namespace vug
