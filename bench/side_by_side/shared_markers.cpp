#include "bench/side_by_side/shared_markers.h"

#include <algorithm>

#include "evaluate/buckets.h"
#include "evaluate/matching.h"

namespace runmark::bench {

SharedMarkers shared_markers(const std::vector<TruthImage>& truth, const std::vector<Run>& runs) {
  SharedMarkers shared;
  shared.total.resize(runs.size());
  shared.by_size.assign(runs.size(), std::vector<CornerErrors>(size_buckets.count()));
  for (const TruthImage& image : truth) {
    std::vector<ImageMatch> matches;
    for (const Run& run : runs) matches.push_back(match(image, run.observations.at(image.image).markers));
    for (std::size_t i = 0; i < image.markers.size(); ++i) {
      const bool all =
          std::ranges::all_of(matches, [&](const ImageMatch& m) { return m.markers[i].found(); });
      if (!all || !image.markers[i].exact_corners) continue;
      ++shared.count;
      const std::size_t bucket = size_buckets.place(marker_size(image.markers[i].corners));
      for (std::size_t r = 0; r < runs.size(); ++r) {
        Tally one;
        one.add(image.markers[i], matches[r].markers[i]);
        shared.total[r].add(one.corners);
        shared.by_size[r][bucket].add(one.corners);
      }
    }
  }
  return shared;
}

}  // namespace runmark::bench
