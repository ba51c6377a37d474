#pragma once
// Time that the work of this process takes.

namespace vug {

/// Time of the work so far, from an arbitrary start, s, after all launched kernels have ended. On a host it is the
/// processor time of all threads together, which other work on the machine increases less than the wall time. Where a
/// GPU does the work it is wall time: nothing else measures a GPU.
double work_seconds();

}  // namespace vug
