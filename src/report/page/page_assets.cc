#include "report/page/page_assets.h"

// Puts a file into the read-only data of the object.
#define CLEVIS_EMBED(name, file)                                               \
  asm(".section .rodata\n"                                                     \
      ".global clevis_" #name                                                  \
      "\n"                                                                     \
      "clevis_" #name                                                          \
      ":\n"                                                                    \
      ".incbin \"" CLEVIS_VIEWER_FOLDER "/" file                               \
      "\"\n"                                                                   \
      ".global clevis_" #name                                                  \
      "_end\n"                                                                 \
      "clevis_" #name                                                          \
      "_end:\n"                                                                \
      ".byte 0\n"                                                              \
      ".previous\n");                                                          \
  extern "C" __attribute__((visibility("hidden"))) const char clevis_##name[]; \
  extern "C" __attribute__((visibility("hidden")))                             \
  const char clevis_##name##_end[];

CLEVIS_EMBED(viewer_script, "dist/viewer.js")
CLEVIS_EMBED(viewer_style, "dist/viewer.css")
CLEVIS_EMBED(viewer_policy, "dist/viewer.csp")
CLEVIS_EMBED(viewer_colours, "src/viridis.json")

#undef CLEVIS_EMBED

namespace clevis::report {

std::string_view viewer_script() {
  return {clevis_viewer_script, clevis_viewer_script_end};
}

std::string_view viewer_style() {
  return {clevis_viewer_style, clevis_viewer_style_end};
}

std::string_view viewer_policy() {
  return {clevis_viewer_policy, clevis_viewer_policy_end};
}

std::string_view viewer_colours() {
  return {clevis_viewer_colours, clevis_viewer_colours_end};
}

}  // namespace clevis::report
