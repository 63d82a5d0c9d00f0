#include "app/start/templates.h"

#include <template_texts.h>  // made by CMake of templates and geometry

namespace clevis::app {
namespace {

constexpr TemplateFile kPart[] = {{"scene.toml", texts::kPartScene},
                                  {"link.geo", texts::kPartLink}};
constexpr TemplateFile kFourBar[] = {{"scene.toml", texts::kFourBarScene},
                                     {"coupler.geo", texts::kFourBarCoupler}};
constexpr TemplateFile kSliderCrank[] = {
    {"scene.toml", texts::kSliderCrankScene},
    {"rod.geo", texts::kSliderCrankRod}};
constexpr TemplateFile kLandingGear[] = {
    {"scene.toml", texts::kLandingGearScene},
    {"link_ab.geo", texts::kLandingGearLinkAb},
    {"link_bc.geo", texts::kLandingGearLinkBc},
    {"link_dce.geo", texts::kLandingGearLinkDce},
    {"cylinder_body.geo", texts::kLandingGearCylinderBody},
    {"rod.geo", texts::kLandingGearRod}};

constexpr Template kTemplates[] = {
    {"part", "a link alone, pulled by its pins", kPart},
    {"four-bar", "a crank-rocker whose coupler is a part", kFourBar},
    {"slider-crank", "a piston whose connecting rod is a part", kSliderCrank},
    {"landing-gear", "five parts of a landing gear on its cylinder",
     kLandingGear}};

}  // namespace

std::span<const Template> templates() {
  return kTemplates;
}

std::string_view scene_schema() {
  return texts::kSceneSchema;
}

}  // namespace clevis::app
