#pragma once
// Error bars: the run again on coarser lattices, or with finer intervals, and what the differences say.
#include "coupling/grid_convergence.hpp"
#include "coupling/run.hpp"
#include "io/history_reader.hpp"

#include <string>
#include <vector>

namespace vug {

/// A run that differs from another only in how finely it computes.
struct Twin {
  std::string folder;  ///< within that of the run
  Scene scene;
};

/// What a case is compared with.
///
/// Lattices of 2 and 4 times the spacing and 4 and 16 times the step (so that viscosity and diffusivities keep their
/// lattice values and every error of second order falls alike): a fifteenth of the run's cost. Where such lattices do
/// not fit the size, the ratio nearest to 2 that does, of 5/4 to 3, is taken. Rock that is broken into pathways a
/// number of cells wide has no such twin: there every interval of [accuracy] is halved instead, and the precision is
/// double.
struct Twins {
  double ratio = 0;         ///< of the spacings; 0: of finer intervals
  std::vector<Twin> twins;  ///< the nearest first
};

/// The twins of a scene. Throws InputError where it has none: numbers of cells without a common divisor, an image,
/// nothing to halve.
Twins find_twins(const Scene& scene);

/// What is known of one column of the history at the end.
struct BarOfColumn {
  std::string name;
  double value = 0;
  ErrorBar error;
};

/// Bars of `run` at every one of its rows from the histories of its twins, values[c][row] of the columns in `names`
/// (those of both that are amounts; not counts, nor errors of balances), and what is known at the end. A bar is NaN
/// where the only twin agrees to the last bit: nothing is known then.
struct ErrorBars {
  std::vector<std::string> names;
  std::vector<double> time;
  std::vector<std::vector<double>> value, bar;
  std::vector<BarOfColumn> last;
};
ErrorBars find_error_bars(const History& run, const std::vector<History>& twins, double ratio);

/// Runs the scene as run_case does, then its twins into DIR/error_bars/, and writes DIR/error_bars.csv: time_s, then
/// every column of the history with its bar beside it, which is empty where nothing is known. Twins continue and
/// replace what is there as `options` say. Returns what is known at the end, one line per column. Throws what run_case
/// throws; a twin that diverges, or is too fast for its lattice, is left out.
std::string run_with_error_bars(const Scene& scene, const RunOptions& options);

}  // namespace vug
