#include "window.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <opencv2/highgui.hpp>

#include "errors.h"

namespace runmark::cli {
namespace {

constexpr const char* name = "runmark view";

/// The window library ends the whole program when it finds no display, so a child process tries first.
bool display_can_be_opened() {
  const pid_t child = ::fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stderr) == nullptr) ::_exit(1);
    cv::namedWindow("try", cv::WINDOW_AUTOSIZE);
    ::_exit(0);
  }
  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Window::Window() {
  if (!display_can_be_opened()) {
    const char* display = std::getenv("DISPLAY");
    throw UserError(display == nullptr ? std::string("no display: DISPLAY is not set")
                                       : "the display '" + std::string(display) + "' cannot be opened");
  }
  // Qt's remarks about its surroundings are not for our users.
  ::setenv("QT_LOGGING_RULES", "*.warning=false", 0);
  cv::namedWindow(name, cv::WINDOW_NORMAL | cv::WINDOW_KEEPRATIO | cv::WINDOW_GUI_NORMAL);
}

Window::~Window() { cv::destroyAllWindows(); }

void Window::show(const cv::Mat& picture, const std::string& title) {
  if (!sized_) {
    constexpr double most_width = 1280;
    constexpr double most_height = 800;
    const double zoom = std::min({1.0, most_width / picture.cols, most_height / picture.rows});
    cv::resizeWindow(name, static_cast<int>(picture.cols * zoom), static_cast<int>(picture.rows * zoom));
    sized_ = true;
  }
  cv::imshow(name, picture);
  if (title == title_) return;
  cv::setWindowTitle(name, title);
  title_ = title;
}

int Window::wait_key(int milliseconds) {
  const int key = cv::waitKeyEx(std::max(milliseconds, 1));
  return key < 0 ? 0 : key;
}

bool Window::closed() const { return cv::getWindowProperty(name, cv::WND_PROP_VISIBLE) < 1; }

}  // namespace runmark::cli
