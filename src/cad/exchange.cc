#include "cad/exchange.h"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "base/messages/errors.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;
using nlohmann::json;

json vector_json(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

Vector3d vector_of(const json& v) {
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

json matrix_json(const Eigen::Matrix3d& m) {
  json columns = json::array();
  for (int c = 0; c < 3; ++c) columns.push_back(vector_json(m.col(c)));
  return columns;
}

Eigen::Matrix3d matrix_of(const json& columns) {
  Eigen::Matrix3d m;
  for (int c = 0; c < 3; ++c) m.col(c) = vector_of(columns.at(std::size_t(c)));
  return m;
}

json list_json(const std::vector<Vector3d>& points) {
  json list = json::array();
  for (const Vector3d& point : points) list.push_back(vector_json(point));
  return list;
}

std::vector<Vector3d> list_of(const json& list) {
  std::vector<Vector3d> points;
  for (const json& point : list) points.push_back(vector_of(point));
  return points;
}

json places_json(const std::vector<Refinement::Place>& places) {
  json list = json::array();
  for (const auto& [at, times] : places) {
    list.push_back({{"at", vector_json(at)}, {"times", times}});
  }
  return list;
}

json face_json(const Face& face) {
  const auto name =
      std::ranges::find(kSurfaceNames, face.kind,
                        &std::pair<std::string_view, SurfaceKind>::second);
  return {{"number", face.number},
          {"kind", name->first},
          {"centre", vector_json(face.centre)},
          {"area", face.area},
          {"normal", vector_json(face.normal)},
          {"axis_point", vector_json(face.axis_point)},
          {"axis", vector_json(face.axis)},
          {"radius", face.radius},
          {"hollow", face.hollow},
          {"angle", face.angle},
          {"normal_square", matrix_json(face.normal_square)},
          {"low", face.low},
          {"high", face.high},
          {"label", face.label},
          {"neighbours", face.neighbours}};
}

Face face_of(const json& text) {
  const auto word = text.at("kind").get<std::string>();
  const auto name = std::ranges::find(
      kSurfaceNames, word, &std::pair<std::string_view, SurfaceKind>::first);
  if (name == kSurfaceNames.end()) throw std::runtime_error("kind of a face");
  Face face;
  face.number = text.at("number");
  face.kind = name->second;
  face.centre = vector_of(text.at("centre"));
  face.area = text.at("area");
  face.normal = vector_of(text.at("normal"));
  face.axis_point = vector_of(text.at("axis_point"));
  face.axis = vector_of(text.at("axis"));
  face.radius = text.at("radius");
  face.hollow = text.at("hollow");
  face.angle = text.at("angle");
  face.normal_square = matrix_of(text.at("normal_square"));
  face.low = text.at("low");
  face.high = text.at("high");
  face.label = text.at("label");
  face.neighbours = text.at("neighbours").get<std::vector<int>>();
  return face;
}

json facets_json(const Facets& facets) {
  return {{"points", list_json(facets.points)},
          {"triangles", facets.triangles}};
}

/// @throws std::exception if a corner is no point.
Facets facets_of(const json& text) {
  Facets facets{list_of(text.at("points")),
                text.at("triangles").get<std::vector<std::array<int, 3>>>()};
  for (const auto& corners : facets.triangles) {
    for (const int corner : corners) {
      if (corner < 0 || std::size_t(corner) >= facets.points.size()) {
        throw std::runtime_error("corner of a triangle");
      }
    }
  }
  return facets;
}

}  // namespace

std::string text_of(const Request& request) {
  json text = {{"file", request.file.string()},
               {"format", int(request.format)},
               {"length_unit", request.length_unit},
               {"points", list_json(request.points)},
               {"facets", request.facets},
               {"mesh", request.mesh.string()},
               {"groups", request.groups},
               {"finer", request.finer.everywhere},
               {"finer_at", places_json(request.finer.at)}};
  if (request.mesh_size) text["mesh_size"] = *request.mesh_size;
  if (request.plate) {
    text["plate"] = {{"bottom", request.plate->bottom},
                     {"top", request.plate->top},
                     {"thickness", request.plate->thickness},
                     {"normal", vector_json(request.plate->normal)}};
  }
  return text.dump();
}

Request read_request(const std::string& text) {
  const json found = json::parse(text);
  Request request;
  request.file = found.at("file").get<std::string>();
  request.format = part::GeometryFormat(found.at("format").get<int>());
  request.length_unit = found.at("length_unit");
  request.points = list_of(found.at("points"));
  request.facets = found.at("facets");
  request.mesh = found.at("mesh").get<std::string>();
  request.groups =
      found.at("groups").get<std::map<std::string, std::vector<int>>>();
  request.finer.everywhere = found.at("finer");
  for (const json& place : found.at("finer_at")) {
    request.finer.at.push_back({vector_of(place.at("at")), place.at("times")});
  }
  if (found.contains("mesh_size")) request.mesh_size = found["mesh_size"];
  if (found.contains("plate")) {
    const json& plate = found["plate"];
    request.plate = {plate.at("bottom"), plate.at("top"), plate.at("thickness"),
                     vector_of(plate.at("normal"))};
  }
  return request;
}

std::string answer(const Solid& solid) {
  json faces = json::array();
  for (const Face& face : solid.faces) faces.push_back(face_json(face));
  json facets = json::array();
  for (const Facets& one : solid.facets) facets.push_back(facets_json(one));
  return json{{"unit", solid.unit},
              {"volume", solid.volume},
              {"low", vector_json(solid.low)},
              {"high", vector_json(solid.high)},
              {"faces", faces},
              {"distances", solid.distances},
              {"facets", facets}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string refusal(const std::string& code, const std::string& place,
                    const std::string& problem, const std::string& remedy) {
  return json{{"error",
               {{"code", code},
                {"place", place},
                {"problem", problem},
                {"remedy", remedy}}}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

Solid read_answer(const std::string& text) {
  const json found = json::parse(text);
  if (found.contains("error")) {
    const json& error = found["error"];
    throw Error(error.at("code").get<std::string>(), error.at("place"),
                error.at("problem"), error.at("remedy"));
  }
  Solid solid;
  solid.unit = found.at("unit");
  solid.volume = found.at("volume");
  solid.low = vector_of(found.at("low"));
  solid.high = vector_of(found.at("high"));
  for (const json& face : found.at("faces")) {
    solid.faces.push_back(face_of(face));
  }
  solid.distances =
      found.at("distances").get<std::vector<std::vector<double>>>();
  for (const json& one : found.at("facets")) {
    solid.facets.push_back(facets_of(one));
  }
  return solid;
}

}  // namespace clevis::cad
