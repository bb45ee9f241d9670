#include "render_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <thread>
#include <vector>

#include "errors.h"
#include "render/samples.h"
#include "render/standard_sets.h"
#include "render/truth_json.h"
#include "runmark/dictionary.h"

namespace runmark::cli {

namespace {

namespace fs = std::filesystem;
using render::Range;

struct RenderOptions {
  std::string set = "vga";
  fs::path output;
  int scenes = 0;
  int first = 0;
  std::uint64_t seed = 0;
  std::string dictionary;
  bool inverted = false;
  std::string format = "png";
  int jobs = 0;
  std::string picture_size;
  fs::path background;
  std::string wall;
  std::string marker_size;
  std::string tilt;
  std::string margin;
  std::string blur;
  std::string motion;
  std::string noise;
  std::string level;
  std::string gradient;
  std::string shadows;
  std::string lamps;
  std::string clutter;
  std::string distortion;
  std::string vignette;
  std::string jpeg;
  double occluded = -1;
  double cut = -1;
  double gamma = -1;
};

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

// The photos of a folder as linear grey planes no larger than needed.
std::vector<std::shared_ptr<const render::Plane>> read_photos(const fs::path& folder, int width) {
  if (folder.empty()) return {};
  if (!fs::is_directory(folder)) throw UserError(folder.string() + ": not a folder of photos");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::shared_ptr<const render::Plane>> photos;
  for (const fs::path& file : files) {
    cv::Mat photo = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (photo.empty()) continue;
    const double scale = 1.3 * width / photo.cols;
    if (scale < 1) cv::resize(photo, photo, {}, scale, scale, cv::INTER_AREA);
    auto plane = std::make_shared<render::Plane>(photo.cols, photo.rows);
    for (int y = 0; y < photo.rows; ++y) {
      for (int x = 0; x < photo.cols; ++x)
        plane->row(y)[x] = static_cast<float>(photo.at<std::uint8_t>(y, x)) / 255;
    }
    photos.push_back(std::move(plane));
  }
  if (photos.empty()) throw UserError(folder.string() + ": no photo in it that can be read");
  return photos;
}

void write_picture(const fs::path& file, const render::RenderedFrame& frame) {
  // OpenCV asks for mutable memory, though it only reads.
  const cv::Mat grey(frame.height, frame.width, CV_8UC1, const_cast<std::uint8_t*>(frame.grey.data()));
  std::vector<int> flags;
  if (file.extension() == ".jpg") flags = {cv::IMWRITE_JPEG_QUALITY, 95};
  if (file.extension() == ".png") flags = {cv::IMWRITE_PNG_COMPRESSION, 1};
  if (!cv::imwrite(file.string(), grey, flags)) throw UserError(file.string() + ": cannot be written");
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw UserError(file.string() + ": cannot be written");
}

// Calls job(0) to job(count - 1), `threads` at a time; the first error ends it.
template <class Job>
void in_parallel(int count, int threads, const Job& job) {
  std::atomic<int> next = 0;
  std::mutex mutex;
  std::exception_ptr error;
  const auto work = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        job(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!error) error = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> pool;
  for (int i = 1; i < threads; ++i) pool.emplace_back(work);
  work();
  for (std::thread& thread : pool) thread.join();
  if (error) std::rethrow_exception(error);
}

// A scene still to be made, and the file it goes into.
struct Job {
  std::string name;
  int index = 0;
  render::Recipe recipe;
  std::shared_ptr<const Dictionary> dictionary;
  std::uint64_t seed = 0;
};

std::shared_ptr<const Dictionary> dictionary_of(const std::string& name) {
  return std::make_shared<const Dictionary>(value_or_throw(load_dictionary(name), "--dict " + name));
}

std::vector<Job> sample_jobs(const RenderOptions& o) {
  std::vector<Job> jobs;
  for (const render::Sample& sample : render::samples()) {
    if (o.scenes > 0 && static_cast<int>(jobs.size()) == o.scenes) break;
    const std::string dictionary = o.dictionary.empty() ? std::string(sample.dictionary) : o.dictionary;
    jobs.push_back({std::string(sample.name), o.first, recipe_of(o, sample.recipe), dictionary_of(dictionary),
                    render::set_seed(sample.name, sample.seed + o.seed)});
  }
  return jobs;
}

std::vector<Job> set_jobs(const RenderOptions& o) {
  const render::StandardSet* set = render::find_standard_set(o.set);
  if (set == nullptr) {
    std::string names = "samples";
    for (const render::StandardSet& s : render::standard_sets()) names += ", " + std::string(s.name);
    throw UserError("--set " + o.set + ": there are " + names);
  }
  const auto dictionary = dictionary_of(o.dictionary.empty() ? "tag36h11" : o.dictionary);
  const render::Recipe recipe = recipe_of(o, set->recipe);
  std::vector<Job> jobs;
  for (int i = 0; i < (o.scenes > 0 ? o.scenes : set->scenes); ++i) {
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", o.first + i);
    jobs.push_back({o.set + number, o.first + i, recipe, dictionary, render::set_seed(set->name, o.seed)});
  }
  return jobs;
}

void run(const RenderOptions& o) {
  const std::vector<Job> jobs = o.set == "samples" ? sample_jobs(o) : set_jobs(o);
  const auto photos = read_photos(o.background, jobs.front().recipe.width);
  std::error_code failed;
  fs::create_directories(o.output, failed);
  if (failed) throw UserError(o.output.string() + ": " + failed.message());

  std::vector<nlohmann::ordered_json> truth(jobs.size());
  const int threads =
      o.jobs > 0 ? o.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  in_parallel(static_cast<int>(jobs.size()), threads, [&](int i) {
    const Job& job = jobs[static_cast<std::size_t>(i)];
    const render::Scene scene = render::make_scene(job.recipe, *job.dictionary, job.seed, job.index, photos);
    const render::RenderedFrame frame = render::render(scene);
    const std::string image = job.name + "." + o.format;
    write_picture(o.output / image, frame);
    nlohmann::ordered_json entry = render::to_json(frame.truth, image);
    entry["scene"]["set"] = o.set;
    entry["scene"]["seed"] = o.seed;
    entry["scene"]["index"] = job.index;
    truth[static_cast<std::size_t>(i)] = std::move(entry);
  });
  write_text(o.output / "truth.json", render::truth_file(truth));
  std::size_t markers = 0;
  for (const auto& entry : truth) markers += entry["markers"].size();
  std::printf("%zu scenes, %zu markers: %s\n", jobs.size(), markers, (o.output / "truth.json").c_str());
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto o = std::make_shared<RenderOptions>();
  CLI::App* c = app.add_subcommand("render", "Makes scenes with exact truth");
  c->add_option("-o,--output", o->output, "Folder for the pictures and truth.json")->required();
  c->add_option("--set", o->set, "vga, hd, fullhd, uhd or samples")->capture_default_str();
  c->add_option("--scenes", o->scenes, "How many; without it the whole set")->check(CLI::Range(1, 1000000));
  c->add_option("--first", o->first, "Number of the first scene")->check(CLI::Range(0, 1000000));
  c->add_option("--seed", o->seed, "Other scenes of the same kind; 0 is the standard set");
  c->add_option("--dict", o->dictionary,
                "Dictionary name or .codes file; without it tag36h11, or the sample's own");
  c->add_flag("--inverted", o->inverted, "White-on-black markers");
  c->add_option("--format", o->format, "png, pgm or jpg")
      ->check(CLI::IsMember({"png", "pgm", "jpg"}))
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
  c->callback([o] { run(*o); });
}

}  // namespace runmark::cli
