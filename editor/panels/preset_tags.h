#pragma once
// The tags that presets share, as a line of switches above them: "leather", "textile".
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/preset_library.h"

namespace vamp::ui {

// Tags that at least two presets bear but not all of them, the most frequent first, then by name; at most eight. None
// for a handful of presets.
std::vector<std::string> common_tags(const std::vector<LibraryEntry>& entries);

bool has_tag(const LibraryEntry& entry, std::string_view tag);

// A line of small buttons, as many as fit: the others are found by typing them. The chosen tag is lit, and pressing it
// again lets all presets show. An empty `chosen` is "all".
void tag_row(const std::vector<std::string>& tags, std::string& chosen);

}  // namespace vamp::ui
