#include <dsc/dsc3/dsc3.h>
#include <dsc/surface_files/surface_files.h>

#include <iostream>

int main(int argc, char** argv) {
    std::string path = argc > 1 ? argv[1] : "ball.stl";
    if (argc == 1) { // a surface to be read
        const auto ball = dsc3::ball({0.5, 0.5, 0.5}, 0.3);
        dsc3::write_stl(dsc3::initial_complex({}, {{ball, 1}}, {.edge_length = 0.08}), path);
    }
    const dsc3::TriangleSurface surface = dsc3::read_surface(path);
    const dsc3::Distance shape =
        dsc3::closed_surface(surface); // refuses one with holes or crossings
    const auto complex = dsc3::initial_complex({}, {{shape, 1}}, {.edge_length = 0.05});
    std::cout << surface.triangles.size() << " triangles, " << complex.tet_count()
              << " tets, volume " << dsc3::phase_volume(complex, 1) << '\n';
    return dsc3::validate(complex).ok() ? 0 : 1;
}
