#pragma once

#include "bench/peers/reader.h"

namespace runmark::bench {

/// Debian's AprilTag 3, with families made from our dictionaries. It corrects up to two bits, as stock,
/// but no more than OpenCV does. White-on-black markers are read from the negative.
/// @param decimate  how many times smaller the image is in which quadrilaterals are looked for
[[nodiscard]] std::unique_ptr<Reader> make_apriltag_reader(const Task& task, float decimate);

}  // namespace runmark::bench
