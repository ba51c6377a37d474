#pragma once
// Error bars: the case is run again on coarser lattices, or with finer intervals, and the bars follow from the
// differences.
#include "coupling/grid_convergence.hpp"
#include "coupling/run.hpp"
#include "io/history_reader.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace vug {

/// A run that differs from another only in its resolution.
struct Twin {
  std::string folder;  ///< inside that of the run
  Scene scene;
};

/// The runs with which a case is compared.
///
/// These have lattices of 2 and 4 times the spacing and 4 and 16 times the time step, so that viscosity and
/// diffusivities keep their lattice values and every error of second order changes by the same factor. They cost a
/// fifteenth of the run. Where such lattices do not fit the size, the ratio is the one in 5/4 to 3 nearest to 2 that
/// does. A picture is coarsened by the same ratio (geometry.coarsen), so that cells stay whole squares of pixels. Rock
/// with pathways that are a number of cells wide has no such twin. There every interval of [accuracy] is halved
/// instead, and the precision is double.
struct Twins {
  double ratio = 0;         ///< ratio of the spacings; 0: the twin has finer intervals
  std::vector<Twin> twins;  ///< the nearest first
};

/// Steps on a lattice `ratio` times coarser that take as long or, rounded up, a part of a step longer; at least 1.
std::int64_t steps_over(std::int64_t steps, double ratio);

/// Finds the twins of a scene. Throws InputError where it has none: numbers of cells without a common divisor, a
/// picture that no whole number of pixels coarsens, no interval to halve.
Twins find_twins(const Scene& scene);

/// What is known about one column of the history at the end.
struct BarOfColumn {
  std::string name;
  double value = 0;
  ErrorBar error;
};

/// Error bars of `run` at each of its rows, from the histories of its twins: values[c][row] of the columns in `names`
/// (amounts that both have; not counts or errors of balances), and the state at the end. A bar is NaN, that is unknown,
/// where the only twin agrees to the last bit, and where rock dissolves but no wall of the nearest twin, on a coarser
/// lattice than `spacing` (m), has moved. An amount below the share `rounding` of the largest of its balance is
/// rounding of the others, and so is a mean velocity (is_rounding_of_velocity, with `sound` in m/s). `staircase` as in
/// error_bar.
struct ErrorBars {
  std::vector<std::string> names;
  std::vector<double> time;
  std::vector<std::vector<double>> value, bar;
  std::vector<BarOfColumn> last;
};
ErrorBars find_error_bars(const History& run, const std::vector<History>& twins, double ratio, double rounding = 1e-12,
                          double sound = 0, double spacing = 0, bool staircase = false);

/// Whether a lattice draws walls of the case as staircases: a picture, or shapes other than rectangles.
bool has_staircases(const Scene& scene);

/// Runs the scene as run_case does, then its twins into DIR/error_bars/, and writes DIR/error_bars.csv: time_s, then
/// every column of the history followed by its bar, which is empty where it is unknown. `options` say whether twins are
/// continued or replaced. Returns what is known at the end, one line per column. Throws what run_case throws; a twin
/// that diverges, or is too fast for its lattice, is left out.
std::string run_with_error_bars(const Scene& scene, const RunOptions& options);

}  // namespace vug
