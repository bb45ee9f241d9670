#include "render_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "errors.h"

namespace runmark::cli {

namespace {

using render::Range;

// "2" or "0.5:3".
Range parse_range(const std::string& option, const std::string& text, double least, double most) {
  const auto number = [&](const std::string& part) {
    std::size_t used = 0;
    double value = 0;
    try {
      value = std::stod(part, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used != part.size() || part.empty()) {
      throw UserError(option + " " + text + ": expected a number or LOW:HIGH");
    }
    if (!(value >= least && value <= most)) {
      throw UserError(option + " " + text + ": must be between " + CLI::detail::to_string(least) + " and " +
                      CLI::detail::to_string(most));
    }
    return value;
  };
  const auto colon = text.find(':');
  const double low = number(text.substr(0, colon));
  const double high = colon == std::string::npos ? low : number(text.substr(colon + 1));
  if (high < low) throw UserError(option + " " + text + ": LOW is above HIGH");
  return {low, high};
}

void parse_picture_size(const std::string& text, render::Recipe& recipe) {
  int width = 0;
  int height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 64 || height < 64 ||
      width > 16384 || height > 16384) {
    throw UserError("--size " + text + ": expected WIDTHxHEIGHT, each 64 to 16384");
  }
  // Sizes of markers stay what they were in pixels, as far as they fit.
  const double limit = 0.55 * std::min(width, height);
  std::erase_if(recipe.sizes, [&](const render::SizeQuota& q) { return q.low > limit; });
  for (render::SizeQuota& q : recipe.sizes) q.high = std::min(q.high, limit);
  recipe.width = width;
  recipe.height = height;
}

render::Wall parse_wall(const std::string& name) {
  using render::Wall;
  const std::vector<std::pair<std::string, Wall>> walls{
      {"any", Wall::any},     {"plaster", Wall::plaster}, {"gradient", Wall::gradient},
      {"noise", Wall::noise}, {"foliage", Wall::foliage}, {"brick", Wall::brick},
      {"wood", Wall::wood},   {"tiles", Wall::tiles},     {"checker", Wall::checker}};
  for (const auto& [known, wall] : walls) {
    if (known == name) return wall;
  }
  std::string names;
  for (const auto& [known, wall] : walls) names += (names.empty() ? "" : ", ") + known;
  throw UserError("--wall " + name + ": expected one of " + names);
}

}  // namespace

render::Recipe recipe_of(const RenderOptions& o, render::Recipe r) {
  r.inverted = r.inverted || o.inverted;
  if (!o.picture_size.empty()) parse_picture_size(o.picture_size, r);
  const auto range = [](Range& to, const char* option, const std::string& text, double least, double most) {
    if (!text.empty()) to = parse_range(option, text, least, most);
  };
  const auto always = [](render::Sometimes& to, const char* option, const std::string& text, double least,
                         double most) {
    if (!text.empty()) to = {1, parse_range(option, text, least, most)};
  };
  if (!o.marker_size.empty()) {
    const Range size = parse_range("--marker-size", o.marker_size, 2, 16384);
    r.sizes = {{size.low, size.high, 8}};
  }
  range(r.tilt, "--tilt", o.tilt, 0, 85);
  range(r.margin, "--margin", o.margin, 0, 20);
  range(r.blur, "--blur", o.blur, 0, 20);
  range(r.noise, "--noise", o.noise, 0, 100);
  range(r.level, "--level", o.level, 0.01, 4);
  range(r.gradient, "--gradient", o.gradient, 0, 0.95);
  range(r.clutter, "--clutter", o.clutter, 0, 500);
  always(r.motion, "--motion", o.motion, 0, 100);
  always(r.shadows, "--shadows", o.shadows, 0, 20);
  always(r.lamps, "--lamps", o.lamps, 0, 20);
  always(r.distortion, "--distortion", o.distortion, -0.5, 0.2);
  always(r.vignette, "--vignette", o.vignette, 0, 1);
  always(r.jpeg, "--jpeg", o.jpeg, 0, 100);
  if (o.occluded >= 0) r.occluded = o.occluded;
  if (o.cut >= 0) r.cut = o.cut;
  if (o.gamma >= 0) r.gamma = o.gamma;
  if (!o.wall.empty()) r.wall = parse_wall(o.wall);
  if (!o.background.empty()) r.wall = render::Wall::photo;
  return r;
}

void check_format(const RenderOptions& o) {
  if (o.format.empty()) return;
  const bool video = o.format == "avi" || o.format == "mp4";
  if (video && o.frames == 0) throw UserError("--format " + o.format + ": a video needs --frames");
  if (!video && o.frames > 0) throw UserError("--format " + o.format + ": with --frames it is avi or mp4");
  if (o.format == "pgm" && o.colour) throw UserError("--format pgm: has no colour");
}

void add_render_options(CLI::App& command, RenderOptions& options) {
  CLI::App* c = &command;
  RenderOptions* o = &options;
  c->add_option("-o,--output", o->output, "Folder for the pictures and truth.json")->required();
  c->add_option("--set", o->set, "vga, hd, fullhd, uhd or samples")->capture_default_str();
  c->add_option("--scenes", o->scenes, "How many; without it the whole set")->check(CLI::Range(1, 1000000));
  c->add_option("--first", o->first, "Number of the first scene")->check(CLI::Range(0, 1000000));
  c->add_option("--seed", o->seed, "Other scenes of the same kind; 0 is the standard set");
  c->add_option("--dict", o->dictionary,
                "Dictionary name or .codes file; without it tag36h11, or the sample's own");
  c->add_option("--board", o->board,
                "Views of a board by one camera instead of scenes: charuco:DICT:COLUMNSxROWS:SQUARE:MARKER, "
                "grid:DICT:COLUMNSxROWS:MARKER:GAP or a .json file of one of these");
  c->add_flag("--inverted", o->inverted, "White-on-black markers");
  c->add_option("--format", o->format, "png (default), pgm or jpg; of videos avi (default) or mp4")
      ->check(CLI::IsMember({"png", "pgm", "jpg", "avi", "mp4"}));
  c->add_flag("--colour", o->colour, "Colour pictures");
  c->add_option("--frames", o->frames, "Videos of so many frames from a moving camera, one for each scene")
      ->check(CLI::Range(1, 1000000));
  c->add_option("--fps", o->fps, "Frames a second")->check(CLI::Range(1.0, 1000.0))->capture_default_str();
  c->add_option("--shake", o->shake, "How far the camera sways; 0 stands still")
      ->check(CLI::Range(0.0, 5.0))
      ->capture_default_str();
  c->add_option("--jobs", o->jobs, "Threads; without it one for each core")->check(CLI::Range(1, 256));
  c->add_option("--size", o->picture_size, "Size of the pictures, WIDTHxHEIGHT");
  c->add_option("--background", o->background, "Folder of photos to use as walls");
  const std::string ranges = "Instead of the set's own values, each a number or LOW:HIGH";
  const auto range = [&](const char* name, std::string& to, const char* what) {
    c->add_option(name, to, what)->group(ranges);
  };
  range("--marker-size", o->marker_size, "Square root of the black square's area, pixels");
  range("--tilt", o->tilt, "Degrees from facing the camera");
  range("--margin", o->margin, "White paper round a marker, cells");
  range("--blur", o->blur, "Defocus: standard deviation, pixels");
  range("--motion", o->motion, "Motion blur: length, pixels");
  range("--noise", o->noise, "Standard deviation at level 128, grey levels");
  range("--level", o->level, "Light; 1 makes a perfect white full scale");
  range("--gradient", o->gradient, "Share of light gained or lost towards an edge");
  range("--shadows", o->shadows, "Shadows in a scene");
  range("--lamps", o->lamps, "Patches of light in a scene");
  range("--clutter", o->clutter, "Things on the wall");
  range("--distortion", o->distortion, "Lens: below 0 barrel, above 0 pincushion");
  range("--vignette", o->vignette, "Share of light lost in the corners");
  range("--jpeg", o->jpeg, "Quality 1 to 100 of the compression gone through; 0 for none");
  c->add_option("--occluded", o->occluded, "Markers with a covered border in a scene, on average")
      ->check(CLI::Range(0.0, 100.0));
  c->add_option("--cut", o->cut, "Markers cut by the edge in a scene, on average")
      ->check(CLI::Range(0.0, 100.0));
  c->add_option("--gamma", o->gamma, "Tone curve; 1 is none")->check(CLI::Range(0.2, 5.0));
  c->add_option("--wall", o->wall, "plaster, gradient, noise, foliage, brick, wood, tiles, checker or any");
}

}  // namespace runmark::cli
