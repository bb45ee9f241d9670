#include "earlier_run.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "errors.h"

namespace runmark::cli {
namespace {

using Json = nlohmann::json;

/// Bytes; thousands of markers fit in it.
constexpr std::streamsize longest_line = 1 << 24;

/// A name as it reads in the lines: JSON is UTF-8, file names need not be.
std::string as_written(const std::string& name) {
  return Json::parse(Json(name).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

/// Finds the input each line belongs to. One that was named several times has its lines as often.
class LineReader {
 public:
  explicit LineReader(const std::vector<Input>& inputs) : frames_(inputs.size()) {
    for (std::size_t i = 0; i < inputs.size(); ++i) inputs_by_name_[as_written(inputs[i].name)].push_back(i);
  }

  /// What is wrong with the line, or nothing.
  std::string take(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    const auto source = json.find("source");
    const auto frame = json.find("frame");
    if (!json.is_object() || source == json.end() || frame == json.end() || !source->is_string() ||
        !frame->is_number_integer()) {
      return "not a line of a frame";
    }
    const auto known = inputs_by_name_.find(source->get<std::string>());
    if (known == inputs_by_name_.end()) return source->get<std::string>() + " is none of the inputs";
    return place(known->second, frame->get<std::int64_t>());
  }

  [[nodiscard]] std::vector<EarlierFrames> frames() const {
    std::vector<EarlierFrames> result = frames_;
    // Inputs are worked through in order. Lines out of it are from one that could be read only later; then
    // nothing is known of where the others stopped.
    for (std::size_t i = 0; i < last_ && in_order_; ++i) result[i].ended = true;
    return result;
  }

 private:
  std::string place(const std::vector<std::size_t>& same_name, std::int64_t frame) {
    const auto next_of = [&](std::size_t i) { return frames_[i].count; };
    // The last one that was begun goes on, or the next one begins.
    auto at =
        std::find_if(same_name.rbegin(), same_name.rend(), [&](std::size_t i) { return next_of(i) > 0; });
    std::size_t input = same_name.front();
    if (at != same_name.rend() && frame != 0) {
      input = *at;
    } else if (at != same_name.rend()) {
      if (at == same_name.rbegin()) return "frame 0 is there more often than its input";
      input = *--at;
    }
    if (frame != next_of(input)) {
      return "frame " + std::to_string(frame) + " stands where " + std::to_string(next_of(input)) +
             " was to follow";
    }
    ++frames_[input].count;
    in_order_ = in_order_ && input >= last_;
    last_ = std::max(last_, input);
    return {};
  }

  std::map<std::string, std::vector<std::size_t>> inputs_by_name_;
  std::vector<EarlierFrames> frames_;
  std::size_t last_ = 0;  // the furthest input a line was for
  bool in_order_ = true;
};

}  // namespace

EarlierRun read_earlier_run(const std::string& path, const std::vector<Input>& inputs) {
  for (const Input& input : inputs) {
    if (input.kind == InputKind::camera)
      throw UserError(input.name + ": what a camera saw cannot be resumed");
  }
  EarlierRun earlier{0, std::vector<EarlierFrames>(inputs.size())};
  if (!std::filesystem::exists(path)) return earlier;
  if (!std::filesystem::is_regular_file(path))
    throw UserError(path + ": not a file; no run can go on with it");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  LineReader reader(inputs);
  std::vector<char> line(longest_line);
  int number = 1;
  const auto refuse = [&](const std::string& wrong) {
    throw UserError(path + ": line " + std::to_string(number) + ": " + wrong +
                    "; this run cannot go on with it");
  };
  // A line without its end was being written when the run was stopped.
  for (; file.getline(line.data(), longest_line) && !file.eof(); ++number) {
    const auto bytes = static_cast<std::size_t>(file.gcount());
    if (const std::string wrong = reader.take({line.data(), bytes - 1}); !wrong.empty()) refuse(wrong);
    earlier.bytes += bytes;
  }
  if (file.gcount() == longest_line - 1) refuse("longer than a frame's");
  if (file.bad() || !file.eof()) throw UserError(path + ": " + std::strerror(errno != 0 ? errno : EIO));
  earlier.inputs = reader.frames();
  return earlier;
}

}  // namespace runmark::cli
