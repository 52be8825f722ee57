#include "program.hpp"

int main(int argc, char** argv) {
  return parapet::cli::run_program(argc, argv);
}
