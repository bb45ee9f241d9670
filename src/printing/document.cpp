#include "printing/document.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "printing/png_resolution.h"

namespace runmark {
namespace {

constexpr double points_per_mm = 72 / 25.4;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
  static_cast<std::vector<unsigned char>*>(bytes)->insert(
      static_cast<std::vector<unsigned char>*>(bytes)->end(), data, data + size);
  return CAIRO_STATUS_SUCCESS;
}

bool write_all(const std::string& path, const std::vector<unsigned char>& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return (std::fclose(file) == 0) && written;
}

}  // namespace

Result<Document> Document::create(const std::string& path, const Paper& paper, int dpi, int pages) {
  std::FILE* file = nullptr;
  for (const auto& [ending, kind] :
       {std::pair{".pdf", Kind::pdf}, std::pair{".svg", Kind::svg}, std::pair{".png", Kind::png}}) {
    if (!path.ends_with(ending)) continue;
    Document document(kind, path, paper, dpi, pages);
    document.page_ = 1;
    const std::string first = document.path_of_page();
    document.page_ = 0;
    file = std::fopen(first.c_str(), "wb");
    if (file == nullptr) return Error{first + ": cannot be written"};
    std::fclose(file);
    return document;
  }
  return Error{path + ": a print is a .pdf, .svg or .png"};
}

std::string Document::path_of_page() const {
  if (kind_ == Kind::pdf || pages_ == 1) return path_;
  const std::size_t dot = path_.rfind('.');
  return path_.substr(0, dot) + "-" + std::to_string(page_) + path_.substr(dot);
}

void Document::open() {
  const std::string path = path_of_page();
  switch (kind_) {
    case Kind::pdf:
      surface_.reset(cairo_pdf_surface_create(path.c_str(), paper_.width * points_per_mm,
                                              paper_.height * points_per_mm));
      break;
    case Kind::svg:
      // The numbers are taken as of the unit.
      surface_.reset(cairo_svg_surface_create(path.c_str(), paper_.width, paper_.height));
      cairo_svg_surface_set_document_unit(surface_.get(), CAIRO_SVG_UNIT_MM);
      break;
    case Kind::png:
      surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                static_cast<int>(std::lround(paper_.width / 25.4 * dpi_)),
                                                static_cast<int>(std::lround(paper_.height / 25.4 * dpi_))));
  }
  context_.reset(cairo_create(surface_.get()));
  const double scale = kind_ == Kind::pdf ? points_per_mm : kind_ == Kind::svg ? 1 : dpi_ / 25.4;
  cairo_scale(context_.get(), scale, scale);
}

cairo_t* Document::begin_page() {
  ++page_;
  if (!context_) open();
  cairo_set_source_rgb(context_.get(), 1, 1, 1);
  cairo_paint(context_.get());
  return context_.get();
}

cairo_status_t Document::finish() {
  cairo_status_t status = cairo_status(context_.get());
  if (kind_ == Kind::png && status == CAIRO_STATUS_SUCCESS) {
    std::vector<unsigned char> bytes;
    status = cairo_surface_write_to_png_stream(surface_.get(), append, &bytes);
    if (status == CAIRO_STATUS_SUCCESS && !write_all(path_of_page(), with_resolution(bytes, dpi_))) {
      status = CAIRO_STATUS_WRITE_ERROR;
    }
  }
  context_.reset();
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  surface_.reset();
  return status;
}

Result<PrintedPage> Document::end_page() {
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (kind_ == Kind::pdf && page_ < pages_) {
    cairo_show_page(context_.get());
    status = cairo_status(context_.get());
  } else {
    if (kind_ != Kind::png) cairo_show_page(context_.get());
    status = finish();
  }
  if (status != CAIRO_STATUS_SUCCESS) return Error{path_of_page() + ": " + cairo_status_to_string(status)};
  return PrintedPage{path_of_page(), kind_ == Kind::pdf ? page_ : 1};
}

}  // namespace runmark
