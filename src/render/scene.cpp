#include "render/scene.h"

#include <algorithm>
#include <cmath>

#include "render/maths.h"
#include "render/placement.h"
#include "render/rasterise.h"

namespace runmark::render {

namespace {

// Degrees between the plane's normal and the line of sight to its point (u, v). The tangent by half angles:
// the arc tangent is summed as a series, since the C library's differs between machines.
double tilt_of(const PlanePose& pose, double u, double v) {
  const Vec3 normal = unit(cross(pose.along_u, pose.along_v));
  const double c = std::min(1.0, std::abs(dot(normal, unit(pose.at(u, v)))));
  double t = std::sqrt((1 - c) / (1 + c));
  int doublings = 1;
  for (int i = 0; i < 3; ++i) {
    t = t / (1 + std::sqrt(1 + t * t));
    ++doublings;
  }
  double sum = 0;
  double term = t;
  for (int n = 1; n <= 21; n += 2) {
    sum += term / n;
    term *= -t * t;
  }
  return std::ldexp(sum, doublings) * 180 / pi;
}

// Whether the camera sees any of the marker's square: a moving one may have left it behind.
bool in_picture(const Scene& scene, const PlacedMarker& marker) {
  const PlanePose& pose = scene.surfaces[marker.surface].pose;
  const double width = marker.width;
  for (const double u : {0.0, width}) {
    for (const double v : {0.0, width}) {
      if (pose.at(u, v).z <= 0) return false;
    }
  }
  const double right = scene.camera.width - 1;
  const double bottom = scene.camera.height - 1;
  return overlap(scene.camera.picture(pose, {0, 0, width, width}),
                 {Point{0, 0}, {right, 0}, {right, bottom}, {0, bottom}});
}

// The picture of all of a marker's cells, those outside the square included.
Quad cells_of(const Scene& scene, const PlacedMarker& marker) {
  const Surface& surface = scene.surfaces[marker.surface];
  const MarkerGrid& grid = std::get<MarkerPrint>(surface.texture).grid;
  const double low = grid.first + 1e-6;
  const double high = grid.first + grid.side - 1e-6;
  return scene.camera.picture(surface.pose, {low, low, high, high});
}

// Whether a later surface lies over any of the marker's cells.
bool is_covered(const Scene& scene, const PlacedMarker& marker) {
  const Quad cells = cells_of(scene, marker);
  const auto later = scene.surfaces.begin() + static_cast<std::ptrdiff_t>(marker.surface) + 1;
  return std::any_of(later, scene.surfaces.end(), [&](const Surface& s) {
    return overlap(cells, scene.camera.picture(s.pose, s.extent));
  });
}

MarkerTruth marker_truth(const Scene& scene, const PlacedMarker& marker) {
  const Surface& surface = scene.surfaces[marker.surface];
  const auto& print = std::get<MarkerPrint>(surface.texture);
  const double width = marker.width;
  MarkerTruth t;
  t.id = marker.id;
  t.corners = scene.camera.picture(surface.pose, {0, 0, width, width});
  double shortest = 1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point a = t.corners[i];
    const Point b = t.corners[(i + 1) % 4];
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    t.side += length / 4;
    shortest = std::min(shortest, length);
  }
  t.size = std::sqrt(std::abs(area(t.corners)));
  t.cell = shortest / width;
  t.tilt = tilt_of(surface.pose, width / 2, width / 2);
  const Vec3 centre = surface.pose.at(width / 2, width / 2);
  t.distance = std::sqrt(dot(centre, centre) / dot(surface.pose.along_u, surface.pose.along_u)) / width;
  t.margin = print.grid.first - surface.extent.left;
  const Point middle = scene.camera.picture(surface.pose, width / 2, width / 2);
  t.contrast = 255 * static_cast<double>((print.white - print.black) * surface.shade) *
               scene.light.at(middle, scene.camera.width, scene.camera.height);
  t.cut = !within(cells_of(scene, marker), scene.camera.width, scene.camera.height, 1);
  t.occluded = is_covered(scene, marker);
  return t;
}

}  // namespace

FrameTruth truth_of(const Scene& scene) {
  FrameTruth t;
  t.width = scene.camera.width;
  t.height = scene.camera.height;
  t.dictionary = scene.dictionary;
  t.inverted = scene.inverted;
  for (const PlacedMarker& marker : scene.markers) {
    if (in_picture(scene, marker)) t.markers.push_back(marker_truth(scene, marker));
  }
  t.background = scene.background;
  t.blur = scene.optics.blur;
  t.defocus = scene.optics.defocus == Optics::Defocus::disc ? "disc" : "gaussian";
  t.motion = scene.optics.motion;
  t.noise = scene.sensor.noise;
  t.gamma = scene.sensor.gamma;
  t.jpeg = scene.sensor.jpeg;
  t.distortion = scene.camera.distortion;
  t.level = scene.light.level;
  t.gradient = std::abs(scene.light.slope_x) + std::abs(scene.light.slope_y);
  t.vignette = scene.light.vignette;
  t.shadows = static_cast<int>(scene.light.shadows.size());
  t.lamps = static_cast<int>(scene.light.lamps.size());
  return t;
}

RenderedFrame render(const Scene& scene) {
  Plane picture(scene.camera.width, scene.camera.height, 0.3F);
  for (const Surface& surface : scene.surfaces) paint(picture, scene.camera, surface);
  shine(picture, scene.light);
  blur(picture, scene.optics);
  return {scene.camera.width, scene.camera.height, expose(picture, scene.sensor), truth_of(scene)};
}

}  // namespace runmark::render
