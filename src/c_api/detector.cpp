#include <optional>
#include <vector>

#include "c_api/guard.h"
#include "c_api/handles.h"
#include "c_api/image.h"
#include "c_api/options.h"

namespace {

using namespace runmark;
using namespace runmark::c_api;

runmark_status to_c(Status status) {
  switch (status) {
    case Status::ok:
      return RUNMARK_OK;
    case Status::bad_view:
      return RUNMARK_BAD_VIEW;
    case Status::frame_too_large:
      return RUNMARK_FRAME_TOO_LARGE;
    case Status::wrong_order:
      return RUNMARK_WRONG_ORDER;
  }
  return RUNMARK_FAILED;
}

/// Runs a call of the detector's on an image; a format there is not is a bad view.
template <class Call>
runmark_status with_image(runmark_detector* detector, const runmark_image* image, const Call& call) {
  if (detector == nullptr || image == nullptr) return RUNMARK_BAD_ARGUMENT;
  const auto view = to_view(*image);
  return view ? to_c(call(detector->value, *view)) : RUNMARK_BAD_VIEW;
}

void put(const std::array<Point, 4>& corners, double (*to)[2]) {
  for (std::size_t i = 0; i < 4; ++i) {
    to[i][0] = corners[i].x;
    to[i][1] = corners[i].y;
  }
}

}  // namespace

runmark_status runmark_detector_create(const runmark_options* options,
                                       runmark_dictionary* const* dictionaries, std::size_t count,
                                       runmark_detector** detector, runmark_error* error) {
  return guarded(error, [&] {
    if (options == nullptr || detector == nullptr || (dictionaries == nullptr && count > 0)) {
      return fail(error, RUNMARK_BAD_ARGUMENT);
    }
    *detector = nullptr;
    const Result<Options> o = to_options(*options);
    if (!o) return fail(error, RUNMARK_BAD_OPTIONS, o.error());
    std::vector<Dictionary> copies;
    for (std::size_t i = 0; i < count; ++i) {
      if (dictionaries[i] == nullptr) return fail(error, RUNMARK_BAD_ARGUMENT);
      copies.push_back(dictionaries[i]->value);
    }
    Result<Detector> made = Detector::create(*o, std::move(copies));
    if (!made) return fail(error, RUNMARK_BAD_OPTIONS, made.error());
    *detector = new runmark_detector{*std::move(made)};
    return RUNMARK_OK;
  });
}

void runmark_detector_free(runmark_detector* detector) { delete detector; }

std::size_t runmark_detector_memory(const runmark_detector* detector) {
  return detector == nullptr ? 0 : detector->value.memory();
}

runmark_status runmark_detect(runmark_detector* detector, const runmark_image* frame) {
  return with_image(detector, frame,
                    [](Detector& d, const ImageView& view) { return d.detect(view).status; });
}

runmark_status runmark_begin(runmark_detector* detector, std::int32_t width, std::int32_t height) {
  return detector == nullptr ? RUNMARK_BAD_ARGUMENT : to_c(detector->value.begin(width, height));
}

runmark_status runmark_push_rows(runmark_detector* detector, const runmark_image* rows) {
  return with_image(detector, rows, [](Detector& d, const ImageView& view) { return d.push_rows(view); });
}

runmark_status runmark_end(runmark_detector* detector) {
  return detector == nullptr ? RUNMARK_BAD_ARGUMENT : to_c(detector->value.end());
}

std::size_t runmark_marker_count(const runmark_detector* detector) {
  return detector == nullptr ? 0 : detector->value.markers().size();
}

runmark_status runmark_get_marker(const runmark_detector* detector, std::size_t index,
                                  runmark_marker* marker) {
  if (marker == nullptr || index >= runmark_marker_count(detector)) return RUNMARK_BAD_ARGUMENT;
  const Marker& m = detector->value.markers()[index];
  marker->dictionary = m.dictionary.data();  // all of a std::string, so it ends with a null
  marker->id = m.id;
  marker->hamming = m.hamming;
  put(m.corners, marker->corners);
  marker->margin = m.margin;
  marker->inverted = m.inverted ? 1 : 0;
  marker->row = m.row;
  return RUNMARK_OK;
}

std::size_t runmark_rejected_count(const runmark_detector* detector) {
  return detector == nullptr ? 0 : detector->value.rejected().size();
}

runmark_status runmark_get_rejected(const runmark_detector* detector, std::size_t index,
                                    double corners[4][2]) {
  if (corners == nullptr || index >= runmark_rejected_count(detector)) return RUNMARK_BAD_ARGUMENT;
  put(detector->value.rejected()[index], corners);
  return RUNMARK_OK;
}

runmark_status runmark_get_stats(const runmark_detector* detector, runmark_stats* stats) {
  if (detector == nullptr || stats == nullptr) return RUNMARK_BAD_ARGUMENT;
  const FrameStats& s = detector->value.stats();
  *stats = {s.pixels,       s.crack_runs,     s.closed_chains,  s.quads,
            s.records_peak, s.dropped_chains, s.dropped_markers};
  return RUNMARK_OK;
}
