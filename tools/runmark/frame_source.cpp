#include "frame_source.h"

#include "image_source.h"
#include "stream_source.h"
#include "video_source.h"

namespace runmark::cli {

std::unique_ptr<FrameSource> open_source(const Input& input) {
  switch (input.kind) {
    case InputKind::image:
      return std::make_unique<ImageSource>(input.name);
    case InputKind::video:
      return std::make_unique<VideoSource>(input.name);
    case InputKind::camera:
      return std::make_unique<CameraSource>(input.name);
    case InputKind::stream:
      break;
  }
  return open_stream(input.name);
}

}  // namespace runmark::cli
