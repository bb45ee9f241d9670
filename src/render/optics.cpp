#include "render/optics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "render/maths.h"

namespace runmark::render {

namespace {

struct Tap {
  int dx;
  int dy;
  float weight;
};

// One tap after the other over whole rows: plain loops the compiler turns into SIMD.
Plane convolve(const Plane& in, const std::vector<Tap>& taps) {
  Plane out(in.width, in.height);
  int reach = 0;
  for (const Tap& tap : taps) reach = std::max(reach, std::abs(tap.dx));
  const auto padded_width = static_cast<std::size_t>(in.width + 2 * reach);
  Plane padded(static_cast<int>(padded_width), in.height);
  for (int y = 0; y < in.height; ++y) {
    const float* from = in.row(y);
    float* to = padded.row(y);
    std::fill_n(to, reach, from[0]);
    std::copy_n(from, in.width, to + reach);
    std::fill_n(to + reach + in.width, reach, from[in.width - 1]);
  }
  for (int y = 0; y < in.height; ++y) {
    float* to = out.row(y);
    for (const Tap& tap : taps) {
      const float* from = padded.row(std::clamp(y + tap.dy, 0, in.height - 1)) + reach + tap.dx;
      const float weight = tap.weight;
      for (int x = 0; x < in.width; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

void normalise(std::vector<Tap>& taps) {
  float sum = 0;
  for (const Tap& tap : taps) sum += tap.weight;
  for (Tap& tap : taps) tap.weight /= sum;
}

std::vector<Tap> gaussian(double sigma, bool upright) {
  const int reach = static_cast<int>(std::ceil(3.5 * sigma));
  std::vector<Tap> taps;
  for (int i = -reach; i <= reach; ++i) {
    const double t = i / sigma;
    taps.push_back({upright ? 0 : i, upright ? i : 0, static_cast<float>(exponential(-t * t / 2))});
  }
  normalise(taps);
  return taps;
}

// Each pixel's share of the disc, by 8 x 8 samples.
std::vector<Tap> disc(double radius) {
  const int reach = static_cast<int>(std::ceil(radius));
  std::vector<Tap> taps;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      int count = 0;
      for (int j = 0; j < 8; ++j) {
        for (int i = 0; i < 8; ++i) {
          const double dx = x + (i + 0.5) / 8 - 0.5;
          const double dy = y + (j + 0.5) / 8 - 0.5;
          if (dx * dx + dy * dy <= radius * radius) ++count;
        }
      }
      if (count > 0) taps.push_back({x, y, static_cast<float>(count)});
    }
  }
  normalise(taps);
  return taps;
}

// A straight path, each of its points shared out among the four pixels round it.
std::vector<Tap> path(double length, double direction) {
  const double ux = cosine(direction);
  const double uy = sine(direction);
  const int reach = static_cast<int>(std::ceil(length / 2)) + 1;
  const int side = 2 * reach + 1;
  Plane weights(side, side);
  const int points = 1 + 8 * static_cast<int>(std::ceil(length));
  for (int i = 0; i < points; ++i) {
    const double t = points == 1 ? 0 : length * (static_cast<double>(i) / (points - 1) - 0.5);
    const double x = t * ux + reach;
    const double y = t * uy + reach;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const auto fx = static_cast<float>(x - x0);
    const auto fy = static_cast<float>(y - y0);
    weights.row(y0)[x0] += (1 - fx) * (1 - fy);
    weights.row(y0)[x0 + 1] += fx * (1 - fy);
    weights.row(y0 + 1)[x0] += (1 - fx) * fy;
    weights.row(y0 + 1)[x0 + 1] += fx * fy;
  }
  std::vector<Tap> taps;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      if (weights.row(y)[x] > 0) taps.push_back({x - reach, y - reach, weights.row(y)[x]});
    }
  }
  normalise(taps);
  return taps;
}

}  // namespace

void blur(Plane& picture, const Optics& optics) {
  if (optics.blur > 0.05) {
    if (optics.defocus == Optics::Defocus::disc) {
      picture = convolve(picture, disc(2 * optics.blur));
    } else {
      picture = convolve(convolve(picture, gaussian(optics.blur, false)), gaussian(optics.blur, true));
    }
  }
  if (optics.motion > 0.05) picture = convolve(picture, path(optics.motion, optics.motion_direction));
}

}  // namespace runmark::render
