#pragma once
// Long work on the command line: how far it is, and what Ctrl+C does to it.
#include <functional>
#include <string>

namespace vamp {

class Progress;

// From here on the first Ctrl+C (or SIGTERM) asks for a stop, and the second one ends the program at once.
void catch_interrupts();
// Whether a signal asked to stop.
bool interrupted();

// Draws `label` and the fraction done on stderr, where that is a terminal, while `work` runs on another thread; a
// request to stop cancels `progress`. Exceptions of `work` come out here.
void run_with_progress(const std::string& label, Progress& progress, const std::function<void()>& work);

}  // namespace vamp
