// Poses of single markers against the exact ones of rendered scenes, beside OpenCV's and AprilTag's, as CSV:
//   runmark-pose [SCENES]     so many scenes a size; 200 without it
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "bench/pose/methods.h"
#include "render/posed_marker.h"
#include "support/posed_scene.h"

namespace runmark::bench {
namespace {

struct Error {
  double degrees;
  double percent;  // of the distance
};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void run(int scenes) {
  std::vector<std::unique_ptr<PoseMethod>> methods;
  methods.push_back(runmark_pose());
  methods.push_back(opencv_pose());
  methods.push_back(apriltag_pose());
  const Dictionary dictionary = *builtin_dictionary("tag36h11");
  std::printf(
      "size,method,scenes,found,shared,turn median,turn 90 %%,distance median,distance 90 %%,flips\n");
  render::Rng rng(42);
  for (const auto& [smallest, largest] : {std::pair{16, 32}, {32, 64}, {64, 128}, {128, 256}}) {
    std::vector<int> found(methods.size());
    std::vector<std::vector<Error>> errors(methods.size());
    for (int i = 0; i < scenes; ++i) {
      const render::Scene scene = render::posed_marker(
          dictionary, {.smallest = static_cast<double>(smallest), .largest = static_cast<double>(largest)},
          rng);
      render::RenderedFrame frame = render::render(scene);
      const cv::Mat grey(frame.height, frame.width, CV_8U, frame.grey.data());
      const render::PlanePose& plane = scene.surfaces[1].pose;
      const double width = dictionary.width;
      const Pose truth = test::pose_of(plane, width / 2, width / 2);
      std::vector<Error> of_scene;
      for (std::size_t m = 0; m < methods.size(); ++m) {
        const auto pose = methods[m]->find(grey, scene.markers[0].id, width * test::unit_of(plane),
                                           test::camera_of(scene.camera));
        if (!pose) continue;
        ++found[m];
        of_scene.push_back({test::turn_between(*pose, truth) * 180 / std::numbers::pi,
                            100 * test::distance_between(*pose, truth) / truth.translation.z});
      }
      if (of_scene.size() < methods.size()) continue;
      for (std::size_t m = 0; m < methods.size(); ++m) errors[m].push_back(of_scene[m]);
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      std::vector<double> turns;
      std::vector<double> distances;
      int flips = 0;
      for (const Error& e : errors[m]) {
        turns.push_back(e.degrees);
        distances.push_back(e.percent);
        flips += e.degrees > 15 ? 1 : 0;
      }
      std::printf("%d-%d,%s,%d,%d,%zu,%.3f,%.3f,%.4f,%.4f,%d\n", smallest, largest,
                  std::string(methods[m]->name()).c_str(), scenes, found[m], errors[m].size(),
                  quantile(turns, 0.5), quantile(turns, 0.9), quantile(distances, 0.5),
                  quantile(distances, 0.9), flips);
    }
  }
  for (const auto& method : methods) {
    std::printf("time,%s,%.1f\n", std::string(method->name()).c_str(), method->microseconds());
  }
}

}  // namespace
}  // namespace runmark::bench

int main(int argc, char** argv) {
  const int scenes = argc > 1 ? std::atoi(argv[1]) : 200;
  if (argc > 2 || scenes < 1) {
    std::fprintf(stderr, "runmark-pose: usage: runmark-pose [SCENES]\n");
    return 2;
  }
  runmark::bench::run(scenes);
}
