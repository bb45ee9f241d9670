#include "print_command.h"

#include <cmath>
#include <memory>

#include "errors.h"
#include "id_list.h"
#include "output_file.h"
#include "pose_settings.h"
#include "runmark/board_file.h"
#include "runmark/print.h"

namespace runmark::cli {
namespace {

struct PrintSettings {
  std::string dictionary;
  std::string ids;
  std::string board;
  std::string output;
  double size = 40;
  std::string paper = "A4";
  std::string unit = "mm";
  PrintStyle style;
};

double millimetres_of(const std::string& unit) {
  return unit == "m" ? 1000 : unit == "cm" ? 10 : unit == "inch" ? 25.4 : 1;
}

void report(const std::vector<PrintedPage>& pages, const std::string& what) {
  std::string text;
  for (const PrintedPage& page : pages) {
    if (text.find(page.path + '\n') == std::string::npos) text += page.path + '\n';
  }
  OutputFile output;
  output.write(text.substr(0, text.size() - 1) + ": " + what + ", " + std::to_string(pages.size()) +
               (pages.size() == 1 ? " page\n" : " pages\n"));
  output.close();
}

void print_a_board(const PrintSettings& settings, const Paper& sheet) {
  if (!settings.ids.empty()) throw UserError("--board and --ids do not go together");
  const Board board = value_or_throw(load_board(settings.board));
  const double unit = millimetres_of(settings.unit);
  const auto& corners = board.markers[0].corners;
  const double marker = std::fabs(corners[1].x - corners[0].x) * unit;
  if (board.charuco || board.grid) {
    if (marker < 2) {
      throw UserError(settings.board + ": its markers would be " + std::to_string(marker) +
                      " mm wide; which unit are its lengths in (--unit)?");
    }
  }
  const Dictionary dictionary = value_or_throw(load_dictionary(board.markers[0].dictionary));
  report(value_or_throw(print_board(settings.output, dictionary, board, unit, sheet, settings.style)),
         std::to_string(board.markers.size()) + " markers");
}

void print(const PrintSettings& settings) {
  const Paper sheet = value_or_throw(paper(settings.paper));
  if (!settings.board.empty()) return print_a_board(settings, sheet);
  if (settings.dictionary.empty() || settings.ids.empty())
    throw UserError("print needs --dict and --ids, or --board");
  const Dictionary dictionary = value_or_throw(load_dictionary(settings.dictionary));
  const std::vector<int> ids = parse_ids(settings.ids);
  report(
      value_or_throw(print_markers(settings.output, dictionary, ids, settings.size, sheet, settings.style)),
      std::to_string(ids.size()) + (ids.size() == 1 ? " marker" : " markers"));
}

}  // namespace

void add_print_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("print", "Put markers and boards on paper, at true size");
  const auto settings = std::make_shared<PrintSettings>();
  command
      ->add_option("-d,--dict", settings->dictionary,
                   "Dictionary: a built-in name or the path of a .codes file")
      ->type_name("NAME");
  command->add_option("--ids", settings->ids, "Markers to print, such as 0-11,15")->type_name("IDS");
  command
      ->add_option("-o,--output", settings->output,
                   "A .pdf, .svg or .png file; several pages of the last two get numbers")
      ->required()
      ->type_name("FILE");
  command->add_option("--size", settings->size, "Side of a marker's black square, in millimetres")
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--board", settings->board, std::string(board_help) + ", instead of single markers")
      ->type_name("BOARD");
  command->add_option("--unit", settings->unit, "Unit of the board's lengths")
      ->check(CLI::IsMember({"mm", "cm", "m", "inch"}).description(""))
      ->capture_default_str()
      ->type_name("mm|cm|m|inch");
  command
      ->add_option("--paper", settings->paper,
                   "A3, A4, A5, Letter, Legal, Tabloid, with -landscape, or WIDTHxHEIGHT in mm")
      ->capture_default_str()
      ->type_name("NAME");
  command
      ->add_option("--margin", settings->style.margin_cells, "White round a marker, in its cells; at least 1")
      ->check(CLI::Range(1.0, 20.0).description(""))
      ->capture_default_str()
      ->type_name("CELLS");
  command->add_option("--dpi", settings->style.dpi, "Pixels an inch of a .png")
      ->check(CLI::Range(30, 2400).description(""))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--inverted", settings->style.inverted, "White on black");
  command->add_flag("!--no-labels", settings->style.labels, "Print no dictionary, id and size beneath");
  command->add_flag("!--no-cut-marks", settings->style.cut_marks,
                    "Print no marks at the corners of the white margin");
  command->add_flag("!--no-ruler", settings->style.ruler, "Print no ruler at the foot of the page");
  command->callback([settings] { print(*settings); });
}

}  // namespace runmark::cli
