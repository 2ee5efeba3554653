// SPDX-License-Identifier: MIT
#include "dsc3/io/vtu.h"

#include "dsc/io/part_file.h"
#include "dsc3/operations/workspace.h"
#include "dsc3/queries/phases.h"

#include <type_traits>

namespace dsc3 {

namespace {

// Cells of one kind, and their vertices, numbered in the order of their ids.
class Grid {
public:
    Grid(const Complex& complex, std::uint32_t size, std::uint8_t type)
        : complex_(complex), size_(size), type_(type), number_(complex.vertex_bound(), -1) {}

    void add_cell(std::span<const std::uint32_t> vertices) {
        for (const std::uint32_t v : vertices) {
            number_[v] = 0;
            cells_.push_back(v);
        }
    }
    // One number a cell.
    template <class Number>
    void add_data(const char* name, const std::vector<Number>& numbers) {
        data_tags_ += tag(name, 1, numbers);
    }

    void write(const std::string& path) {
        std::vector<double> points;
        std::int64_t count = 0;
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            if (number_[v] == 0) {
                number_[v] = count++;
                const Point& p = complex_.at(v);
                points.insert(points.end(), {p.x(), p.y(), p.z()});
            }
        }
        const std::size_t n = cells_.size() / size_;
        std::vector<std::int64_t> ends;
        std::vector<std::int64_t> corners;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            corners.push_back(number_[cells_[i]]);
            if ((i + 1) % size_ == 0) {
                ends.push_back(static_cast<std::int64_t>(i + 1));
            }
        }
        const std::string point_tag = tag("Points", 3, points);
        const std::string cell_tags = tag("connectivity", 1, corners) + tag("offsets", 1, ends) +
                                      tag("types", 1, std::vector<std::uint8_t>(n, type_));
        dsc::PartFile file(path);
        file << "<?xml version=\"1.0\"?>\n"
             << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
             << static_cast<std::uint64_t>(count) << "\" NumberOfCells=\"" << std::uint64_t{n}
             << "\">\n<CellData>\n"
             << data_tags_ << "</CellData>\n<Points>\n"
             << point_tag << "</Points>\n<Cells>\n"
             << cell_tags << "</Cells>\n</Piece>\n</UnstructuredGrid>\n"
             << "<AppendedData encoding=\"raw\">\n_" << bytes_ << "\n</AppendedData>\n</VTKFile>\n";
        file.commit();
    }

private:
    // Appends the numbers to the data, after their size in bytes.
    template <class Number>
    std::string tag(const char* name, int components, const std::vector<Number>& numbers) {
        const std::size_t offset = bytes_.size();
        const std::uint64_t size = numbers.size() * sizeof(Number);
        bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
        bytes_.append(reinterpret_cast<const char*>(numbers.data()), size);
        const char* const family = std::is_floating_point_v<Number> ? "Float"
                                   : std::is_signed_v<Number>       ? "Int"
                                                                    : "UInt";
        return std::string("<DataArray type=\"") + family + std::to_string(8 * sizeof(Number)) +
               "\" Name=\"" + name +
               (components > 1 ? "\" NumberOfComponents=\"" + std::to_string(components) : "") +
               "\" format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
    }

    const Complex& complex_;
    std::uint32_t size_;               ///< vertices of a cell
    std::uint8_t type_;                ///< VTK's number for the kind of cell
    std::vector<std::int64_t> number_; ///< by vertex; -1: no cell has it
    std::vector<std::uint32_t> cells_;
    std::string bytes_;
    std::string data_tags_;
};

} // namespace

void write_vtu(const Complex& complex, const std::string& path) {
    Grid grid(complex, 4, 10); // VTK_TETRA
    std::vector<Phase> phases;
    std::vector<Real> qualities;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t})) {
            grid.add_cell(complex.tets[t].v);
            phases.push_back(complex.phases[t]);
            qualities.push_back(quality_of(complex, t));
        }
    }
    grid.add_data("phase", phases);
    grid.add_data("quality", qualities);
    grid.write(path);
}

void write_interface_vtu(const Complex& complex, const std::string& path) {
    Grid grid(complex, 3, 5); // VTK_TRIANGLE
    std::vector<Phase> inside;
    std::vector<Phase> outside;
    for (const InterfaceFace& face : interface_faces(complex)) {
        grid.add_cell(face.v);
        inside.push_back(face.inside);
        outside.push_back(face.outside);
    }
    grid.add_data("inside", inside);
    grid.add_data("outside", outside);
    grid.write(path);
}

} // namespace dsc3
