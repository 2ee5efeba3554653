// SPDX-License-Identifier: MIT
// dsc_scene under mpirun: its processes share the work of a run. A program of its own, as MPI's
// libraries would take longer to load than dsc_scene takes to begin.
#include "mpi/session.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/scene_program.h"

int main(int argc, char** argv) {
    dsc::MpiSession session(argc, argv);
    dsc::Ranks ranks(session.transport());
    return dsc::scenes::scene_program("dsc_scene", dsc::scenes::catalogue(), argc, argv, &ranks);
}
