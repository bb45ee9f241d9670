#pragma once

namespace runmark::cli {

/// From now on Ctrl-C (and SIGTERM) only sets a flag, so that the work in hand is finished and files
/// are closed; a second one ends the program at once.
void catch_interrupts();

[[nodiscard]] bool interrupted();

}  // namespace runmark::cli
