#pragma once
#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "taut/io/deck/node.hpp"
#include "taut/io/file_reader.hpp"

namespace taut::io {

/// The text of a regular file, cut one byte behind largest_deck. Everything else is refused unopened, as it could hold
/// the program up for ever or have side effects: folders, pipes, sockets, devices.
tl::expected<std::string, Unreadable> read_file(const std::string& path);

/// The same from a descriptor that is open already, whatever stands behind it: standard input, a pipe of the shell.
tl::expected<std::string, Unreadable> read_open(int descriptor, const std::string& name);

/// Gives a file that was written beside its place its name, so that after a power cut the name has all that was
/// written, or what it had before: the file is on the disk before it is renamed, its folder after it. The error: why it
/// was not, in words.
tl::expected<void, std::string> put_in_place(const std::string& written, const std::string& path);

/// The text of a file that a deck with that source names: by the reader of its reading, else by read_file.
tl::expected<std::string, Unreadable> read_beside(const Source& source, const std::string& path);

/// A file that a deck names: its text, and what messages call it.
struct NamedFile {
  std::string path;
  std::string text;
};

/// Reads the file that the text at `node` names, relative to the folder of the deck that names it, and notes it in the
/// reading of that deck. A mistake at the node when it can't be read.
std::optional<NamedFile> read_named(const Node& node, const std::string& name, Diagnostics& mistakes);

}  // namespace taut::io
