// Every code of every AprilTag family, read back by AprilTag's own detector.

#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagCircle49h12.h>
#include <apriltag/tagCustom48h12.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sheet.h"

namespace runmark {
namespace {

struct Family {
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};

const Family families[] = {
    {"tag16h5", tag16h5_create, tag16h5_destroy},
    {"tag25h9", tag25h9_create, tag25h9_destroy},
    {"tag36h10", tag36h10_create, tag36h10_destroy},
    {"tag36h11", tag36h11_create, tag36h11_destroy},
    {"tagCircle21h7", tagCircle21h7_create, tagCircle21h7_destroy},
    {"tagCircle49h12", tagCircle49h12_create, tagCircle49h12_destroy},
    {"tagCustom48h12", tagCustom48h12_create, tagCustom48h12_destroy},
    {"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    {"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy},
};

std::vector<Reading> read(const Sheet& sheet, apriltag_detector_t* detector) {
  image_u8_t picture{sheet.side, sheet.side, sheet.side, const_cast<std::uint8_t*>(sheet.grey.data())};
  zarray_t* const found = apriltag_detector_detect(detector, &picture);
  std::vector<Reading> readings;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found, i, &detection);
    Reading& reading = readings.emplace_back();
    reading.id = detection->id;
    // From bottom-left counter-clockwise, and half a pixel off.
    for (std::size_t c = 0; c < 4; ++c) {
      reading.corners[c] = {detection->p[3 - c][0] - 0.5, detection->p[3 - c][1] - 0.5};
    }
  }
  apriltag_detections_destroy(found);
  return readings;
}

class EveryCodeAprilTag : public testing::TestWithParam<Family> {};

TEST_P(EveryCodeAprilTag, IsRead) {
  const auto dictionary = builtin_dictionary(GetParam().name);
  ASSERT_TRUE(dictionary) << dictionary.error();
  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family(GetParam().create(),
                                                                                GetParam().destroy);
  ASSERT_EQ(family->ncodes, dictionary->codes.size());
  const std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector(
      apriltag_detector_create(), apriltag_detector_destroy);
  detector->quad_decimate = 1;
  apriltag_detector_add_family_bits(detector.get(), family.get(), 0);
  for (std::size_t first = 0; first < dictionary->codes.size();) {
    const Sheet sheet = draw_sheet(*dictionary, first, 4, 1);
    EXPECT_EQ(mistakes(sheet, read(sheet, detector.get()), *dictionary, 1), std::vector<std::string>{});
    first += sheet.markers.size();
    if (one_sheet_only) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryCodeAprilTag, testing::ValuesIn(families),
                         [](const auto& param) { return std::string(param.param.name); });

}  // namespace
}  // namespace runmark
