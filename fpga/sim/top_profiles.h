#pragma once

#include <gtest/gtest.h>

#include <string>

#include "Vrunmark_top.h"
#include "Vrunmark_top_4k.h"
#include "Vrunmark_top_hardware.h"
#include "Vrunmark_top_hardware_4k.h"
#include "Vrunmark_top_hardware_small.h"
#include "Vrunmark_top_small.h"
#include "top_station.h"

namespace runmark::rtl {

/// The paper profile with its buses: 640x480, 3840x2160, and so small that everything runs out.
struct PaperProfile {
  static constexpr const char* name = "Paper";
  static constexpr Pipeline pipeline = Pipeline::paper;
  static constexpr int least_width = 3;
  using Vga = TopBench<Vrunmark_top>;
  using Large = TopBench<Vrunmark_top_4k>;
  using Small = TopBench<Vrunmark_top_small>;
  static constexpr std::size_t vga_records = 1023;
  static constexpr std::size_t large_records = 4095;
  static constexpr std::size_t small_records = 40;
  /// Of `runmark render --set vga`, some with markers upright enough for the paper's cores; of `fullhd` one.
  static constexpr std::array rendered{21, 33, 62, 81, 106};
  static constexpr int rendered_large = 12;
  static constexpr double clocks_a_pixel = 1.02;
};

/// The hardware profile, alike.
struct HardwareProfile {
  static constexpr const char* name = "Hardware";
  static constexpr Pipeline pipeline = Pipeline::hardware;
  static constexpr int least_width = 16;
  using Vga = TopBench<Vrunmark_top_hardware>;
  using Large = TopBench<Vrunmark_top_hardware_4k>;
  using Small = TopBench<Vrunmark_top_hardware_small>;
  static constexpr std::size_t vga_records = 2047;
  static constexpr std::size_t large_records = 8191;
  static constexpr std::size_t small_records = 60;
  static constexpr std::array rendered{1, 2, 6, 10};
  static constexpr int rendered_large = 12;
  static constexpr double clocks_a_pixel = 1.05;  // eight rows are sent after the last one has come in
};

/// Tests of `runmark_top` that hold for both.
template <class Profile>
class RtlTop : public ::testing::Test {
 protected:
  static Options options(int width, int height) { return options_of(Profile::pipeline, width, height); }
  static const Dictionary& dictionary() {
    static const Dictionary it = *builtin_dictionary("DICT_6X6_250");
    return it;
  }
  /// Nearly every quad is taken for a marker of it.
  static const Dictionary& lax() {
    static const Dictionary it = made_lax(dictionary());
    return it;
  }
};

struct ProfileName {
  template <class Profile>
  static std::string GetName(int /*number*/) {
    return Profile::name;
  }
};
using Profiles = testing::Types<PaperProfile, HardwareProfile>;

}  // namespace runmark::rtl
