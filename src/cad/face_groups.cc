#include "cad/face_groups.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "cad/cylinders.h"
#include "cad/joint_cylinder.h"
#include "cad/pin_bores.h"
#include "cad/select_faces.h"

namespace clevis::cad {
namespace {

/// @throws Error M012.
void add(const std::string& group, const std::vector<int>& faces,
         const std::string& place, FaceGroups& groups) {
  for (const auto& [other, taken] : groups.faces) {
    for (const int face : faces) {
      if (std::ranges::find(taken, face) == taken.end()) continue;
      throw Error("M012", place,
                  fmt::format("face {} would be in the groups {} and {}", face,
                              other, group),
                  "Let every face belong to one group at most.");
    }
  }
  groups.faces[group] = faces;
}

bool has(const std::vector<int>& faces, const Cylinder& piece) {
  return std::ranges::any_of(piece.faces, [&](int face) {
    return std::ranges::find(faces, face) != faces.end();
  });
}

/// A pin goes through all pieces of its bore: tells where a selector left some
/// out, and no other has them.
void tell_left_out(const std::vector<PinBore>& bores,
                   const part::NamedFaces& named, FaceGroups& groups) {
  const std::vector<int>& taken = groups.faces.at(named.group);
  for (const PinBore& bore : bores) {
    if (std::ranges::none_of(bore.pieces, [&](const Cylinder& piece) {
          return has(taken, piece);
        })) {
      continue;
    }
    for (const Cylinder& piece : bore.pieces) {
      if (std::ranges::any_of(groups.faces, [&](const auto& group) {
            return has(group.second, piece);
          })) {
        continue;
      }
      groups.told.push_back(fmt::format(
          "{}: only a part of its bore, {} is on the same axis; all_of takes "
          "them together",
          named.group, text_of(piece)));
    }
  }
}

}  // namespace

FaceGroups face_groups(const Solid& solid,
                       const std::vector<Eigen::Vector3d>& points,
                       const part::SolidSource& source) {
  FaceGroups groups;
  for (const part::JointFaces& joint : source.joints) {
    std::vector<int> faces;
    for (const Cylinder& cylinder : joint_cylinders(solid, joint)) {
      faces.insert(faces.end(), cylinder.faces.begin(), cylinder.faces.end());
      groups.told.push_back(
          fmt::format("joint {}: {}", joint.joint, text_of(cylinder)));
    }
    add(joint.group, faces, joint.place, groups);
  }
  for (const part::NamedFaces& named : source.faces) {
    add(named.group, select_faces(solid, points, named.selector),
        named.selector.place, groups);
  }
  if (source.faces.empty()) return groups;
  const std::vector<PinBore> bores = pin_bores(solid);
  for (const part::NamedFaces& named : source.faces) {
    tell_left_out(bores, named, groups);
  }
  return groups;
}

void add_rounds(const Solid& solid, FaceGroups& groups) {
  constexpr double kLeastTurn = 0.2;  // [rad]: less hardly tells its axis
  for (const Cylinder& cylinder : cylinders_of(solid)) {
    const bool is_free = std::ranges::none_of(groups.faces, [&](const auto& g) {
      return std::ranges::any_of(cylinder.faces, [&](int face) {
        return std::ranges::find(g.second, face) != g.second.end();
      });
    });
    const std::string name =
        fmt::format("{}{}", kRound, cylinder.faces.front());
    if (is_free && cylinder.angle >= kLeastTurn) {
      groups.faces.try_emplace(name, cylinder.faces);
    }
  }
}

}  // namespace clevis::cad
