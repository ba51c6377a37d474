#pragma once
// `vug report`: a bundle with which somebody else sees what happened in a run.
#include <string>

namespace vug {

/// Writes the new folder `bundle`: the case with the files that it names, the run's record and history, the checkpoint
/// from which its last stretch can be run again (the newest sound one before the step that it had reached), and a
/// script `replay` that does so and compares the histories byte by byte. The run itself is left as it is, and may be
/// under way. Gives what to tell the user: what is in the bundle, and what of the case could not be taken along. Throws
/// InputError where `directory` holds no run that can be replayed or `bundle` is there already, and FileError; then
/// nothing has been written.
std::string report_run(const std::string& directory, const std::string& bundle);

/// Where the bundle of the run in `directory` goes unless told otherwise: beside it.
std::string report_directory(const std::string& directory);

}  // namespace vug
