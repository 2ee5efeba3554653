// SPDX-License-Identifier: MIT
#include "dsc3/io/surface.h"

#include "dsc/io/part_file.h"
#include "dsc3/geometry/tet.h"
#include "dsc3/queries/phases.h"

namespace dsc3 {

namespace {

template <class Value>
void append(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace

void write_ply(const Complex& complex, const std::string& path) {
    std::vector<std::int32_t> numbers(complex.vertex_bound(), -1);
    std::string points;
    std::string faces;
    std::uint32_t point_count = 0;
    std::uint32_t face_count = 0;
    for (const InterfaceFace& face : interface_faces(complex)) {
        append(faces, std::uint8_t{3});
        for (const std::uint32_t v : face.v) {
            if (numbers[v] < 0) {
                numbers[v] = static_cast<std::int32_t>(point_count++);
                for (int axis = 0; axis < 3; ++axis) {
                    append(points, complex.at(v)[axis]);
                }
            }
            append(faces, numbers[v]);
        }
        ++face_count;
    }
    dsc::PartFile file(path);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << point_count
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << face_count
         << "\nproperty list uchar int vertex_indices\nend_header\n"
         << points << faces;
    file.commit();
}

void write_stl(const Complex& complex, const std::string& path) {
    const std::vector<InterfaceFace> faces = interface_faces(complex);
    std::string bytes(80, ' '); // the header, which readers ignore
    append(bytes, static_cast<std::uint32_t>(faces.size()));
    const auto append_vector = [&](const Point& p) {
        for (int axis = 0; axis < 3; ++axis) {
            append(bytes, static_cast<float>(p[axis]));
        }
    };
    for (const InterfaceFace& face : faces) {
        const auto& [a, b, c] = face.v;
        append_vector(unit((complex.at(b) - complex.at(a)).cross(complex.at(c) - complex.at(a))));
        for (const std::uint32_t v : face.v) {
            append_vector(complex.at(v));
        }
        append(bytes, std::uint16_t{0}); // no attributes
    }
    dsc::PartFile file(path);
    file << bytes;
    file.commit();
}

} // namespace dsc3
