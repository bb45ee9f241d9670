#pragma once

#include <apriltag/apriltag.h>

#include <optional>
#include <string>
#include <vector>

#include "runmark/dictionary.h"

namespace runmark::bench {

/// One of our dictionaries as a family AprilTag 3 can read: the same codes, with the bits in the order
/// its decoder needs, in which a quarter turn of the tag is a rotation of the word by a quarter.
class AprilTagFamily {
 public:
  /// None when the cells are not the same after a quarter turn, or the border is not one AprilTag knows.
  [[nodiscard]] static std::optional<AprilTagFamily> make(const Dictionary& dictionary);

  /// Points into this object, which must stay where it is from now on.
  [[nodiscard]] apriltag_family_t* family();

 private:
  AprilTagFamily() = default;
  std::string name_;
  std::vector<std::uint64_t> codes_;
  std::vector<std::uint32_t> x_;
  std::vector<std::uint32_t> y_;
  apriltag_family_t family_{};
};

}  // namespace runmark::bench
