#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "render/maths.h"
#include "render/placement.h"
#include "render/scene.h"
#include "render/standard_sets.h"
#include "render/truth_json.h"
#include "runmark/dictionary.h"
#include "runmark/marker_grid.h"

namespace runmark::render {
namespace {

Dictionary tag36h11() { return *builtin_dictionary("tag36h11"); }

// One marker, black 0 and white 1, on white paper with a margin of four cells.
Scene one_marker(Stance stance, double size, double distortion = 0) {
  const Dictionary dictionary = tag36h11();
  Scene scene;
  scene.dictionary = dictionary.name;
  scene.camera = {400, 400, 500, distortion};
  scene.light.level = 230.0 / 255;
  Surface surface;
  surface.texture = MarkerPrint{marker_grid(dictionary, 3), 0, 1, false};
  surface.extent = {-4, -4, 12, 12};
  surface.pose = stand_to_size(scene.camera, stance, size, {0, 0, 8, 8});
  scene.surfaces = {surface};
  scene.markers = {{0, 3, 8}};
  return scene;
}

struct Line {
  Point on;
  Point normal;
};

// The border between the outer ring and the paper, measured from grey levels alone: across the side, the
// sum of (1 - level / white) over a strip is the length that is black. Fits a line to many such strips.
Line measure_side(const RenderedFrame& frame, Point a, Point b, double white, double cell) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const Point along{(b.x - a.x) / length, (b.y - a.y) / length};
  const Point inward{-along.y, along.x};
  const auto level = [&](double x, double y) {
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0;
    const double fy = y - y0;
    const auto at = [&](int i, int j) {
      return static_cast<double>(frame.grey[static_cast<std::size_t>(j * frame.width + i)]);
    };
    return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x0 + 1, y0)) +
           fy * ((1 - fx) * at(x0, y0 + 1) + fx * at(x0 + 1, y0 + 1));
  };
  const double reach = 0.6 * cell;
  double n = 0;
  double st = 0;
  double sd = 0;
  double stt = 0;
  double std_ = 0;
  for (double t = 0.15; t <= 0.85; t += 0.001) {
    double black = 0;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i) {
      const double s = reach * (2 * (i + 0.5) / steps - 1);
      black +=
          (1 - level(a.x + t * length * along.x + s * inward.x, a.y + t * length * along.y + s * inward.y) /
                   white) *
          2 * reach / steps;
    }
    const double d = reach - black;  // the edge's distance inward from the line a-b
    n += 1;
    st += t;
    sd += d;
    stt += t * t;
    std_ += t * d;
  }
  const double slope = (n * std_ - st * sd) / (n * stt - st * st);
  const double start = (sd - slope * st) / n;
  const Point first{a.x + start * inward.x, a.y + start * inward.y};
  const Point last{b.x + (start + slope) * inward.x, b.y + (start + slope) * inward.y};
  return {first, {-(last.y - first.y), last.x - first.x}};
}

Point meet(const Line& p, const Line& q) {
  const double c = p.normal.x * p.on.x + p.normal.y * p.on.y;
  const double d = q.normal.x * q.on.x + q.normal.y * q.on.y;
  const double det = p.normal.x * q.normal.y - p.normal.y * q.normal.x;
  return {(c * q.normal.y - d * p.normal.y) / det, (p.normal.x * d - q.normal.x * c) / det};
}

double worst_corner(const Scene& scene) {
  const RenderedFrame frame = render(scene);
  const MarkerTruth& truth = frame.truth.markers.at(0);
  constexpr double white = 230;
  std::array<Line, 4> sides;
  for (std::size_t i = 0; i < 4; ++i) {
    sides[i] = measure_side(frame, truth.corners[i], truth.corners[(i + 1) % 4], white, truth.cell);
  }
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = meet(sides[(i + 3) % 4], sides[i]);
    worst = std::max(worst, std::hypot(p.x - truth.corners[i].x, p.y - truth.corners[i].y));
  }
  return worst;
}

TEST(RenderScene, CornersAreWhereTheTruthSays) {
  // Upright at places between the pixels, where a plain 8 x 8 grid of samples would be 1/16 pixel off.
  for (const double shift : {0.0, 0.03, 0.06, 0.25, 0.41}) {
    EXPECT_LT(worst_corner(one_marker({{200 + shift, 200 - shift}, 10}, 160)), 0.02) << shift;
  }
  for (const double spin : {5.0, 20.0, 45.0}) {
    EXPECT_LT(worst_corner(one_marker({{190, 210}, 10, 0, 0, radians(spin)}, 150)), 0.02) << spin;
  }
  for (const double tilt : {30.0, 60.0}) {
    EXPECT_LT(worst_corner(one_marker({{190, 205}, 10, radians(tilt), 0.7, 0.3}, 150)), 0.02) << tilt;
  }
}

TEST(RenderScene, BlurMovesNoCorner) {
  Scene scene = one_marker({{200.3, 199.6}, 10, radians(20), 0.7, 0.3}, 170);
  scene.optics.blur = 1.5;
  EXPECT_LT(worst_corner(scene), 0.02);
  scene.optics.defocus = Optics::Defocus::disc;
  EXPECT_LT(worst_corner(scene), 0.02);
  scene.optics.motion = 3;
  scene.optics.motion_direction = 0.5;
  EXPECT_LT(worst_corner(scene), 0.02);
}

TEST(RenderScene, TiltAndSizeAreAsAskedFor) {
  for (const double tilt : {0.0, 33.0, 65.0, 70.0}) {
    const FrameTruth truth = truth_of(one_marker({{250, 120}, 10, radians(tilt), 2, 1}, 80));
    EXPECT_NEAR(truth.markers.at(0).tilt, tilt, 1e-5);
    EXPECT_NEAR(truth.markers.at(0).size, 80, 0.1);
    EXPECT_GT(area(truth.markers.at(0).corners), 0) << "corners must run clockwise";
  }
}

TEST(RenderScene, LensBendsBothWays) {
  for (const double distortion : {-0.3, -0.05, 0.1}) {
    const Camera camera{640, 480, 500, distortion};
    for (const Point p : {Point{3, 4}, Point{320, 470}, Point{600, 20}}) {
      const Point q = camera.distort(camera.undistort(p));
      EXPECT_NEAR(q.x, p.x, 1e-9);
      EXPECT_NEAR(q.y, p.y, 1e-9);
    }
  }
}

TEST(RenderScene, SamePictureOnEveryMachine) {
  const StandardSet* set = find_standard_set("vga");
  ASSERT_NE(set, nullptr);
  const auto picture = [&](int index) {
    return render(make_scene(set->recipe, tag36h11(), set_seed("vga", 0), index)).grey;
  };
  const auto sum = [](const std::vector<std::uint8_t>& grey) {
    return hash({reinterpret_cast<const char*>(grey.data()), grey.size()});
  };
  EXPECT_EQ(picture(7), picture(7));
  EXPECT_NE(picture(7), picture(8));
  // Changes only when the renderer does: say so in the changelog, figures of before do not compare.
  EXPECT_EQ(sum(picture(1)), 15895505330788936541U);
}

}  // namespace
}  // namespace runmark::render
