#include "view_command.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "errors.h"

namespace runmark::cli {
namespace {

[[noreturn]] void run_viewer(std::vector<std::string> arguments) {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  std::string program = (self.parent_path() / "runmark-view").string();
  std::vector<char*> words{program.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  throw UserError("view: " + program + ": " + std::strerror(errno));
}

}  // namespace

void add_view_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "Show markers live in a window");
  // All that follows is for the other program, --help too.
  command->prefix_command();
  command->set_help_flag();
  command->callback([command] { run_viewer(command->remaining()); });
}

}  // namespace runmark::cli
