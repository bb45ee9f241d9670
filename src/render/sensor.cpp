#include "render/sensor.h"

#include <algorithm>
#include <cmath>

#include "render/jpeg_damage.h"
#include "render/maths.h"
#include "render/rng.h"

namespace runmark::render {

std::vector<std::uint8_t> expose(const Plane& picture, const Sensor& sensor) {
  std::vector<std::uint8_t> grey(picture.values.size());
  // Deviation and tone curve by tables: one entry for each 1/16 of a grey level.
  constexpr int levels = 4096;
  std::vector<float> deviation(levels);
  std::vector<float> tone(levels + 1);
  for (int i = 0; i < levels; ++i) {
    const double level = i / 16.0;
    deviation[static_cast<std::size_t>(i)] =
        static_cast<float>(sensor.noise * std::sqrt(0.5 + 0.5 * level / 128));
  }
  for (int i = 0; i <= levels; ++i) {
    const double level = i / 16.0 / 255;
    tone[static_cast<std::size_t>(i)] =
        static_cast<float>(255 * (sensor.gamma == 1 ? level : power(level, 1 / sensor.gamma)));
  }
  Rng rng(sensor.seed);
  for (std::size_t i = 0; i < grey.size(); ++i) {
    float level = 255 * picture.values[i];
    if (sensor.noise > 0) {
      const int entry = std::clamp(static_cast<int>(16 * level), 0, levels - 1);
      level += deviation[static_cast<std::size_t>(entry)] * rng.normal();
    }
    if (sensor.gamma != 1) {
      const float place = std::clamp(16 * level, 0.0F, 4095.0F);
      const auto entry = static_cast<std::size_t>(place);
      level = tone[entry] + (tone[entry + 1] - tone[entry]) * (place - static_cast<float>(entry));
    }
    grey[i] = static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
  }
  if (sensor.jpeg > 0) damage_as_jpeg(grey, picture.width, picture.height, sensor.jpeg);
  return grey;
}

}  // namespace runmark::render
