#include "evaluate/observations.h"

#include <fstream>
#include <string_view>
#include <vector>

#include "evaluate/json_fields.h"

namespace runmark {

std::vector<Observation> observations_of(const Detection& detection) {
  std::vector<Observation> found;
  for (const Marker& marker : detection) found.push_back({marker.id, marker.corners});
  return found;
}

Result<Observations> read_observations(const std::filesystem::path& file) {
  using nlohmann::json;
  std::ifstream stream(file);
  if (!stream) return Error{file.string() + ": cannot be read"};
  Observations all;
  // Room for thousands of markers; what is no such file must not fill the memory.
  std::vector<char> buffer(std::size_t{1} << 24U);
  int number = 1;
  for (; stream.getline(buffer.data(), static_cast<std::streamsize>(buffer.size())); ++number) {
    const std::string_view line(buffer.data());
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const std::string where = file.string() + ":" + std::to_string(number) + ": ";
    try {
      const json object = json::parse(line);
      // runmark detect names every input, a video too, its source.
      const bool own = object.is_object() && object.contains("source") && !object.contains("image");
      const std::string image = text_member(object, own ? "source" : "image");
      ImageObservations found;
      for (const json& marker : list_member(object, "markers")) {
        found.markers.push_back({whole_number(member(marker, "id"), "id"), corners_member(marker)});
      }
      if (const auto ms = object.find("ms"); ms != object.end() && ms->is_number()) {
        found.milliseconds = ms->get<double>();
      }
      if (!all.emplace(image, std::move(found)).second) return Error{where + image + " comes twice"};
    } catch (const FieldError& e) {
      return Error{where + e.what()};
    } catch (const json::exception& e) {
      return Error{where + e.what()};
    }
  }
  if (!stream.eof() && !stream.bad())
    return Error{file.string() + ":" + std::to_string(number) + ": longer than a frame's"};
  if (stream.bad()) return Error{file.string() + ": cannot be read to its end"};
  return all;
}

}  // namespace runmark
