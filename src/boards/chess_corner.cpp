#include "boards/chess_corner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "boards/crossing_shape.h"
#include "pose/damped_step.h"

namespace runmark {
namespace {

/// Grey level = mean + slope . (p - place) + contrast * shape(u, v), where u and v are the distances from the
/// two edges and the shape is the product of two steps from -1 to 1, blurred by `width`, with the drawings.
struct Crossing {
  static constexpr int parameters = 9;
  Point place;
  double angle_u = 0;  // of the normal of the upright edge, towards the right
  double angle_v = 0;  // of the level edge, downwards
  double width = 1;
  double mean = 0;
  Point slope;
  double contrast = 0;

  void move(const cv::Vec<double, parameters>& step) {
    place.x += step[0];
    place.y += step[1];
    angle_u += step[2];
    angle_v += step[3];
    width = std::clamp(width + step[4], 0.25, 20.0);
    mean += step[5];
    slope.x += step[6];
    slope.y += step[7];
    contrast += step[8];
  }
};

struct Pixel {
  double x;
  double y;
  double level;
};

struct Linearised {
  cv::Matx<double, Crossing::parameters, Crossing::parameters> information;
  cv::Vec<double, Crossing::parameters> gradient;
  double square_error = 0;
};

Linearised linearise(const std::vector<Pixel>& pixels, const Crossing& c, const CrossingDrawings& drawings) {
  constexpr int n = Crossing::parameters;
  constexpr int row = n + 1;  // even, so that the compiler takes two columns at a time
  const Point nu{std::cos(c.angle_u), std::sin(c.angle_u)};
  const Point nv{std::cos(c.angle_v), std::sin(c.angle_v)};
  double information[n][row]{};  // its last column is the gradient
  double square_error = 0;
  for (const Pixel& pixel : pixels) {
    const double dx = pixel.x - c.place.x;
    const double dy = pixel.y - c.place.y;
    const CrossingShape shape =
        shape_of_crossing(nu.x * dx + nu.y * dy, nv.x * dx + nv.y * dy, c.width, drawings);
    const double by_u = c.contrast * shape.by_u;
    const double by_v = c.contrast * shape.by_v;
    const double offset = pixel.level - (c.mean + c.slope.x * dx + c.slope.y * dy + c.contrast * shape.value);
    const double by[row]{-by_u * nu.x - by_v * nv.x - c.slope.x,
                         -by_u * nu.y - by_v * nv.y - c.slope.y,
                         by_u * (-nu.y * dx + nu.x * dy),
                         by_v * (-nv.y * dx + nv.x * dy),
                         c.contrast * shape.by_width,
                         1,
                         dx,
                         dy,
                         shape.value,
                         offset};
    square_error += offset * offset;
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < row; ++k) information[i][k] += by[i] * by[k];
    }
  }
  Linearised sums;
  sums.square_error = square_error;
  for (int i = 0; i < n; ++i) {
    sums.gradient[i] = information[i][n];
    for (int k = 0; k < n; ++k) sums.information(i, k) = information[i][k];
  }
  return sums;
}

double length_of(Point v) { return std::hypot(v.x, v.y); }

/// The pixels along the two edges; of the others only what lies before their drawing.
std::vector<Pixel> pixels_about(const GreySampler& grey, const CornerGuess& guess) {
  constexpr double farthest = 10;  // pixels along an edge
  constexpr double deepest = 3;    // pixels into a plain square
  const double det = guess.right.x * guess.down.y - guess.right.y * guess.down.x;
  const double side = std::min(length_of(guess.right), length_of(guess.down));
  const double reach = std::min(0.7, farthest / side);
  const double plain_depth = std::max(guess.margin, std::min(deepest / side, 0.5 * reach));
  const double wide_x = reach * (std::fabs(guess.right.x) + std::fabs(guess.down.x));
  const double wide_y = reach * (std::fabs(guess.right.y) + std::fabs(guess.down.y));
  std::vector<Pixel> pixels;
  const int x0 = std::max(static_cast<int>(std::ceil(guess.place.x - wide_x)), 0);
  const int x1 = std::min(static_cast<int>(guess.place.x + wide_x), grey.width() - 1);
  const int y0 = std::max(static_cast<int>(std::ceil(guess.place.y - wide_y)), 0);
  const int y1 = std::min(static_cast<int>(guess.place.y + wide_y), grey.height() - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const double dx = x - guess.place.x;
      const double dy = y - guess.place.y;
      const double a = (dx * guess.down.y - dy * guess.down.x) / det;    // squares to the right
      const double b = (guess.right.x * dy - guess.right.y * dx) / det;  // and downwards
      if (std::max(std::fabs(a), std::fabs(b)) > reach) continue;
      const bool plain = (a * b > 0) == guess.plain_first;
      if (std::min(std::fabs(a), std::fabs(b)) > (plain ? plain_depth : guess.margin)) continue;
      pixels.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(grey.at(x, y))});
    }
  }
  return pixels;
}

