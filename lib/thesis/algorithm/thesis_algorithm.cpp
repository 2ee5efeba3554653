// SPDX-License-Identifier: MIT
#include "thesis/algorithm/thesis_algorithm.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/operations/edge_flip.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "thesis/operations/local_retriangulation.h"
#include "thesis/operations/loop_subdivision.h"
#include "thesis/operations/smoothing.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

// The triangles, edges or vertices of the stars of the active set that the submesh owns, once each,
// by id.
template <class Simplex, class Real>
std::vector<Simplex> active_simplices(Work<Real>& work) {
    std::vector<Simplex> found;
    const Complex<Real>& complex = work.complex;
    for (const std::uint32_t v : work.active) {
        if (!complex.is_alive(Vertex{v}) || !gather(complex, work.submesh.region, v, work.star) ||
            !work.star.owned) {
            continue;
        }
        if constexpr (std::is_same_v<Simplex, Vertex>) {
            found.push_back(Vertex{v});
        } else {
            for (std::uint32_t i = 0; i < work.star.size; ++i) {
                if constexpr (std::is_same_v<Simplex, Edge>) {
                    found.push_back(complex.edge(prev(work.star.corner[i])));
                } else {
                    found.push_back(Triangle{triangle_of(work.star.corner[i])});
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

template <class Real>
void activate_triangle(Work<Real>& work, Triangle triangle) {
    for (const Vertex v : work.complex.vertices_of(triangle)) {
        work.activate(v.id);
    }
}

template <class Real>
void smooth_interface(Work<Real>& work) {
    const InterfaceSmoothingOptions options{.feature_degrees =
                                                work.options.interface.feature_degrees};
    for (const std::uint32_t v : work.interface) {
        if (work.complex.is_alive(Vertex{v}) &&
            interface_smoothing(work.submesh, Vertex{v}, options) == Verdict::legal) {
            work.activate(v);
        }
    }
}

} // namespace

template <class Real, class Simplex>
Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Simplex> line) {
    std::string name = line.name;
    return {std::move(name), [line = std::move(line)](Work<Real>& work) {
                const std::vector<Simplex> candidates = active_simplices<Simplex>(work);
                Selection<Simplex> selection(
                    candidates, [&](Simplex s) { return line.quality(work.complex, s); },
                    line.select);
                while (selection.has_next()) {
                    const Simplex simplex = selection.get_next();
                    if (work.complex.is_alive(simplex)) {
                        line.operation(work, simplex);
                    }
                }
            }};
}

template <class Real>
Algorithm<Real> thesis_algorithm(const Options<Real>& options, const ThesisThresholds& thresholds) {
    const double h = static_cast<double>(options.edge_length);
    const double unit = std::sqrt(3.0) / 4 * h * h;
    const auto triangle_area = [](const Complex<Real>& K, Triangle t) {
        return static_cast<double>(area(K, t));
    };

    Algorithm<Real> algorithm = default_algorithm<Real>();
    if (thresholds.smooth_interface) {
        algorithm.remeshing.push_back({"interface smoothing", &smooth_interface<Real>, true});
    }
    const Pass<Real> last = algorithm.motion.back();
    algorithm.motion.pop_back();
    algorithm.motion.push_back(mesh_update_pass<Real, Triangle>(
        {.name = "coarsening: local retriangulation",
         .quality = triangle_area,
         .select = below<Triangle>(thresholds.small_area * unit),
         .operation = [](Work<Real>& work, Triangle t) {
             const auto corners = work.complex.vertices_of(t);
             const Verdict verdict =
                 local_retriangulation(work.submesh, t, RetriangulationMethod::delaunay).verdict;
             if (verdict == Verdict::legal) {
                 for (const Vertex v : corners) {
                     if (work.complex.is_alive(v)) {
                         work.activate(v.id);
                     }
                 }
             }
             return verdict;
         }}));
    algorithm.motion.push_back(mesh_update_pass<Real, Triangle>(
        {.name = "refinement: loop subdivision",
         .quality = [triangle_area](const Complex<Real>& K,
                                    Triangle t) { return -triangle_area(K, t); },
         .select = below<Triangle>(-thresholds.large_area * unit),
         .operation =
             [](Work<Real>& work, Triangle t) {
                 const Verdict verdict = loop_subdivision(work.submesh, t).verdict;
                 if (verdict == Verdict::legal) {
                     activate_triangle(work, t);
                 }
                 return verdict;
             }}));
    algorithm.motion.push_back(mesh_update_pass<Real, Edge>(
        {.name = "optimization: edge flip",
         .quality =
             [](const Complex<Real>& K, Edge e) {
                 const bool flat = is_border(K.twin(e.id)) || is_delaunay(K, e.id);
                 return flat ? 1.0 : 0.0;
             },
         .select = below<Edge>(0.5),
         .operation =
             [](Work<Real>& work, Edge e) {
                 // An earlier flip may have repaired the edge.
                 if (is_border(work.complex.twin(e.id)) || is_delaunay(work.complex, e.id)) {
                     return Verdict::no_gain;
                 }
                 return edge_flip(work.submesh, e);
             }}));
    algorithm.motion.push_back(mesh_update_pass<Real, Vertex>(
        {.name = "smoothing: Laplacian",
         .quality =
             [](const Complex<Real>& K, Vertex v) {
                 Star<Real> star;
                 if (!gather(K, Region{}, v.id, star)) {
                     return 1.0;
                 }
                 const auto squared =
                     static_cast<double>(worst_quality_squared(star, star.x0, star.y0));
                 return std::sqrt(std::max(squared, 0.0));
             },
         .select = below<Vertex>(thresholds.smooth_quality),
         .operation = [](Work<Real>& work,
                         Vertex v) { return laplacian_smoothing(work.submesh, v); }}));
    algorithm.motion.push_back(last);
    return algorithm;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Vertex>);                            \
    template Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Edge>);                              \
    template Pass<Real> mesh_update_pass(MeshUpdateLine<Real, Triangle>);                          \
    template Algorithm<Real> thesis_algorithm(const Options<Real>&, const ThesisThresholds&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
