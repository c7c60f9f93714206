#pragma once
// Files dropped on a window as a file manager drops them: the source's side of XDND, version 5
// (https://freedesktop.org/wiki/Specifications/XDND).
#include <string>
#include <vector>

namespace vamp::editor_test {

// At a point of the screen, onto the window there that takes drops. Whether it took them.
bool drop_files(const std::string& display, int x, int y, const std::vector<std::string>& paths);

}  // namespace vamp::editor_test
