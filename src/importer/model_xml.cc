#include "importer/model_xml.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <locale>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "base/messages/errors.h"

namespace clevis::importer {
namespace {

using std::string_view;
using tinyxml2::XMLElement;

constexpr std::size_t kMostLines = 2000;
// Far more than a motion can be found of; the libraries recurse over links.
constexpr std::size_t kMostElements = 4000;

/// Elements that are read, by the element around them.
using Known = std::map<string_view, std::set<string_view>>;

const Known& known_of_sdf() {
  static const Known known{
      {"sdf", {"world", "model"}},
      {"world", {"gravity", "model", "frame"}},
      {"model", {"static", "pose", "link", "joint", "frame", "model"}},
      {"frame", {"pose"}},
      {"link", {"pose", "inertial"}},
      {"inertial", {"pose", "mass", "inertia"}},
      {"inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}},
      {"joint", {"parent", "child", "pose", "axis", "axis2", "thread_pitch"}},
      {"axis", {"xyz", "limit", "dynamics", "use_parent_model_frame"}},
      {"axis2", {"xyz", "limit", "dynamics", "use_parent_model_frame"}},
      {"limit", {"lower", "upper", "stiffness", "dissipation"}},
      {"dynamics",
       {"damping", "friction", "spring_stiffness", "spring_reference"}}};
  return known;
}

const Known& known_of_urdf() {
  static const Known known{
      {"robot", {"link", "joint"}},
      {"link", {"inertial"}},
      {"inertial", {"origin", "mass", "inertia"}},
      {"joint", {"origin", "parent", "child", "axis", "limit", "dynamics"}}};
  return known;
}

/// Attributes of URDF elements that are one number.
const Known& numbers_of_urdf() {
  static const Known numbers{
      {"mass", {"value"}},
      {"inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}},
      {"limit", {"lower", "upper", "effort", "velocity"}},
      {"dynamics", {"damping", "friction"}}};
  return numbers;
}

/// What an element is that clevis leaves out.
string_view meaning(string_view element) {
  static const std::map<string_view, string_view> meanings{
      {"visual", "a shape to look at"},
      {"collision", "a shape of contact; bodies pass through one another"},
      {"sensor", "a sensor"},
      {"plugin", "a program; never run"},
      {"gazebo", "settings of a simulator"},
      {"include", "a model in another file; never opened"},
      {"material", "a colour"},
      {"light", "a light"},
      {"actor", "an actor"},
      {"physics", "settings of a simulator"},
      {"scene", "settings of a simulator"},
      {"gui", "settings of a simulator"},
      {"mimic", "a joint that follows another; it moves freely"},
      {"effort", "a bound of a drive that is not there"},
      {"velocity", "a bound of a drive that is not there"},
      {"transmission", "a drive"},
      {"gripper", "a gripper"},
      {"gravity", "a link without gravity; it has its weight"},
      {"world", "a further world"},
      {"model", "a further model"},
      {"use_parent_model_frame",
       "of SDF up to 1.6; the axis stands in the joint's frame"},
      {"initial_position", "a position at the start; it starts at zero"}};
  const auto found = meanings.find(element);
  return found == meanings.end() ? "not known to clevis" : found->second;
}

/// As liburdfdom takes it.
bool is_number(const char* text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return !stream.fail() && stream.eof();
}

/// One line that a terminal and a comment can take, whatever the file holds.
std::string printable(string_view text) {
  constexpr std::size_t kLongest = 64;
  std::string line(text.substr(0, kLongest));
  std::ranges::replace_if(
      line,
      [](unsigned char c) {
        return c < ' ' || c == 0x7F;
      },
      '?');
  return line;
}

bool is_default(const XMLElement& element) {
  static const std::map<string_view, std::set<string_view>> defaults{
      {"gravity", {"1", "true"}},
      {"use_parent_model_frame", {"0", "false"}},
      {"self_collide", {"0", "false"}},
      {"kinematic", {"0", "false"}},
      {"enable_wind", {"0", "false"}},
      {"allow_auto_disable", {"0", "1", "false", "true"}}};
  const string_view name = element.Name();
  const char* text = element.GetText();
  if (text == nullptr) return false;
  if (name == "effort" || name == "velocity") {
    constexpr double kNoBound = 1e15;  // -1, 1e16 and infinity mean none
    double bound = 0.0;
    return element.QueryDoubleText(&bound) == tinyxml2::XML_SUCCESS &&
           !(bound >= 0.0 && bound < kNoBound);
  }
  const auto found = defaults.find(name);
  return found != defaults.end() && found->second.contains(text);
}

const std::set<string_view> kCounted{"link", "joint", "frame", "model"};

class Stripper {
 public:
  Stripper(const Known& known, const std::string& file, ModelXml& result)
      : known_(known), file_(file), result_(result) {}

  /// tinyxml2 refuses more than 500 elements in one another.
  void strip(XMLElement& element, const std::string& path) {
    const auto known = known_.find(element.Name());
    XMLElement* next = element.FirstChildElement();
    while (next != nullptr) {
      XMLElement& child = *next;
      next = child.NextSiblingElement();
      const string_view name = child.Name();
      const std::string here = fmt::format("{}/{}", path, title(child));
      // A leaf: whatever is in it means nothing to its reader.
      const bool is_read =
          known != known_.end() && known->second.contains(name);
      if (is_read && !is_further(element, name)) {
        count_ += kCounted.contains(name) ? 1 : 0;
        if (result_.is_urdf) require_numbers(child, here);
        tell_urdf_bounds(child, here);
        strip(child, here);
        continue;
      }
      if (!is_default(child)) tell(here, meaning(name));
      element.DeleteChild(&child);
    }
  }

  /// Links, joints, frames and models that are read.
  std::size_t count() const { return count_; }

 private:
  static std::string title(const XMLElement& element) {
    const char* name = element.Attribute("name");
    if (name == nullptr) return printable(element.Name());
    return fmt::format("{} {}", printable(element.Name()), printable(name));
  }

  /// Of several worlds and models the first is read.
  bool is_further(const XMLElement& parent, string_view name) {
    if (string_view(parent.Name()) != "sdf") return false;
    if (first_.empty()) first_ = name;
    return name != first_ || roots_++ > 0;
  }

  /// liburdfdom would take a link whose mass is no number for one without.
  /// @throws Error S014.
  void require_numbers(const XMLElement& element,
                       const std::string& path) const {
    const auto numbers = numbers_of_urdf().find(element.Name());
    if (numbers == numbers_of_urdf().end()) return;
    for (const string_view name : numbers->second) {
      const char* text = element.Attribute(std::string(name).c_str());
      if (text == nullptr || is_number(text)) continue;
      throw Error("S014", fmt::format("{}:{}:1", file_, element.GetLineNum()),
                  fmt::format("{}: {} = \"{}\" is no number", path, name,
                              printable(text)),
                  "Write one number, without a unit.");
    }
  }

  void tell_urdf_bounds(const XMLElement& child, const std::string& path) {
    if (!result_.is_urdf || string_view(child.Name()) != "limit") return;
    for (const char* bound : {"effort", "velocity"}) {
      if (child.DoubleAttribute(bound) > 0.0) {
        tell(path + "/" + bound, meaning(bound));
      }
    }
  }

  void tell(const std::string& path, string_view what) {
    if (result_.lost.size() < kMostLines) {
      result_.lost.push_back(fmt::format("{}: {}", path, what));
    } else if (result_.lost.size() == kMostLines) {
      result_.lost.emplace_back("and more: the list is too long");
    }
  }

  const Known& known_;
  const std::string& file_;
  ModelXml& result_;
  std::string first_;
  int roots_ = 0;
  std::size_t count_ = 0;
};

[[noreturn]] void refuse_root(const std::string& file, string_view root) {
  throw Error("S013", file,
              fmt::format("the root element is <{}>", printable(root)),
              "Give an SDF file (<sdf>) or a URDF file (<robot>).");
}

using Version = std::pair<int, int>;

/// Nothing if the file gives none.
std::optional<Version> version_of(const XMLElement& root) {
  const char* version = root.Attribute("version");
  Version found{0, 0};
  if (version == nullptr || std::sscanf(version, "%d.%d",  // NOLINT
                                        &found.first, &found.second) < 1) {
    return std::nullopt;
  }
  return found;
}

/// What later versions renamed or made anew would be lost or taken for
/// something else.
void require_known_version(const XMLElement& root, const std::string& file) {
  constexpr Version kLast{1, 9};  // of libsdformat12
  const auto version = version_of(root);
  if (!version || *version <= kLast) return;
  throw Error("S014", file,
              fmt::format("it is SDF {}, up to {}.{} is read",
                          printable(root.Attribute("version")), kLast.first,
                          kLast.second),
              "Export the model as an older version.");
}

/// libsdformat turns use_parent_model_frame into a frame up to 1.6 and passes
/// over it from then on.
Known known_of_sdf(const XMLElement& root) {
  constexpr Version kFrameOfAxes{1, 7};
  Known known = known_of_sdf();
  const auto version = version_of(root);
  if (version && *version < kFrameOfAxes) return known;
  for (const char* axis : {"axis", "axis2"}) {
    known.at(axis).erase("use_parent_model_frame");
  }
  return known;
}

bool is_xacro(const XMLElement& element) {
  if (string_view(element.Name()).starts_with("xacro:")) return true;
  for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (is_xacro(*child)) return true;
  }
  return false;
}

}  // namespace

ModelXml model_xml(const std::string& text, const std::string& file) {
  for (const string_view declared : {"<!DOCTYPE", "<!ENTITY"}) {
    if (text.find(declared) == std::string::npos) continue;
    throw Error("S014", file, fmt::format("the file has a {}", declared),
                "Write entities out and remove the declaration; neither SDF "
                "nor URDF has any.");
  }
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    throw Error("S014", fmt::format("{}:{}:1", file, document.ErrorLineNum()),
                fmt::format("no XML: {}", document.ErrorName()),
                "Repair the file or export it again.");
  }
  XMLElement* root = document.RootElement();
  if (root == nullptr) refuse_root(file, "");
  ModelXml result;
  result.is_urdf = string_view(root->Name()) == "robot";
  if (!result.is_urdf && string_view(root->Name()) != "sdf") {
    refuse_root(file, root->Name());
  }
  if (!result.is_urdf) require_known_version(*root, file);
  if (is_xacro(*root)) {
    throw Error("S013", file, "the file is a xacro file, not yet a URDF",
                "Expand it with `xacro` and import what that writes.");
  }
  const Known known = result.is_urdf ? known_of_urdf() : known_of_sdf(*root);
  Stripper stripper(known, file, result);
  stripper.strip(*root, printable(root->Name()));
  if (stripper.count() > kMostElements) {
    throw Error("S015", file,
                fmt::format("it has {} links, joints, frames and models, {} "
                            "are the most",
                            stripper.count(), kMostElements),
                "Import one mechanism alone.");
  }
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  result.text = printer.CStr();
  return result;
}

}  // namespace clevis::importer
