// SPDX-License-Identifier: MIT
#include "dsc/io/pictures.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/geometry/triangle.h"
#include "dsc/io/appended_data.h"
#include "dsc/io/part_file.h"

#include <set>
#include <type_traits>

namespace dsc {

namespace {

template <class Number>
std::string vtk_type() {
    const char* const family = std::is_floating_point_v<Number> ? "Float"
                               : std::is_signed_v<Number>       ? "Int"
                                                                : "UInt";
    return family + std::to_string(8 * sizeof(Number));
}

// VTK counts without gaps: the living vertices and triangles, numbered in the order of their ids.
// Tags and data are collected first, since a tag names the place of its data.
template <class Real>
class VtuWriter {
public:
    explicit VtuWriter(const Complex<Real>& complex)
        : complex_(complex), vertices_(ids_of(dsc::vertices(complex))),
          triangles_(ids_of(dsc::triangles(complex))) {}

    void write(PartFile& file, std::span<const VtuArray> more) {
        file << "<?xml version=\"1.0\"?>\n"
             << "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n"
             << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << std::uint64_t{vertices_.size()}
             << "\" NumberOfCells=\"" << std::uint64_t{triangles_.size()} << "\">\n<PointData>\n";
        add_vectors<Real>("position", vertices_, 2, positions());
        add_all<Vertex>(more);
        file << take_tags() << "</PointData>\n<CellData Scalars=\"phase\">\n";
        add("phase", 1, each<Phase>([&](std::uint32_t t) { return complex_.triangles[t].phase; }));
        add("quality", 1, each<Real>([&](std::uint32_t t) {
                const auto [a, b, c] = complex_.positions_of(Triangle{t});
                return quality<Real>(a, b, c);
            }));
        add_all<Triangle>(more);
        file << take_tags() << "</CellData>\n<Points>\n";
        // The same numbers as `position`, which are stored only once.
        file << tag<Real>("Points", 3, 0) << "</Points>\n<Cells>\n";
        add_cells();
        file << take_tags() << "</Cells>\n</Piece>\n</UnstructuredGrid>\n"
             << "<AppendedData encoding=\"base64\">\n_" << data_.text()
             << "\n</AppendedData>\n</VTKFile>\n";
    }

private:
    template <class Number>
    static std::string tag(const std::string& name, int components, std::size_t offset) {
        std::string text = "<DataArray type=\"";
        text += vtk_type<Number>();
        text += "\" Name=\"" + escape_xml(name) + "\"";
        if (components > 1) {
            text += " NumberOfComponents=\"" + std::to_string(components) + "\"";
        }
        return text + " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
    }
    template <class Number>
    void add(const std::string& name, int components, const std::vector<Number>& numbers) {
        tags_ += tag<Number>(name, components, data_.add(numbers));
        names_.insert(name);
    }
    std::string take_tags() {
        names_.clear();
        return std::exchange(tags_, {});
    }

    template <class Number, class Value>
    std::vector<Number> each(Value value) const {
        std::vector<Number> numbers;
        numbers.reserve(triangles_.size());
        for (const std::uint32_t t : triangles_) {
            numbers.push_back(value(t));
        }
        return numbers;
    }
    std::vector<Real> positions() const {
        std::vector<Real> numbers;
        numbers.reserve(2 * std::size_t{complex_.vertex_bound()});
        for (const auto& vertex : complex_.vertices) {
            numbers.insert(numbers.end(), {vertex.x, vertex.y});
        }
        return numbers;
    }

    // The entries of the ids listed; vectors of the plane get a third component.
    template <class Number>
    void add_vectors(const std::string& name, const std::vector<std::uint32_t>& ids,
                     std::size_t components, const std::vector<Number>& by_id) {
        std::vector<Number> numbers;
        numbers.reserve(ids.size() * (components == 2 ? 3 : components));
        for (const std::uint32_t id : ids) {
            for (std::size_t k = 0; k < components; ++k) {
                numbers.push_back(by_id[id * components + k]);
            }
            if (components == 2) {
                numbers.push_back(0);
            }
        }
        add(name, components == 2 ? 3 : 1, numbers);
    }

