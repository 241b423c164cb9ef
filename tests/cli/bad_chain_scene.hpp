#pragma once

#include "tests/cli/bad_input.hpp"

namespace plastica::testing {

inline constexpr const char* kChainScene =
    "[beam]\n"                                                                // 1
    "length = '4 m'\n"                                                        // 2
    "segments = 8\n"                                                          // 3
    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"  // 4
    "material = 'S355'\n"                                                     // 5
    "[rules]\n"                                                               // 6
    "yield_model = 'interaction'\n"                                           // 7
    "[solver]\n"                                                              // 8
    "steps = 10\n"                                                            // 9
    "[[support]]\n"                                                           // 10
    "at = 'start'\n"                                                          // 11
    "kind = 'clamp'\n"                                                        // 12
    "[[support]]\n"                                                           // 13
    "at = 0.5\n"                                                              // 14
    "kind = 'elastic'\n"                                                      // 15
    "stiffness = ['0 N/m', '1 kN/m', '0 N/m']\n"                              // 16
    "[[load]]\n"                                                              // 17
    "at = 'end'\n"                                                            // 18
    "force = ['0 N', '-100 N', '0 N']\n"                                      // 19
    "history = 'ramp'\n"                                                      // 20
    "[[probe]]\n"                                                             // 21
    "name = 'tip'\n"                                                          // 22
    "kind = 'displacement'\n"                                                 // 23
    "at = 'end'\n";                                                           // 24

/// The scene with one piece changed, and the line that `simulate` answers with behind the file.
inline BadInput change_chain(std::string name, const std::string& from, const std::string& to,
                             const std::string& line) {
  return bad_scene(std::move(name), changed(kChainScene, from, to), line);
}

/// The scene with more at its end, from line 25 on.
inline BadInput add_to_chain(std::string name, const std::string& text, const std::string& line) {
  const std::string last = "at = 'end'\n";
  return change_chain(std::move(name), "'displacement'\n" + last, "'displacement'\n" + last + text,
                      line);
}

}  // namespace plastica::testing
