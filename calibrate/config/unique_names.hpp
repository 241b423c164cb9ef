#pragma once

#include <map>
#include <set>
#include <string>

namespace plastica::calibrate {

/// Names of which no two are alike: the second of a name becomes "name#2".
class UniqueNames {
 public:
  /// Takes a name, or the next one of it that is free.
  std::string add(const std::string& name) {
    std::string found = name;
    for (int& uses = uses_[name]; !taken_.insert(found).second;) {
      uses = uses < 2 ? 2 : uses + 1;
      found = name + "#" + std::to_string(uses);
    }
    return found;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> uses_;  // the last number tried of a name
};

}  // namespace plastica::calibrate