    template <class Simplex>
    [[nodiscard]] const std::vector<std::uint32_t>& ids() const {
        if constexpr (std::same_as<Simplex, Vertex>) {
            return vertices_;
        } else {
            return triangles_;
        }
    }

    template <class Simplex>
    void add_all(std::span<const VtuArray> more) {
        constexpr SimplexKind kind = kind_of<Simplex>;
        const std::size_t bound =
            kind == SimplexKind::vertex ? complex_.vertex_bound() : complex_.triangle_bound();
        for (const VtuArray& array : more) {
            if (array.kind != kind) {
                continue;
            }
            std::visit(
                [&](const auto& values) {
                    if (array.components < 1 || array.components > 2 ||
                        values.size() != bound * array.components) {
                        refuse(array, values.size(), bound);
                    }
                    add_vectors(array.name, ids<Simplex>(), array.components, values);
                },
                array.values);
        }
        for (const auto& attribute : complex_.attributes.list()) {
            if (attribute->kind() == kind && !names_.contains(attribute->name())) {
                add_one_of<Simplex, double, float, std::int8_t, std::uint8_t, std::int16_t,
                           std::uint16_t, std::int32_t, std::uint32_t, std::int64_t, std::uint64_t,
                           Point<double>, Point<float>>(*attribute);
            }
        }
    }

    template <class Simplex, class... Values>
    void add_one_of(const AttributeBase& attribute) {
        (void)(add_if<Simplex, Values>(attribute) || ...);
    }
    template <class Simplex, class Value>
    bool add_if(const AttributeBase& attribute) {
        const auto* typed = dynamic_cast<const Attribute<Value, Simplex>*>(&attribute);
        if (typed == nullptr) {
            return false;
        }
        if constexpr (std::is_arithmetic_v<Value>) {
            add_vectors(typed->name(), ids<Simplex>(), 1, typed->data());
        } else {
            std::vector<typename Value::Scalar> numbers;
            numbers.reserve(2 * typed->data().size());
            for (const Value& p : typed->data()) {
                numbers.insert(numbers.end(), {p.x(), p.y()});
            }
            add_vectors(typed->name(), ids<Simplex>(), 2, numbers);
        }
        return true;
    }

    void add_cells() {
        std::vector<std::int64_t> number(complex_.vertex_bound(), -1);
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            number[vertices_[i]] = static_cast<std::int64_t>(i);
        }
        std::vector<std::int64_t> corners;
        std::vector<std::int64_t> ends;
        for (const std::uint32_t t : triangles_) {
            for (const std::uint32_t v : complex_.triangles[t].v) {
                corners.push_back(number[v]);
            }
            ends.push_back(static_cast<std::int64_t>(corners.size()));
        }
        add("connectivity", 1, corners);
        add("offsets", 1, ends);
        add("types", 1, std::vector<std::uint8_t>(triangles_.size(), 5)); // VTK_TRIANGLE
    }

    [[noreturn]] static void refuse(const VtuArray& array, std::size_t size, std::size_t bound) {
        throw InputError(
            {.what = "array '" + array.name + "' has a wrong length",
             .where = "write_vtu",
             .value = std::to_string(size) + " numbers of " + std::to_string(array.components) +
                      " components",
             .allowed = "1 or 2 components for each of " + std::to_string(bound) + " ids"});
    }

    const Complex<Real>& complex_;
    std::vector<std::uint32_t> vertices_;
    std::vector<std::uint32_t> triangles_;
    AppendedData data_;
    std::string tags_;
    std::set<std::string> names_; ///< in the present section
};

} // namespace

template <class Real>
void write_vtu(const Complex<Real>& complex, const std::string& path,
               std::span<const VtuArray> more) {
    PartFile file(path);
    VtuWriter<Real>(complex).write(file, more);
    file.commit();
}

template void write_vtu(const Complex<double>&, const std::string&, std::span<const VtuArray>);
template void write_vtu(const Complex<float>&, const std::string&, std::span<const VtuArray>);

} // namespace dsc
