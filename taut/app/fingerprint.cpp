#include "taut/app/fingerprint.hpp"

#include <fmt/format.h>

#include <boost/uuid/detail/sha1.hpp>

namespace taut::app {

std::string fingerprint(std::string_view text) {
  boost::uuids::detail::sha1 sha;
  sha.process_bytes(text.data(), text.size());
  boost::uuids::detail::sha1::digest_type digest{};
  sha.get_digest(digest);
  std::string hex;
  for (const unsigned int word : digest) hex += fmt::format("{:08x}", word);
  return hex;
}

std::string fingerprint(std::string_view deck, const std::vector<std::string>& files,
                        const std::vector<std::string>& set) {
  if (files.empty() && set.empty()) return fingerprint(deck);
  std::string list = fmt::format("deck {}\n", fingerprint(deck));
  for (const std::string& file : files) list += fmt::format("file {}\n", fingerprint(file));
  for (const std::string& one : set) list += fmt::format("set {}\n", fingerprint(one));
  return fingerprint(list);
}

}  // namespace taut::app
