#include "cli/entry.hpp"
#include "tests/mutation/command.hpp"

int main(int argc, char** argv) {
  return mpmvv::cli::enter(argc, argv, "mutation_campaign",
                           "Plants mistakes in a copy of the sources and says what of the gate catches each",
                           mpmvv::mutation::add_options);
}
