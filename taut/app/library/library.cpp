#include "taut/app/library/library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/forestry/carriage.hpp"
#include "taut/catalogue/forestry/yarder.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/io/deck/source.hpp"
#include "taut/io/file.hpp"

namespace taut::app {
namespace {

/// The rows of the file that the deck names at `path`, else the built-in ones; none with mistakes.
template <class Row>
std::optional<std::vector<Row>> rows_of_library(
    const io::Node& input, const std::string& path, const std::optional<std::string>& file_name,
    const std::vector<Row>& built_in,
    tl::expected<std::vector<Row>, Diagnostics> (*read)(std::string_view csv, std::string file),
    Diagnostics& mistakes) {
  if (!file_name) return built_in;
  const io::Node& node = *io::follow(input, path + ".catalogue").node;
  const auto file = io::read_named(node, *file_name, mistakes);
  if (!file) return std::nullopt;
  if (file->text.size() > io::largest_deck) {
    io::add(mistakes, node.spot, fmt::format("'{}' has more than {} MB", file->path, io::largest_deck >> 20U));
    return std::nullopt;
  }
  auto rows = read(file->text, file->path);
  if (rows) return std::move(*rows);
  for (Diagnostic& d : rows.error()) io::add(mistakes, io::without_text(std::move(d), file->text));
  return std::nullopt;
}

/// Takes one figure of a row where the deck has no such key, and notes it in words.
class CarriageFigures {
 public:
  CarriageFigures(const io::Node& input, std::string path) : input_(input), path_(std::move(path)) {}

  bool takes(const char* key, const std::string& words) {
    if (io::follow(input_, path_ + "." + key).all) {
      own_.emplace_back(key);
      return false;
    }
    taken_.push_back(words);
    return true;
  }

  std::string words(const machine::description::Carriage& car, const catalogue::CarriageRow& row) const {
    std::string text = fmt::format("{}: {} of '{}' in the catalogue ({}: {})", car.name, fmt::join(taken_, ", "),
                                   row.name, catalogue::to_text(row.trust), row.trust_text);
    if (taken_.empty()) text = fmt::format("{}: nothing is taken of '{}' in the catalogue", car.name, row.name);
    if (!own_.empty()) text += fmt::format("; the deck's own: {}", fmt::join(own_, ", "));
    return text;
  }

 private:
  const io::Node& input_;
  std::string path_;
  std::vector<std::string> taken_, own_;
};

void take_row(const io::Node& input, const std::string& path, const catalogue::CarriageRow& row,
              machine::description::Carriage& car) {
  CarriageFigures figures(input, path);
  if (figures.takes("mass", fmt::format("mass {:.4g} kg", row.mass))) car.mass = row.mass;
  if (figures.takes("rated_payload", fmt::format("rated payload {:.4g} kg", row.payload))) {
    car.rated_payload = row.payload;
    car.rating_trust = catalogue::trust_words(row);
  }
  const bool knows_rope = row.rope_least && row.rope_most;
  if (knows_rope && figures.takes("rope_diameters", fmt::format("ropes of {:.3g} to {:.3g} mm", *row.rope_least * 1e3,
                                                                *row.rope_most * 1e3))) {
    car.rope_diameters = {*row.rope_least, *row.rope_most};
  }
  // rollers and wheelbase belong together
  const bool own_rollers = io::follow(input, path + ".rollers").all || io::follow(input, path + ".wheelbase").all;
  if (!row.rollers || own_rollers) {
    car.from_library = figures.words(car, row);
    return;
  }
  figures.takes("rollers", fmt::format("{} rollers", *row.rollers));
  car.rollers = *row.rollers;
  if (row.wheelbase && figures.takes("wheelbase", fmt::format("wheelbase {:.3g} m", *row.wheelbase)))
    car.wheelbase = row.wheelbase;
  car.from_library = figures.words(car, row);
}

void take_carriage(const io::Node& input, machine::description::Carriage& car, Diagnostics& mistakes) {
  const std::string path = fmt::format("machine.carriages.{}", car.name);
  if (!car.library) {
    if (car.catalogue) {
      io::add(mistakes, io::follow(input, path + ".catalogue").node->spot,
              "says a file of carriages; 'carriage' says which one it is");
    }
    return;
  }
  const auto rows =
      rows_of_library(input, path, car.catalogue, catalogue::carriages(), catalogue::read_carriages, mistakes);
  if (!rows) return;
  const auto row = catalogue::find_carriage(*car.library, *rows);
  if (row) return take_row(input, path, *row, car);
  io::add(mistakes, io::follow(input, path + ".carriage").node->spot,
          catalogue::to_text(row.error()) + "; 'taut list carriages' shows the built-in ones");
}

void take_yarder(const io::Node& input, checks::YarderCheckRequest& request, Diagnostics& mistakes) {
  const std::string path = fmt::format("checks.yarders.{}", request.name);
  const auto rows =
      rows_of_library(input, path, request.catalogue, catalogue::yarders(), catalogue::read_yarders, mistakes);
  if (!rows) return;
  const auto row = catalogue::find_yarder(request.yarder, *rows);
  if (row) {
    request.row = *row;
    return;
  }
  io::add(mistakes, io::follow(input, path + ".yarder").node->spot,
          catalogue::to_text(row.error()) + "; 'taut list yarders' shows the built-in ones");
}

}  // namespace

void take_from_library(const io::Node& input, MachineDeck& deck, Diagnostics& mistakes) {
  for (auto& car : deck.machine.carriages) take_carriage(input, car, mistakes);
  if (!deck.checks) return;
  for (auto& yarder : deck.checks->yarders) take_yarder(input, yarder, mistakes);
}

}  // namespace taut::app
