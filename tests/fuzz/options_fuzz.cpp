// Any command line: the program itself runs with it, in a folder of its own with a few small files. It ends
// with 0, or with 2 and one line on stderr that begins with its name. Arguments are separated by line feeds.

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "expect.h"

/// main of tools/runmark/main.cpp, which is compiled under this name here.
int runmark_main(int argc, char** argv);

namespace runmark::fuzz {
namespace {

namespace fs = std::filesystem;

/// From here on the program works in a folder of its own.
void enter_folder() {
  static std::string folder = fs::temp_directory_path() / "runmark-fuzz-XXXXXX";
  expect(::mkdtemp(folder.data()) != nullptr, "a folder can be made");
  std::atexit([] {
    std::error_code error;
    fs::remove_all(folder, error);
  });
  fs::current_path(folder);
}

/// Puts into it what the program may be asked to read, and nothing else.
void fill_folder() {
  for (const auto& entry : fs::directory_iterator(".")) fs::remove_all(entry);
  std::string page = "P5 40 40 255\n" + std::string(1600, '\xC8');
  for (int y = 8; y < 32; ++y) std::fill_n(page.begin() + 13 + 40 * y + 8, 24, '\x1E');
  std::ofstream("a.pgm", std::ios::binary) << page;
  std::ofstream("v.y4m", std::ios::binary) << "YUV4MPEG2 W8 H8 F25:1 Cmono\nFRAME\n"
                                           << std::string(64, 'x') << "FRAME\n"
                                           << std::string(64, 'y');
  std::ofstream("bad.png", std::ios::binary) << "no picture";
  std::ofstream("d.codes") << "3 0\n0b1\n1e4\n";
  std::ofstream("t.json") << R"([{"image":"a.pgm","width":40,"height":40,"dictionary":null,"markers":[]}])";
}

std::vector<std::string> arguments(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> result{"runmark"};
  std::string argument;
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] == '\n') {
      result.push_back(argument);
      argument.clear();
    } else if (data[i] != 0) {
      argument += static_cast<char>(data[i]);
    }
  }
  result.push_back(argument);
  return result;
}

bool has_large_number(const std::string& word) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  return std::adjacent_find(word.begin(), word.end(), [&](char a, char b) { return digit(a) && digit(b); }) !=
         word.end();
}

/// Whether the program may be let loose with this: it stays in its folder, ends soon and starts few threads.
bool harmless(const std::vector<std::string>& words) {
  const bool threads = std::ranges::any_of(
      words, [](const std::string& word) { return word.starts_with("-j") || word.starts_with("--jobs"); });
  return std::ranges::none_of(words, [&](const std::string& word) {
    return word.find('/') != std::string::npos || word.find("..") != std::string::npos || word == "render" ||
           word.find("camera:") != std::string::npos || (threads && has_large_number(word));
  });
}

/// What the program prints on stderr meanwhile.
class CaughtStderr {
 public:
  CaughtStderr() : file_(::memfd_create("stderr", MFD_CLOEXEC)), before_(::dup(STDERR_FILENO)) {
    expect(file_ >= 0 && before_ >= 0, "stderr can be caught");
    ::dup2(file_, STDERR_FILENO);
  }
  ~CaughtStderr() {
    ::close(before_);
    ::close(file_);
  }
  CaughtStderr(const CaughtStderr&) = delete;
  CaughtStderr& operator=(const CaughtStderr&) = delete;

  [[nodiscard]] std::string stop() {
    ::dup2(before_, STDERR_FILENO);
    std::string text(static_cast<std::size_t>(std::max<off_t>(::lseek(file_, 0, SEEK_END), 0)), ' ');
    expect(::pread(file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()),
           "stderr can be read");
    return text;
  }

 private:
  int file_;
  int before_;
};

void run(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  CaughtStderr caught;
  const int status = runmark_main(static_cast<int>(words.size()), argv.data());
  const std::string said = caught.stop();
  expect(status == 0 || status == 2, "the status is 0 or 2");
  expect((status == 2) == !said.empty(), "an error is told, and nothing else");
  expect(said.empty() || said.ends_with('\n'), "what is told is whole lines");
  // Several inputs can be broken; each has its line.
  for (std::size_t at = 0; at < said.size(); at = said.find('\n', at) + 1) {
    expect(said.compare(at, 9, "runmark: ") == 0, "a line begins with the program's name");
  }
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace runmark::fuzz;
  static const bool entered = [] {
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    ::close(nothing);
    enter_folder();
    return true;
  }();
  if (!entered) return 0;
  const auto words = arguments(data, size);
  if (!harmless(words)) return 0;
  fill_folder();
  run(words);
  return 0;
}
