#include "multibody/exchange.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace clevis::multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

/// A name in the file need not be UTF-8.
std::string text_of(const json& document) {
  return document.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// JSON has no other numbers than finite ones; who asks names those (S015).
json number_json(double value) {
  return std::isfinite(value) ? json(value) : json("not finite");
}

double number_of(const json& value) {
  return value.is_string() ? std::numeric_limits<double>::quiet_NaN()
                           : value.get<double>();
}

json vector_json(const Vector3d& v) {
  return {number_json(v.x()), number_json(v.y()), number_json(v.z())};
}

Vector3d vector_of(const json& v) {
  return {number_of(v.at(0)), number_of(v.at(1)), number_of(v.at(2))};
}

json matrix_json(const Matrix3d& m) {
  return {vector_json(m.row(0)), vector_json(m.row(1)), vector_json(m.row(2))};
}

Matrix3d matrix_of(const json& rows) {
  Matrix3d m;
  for (Eigen::Index i = 0; i < 3; ++i) {
    m.row(i) = vector_of(rows.at(static_cast<std::size_t>(i)));
  }
  return m;
}

json optional_json(const std::optional<double>& value) {
  return value ? number_json(*value) : json();
}

std::optional<double> optional_of(const json& value) {
  if (value.is_null()) return {};
  return number_of(value);
}

json axis_json(const Axis& axis) {
  return {{"direction", vector_json(axis.direction)},
          {"lower", optional_json(axis.lower)},
          {"upper", optional_json(axis.upper)},
          {"stop_stiffness", number_json(axis.stop_stiffness)},
          {"stop_damping", number_json(axis.stop_damping)},
          {"damping", number_json(axis.damping)},
          {"friction", number_json(axis.friction)},
          {"spring_stiffness", number_json(axis.spring_stiffness)},
          {"spring_reference", number_json(axis.spring_reference)}};
}

Axis axis_of(const json& text) {
  return {.direction = vector_of(text.at("direction")),
          .lower = optional_of(text.at("lower")),
          .upper = optional_of(text.at("upper")),
          .stop_stiffness = number_of(text.at("stop_stiffness")),
          .stop_damping = number_of(text.at("stop_damping")),
          .damping = number_of(text.at("damping")),
          .friction = number_of(text.at("friction")),
          .spring_stiffness = number_of(text.at("spring_stiffness")),
          .spring_reference = number_of(text.at("spring_reference"))};
}

json link_json(const Link& link) {
  return {{"name", link.name},
          {"origin", vector_json(link.p_WL)},
          {"rotation", matrix_json(link.R_WL)},
          {"mass", number_json(link.mass)},
          {"center_of_mass", vector_json(link.p_LCm)},
          {"inertia", matrix_json(link.inertia_LCm)},
          {"is_fixed", link.is_fixed}};
}

Link link_of(const json& text) {
  return {.name = text.at("name"),
          .p_WL = vector_of(text.at("origin")),
          .R_WL = matrix_of(text.at("rotation")),
          .mass = number_of(text.at("mass")),
          .p_LCm = vector_of(text.at("center_of_mass")),
          .inertia_LCm = matrix_of(text.at("inertia")),
          .is_fixed = text.at("is_fixed")};
}

json joint_json(const Joint& joint) {
  json axes = json::array();
  for (const Axis& axis : joint.axes) axes.push_back(axis_json(axis));
  return {{"name", joint.name},
          {"type", joint.type},
          {"parent", joint.parent},
          {"child", joint.child},
          {"axes", axes},
          {"point", vector_json(joint.point)},
          {"lead", number_json(joint.lead)}};
}

Joint joint_of(const json& text) {
  Joint joint{.name = text.at("name"),
              .type = text.at("type"),
              .parent = text.at("parent"),
              .child = text.at("child"),
              .point = vector_of(text.at("point")),
              .axes = {},
              .lead = number_of(text.at("lead"))};
  for (const json& axis : text.at("axes")) joint.axes.push_back(axis_of(axis));
  return joint;
}

}  // namespace

std::string answer(const Model& model) {
  json links = json::array(), joints = json::array();
  for (const Link& link : model.links) links.push_back(link_json(link));
  for (const Joint& joint : model.joints) joints.push_back(joint_json(joint));
  return text_of(
      {{"name", model.name},
       {"gravity", model.gravity ? vector_json(*model.gravity) : json()},
       {"links", links},
       {"joints", joints},
       {"told", model.told}});
}

std::string refusal(const Error& error) {
  return text_of({{"error",
                   {{"code", error.code()},
                    {"place", error.place()},
                    {"problem", error.problem()},
                    {"remedy", error.remedy()}}}});
}

Model read_answer(const std::string& text) {
  const json found = json::parse(text);
  if (found.contains("error")) {
    const json& error = found["error"];
    throw Error(error.at("code").get<std::string>(), error.at("place"),
                error.at("problem"), error.at("remedy"));
  }
  Model model;
  model.name = found.at("name");
  if (!found.at("gravity").is_null()) {
    model.gravity = vector_of(found["gravity"]);
  }
  for (const json& link : found.at("links")) {
    model.links.push_back(link_of(link));
  }
  for (const json& joint : found.at("joints")) {
    model.joints.push_back(joint_of(joint));
  }
  model.told = found.at("told").get<std::vector<std::string>>();
  return model;
}

}  // namespace clevis::multibody
