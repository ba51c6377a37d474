#pragma once
// Fragments of rock that have been let go, for the log and for run.json.

namespace vug {

/// A module that may let fragments go.
class LetsFragmentsGo {
 public:
  virtual ~LetsFragmentsGo() = default;
  /// Number of triangles let go so far; waits for the device.
  virtual int fragments_let_go() const = 0;
};

}  // namespace vug
