#pragma once

namespace runmark::cli {

/// From now on Ctrl-C (and SIGTERM, SIGHUP) only sets a flag, so that the work in hand is finished and files
/// are closed; a second one ends the program at once.
void catch_interrupts();

[[nodiscard]] bool interrupted();

/// Waits until there is something to read, or the file's end. False: Ctrl-C or `stop_waiting` came first.
[[nodiscard]] bool wait_for_input(int file);

/// Ends every `wait_for_input`, now and later; from any thread.
void stop_waiting();

}  // namespace runmark::cli
