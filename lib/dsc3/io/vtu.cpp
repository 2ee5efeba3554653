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

    // The attributes of the tets, which are the cells.
    void add_tet_attributes(const std::vector<std::uint32_t>& tets) {
        data_tags_ += attributes<Tet>(tets);
    }

    void write(const std::string& path) {
        std::vector<double> points;
        std::int64_t count = 0;
        std::vector<std::uint32_t> ids;
        for (std::uint32_t v = 0; v < complex_.vertex_bound(); ++v) {
            if (number_[v] == 0) {
                number_[v] = count++;
                ids.push_back(v);
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
        const std::string point_data = attributes<Vertex>(ids);
        const std::string point_tag = tag("Points", 3, points);
        const std::string cell_tags = tag("connectivity", 1, corners) + tag("offsets", 1, ends) +
                                      tag("types", 1, std::vector<std::uint8_t>(n, type_));
        dsc::PartFile file(path);
        file << "<?xml version=\"1.0\"?>\n"
             << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\""
             << static_cast<std::uint64_t>(count) << "\" NumberOfCells=\"" << std::uint64_t{n}
             << "\">\n<PointData>\n"
             << point_data << "</PointData>\n<CellData>\n"
             << data_tags_ << "</CellData>\n<Points>\n"
             << point_tag << "</Points>\n<Cells>\n"
             << cell_tags << "</Cells>\n</Piece>\n</UnstructuredGrid>\n"
             << "<AppendedData encoding=\"raw\">\n_" << bytes_ << "\n</AppendedData>\n</VTKFile>\n";
        file.commit();
    }

private:
    // The attributes whose entries are numbers or points, for simplices by id.
    template <class Simplex>
    std::string attributes(const std::vector<std::uint32_t>& ids) {
        std::string tags;
        for (const auto& one : complex_.attributes.list()) {
            if (data_tags_.find("Name=\"" + dsc::escape_xml(one->name()) + '"') ==
                std::string::npos) {
                tags += tag_of_one<Simplex, double, float, std::int8_t, std::uint8_t, std::int16_t,
                                   std::uint16_t, std::int32_t, std::uint32_t, std::int64_t,
                                   std::uint64_t, Point>(*one, ids);
            }
        }
        return tags;
    }
    template <class Simplex, class... Values>
    std::string tag_of_one(const dsc::AttributeBase& one, const std::vector<std::uint32_t>& ids) {
        std::string text;
        (void)(add_if<Simplex, Values>(one, ids, text) || ...);
        return text;
    }
    template <class Simplex, class Value>
    bool add_if(const dsc::AttributeBase& one, const std::vector<std::uint32_t>& ids,
                std::string& text) {
        const auto* const typed = dynamic_cast<const dsc::Attribute<Value, Simplex>*>(&one);
        if (typed == nullptr) {
            return false;
        }
        const std::string name = dsc::escape_xml(one.name());
        if constexpr (std::is_arithmetic_v<Value>) {
            std::vector<Value> numbers;
            for (const std::uint32_t id : ids) {
                numbers.push_back((*typed)[Simplex{id}]);
            }
            text = tag(name, 1, numbers);
        } else {
            std::vector<Real> numbers;
            for (const std::uint32_t id : ids) {
                const Point& p = (*typed)[Simplex{id}];
                numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
            }
            text = tag(name, 3, numbers);
        }
        return true;
    }

    // Appends the numbers to the data, after their size in bytes.
    template <class Number>
    std::string tag(const std::string& name, int components, const std::vector<Number>& numbers) {
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
    std::vector<std::uint32_t> ids;
    for (std::uint32_t t = 1; t < complex.tet_bound(); ++t) {
        if (complex.is_alive(Tet{t})) {
            grid.add_cell(complex.tets[t].v);
            phases.push_back(complex.phases[t]);
            qualities.push_back(quality_of(complex, t));
            ids.push_back(t);
        }
    }
    grid.add_data("phase", phases);
    grid.add_data("quality", qualities);
    grid.add_tet_attributes(ids);
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
