#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "cli/commands.h"
#include "cli/view_options.h"
#include "error.h"

namespace vernier {
namespace {

/// Becomes the program with the window, which lies beside this one and is given the same words: this one needs no
/// window system, and no Vulkan loader at its start. Throws Error(failed) where it is not there.
int run_window_program(std::vector<std::string> words) {
  std::error_code failure;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
  const std::string program = (self.parent_path() / "vernier-view").string();
  words.insert(words.begin(), program);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw Error(ErrorKind::failed, program + " cannot be run (" + std::strerror(errno) +
                                     "): the window needs GLFW and Dear ImGui (libglfw3-dev libimgui-dev); "
                                     "tools/setup window installs them, then build again");
}

}  // namespace

void add_view_command(CLI::App& app, Command& chosen, std::vector<std::string> words) {
  const auto arguments = std::make_shared<ViewArguments>();
  add_view_subcommand(app, *arguments).callback([arguments, words = std::move(words), &chosen] {
    chosen = [arguments, words] {
      parse_view(*arguments);  // wrong usage is told before there is a window
      return run_window_program(words);
    };
  });
}

}  // namespace vernier
