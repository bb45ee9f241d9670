#pragma once

#include "bench/peers/reader.h"

namespace runmark::bench {

enum class Refinement : bool { none, sub_pixel };

/// Debian's OpenCV ArUco. Its own predefined dictionary where it has one of that name, else one made
/// from ours; dictionaries whose border is not black are passed over.
[[nodiscard]] std::unique_ptr<Reader> make_opencv_reader(const Task& task, Refinement refinement);

}  // namespace runmark::bench
