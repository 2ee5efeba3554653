// SPDX-License-Identifier: MIT
// Zalesak's slotted disc (thesis, section 9.6), the usual test of sharp corners and thin slots.
#include "scenes/catalogue/families.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

std::vector<Scene> zalesak_scenes() {
    return {rotation_scene({"zalesak", "Zalesak's slotted disc, one revolution", "9.6"}, 0.01, 628,
                           [](double h) { return std::vector<Outline>{slotted_disc({}, h)}; })};
}

} // namespace dsc::scenes
