// Threads of a library that is a guest in its process.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <thread>

namespace ups::platform {

// Processors that this process may run on.
int processor_count();

// Other in the child of a fork().
int64_t process_id();

// A thread that debuggers and monitors show by its name, which takes no signals but those of faults: they are its own,
// and the host's crash handler wants to see them. Throws std::system_error where it cannot start.
std::thread start_thread(const std::string& name, std::function<void()> body);

// The calling thread, and those that start_thread() starts on it from now on, run when nothing else wants the
// processor. On Linux there is no way back without privileges.
void lower_priority();

}  // namespace ups::platform
