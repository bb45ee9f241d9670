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
#include <opencv2/videoio.hpp>
#include <string>
#include <thread>
#include <vector>

#include "errors.h"
#include "render/board_scene.h"
#include "render/camera_path.h"
#include "render/colour.h"
#include "render/samples.h"
#include "render/standard_sets.h"
#include "render/truth_json.h"
#include "render_options.h"
#include "runmark/board_file.h"
#include "runmark/dictionary.h"

namespace runmark::cli {

namespace {

namespace fs = std::filesystem;

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

// Grey, or in colour when asked for.
cv::Mat picture_of(const render::Scene& scene, const render::RenderedFrame& frame, bool colour) {
  if (colour) {
    std::vector<std::uint8_t> bgr = render::colourise(scene, frame);
    return cv::Mat(frame.height, frame.width, CV_8UC3, bgr.data()).clone();
  }
  cv::Mat grey(frame.height, frame.width, CV_8UC1);
  std::copy(frame.grey.begin(), frame.grey.end(), grey.data);
  return grey;
}

void write_picture(const fs::path& file, const cv::Mat& picture) {
  std::vector<int> flags;
  if (file.extension() == ".jpg") flags = {cv::IMWRITE_JPEG_QUALITY, 95};
  if (file.extension() == ".png") flags = {cv::IMWRITE_PNG_COMPRESSION, 1};
  if (!cv::imwrite(file.string(), picture, flags)) throw UserError(file.string() + ": cannot be written");
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
  std::shared_ptr<const Board> board = nullptr;  // of which it is a view
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

// Views of a board: well lit, in focus and as large as the set's pictures, unless the options say otherwise.
std::vector<Job> board_jobs(const RenderOptions& o) {
  const auto board = std::make_shared<const Board>(value_or_throw(load_board(o.board), "--board"));
  if (!board->charuco && !board->grid)
    throw UserError("--board " + o.board + ": is no grid and no ChArUco board");
  if (o.frames > 0) throw UserError("--frames: views of a board are pictures");
  const render::StandardSet* set = render::find_standard_set(o.set);
  render::Recipe recipe;
  recipe.width = set != nullptr ? set->recipe.width : recipe.width;
  recipe.height = set != nullptr ? set->recipe.height : recipe.height;
  recipe.tilt = {5, 50};
  recipe.level = {0.8, 1.1};
  recipe.blur = {0.4, 1};
  recipe.noise = {1, 3};
  recipe.motion = recipe.lamps = recipe.shadows = recipe.jpeg = {};
  recipe.distortion = {1, {-0.08, -0.03}};
  recipe = recipe_of(o, recipe);
  const auto dictionary = dictionary_of(board->markers[0].dictionary);
  std::vector<Job> jobs;
  for (int i = 0; i < (o.scenes > 0 ? o.scenes : 20); ++i) {
    char number[16];
    std::snprintf(number, sizeof number, "_%04d", o.first + i);
    jobs.push_back({std::string("board") + number, o.first + i, recipe, dictionary,
                    render::set_seed("board", o.seed), board});
  }
  return jobs;
}

// The pose of the board, and the camera by the division model (src/render/camera.h).
nlohmann::ordered_json board_truth(const render::BoardScene& made) {
  const render::Vec3 x = made.plane.along_u;
  const render::Vec3 y = made.plane.along_v;
  const render::Vec3 z = render::cross(x, y);
  const render::Vec3 t = made.plane.origin;
  const render::Camera& camera = made.scene.camera;
  return {{"translation", {t.x, t.y, t.z}},
          {"rotation", {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}},
          {"focal", camera.focal},
          {"centre", {camera.centre_x(), camera.centre_y()}},
          {"distortion", camera.distortion}};
}

std::vector<nlohmann::ordered_json> make_picture(const RenderOptions& o, const Job& job,
                                                 const render::Scene& scene) {
  const render::RenderedFrame frame = render::render(scene);
  const std::string image = job.name + "." + (o.format.empty() ? "png" : o.format);
  write_picture(o.output / image, picture_of(scene, frame, o.colour));
  return {render::to_json(frame.truth, image)};
}

std::vector<nlohmann::ordered_json> make_video(const RenderOptions& o, const Job& job,
                                               const render::Scene& scene) {
  const std::string format = o.format.empty() ? "avi" : o.format;
  const std::string video = job.name + "." + format;
  const int code = format == "mp4" ? cv::VideoWriter::fourcc('m', 'p', '4', 'v')
                                   : cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
  cv::VideoWriter writer((o.output / video).string(), code, o.fps, {scene.camera.width, scene.camera.height});
  if (!writer.isOpened()) throw UserError((o.output / video).string() + ": cannot be written");
  writer.set(cv::VIDEOWRITER_PROP_QUALITY, 95);
  std::vector<nlohmann::ordered_json> truth;
  for (int i = 0; i < o.frames; ++i) {
    const render::Scene now = render::after(scene, i / o.fps, o.shake);
    const render::RenderedFrame frame = render::render(now);
    cv::Mat picture = picture_of(now, frame, o.colour);
    if (!o.colour) cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
    writer.write(picture);
    truth.push_back(render::to_json(frame.truth, video));
    truth.back()["frame"] = i;
  }
  return truth;
}

void run(const RenderOptions& o) {
  check_format(o);
  const std::vector<Job> jobs = !o.board.empty()     ? board_jobs(o)
                                : o.set == "samples" ? sample_jobs(o)
                                                     : set_jobs(o);
  const auto photos = read_photos(o.background, jobs.front().recipe.width);
  std::error_code failed;
  fs::create_directories(o.output, failed);
  if (failed) throw UserError(o.output.string() + ": " + failed.message());

  std::vector<std::vector<nlohmann::ordered_json>> made(jobs.size());
  const int threads =
      o.jobs > 0 ? o.jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  in_parallel(static_cast<int>(jobs.size()), threads, [&](int i) {
    const Job& job = jobs[static_cast<std::size_t>(i)];
    auto& entries = made[static_cast<std::size_t>(i)];
    if (job.board) {
      const auto view =
          render::make_board_scene(job.recipe, *job.board, *job.dictionary, job.seed, job.index);
      entries = make_picture(o, job, view.scene);
      entries[0]["board"] = board_truth(view);
      return;
    }
    const render::Scene scene = render::make_scene(job.recipe, *job.dictionary, job.seed, job.index, photos);
    entries = o.frames > 0 ? make_video(o, job, scene) : make_picture(o, job, scene);
    for (auto& entry : entries) {
      entry["scene"]["set"] = o.set;
      entry["scene"]["seed"] = o.seed;
      entry["scene"]["index"] = job.index;
    }
  });
  std::vector<nlohmann::ordered_json> truth;
  std::size_t markers = 0;
  for (auto& entries : made) {
    for (auto& entry : entries) {
      markers += entry["markers"].size();
      truth.push_back(std::move(entry));
    }
  }
  write_text(o.output / "truth.json", render::truth_file(truth));
  const std::string what = o.frames > 0 ? "frame" : "scene";
  std::printf("%zu %s%s, %zu markers: %s\n", truth.size(), what.c_str(), truth.size() == 1 ? "" : "s",
              markers, (o.output / "truth.json").c_str());
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto o = std::make_shared<RenderOptions>();
  CLI::App* c = app.add_subcommand("render", "Makes scenes with exact truth");
  add_render_options(*c, *o);
  c->callback([o] { run(*o); });
}

}  // namespace runmark::cli
