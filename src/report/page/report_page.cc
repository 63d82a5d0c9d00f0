#include "report/page/report_page.h"

#include <fmt/format.h>

#include "base/bytes/base64.h"
#include "base/bytes/compression.h"
#include "report/page/page_assets.h"
#include "report/page/watch_mark.h"
#include "report/stored/packed_part.h"
#include "report/text/atomic_file.h"
#include "report/text/markup.h"

namespace clevis::report {
namespace {

std::string data_element(std::string_view id, std::string_view json) {
  return fmt::format(
      "<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
      escape_json_for_html(json));
}

/// The fields of a part: most of a page, a fifth of it when packed.
std::string packed_element(std::string_view id, std::string_view json) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", id,
                     base64(compressed(packed_part(json))));
}

std::string head(const std::string& title, const char* pictures) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src "
      "'none'; {}; img-src {}; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n"
      "<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n",
      viewer_policy(), pictures, escape_markup(title), viewer_style());
}

}  // namespace

std::string escape_json_for_html(std::string_view json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string report_page(const StoredPage& page, std::optional<int> watch_run) {
  std::string html = head(page.title, watch_run ? "data: file:" : "data:");
  html +=
      "<body>\n<div id=\"report\"><noscript>This report needs JavaScript; it "
      "loads nothing from elsewhere. Its numbers also stand in result.json."
      "</noscript></div>\n";
  html += data_element("result", page.result);
  html += data_element("motion", page.motion);
  for (std::size_t p = 0; p < page.parts.size(); ++p) {
    html += packed_element(fmt::format("part-{}", p), page.parts[p]);
  }
  for (std::size_t s = 0; s < page.shapes.size(); ++s) {
    html += packed_element(fmt::format("shape-{}", s), page.shapes[s]);
  }
  if (watch_run) {
    html += data_element("watch", fmt::format(R"({{"run":{},"mark":"{}"}})",
                                              *watch_run, kWatchMark));
  }
  html +=
      fmt::format("<script>{}</script>\n</body>\n</html>\n", viewer_script());
  return html;
}

std::filesystem::path write_report(const std::filesystem::path& folder,
                                   ResultKind kind,
                                   std::optional<int> watch_run) {
  const std::filesystem::path file = folder / "report.html";
  write_file(file, report_page(read_result_folder(folder, kind), watch_run));
  return file;
}

}  // namespace clevis::report
