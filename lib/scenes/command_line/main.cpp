// SPDX-License-Identifier: MIT
// dsc_scene: the scenes of the catalogue on the command line.
#include "scenes/catalogue/catalogue.h"
#include "scenes/command_line/scene_program.h"

#if defined(DSC_HAS_MPI)
#include "mpi/session.h"
#endif

int main(int argc, char** argv) {
#if defined(DSC_HAS_MPI)
    if (dsc::is_started_by_mpi()) {
        dsc::MpiSession session(argc, argv);
        dsc::Ranks ranks(session.transport());
        return dsc::scenes::scene_program("dsc_scene", dsc::scenes::catalogue(), argc, argv,
                                          &ranks);
    }
#endif
    return dsc::scenes::scene_program("dsc_scene", dsc::scenes::catalogue(), argc, argv);
}
