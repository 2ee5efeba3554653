// SPDX-License-Identifier: MIT
#include "surface_files/surface_files.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <map>
#include <span>

namespace dsc3 {

TriangleSurface read_surface(const std::string& path) {
    Assimp::Importer importer;
    const aiScene* const scene =
        importer.ReadFile(path, aiProcess_Triangulate | aiProcess_PreTransformVertices);
    if (scene == nullptr) {
        throw dsc::FileError(importer.GetErrorString(), path);
    }
    TriangleSurface surface;
    surface.name = path;
    std::map<std::array<float, 3>, std::uint32_t> numbers;
    for (const aiMesh* const mesh : std::span(scene->mMeshes, scene->mNumMeshes)) {
        for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces)) {
            if (face.mNumIndices != 3) {
                continue; // a point or a line
            }
            std::array<std::uint32_t, 3> triangle{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const aiVector3D& p = mesh->mVertices[face.mIndices[k]];
                const auto next = static_cast<std::uint32_t>(surface.points.size());
                const auto [place, is_new] = numbers.try_emplace({p.x, p.y, p.z}, next);
                if (is_new) {
                    surface.points.emplace_back(p.x, p.y, p.z);
                }
                triangle[k] = place->second;
            }
            surface.triangles.push_back(triangle);
        }
    }
    if (surface.triangles.empty()) {
        throw dsc::FileError("has no triangles", path);
    }
    return surface;
}

} // namespace dsc3
