#pragma once

namespace CLI {
class App;
}

namespace runmark::cli {

/// `runmark render`: scenes with exact truth, as pictures or as a video.
void add_render_command(CLI::App& app);

}  // namespace runmark::cli
