// The tables of this instruction set, one for each scheme; compiled once for each.
#include "as_published/passes.hpp"
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

extern const PassTable as_published_table;
const PassTable as_published_table = {PARAPET_STRING(PARAPET_ISA),
                                      pick_near,
                                      reached_rows,
                                      as_published::extrapolate_walls,
                                      as_published::gradient_sums,
                                      as_published::pressure_force,
                                      as_published::viscous_force,
                                      as_published::density_rate,
                                      as_published::viscous_matrix,
                                      viscous_product,
                                      descend,
                                      turn,
                                      as_published::wall_load};

}  // namespace parapet::solver::PARAPET_ISA
