// The table of this instruction set; compiled once for each.
#include "parapet/flow/pass_table.hpp"
#include "passes.hpp"

#define PARAPET_STRING_OF(x) #x
#define PARAPET_STRING(x) PARAPET_STRING_OF(x)

namespace parapet::solver::PARAPET_ISA {

extern const PassTable table;
const PassTable table = {PARAPET_STRING(PARAPET_ISA),
                         pick_near,
                         reached_rows,
                         extrapolate_walls,
                         gradient_sums,
                         pressure_force,
                         viscous_force,
                         density_rate,
                         viscous_matrix,
                         viscous_product,
                         descend,
                         turn,
                         wall_load};

}  // namespace parapet::solver::PARAPET_ISA
