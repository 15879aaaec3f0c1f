#include <map>

#include "taut/machine/links/motion_links.hpp"
#include "taut/machine/links/observable.hpp"

namespace taut::machine {
namespace {

class EventReader {
 public:
  EventReader(const description::Event& given, const Model& model, std::string path, Complaints& complaints)
      : given_(given), model_(model), path_(std::move(path)), complaints_(complaints) {}

  Event read() {
    event_.words = "stop";
    event_.at = given_.at;
    if (given_.when) event_.when = condition(*given_.when, model_, path_ + ".when", complaints_);
    event_.over = given_.over;
    if (given_.over > 0 && !given_.breaks) complain(".over", "belongs to a 'break'");
    if (given_.mode && !given_.actuator && !given_.brake) complain(".mode", "belongs to an 'actuator' or a 'brake'");
    const bool driven = given_.speed || given_.torque || given_.pull;
    if (driven && !given_.drive) complain("", "speed, torque and pull belong to a 'drive'");
    if (given_.breaks) breaks();
    const bool other = given_.breaks || given_.actuator || given_.brake || given_.drive;
    if (!given_.stop && !other) complain(".stop", "'stop: false' does nothing; leave the event away");
    if (given_.actuator) actuator();
    if (given_.brake) brake();
    if (given_.drive) drive();
    return std::move(event_);
  }

 private:
  void complain(const char* key, std::string message) { complaints_.push_back({path_ + key, std::move(message)}); }

  /// False where there is none.
  bool set_index(std::optional<int> index) {
    event_.index = index.value_or(0);
    return index.has_value();
  }

  void breaks() {
    event_.kind = EventKind::breaks;
    event_.words = fmt::format("break {}", *given_.breaks);
    if (set_index(index_of(model_.reevings, *given_.breaks))) return;
    // a branch of it is what observers call REEVING[k].T
    if (given_.breaks->back() == ']') {
      if (const auto branch = observable(*given_.breaks + ".T", model_, path_ + ".break", complaints_)) {
        event_.index = branch->index;
        event_.part = branch->part;
      }
      return;
    }
    set_index(named(model_.reevings, *given_.breaks, "reeving", path_ + ".break", complaints_));
  }
  void actuator() {
    static const std::map<std::string, ActuatorMode> modes = {{"extend", ActuatorMode::extend},
                                                              {"retract", ActuatorMode::retract},
                                                              {"lock", ActuatorMode::lock},
                                                              {"free", ActuatorMode::free}};
    event_.kind = EventKind::actuator;
    set_index(named(model_.actuators, *given_.actuator, "actuator", path_ + ".actuator", complaints_));
    const auto mode = modes.find(given_.mode.value_or(""));
    if (mode == modes.end()) return complain(given_.mode ? ".mode" : "", "'mode' is extend, retract, lock or free");
    event_.mode = mode->second;
    event_.words = fmt::format("{} {}", *given_.actuator, *given_.mode);
  }
  void brake() {
    event_.kind = EventKind::brake;
    set_index(named(model_.drums, *given_.brake, "drum", path_ + ".brake", complaints_));
    const std::string mode = given_.mode.value_or("set");
    if (mode != "set" && mode != "open") complain(".mode", "of a brake is set or open");
    event_.brake_set = mode == "set";
    event_.words = fmt::format("brake of {} {}", *given_.brake, mode);
  }
  void drive() {
    event_.kind = EventKind::drive;
    event_.words = fmt::format("drive of {}", *given_.drive);
    event_.of_motor = set_index(index_of(model_.motors, *given_.drive));
    if (!event_.of_motor) {
      set_index(named(model_.drums, *given_.drive, "drum or driven sheave", path_ + ".drive", complaints_));
    }
    if (event_.of_motor && given_.pull) complain(".pull", "belongs to a drum; a sheave has a speed or a torque");
    const auto found = drive_of(given_.speed, given_.torque, given_.pull, model_.signals, path_, complaints_);
    if (found) event_.drive = *found;
    if (!given_.speed && !given_.torque && !given_.pull) complain("", "says no speed, torque or pull for the drive");
  }

  const description::Event& given_;
  const Model& model_;
  std::string path_;
  Complaints& complaints_;
  Event event_;
};

}  // namespace

Event event_of(const description::Event& given, const Model& model, const std::string& path, Complaints& complaints) {
  return EventReader(given, model, path, complaints).read();
}

}  // namespace taut::machine
