#pragma once

#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "runmark/print.h"

namespace runmark {

/// The pages of a PDF, SVG or PNG file, drawn with cairo in millimetres from the top-left corner of the
/// paper.
class Document {
 public:
  /// Errors: a path that ends in none of the three, a folder that is not there.
  [[nodiscard]] static Result<Document> create(const std::string& path, const Paper& paper, int dpi,
                                               int pages);

  /// Begins the next page, white.
  [[nodiscard]] cairo_t* begin_page();
  /// Errors: what could not be written.
  [[nodiscard]] Result<PrintedPage> end_page();

 private:
  enum class Kind { pdf, svg, png };
  struct Destroy {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  Document(Kind kind, std::string path, const Paper& paper, int dpi, int pages)
      : kind_(kind), path_(std::move(path)), paper_(paper), dpi_(dpi), pages_(pages) {}

  [[nodiscard]] std::string path_of_page() const;
  void open();
  [[nodiscard]] cairo_status_t finish();

  Kind kind_;
  std::string path_;
  Paper paper_;
  int dpi_;
  int pages_;
  int page_ = 0;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace runmark