/// Of the contrast.
int sign_of(const CornerGuess& guess) { return guess.plain_first == guess.inverted ? 1 : -1; }

Crossing first_guess(const std::vector<Pixel>& pixels, const CornerGuess& guess) {
  Crossing c;
  c.place = guess.place;
  // Normals of the edges; the upright one runs along `down`.
  c.angle_u = std::atan2(-guess.down.x, guess.down.y);
  c.angle_v = std::atan2(guess.right.x, -guess.right.y);
  double sum = 0;
  double sum2 = 0;
  for (const Pixel& p : pixels) {
    sum += p.level;
    sum2 += p.level * p.level;
  }
  const auto n = static_cast<double>(pixels.size());
  c.mean = sum / n;
  c.contrast = std::sqrt(std::max(0.0, sum2 / n - c.mean * c.mean)) * sign_of(guess);
  return c;
}

double turn_between(double a, double b) { return std::fabs(std::remainder(a - b, 2 * std::numbers::pi)); }

}  // namespace

std::optional<ChessCorner> fit_chess_corner(const GreySampler& grey, const CornerGuess& guess) {
  constexpr int most_steps = 25;
  constexpr std::size_t least_pixels = 24;
  constexpr double least_contrast = 6;      // grey levels, half of white less black
  constexpr double most_unexplained = 0.2;  // of the variance
  constexpr double most_turn = 0.3;         // radians
  constexpr double of_model = 1.3;  // on rendered boards corners are off by so much more than by noise alone
  const std::vector<Pixel> pixels = pixels_about(grey, guess);
  if (pixels.size() < least_pixels) return {};
  const Crossing first = first_guess(pixels, guess);
  const double variance = first.contrast * first.contrast;
  if (variance < 1) return {};
  const double det = guess.right.x * guess.down.y - guess.right.y * guess.down.x;
  const CrossingDrawings drawings{guess.margin * det / length_of(guess.down),
                                  guess.margin * det / length_of(guess.right), !guess.plain_first};
  Crossing here = first;
  Linearised sums = linearise(pixels, here, drawings);
  double damping = 1e-3;
  for (int i = 0; i < most_steps && damping < 1e6; ++i) {
    cv::Vec<double, Crossing::parameters> step;
    if (!damped_step(sums.information, sums.gradient, damping, step)) return {};
    Crossing next = here;
    next.move(step);
    const Linearised there = linearise(pixels, next, drawings);
    if (!(there.square_error < sums.square_error)) {
      damping *= 10;
      continue;
    }
    here = next;
    sums = there;
    damping = std::max(damping / 10, 1e-9);
    if (std::fabs(step[0]) + std::fabs(step[1]) < 1e-4) break;
  }
  const auto n = static_cast<double>(pixels.size());
  const double side = std::min(length_of(guess.right), length_of(guess.down));
  const double moved = std::hypot(here.place.x - guess.place.x, here.place.y - guess.place.y);
  const bool good = here.contrast * sign_of(guess) > least_contrast &&
                    sums.square_error < most_unexplained * variance * n && moved < 0.3 * side &&
                    here.width < 0.4 * side && turn_between(here.angle_u, first.angle_u) < most_turn &&
                    turn_between(here.angle_v, first.angle_v) < most_turn;
  if (!good) return {};
  cv::Vec<double, Crossing::parameters> of_x;
  cv::Vec<double, Crossing::parameters> of_y;
  cv::Vec<double, Crossing::parameters> unit_x;
  cv::Vec<double, Crossing::parameters> unit_y;
  unit_x[0] = unit_y[1] = 1;
  if (!damped_step(sums.information, unit_x, 0, of_x) || !damped_step(sums.information, unit_y, 0, of_y))
    return {};
  const double noise2 = sums.square_error / (n - Crossing::parameters);
  const double deviation = std::sqrt(noise2 * (of_x[0] + of_y[1]) / 2);
  if (!std::isfinite(deviation)) return {};
  return ChessCorner{here.place, of_model * deviation};
}

}  // namespace runmark
