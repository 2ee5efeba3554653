// SPDX-License-Identifier: MIT
// dsc_scene: the scenes of the catalogue on the command line.
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/launched.h"
#include "scenes/command_line/scene_program.h"

int main(int argc, char** argv) {
    if (dsc::scenes::is_launched()) {
        dsc::scenes::become("dsc_scene_mpi", argv); // returns if there is none
        if (!dsc::scenes::is_alone("dsc_scene")) {
            return 2;
        }
    }
    return dsc::scenes::scene_program("dsc_scene", dsc::scenes::catalogue(), argc, argv);
}
