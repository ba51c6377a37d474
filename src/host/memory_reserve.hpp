#pragma once
// Memory for the end of a process that has run out of it: without any, C++ cannot even throw (it calls std::terminate
// where there is no room for an exception), and OpenMP ends the process with words of its own.

namespace vug {

/// Sets some memory aside, which the first operator new that fails gives back before it throws std::bad_alloc: the
/// error then finds room on its way. Where an exception finds none all the same, the process ends with exit code 5 and
/// one line. Returns false where there is not even the memory to be set aside. Called once, before anything else.
bool reserve_memory();

/// Throws std::bad_alloc unless as much more could be had as the libraries below take in passing. OpenMP takes a few
/// KiB with every parallel region of one thread.
void require_spare_memory();

/// Writes a line about too little memory to the standard error and ends the process with exit code 5; allocates
/// nothing.
[[noreturn]] void end_out_of_memory();

}  // namespace vug
