#include <algorithm>
#include <cmath>

#include "render/background.h"
#include "render/draw_light.h"
#include "render/maths.h"
#include "render/placement.h"
#include "render/recipe.h"
#include "runmark/marker_grid.h"

namespace runmark::render {

double Range::draw(Rng& rng) const {
  const double t = rng.uniform();
  return low + (high - low) * (skew == 1 ? t : power(t, skew));
}

namespace {

// A whole number with that mean.
int count_of(double mean, Rng& rng) {
  const double whole = std::floor(mean);
  return static_cast<int>(whole) + (rng.chance(mean - whole) ? 1 : 0);
}

enum class Place : std::uint8_t { inside, cut };

class MarkerPlacer {
 public:
  MarkerPlacer(Scene& scene, const Recipe& recipe, const Dictionary& dictionary, Rng& rng)
      : scene_(scene), recipe_(recipe), dictionary_(dictionary), rng_(rng) {}

  // False when no free place was found for it.
  bool add(double size, Place where) {
    const int tries = 300;
    const int id = next_id();
    Surface surface;
    surface.paper = true;
    surface.texture = print(id);
    const auto& grid = std::get<MarkerPrint>(surface.texture).grid;
    const double margin = recipe_.margin.draw(rng_);
    const double low = grid.first - margin;
    const double high = grid.first + grid.side + margin;
    surface.extent = {low, low, high, high};
    surface.shade = static_cast<float>(rng_.uniform(0.75, 1));
    const double width = dictionary_.width;
    const double first = grid.first;
    const Rectangle grid_extent{first, first, first + grid.side, first + grid.side};
    for (int i = 0; i < tries; ++i) {
      const Stance stance = any_stance(somewhere(size, where));
      surface.pose = stand_to_size(scene_.camera, stance, size, {0, 0, width, width});
      const Quad square = scene_.camera.picture(surface.pose, {0, 0, width, width});
      const Quad paper = scene_.camera.picture(surface.pose, surface.extent);
      if (std::abs(area(square) - size * size) > 0.02 * size * size || !taken_.is_free(paper)) continue;
      const Quad cells = scene_.camera.picture(surface.pose, grid_extent);
      const bool inside = within(cells, recipe_.width, recipe_.height, 2);
      if (inside != (where == Place::inside)) continue;
      taken_.take(paper);
      scene_.surfaces.push_back(surface);
      scene_.markers.push_back({scene_.surfaces.size() - 1, id, dictionary_.width});
      return true;
    }
    return false;
  }

  // A sheet of markers, or a chessboard with one in each white square, all of about that size.
  void add_board(double size) {
    const int columns = 3 + rng_.below(5);
    const int rows = 2 + rng_.below(5);
    const bool chess = rng_.chance(0.5);
    const double width = dictionary_.width;
    MarkerPrint first = print(next_id());
    // A pitch is the side of the marker, its outer cells and a margin.
    const double pitch = first.grid.side + (chess ? rng_.uniform(1.5, 4) : rng_.uniform(1, 6));
    const Rectangle board{0, 0, columns * pitch, rows * pitch};
    const double rim = pitch * rng_.uniform(0, 0.3);
    Surface paper;
    paper.paper = true;
    paper.extent = {-rim, -rim, board.right + rim, board.bottom + rim};
    paper.shade = static_cast<float>(rng_.uniform(0.75, 1));
    const float dark = recipe_.inverted ? first.white : first.black;
    const float light = recipe_.inverted ? first.black : first.white;
    if (chess) {
      paper.extent = board;
      paper.texture = Checker{dark, light, pitch, 0};
    } else {
      paper.texture = Gradient{light, light};
    }
    for (int i = 0; i < 100; ++i) {
      const Stance stance = any_stance({rng_.uniform(0, recipe_.width), rng_.uniform(0, recipe_.height)});
      paper.pose =
          stand_to_size(scene_.camera, stance, size / width * std::sqrt(board.right * board.bottom), board);
      const Quad quad = scene_.camera.picture(paper.pose, paper.extent);
      if (!within(quad, recipe_.width, recipe_.height, -0.3 * size)) continue;
      taken_.take(quad);
      scene_.surfaces.push_back(paper);
      for (int square = 0; square < rows * columns; ++square) {
        const int column = square % columns;
        const int row = square / columns;
        if (chess && ((column + row) & 1) != 0) continue;
        const int id = static_cast<int>((static_cast<std::size_t>(last_id_) + 1) % dictionary_.codes.size());
        last_id_ = id;
        first.grid = marker_grid(dictionary_, static_cast<std::size_t>(id));
        add_to_board(paper, first, id, (column + 0.5) * pitch, (row + 0.5) * pitch);
      }
      return;
    }
  }

  // Lays something over the border of the marker added last: a tape, a cable or a finger's width.
  void cover() {
    const PlacedMarker& marker = scene_.markers.back();
    const Surface& below = scene_.surfaces[marker.surface];
    const double width = marker.width;
    const double thick = width * rng_.uniform(0.06, 0.25);
    const double place = rng_.uniform(0.1, 0.9) * width;
    Surface over;
    over.pose = below.pose;
    over.extent = {place - thick, -width * 0.6, place + thick, width * rng_.uniform(0.12, 0.5)};
    // Turned by a quarter as often as the cover may come from each of the four sides.
    for (int turns = rng_.below(4); turns > 0; --turns) {
      const PlanePose pose = over.pose;
      over.pose.origin = pose.at(width, 0);
      over.pose.along_u = pose.along_v;
      over.pose.along_v = -1 * pose.along_u;
    }
    const auto shade = static_cast<float>(rng_.uniform(0.1, 0.95));
    over.texture = Noise{shade * 0.9F, shade, thick, 2, static_cast<std::uint32_t>(rng_.next())};
    scene_.surfaces.push_back(std::move(over));
  }

