#include <algorithm>
#include <array>

#include "bench/peers/apriltag_reader.h"
#include "bench/peers/opencv_reader.h"
#include "bench/peers/reader.h"
#include "bench/peers/runmark_reader.h"

namespace runmark::bench {
namespace {

constexpr std::array all{
    Contender{"runmark", make_runmark_reader},
    Contender{"opencv", [](const Task& task) { return make_opencv_reader(task, Refinement::none); }},
    Contender{"opencv-subpix",
              [](const Task& task) { return make_opencv_reader(task, Refinement::sub_pixel); }},
    Contender{"apriltag-1", [](const Task& task) { return make_apriltag_reader(task, 1); }},
    Contender{"apriltag-2", [](const Task& task) { return make_apriltag_reader(task, 2); }},
};

}  // namespace

std::span<const Contender> contenders() { return all; }

const Contender* find_contender(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Contender::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace runmark::bench
