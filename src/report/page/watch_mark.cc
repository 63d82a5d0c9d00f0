#include "report/page/watch_mark.h"

#include <fmt/format.h>

#include "report/text/atomic_file.h"

namespace clevis::report {

void write_watch_mark(const std::filesystem::path& folder, int run,
                      WatchState state) {
  write_file(folder / kWatchMark,
             fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" "
                         "width=\"{}\" height=\"{}\"/>\n",
                         run, static_cast<int>(state)));
}

}  // namespace clevis::report
