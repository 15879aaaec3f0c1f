#pragma once
#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace taut::io {

/// Writes files into the folder `place`, which is there and empty: their names, or why it can't.
using FillFolder = std::function<tl::expected<std::vector<std::string>, std::string>(const std::string& place)>;

/// How two folders change their names: in one step, or in two where the file system knows no other way.
enum class Swap { at_once, in_two_steps };

/// Makes `folder` hold what `fill` writes, all of it at once: it is written into a folder beside, which then takes the
/// place of `folder`. Whoever looks, and whenever this is killed, finds the old files or the new ones, each set whole;
/// of two runs at the same time the later one's files stand, whole. (A kill between the steps of Swap::in_two_steps
/// leaves no folder until the next run puts the old one back.)
///
/// The names of the files written stand in the file `list` of the folder. The files of an earlier list are gone
/// afterwards. Everything else in the folder is kept, as hard links; it is an error when a file that is not on the list
/// has a name of the new ones. Folders beside it that killed runs left are removed. `unlisted`: names that count as
/// listed where the folder has no such list.
///
/// Refused: a folder that cannot change its name as a whole (a mount point, the current folder or one above it), or
/// that holds the user's home or is shared with other users; and one with more than most_kept other files. A link to a
/// folder stays; the folder behind it is replaced. The folder is made when missing. The error says why in words.
tl::expected<std::vector<std::string>, std::string> replace_folder(const std::string& folder, const std::string& list,
                                                                   const FillFolder& fill,
                                                                   const std::vector<std::string>& unlisted = {},
                                                                   Swap swap = Swap::at_once);

/// Whether replace_folder could take that folder, as far as this shows before the files are there; changes nothing.
tl::expected<void, std::string> check_replaceable(const std::string& folder);

/// Other files in a folder that are kept, at most: more than these are no folder of results.
inline constexpr int most_kept = 10000;

}  // namespace taut::io