 private:
  int next_id() {
    if (scene_.markers.empty() || !rng_.chance(recipe_.repeated)) {
      last_id_ = rng_.below(static_cast<int>(dictionary_.codes.size()));
    }
    return last_id_;
  }

  void add_to_board(const Surface& paper, const MarkerPrint& marker, int id, double u, double v) {
    const double low = marker.grid.first;
    const double high = low + marker.grid.side;
    const double half = dictionary_.width / 2.0;
    Surface surface{paper.pose, {low, low, high, high}, marker, paper.shade, true};
    surface.pose.origin = paper.pose.at(u - half, v - half);
    const Quad cells = scene_.camera.picture(surface.pose, surface.extent);
    const double right = recipe_.width - 1;
    const double bottom = recipe_.height - 1;
    if (!overlap(cells, {Point{0, 0}, {right, 0}, {right, bottom}, {0, bottom}})) return;
    scene_.surfaces.push_back(std::move(surface));
    scene_.markers.push_back({scene_.surfaces.size() - 1, id, dictionary_.width});
  }

  Stance any_stance(Point place) {
    Stance stance;
    stance.place = place;
    stance.distance = rng_.uniform(6, 25);
    stance.tilt = radians(recipe_.tilt.draw(rng_));
    stance.azimuth = rng_.uniform(0, 2 * pi);
    stance.spin = rng_.chance(0.5) ? rng_.uniform(-0.35, 0.35) : rng_.uniform(0, 2 * pi);
    return stance;
  }

  MarkerPrint print(int id) {
    MarkerPrint p;
    p.grid = marker_grid(dictionary_, static_cast<std::size_t>(id));
    p.black = static_cast<float>(rng_.uniform(0.05, 0.22));
    p.white = static_cast<float>(rng_.uniform(0.75, 0.95));
    p.inverted = recipe_.inverted;
    return p;
  }

  // Large markers are not tried where they cannot fit.
  Point somewhere(double size, Place where) {
    const double w = recipe_.width;
    const double h = recipe_.height;
    if (where == Place::inside) {
      const double inset_x = std::min(0.5 * size, 0.45 * w);
      const double inset_y = std::min(0.5 * size, 0.45 * h);
      return {rng_.uniform(inset_x, w - inset_x), rng_.uniform(inset_y, h - inset_y)};
    }
    const double offset = rng_.uniform(-0.35, 0.35) * size;
    switch (rng_.below(4)) {
      case 0:
        return {offset, rng_.uniform(0, h)};
      case 1:
        return {w + offset, rng_.uniform(0, h)};
      case 2:
        return {rng_.uniform(0, w), offset};
      default:
        return {rng_.uniform(0, w), h + offset};
    }
  }

  Scene& scene_;
  const Recipe& recipe_;
  const Dictionary& dictionary_;
  Rng& rng_;
  Taken taken_;
  int last_id_ = 0;
};

}  // namespace

Scene make_scene(const Recipe& recipe, const Dictionary& dictionary, std::uint64_t seed, int index,
                 const std::vector<std::shared_ptr<const Plane>>& photos) {
  Rng rng(mix(seed ^ mix(static_cast<std::uint64_t>(index) + 1)));
  Scene scene;
  scene.dictionary = dictionary.name;
  scene.inverted = recipe.inverted;
  scene.camera = {recipe.width, recipe.height, recipe.width * recipe.focal.draw(rng),
                  recipe.distortion.draw(rng)};
  scene.light = draw_light(recipe, rng);
  scene.optics.defocus = rng.chance(0.4) ? Optics::Defocus::disc : Optics::Defocus::gaussian;
  scene.optics.blur = recipe.blur.draw(rng);
  scene.optics.motion = recipe.motion.draw(rng);
  scene.optics.motion_direction = rng.uniform(0, pi);
  scene.sensor = {recipe.noise.draw(rng), recipe.gamma, static_cast<int>(recipe.jpeg.draw(rng)), rng.next()};
  scene.tints = scene.sensor.seed;
  scene.background = add_wall(scene, recipe.wall, rng, photos);
  add_clutter(scene, static_cast<int>(recipe.clutter.draw(rng)), rng);
  if (rng.chance(recipe.marker_free)) return scene;

  MarkerPlacer placer(scene, recipe, dictionary, rng);
  // The large ones first, while there is room.
  std::vector<SizeQuota> quotas = recipe.sizes;
  std::stable_sort(quotas.begin(), quotas.end(), [](const auto& a, const auto& b) { return a.low > b.low; });
  const auto size_in = [&](const SizeQuota& q) {
    return exponential(rng.uniform(logarithm(q.low), logarithm(q.high)));
  };
  if (rng.chance(recipe.board)) placer.add_board(recipe.board_size.draw(rng));
  for (const SizeQuota& quota : quotas) {
    for (int n = count_of(quota.count, rng); n > 0; --n) placer.add(size_in(quota), Place::inside);
  }
  // The ones nobody has to find, of any size.
  if (quotas.empty()) return scene;
  const SizeQuota any{std::min(quotas.back().low * 2, quotas.front().high), quotas.front().low + 1, 1};
  for (int n = count_of(recipe.occluded, rng); n > 0; --n) {
    if (placer.add(size_in(any), Place::inside)) placer.cover();
  }
  for (int n = count_of(recipe.cut, rng); n > 0; --n) placer.add(size_in(any), Place::cut);
  return scene;
}

}  // namespace runmark::render
