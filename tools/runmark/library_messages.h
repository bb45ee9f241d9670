#pragma once

namespace runmark::cli {

/// OpenCV and FFmpeg keep quiet from now on: what is wrong with an input is said once, in our words.
/// Their own environment variables (OPENCV_LOG_LEVEL, OPENCV_FFMPEG_LOGLEVEL) still turn them on.
void silence_libraries();

/// While one of these lives, what image libraries print on stderr themselves (libpng's errors,
/// libjpeg's warnings) goes nowhere. Threads may each hold one.
class QuietStderr {
 public:
  QuietStderr();
  ~QuietStderr();
  QuietStderr(const QuietStderr&) = delete;
  QuietStderr& operator=(const QuietStderr&) = delete;
};

}  // namespace runmark::cli
