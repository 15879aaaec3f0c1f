#include "taut/io/vtk.hpp"

#include <fmt/format.h>

#include <cmath>

namespace taut::io {
namespace {

using Triples = std::vector<std::array<double, 3>>;

/// The parts of one time as flat arrays.
struct PolyData {
  Triples points, velocity;
  std::vector<double> tension, radius;
  std::vector<std::size_t> vertex_points;
  std::vector<std::vector<std::size_t>> lines;
  std::vector<std::size_t> part;  ///< by cell: vertices first, as VTK has them
};

double finite(double x) { return std::isfinite(x) ? x : 0; }

void add_point(PolyData& data, const std::array<double, 3>& at, double tension, double radius,
               const std::array<double, 3>& velocity) {
  data.points.push_back(at);
  data.tension.push_back(finite(tension));
  data.radius.push_back(radius);
  data.velocity.push_back(velocity);
}

PolyData poly_data(const Scene& scene, std::size_t frame) {
  PolyData data;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const ScenePoint& p = scene.points[i];
    data.vertex_points.push_back(data.points.size());
    data.part.push_back(scene.lines.size() + i);
    add_point(data, p.at[frame], 0, p.radius, p.velocity.empty() ? std::array<double, 3>{} : p.velocity[frame]);
  }
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    const SceneLine& line = scene.lines[i];
    const Triples& points = line.points[frame];
    if (points.size() < 2) continue;
    std::vector<std::size_t> chain;
    for (std::size_t k = 0; k < points.size(); ++k) {
      chain.push_back(data.points.size());
      add_point(data, points[k], line.tension.empty() ? 0 : line.tension[frame][k], 0, {});
    }
    data.lines.push_back(std::move(chain));
    data.part.push_back(i);
  }
  return data;
}

std::string triples_text(const Triples& all) {
  std::string text;
  for (const auto& v : all) text += fmt::format("{} {} {}\n", finite(v[0]), finite(v[1]), finite(v[2]));
  return text;
}

std::string array_text(const char* name, const char* type, int components, const std::string& numbers) {
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n{}</DataArray>\n",
                     type, name, components, numbers);
}

std::string cells_text(const char* what, const std::vector<std::vector<std::size_t>>& cells) {
  std::string connectivity, offsets;
  std::size_t offset = 0;
  for (const auto& cell : cells) {
    connectivity += fmt::format("{}\n", fmt::join(cell, " "));
    offsets += fmt::format("{}\n", offset += cell.size());
  }
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", what, array_text("connectivity", "Int64", 1, connectivity),
                     array_text("offsets", "Int64", 1, offsets));
}

std::string vtp_text(const Scene& scene, std::size_t frame) {
  const PolyData data = poly_data(scene, frame);
  std::vector<std::vector<std::size_t>> vertices;
  vertices.reserve(data.vertex_points.size());
  for (const std::size_t p : data.vertex_points) vertices.push_back({p});
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\">\n", data.points.size(),
                      vertices.size(), data.lines.size());
  text += fmt::format("<PointData Scalars=\"tension\">\n{}{}{}</PointData>\n",
                      array_text("tension", "Float64", 1, fmt::format("{}\n", fmt::join(data.tension, "\n"))),
                      array_text("radius", "Float64", 1, fmt::format("{}\n", fmt::join(data.radius, "\n"))),
                      array_text("velocity", "Float64", 3, triples_text(data.velocity)));
  text += fmt::format("<CellData>\n{}</CellData>\n",
                      array_text("part", "Int64", 1, fmt::format("{}\n", fmt::join(data.part, "\n"))));
  text += fmt::format("<Points>\n{}</Points>\n", array_text("Points", "Float64", 3, triples_text(data.points)));
  text += cells_text("Verts", vertices) + cells_text("Lines", data.lines);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

std::vector<std::pair<std::string, std::string>> to_vtk(const Scene& scene) {
  std::vector<std::pair<std::string, std::string>> files;
  std::string index =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (std::size_t i = 0; i < scene.t.size(); ++i) {
    const std::string name = fmt::format("{}_{:04}.vtp", scene.name, i);
    index += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", scene.t[i], name);
    files.emplace_back(name, vtp_text(scene, i));
  }
  files.emplace_back(scene.name + ".pvd", index + "</Collection>\n</VTKFile>\n");
  return files;
}

}  // namespace taut::io
