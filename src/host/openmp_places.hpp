#pragma once
// Processors of a process whose threads OpenMP binds.

namespace vug {

/// Lets this thread run on the processors of all places of OpenMP, of which it was bound to the first when the program
/// was loaded (OMP_PROC_BIND, OMP_PLACES): programs that it becomes or begins would see no other. Nothing where threads
/// are not bound.
void leave_openmp_place();

}  // namespace vug
