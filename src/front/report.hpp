#pragma once
// `vug report`: a bundle that shows somebody else what happened in a run.
#include <string>

namespace vug {

/// Writes the new folder `bundle`. It contains the case with the files that it names, the run's record and history, the
/// checkpoint from which its last part can be run again (the newest undamaged one before the last step), and a script
/// `replay` that does so and compares the histories byte by byte. The run itself is not changed, and may still be
/// running. Returns a message for the user: what is in the bundle, and what of the case could not be included. Throws
/// InputError where `directory` holds no run that can be replayed or `bundle` exists already, and FileError; then
/// nothing has been written.
std::string report_run(const std::string& directory, const std::string& bundle);

/// Default folder of the bundle of the run in `directory`: beside it.
std::string report_directory(const std::string& directory);

}  // namespace vug
