#!/usr/bin/env bash
# tests/full/debian_package.sh BUILD SCRATCH: makes the package for Debian of a build, has lintian look
# at it, unpacks it, and runs the command and builds a user's program from what it holds.
set -euo pipefail

build=${1:?needs the build folder}
scratch=${2:?needs a scratch folder}
rm -rf "$scratch"
mkdir -p "$scratch"
cd "$scratch"

cpack --config "$build/CPackConfig.cmake" -B "$scratch/made"
package=$(echo "$scratch"/made/plastica_*.deb)
lintian --allow-root --fail-on error "$package"

root=$scratch/root
dpkg-deb -x "$package" "$root"
for path in bin/plastica lib/libplastica.a share/man/man1/plastica.1.gz \
  share/doc/plastica/copyright share/bash-completion/completions/plastica; do
  [ -s "$root/usr/$path" ] || { echo "the package lacks $path" >&2; exit 1; }
done

"$root/usr/bin/plastica" init scene -d "$scratch"
"$root/usr/bin/plastica" simulate "$scratch/scene.toml" -o "$scratch/scene.h5"

mkdir "$scratch/user"
cat >"$scratch/user/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(user CXX)
find_package(plastica REQUIRED)
add_executable(user user.cpp)
target_link_libraries(user plastica::plastica)
END
cat >"$scratch/user/user.cpp" <<'END'
#include <plastica/base/version.hpp>

#include <iostream>

int main() { std::cout << plastica::version() << '\n'; }
END
cmake -S "$scratch/user" -B "$scratch/user/build" -DCMAKE_PREFIX_PATH="$root/usr"
cmake --build "$scratch/user/build"
[ "$("$scratch/user/build/user")" = "$("$root/usr/bin/plastica" --version)" ]
