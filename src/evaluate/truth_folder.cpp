#include "evaluate/truth_folder.h"

namespace runmark {
namespace {

namespace fs = std::filesystem;

std::string without_prefix(const std::string& name) {
  const std::string prefix = "custom:";
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

}  // namespace

TruthFolder::TruthFolder(const fs::path& truth_file, fs::path images)
    : folder_(truth_file.parent_path()), images_(std::move(images)) {
  if (!images_.empty()) return;
  std::error_code ignored;
  images_ = fs::is_directory(folder_ / "images", ignored) ? folder_ / "images" : folder_;
}

fs::path TruthFolder::image(const TruthImage& image) const { return images_ / image.image; }

Result<std::vector<Dictionary>> TruthFolder::dictionaries(const TruthImage& image) const {
  const std::vector<std::string> names =
      image.dictionary ? std::vector{*image.dictionary} : dictionaries_without_markers;
  std::vector<Dictionary> loaded;
  for (const std::string& name : names) {
    const fs::path own = folder_ / "dictionaries" / (without_prefix(name) + ".codes");
    std::error_code ignored;
    auto dictionary = builtin_dictionary(name);
    if (!dictionary && fs::exists(own, ignored)) dictionary = load_dictionary(own.string());
    if (!dictionary) return Error{image.image + ": " + dictionary.error()};
    loaded.push_back(*std::move(dictionary));
  }
  return loaded;
}

}  // namespace runmark
