#include "evaluate/truth.h"

#include <fstream>
#include <set>

#include "evaluate/json_fields.h"

namespace runmark {
namespace {

using nlohmann::json;

std::optional<double> optional_number(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || found->is_null()) return std::nullopt;
  if (!found->is_number()) throw FieldError(std::string("\"") + name + "\" is not a number");
  return found->get<double>();
}

bool flag(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return false;
  if (!found->is_boolean()) throw FieldError(std::string("\"") + name + "\" is neither true nor false");
  return found->get<bool>();
}

// Corners of real photos were measured by other detectors; only where two of them agreed can an error be
// told from theirs. A renderer knows its corners.
bool corners_are_exact(const std::string& evidence, bool rendered) {
  return evidence == "rendered" || (evidence == "both" && !rendered);
}

TruthMarker read_marker(const json& object, bool rendered) {
  TruthMarker marker;
  marker.id = whole_number(member(object, "id"), "id");
  marker.corners = corners_member(object);
  marker.exact_corners = corners_are_exact(object.value("truth", std::string()), rendered);
  marker.tilt = optional_number(object, "tilt");
  marker.blur = optional_number(object, "blur");
  marker.motion = optional_number(object, "motion");
  marker.noise = optional_number(object, "noise");
  marker.contrast = optional_number(object, "contrast");
  return marker;
}

TruthImage read_image(const json& object) {
  TruthImage image;
  image.image = text_member(object, "image");
  image.width = whole_number(member(object, "width"), "width");
  image.height = whole_number(member(object, "height"), "height");
  if (!member(object, "dictionary").is_null()) image.dictionary = text_member(object, "dictionary");
  image.inverted = flag(object, "inverted");
  image.rendered = flag(object, "rendered");
  image.source = object.contains("source") ? text_member(object, "source") : "";
  for (const json& marker : list_member(object, "markers")) {
    image.markers.push_back(read_marker(marker, image.rendered));
  }
  if (object.contains("maybe")) {
    for (const json& marker : list_member(object, "maybe")) {
      image.maybe.push_back(read_marker(marker, image.rendered));
    }
  }
  for (const json& id : list_member(object, "present_ids")) {
    image.present_ids.push_back(whole_number(id, "present_ids"));
  }
  return image;
}

}  // namespace

Result<std::vector<TruthImage>> read_truth(const std::filesystem::path& file) {
  const auto error = [&](const std::string& what) { return Error{file.string() + ": " + what}; };
  std::ifstream stream(file);
  if (!stream) return error("cannot be read");
  std::string where = "not a truth file";
  try {
    const json all = json::parse(stream);
    if (!all.is_array()) return error("is not a list of images");
    std::vector<TruthImage> images;
    std::set<std::string> names;
    for (const json& object : all) {
      where = "image " + std::to_string(images.size() + 1);
      if (object.is_object() && object.contains("image") && object["image"].is_string()) {
        where = object["image"].get<std::string>();
      }
      images.push_back(read_image(object));
      if (!names.insert(images.back().image).second) return error(where + " is listed twice");
    }
    return images;
  } catch (const FieldError& e) {
    return error(where + ": " + e.what());
  } catch (const json::exception& e) {
    return error(where + ": " + e.what());
  }
}

}  // namespace runmark
