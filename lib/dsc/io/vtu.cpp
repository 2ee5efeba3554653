// SPDX-License-Identifier: MIT
#include "dsc/io/vtu.h"

#include "dsc/complex/ranges.h"
#include "dsc/io/part_file.h"

#include <type_traits>
#include <vector>

namespace dsc {

namespace {

// VTK counts without gaps: the living vertices and triangles, numbered in the order of their ids.
template <class Real>
struct Numbers {
    explicit Numbers(const Complex<Real>& complex) : vertex_number(complex.vertex_bound(), no_id) {
        for (const Vertex v : dsc::vertices(complex)) {
            vertex_number[v.id] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(v.id);
        }
        for (const Triangle t : dsc::triangles(complex)) {
            triangles.push_back(t.id);
        }
    }

    std::vector<std::uint32_t> vertex_number;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> triangles;
};

void begin_array(PartFile& file, std::string_view type, std::string_view name,
                 std::string_view more = {}) {
    file << "<DataArray type=\"" << type << "\" Name=\"" << name << "\"" << more
         << " format=\"ascii\">\n";
}

void end_array(PartFile& file) { file << "</DataArray>\n"; }

template <class Real>
void write_points(PartFile& file, const Complex<Real>& complex, const Numbers<Real>& numbers) {
    file << "<Points>\n";
    begin_array(file, std::is_same_v<Real, double> ? "Float64" : "Float32", "Points",
                " NumberOfComponents=\"3\"");
    for (const std::uint32_t v : numbers.vertices) {
        file << complex.vertices[v].x << ' ' << complex.vertices[v].y << " 0\n";
    }
    end_array(file);
    file << "</Points>\n";
}

template <class Real>
void write_cells(PartFile& file, const Complex<Real>& complex, const Numbers<Real>& numbers) {
    file << "<Cells>\n";
    begin_array(file, "Int64", "connectivity");
    for (const std::uint32_t t : numbers.triangles) {
        const auto& v = complex.triangles[t].v;
        file << numbers.vertex_number[v[0]] << ' ' << numbers.vertex_number[v[1]] << ' '
             << numbers.vertex_number[v[2]] << '\n';
    }
    end_array(file);
    begin_array(file, "Int64", "offsets");
    for (std::uint64_t i = 1; i <= numbers.triangles.size(); ++i) {
        file << 3 * i << '\n';
    }
    end_array(file);
    begin_array(file, "UInt8", "types");
    for (std::size_t i = 0; i < numbers.triangles.size(); ++i) {
        file << "5\n"; // VTK_TRIANGLE
    }
    end_array(file);
    file << "</Cells>\n";
}

template <SimplexHandle Simplex>
void write_attributes(PartFile& file, const AttributeSet& attributes,
                      const std::vector<std::uint32_t>& ids) {
    for (const auto& attribute : attributes.list()) {
        const auto* typed = dynamic_cast<const Attribute<double, Simplex>*>(attribute.get());
        if (typed == nullptr) {
            continue;
        }
        begin_array(file, "Float64", escape_xml(typed->name()));
        for (const std::uint32_t id : ids) {
            file << typed->data()[id] << '\n';
        }
        end_array(file);
    }
}

} // namespace

template <class Real>
void write_vtu(const Complex<Real>& complex, const std::string& path) {
    const Numbers<Real> numbers(complex);
    PartFile file(path);
    file << "<?xml version=\"1.0\"?>\n"
         << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << std::uint64_t{numbers.vertices.size()}
         << "\" NumberOfCells=\"" << std::uint64_t{numbers.triangles.size()} << "\">\n";
    file << "<PointData>\n";
    write_attributes<Vertex>(file, complex.attributes, numbers.vertices);
    file << "</PointData>\n<CellData Scalars=\"phase\">\n";
    begin_array(file, "UInt32", "phase");
    for (const std::uint32_t t : numbers.triangles) {
        file << complex.triangles[t].phase << '\n';
    }
    end_array(file);
    write_attributes<Triangle>(file, complex.attributes, numbers.triangles);
    file << "</CellData>\n";
    write_points(file, complex, numbers);
    write_cells(file, complex, numbers);
    file << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    file.commit();
}

void write_pvd(std::span<const PvdEntry> entries, const std::string& path) {
    PartFile file(path);
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
         << "byte_order=\"LittleEndian\">\n<Collection>\n";
    for (const PvdEntry& entry : entries) {
        file << "<DataSet timestep=\"" << entry.time << "\" part=\"0\" file=\""
             << escape_xml(entry.file) << "\"/>\n";
    }
    file << "</Collection>\n</VTKFile>\n";
    file.commit();
}

template void write_vtu(const Complex<double>&, const std::string&);
template void write_vtu(const Complex<float>&, const std::string&);

} // namespace dsc
