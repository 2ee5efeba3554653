// SPDX-License-Identifier: MIT
// dsc_scene: the scenes of the catalogue on the command line.
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/scene_program.h"

int main(int argc, char** argv) {
    return dsc::scenes::scene_program("dsc_scene", dsc::scenes::catalogue(), argc, argv);
}
