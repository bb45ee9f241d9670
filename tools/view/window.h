#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace runmark::cli {

/// One window on the screen.
class Window {
 public:
  /// Throws UserError when there is no display.
  Window();
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// The first picture also gives the window its size.
  void show(const cv::Mat& picture, const std::string& title);

  /// Waits for a key, but no longer than that. 0 when none was pressed.
  [[nodiscard]] int wait_key(int milliseconds);

  /// Whether somebody closed it.
  [[nodiscard]] bool closed() const;

 private:
  std::string title_;
  bool sized_ = false;
};

}  // namespace runmark::cli
