#include "app/command_list.h"

#include <algorithm>
#include <array>

#include "app/commands/explain_command.h"
#include "app/commands/faces_command.h"
#include "app/commands/impact_command.h"
#include "app/commands/mesh_command.h"
#include "app/commands/simulate_command.h"
#include "app/commands/transmission_command.h"
#include "app/plugin/check_command.h"
#include "app/plugin/export_command.h"
#include "app/plugin/modes_command.h"
#include "app/plugin/study_command.h"
#include "app/results/compare_command.h"
#include "app/results/picture_command.h"
#include "app/results/report_command.h"
#include "app/start/completion.h"
#include "app/start/doctor_command.h"
#include "app/start/import_command.h"
#include "app/start/init_command.h"
#include "app/variants/collect_command.h"
#include "app/variants/plan_command.h"

namespace clevis::app {

std::span<const Command> commands() {
  static constexpr std::array kCommands{
      Command{"check", "does every part hold over the motion and its cases?",
              declare_check, Memory::kMuch, Ranks::kAll},
      Command{"simulate", "the mechanism alone: structure, motion, reactions",
              declare_simulate},
      Command{"transmission",
              "compliance, frequencies and error of drive trains",
              declare_transmission},
      Command{"impact",
              "ejectors by beam theory: blow on the workpiece, limits",
              declare_impact},
      Command{"mesh", "(re)build the meshes of a scene's parts", declare_mesh},
      Command{"faces", "the faces of a STEP, IGES or BREP solid",
              declare_faces},
      Command{"study",
              "speed against error: every model and degree, and CalculiX",
              declare_study, Memory::kMuch},
      Command{"modes", "free vibrations of the parts: frequencies and shapes",
              declare_modes, Memory::kMuch},
      Command{"export", "the parts as CalculiX decks, or a result as glTF",
              declare_export},
      Command{"plan", "commands that check many variants of a scene",
              declare_plan},
      Command{"collect",
              "the results of a plan: table, plot, lightest that passes",
              declare_collect},
      Command{"report", "a result as one HTML file to look at and pass on",
              declare_report},
      Command{"picture", "a result as a picture: the mechanism, or a part",
              declare_picture},
      Command{"compare", "regression check against a baseline",
              declare_compare},
      Command{"explain", "what a diagnostic means and what to do",
              declare_explain},
      Command{"init", "write a commented scene that runs", declare_init},
      Command{"import", "a scene of an SDF or URDF model, and what was lost",
              declare_import},
      Command{"doctor", "what is installed, and what it is needed for",
              declare_doctor},
      Command{"completion", "completion of commands in a shell",
              declare_completion}};
  return kCommands;
}

const Command* find_command(std::string_view name) {
  const auto found = std::ranges::find(commands(), name, &Command::name);
  return found == commands().end() ? nullptr : &*found;
}

}  // namespace clevis::app
