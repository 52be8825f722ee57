/// Who may be near whom: particles sorted by cell, and lists where bodies and walls are, reused
/// while no pair can have come closer than the skin allows. StepRows picks from them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "parapet/flow/fluid.hpp"
#include "parapet/flow/geometry.hpp"
#include "parapet/flow/pass_table.hpp"
#include "parapet/flow/wall_cells.hpp"
#include "parapet/flow/wall_layout.hpp"

namespace parapet::solver {

/// Who is near whom. A flow keeps its own; on their own they serve to study the neighbour search.
class NeighborRows {
 public:
  /// Solids and walls are kept by reference.
  /// @param reach kernel support 2h [m]
  /// @param skin extra reach of the rows [m]
  /// @param spacing dx [m]: so near a corner of a body the fluid sees around it; 0: never
  /// @param periodic_length along x from 0 [m]; 0 when not periodic
  /// @param passes the instruction set; nullptr: the fastest
  NeighborRows(const Solids& solids, const WallPoints& walls, double reach, double skin,
               double spacing, double periodic_length, const PassTable* passes = nullptr);

  /// True when a pair outside the rows may have come within the reach.
  bool outdated(const Fluid& fluid) const;
  /// Sorts the fluid by cell and builds the rows anew.
  void build(Fluid& fluid, int threads);
  /// The rows are outdated from now on.
  void invalidate() { valid_ = false; }
  bool valid() const { return valid_; }  ///< they have been built since then
  /// Where the particles stood at the last build, in their present order [n] [m].
  const std::vector<double>& built_x() const { return built_x_; }
  const std::vector<double>& built_z() const { return built_z_; }  ///< likewise

  NearView view() const;  ///< valid until the next build
  /// The rows of the wall points, with all that the skin holds; those of the particles are not set.
  RowView wall_point_rows() const;
  /// Where the rows of each block of particles may start, so that all have room [n_blocks + 1].
  const std::vector<std::int32_t>& block_first() const { return block_first_; }
  /// Room for what one row is picked from, and a vector more.
  std::int32_t room() const { return room_; }
  bool touches_wall(int i) const;  ///< particle i has wall points in its list
  /// True only when no face can lie between two places where particle i has been since the build.
  bool clear_of_faces(int i, Vec2 before, Vec2 after) const;
  /// Faces near a place: a superset of those within reach + skin.
  const std::vector<int>& faces_near(Vec2 p) const { return wall_cells_.faces_near(p); }

 private:
  struct Grid {  // uniform cells, numbered column by column
    double x0 = 0.0, z0 = 0.0, cell_x = 1.0, cell_z = 1.0;
    std::int64_t nx = 1, nz = 1;
    std::int64_t column(double x) const;
    std::int64_t row(double z) const;
    std::int64_t cell(std::int64_t ix, std::int64_t iz) const { return ix * nz + iz; }
  };
  struct CellRange {  // [begin, end)
    std::int32_t begin = 0, end = 0;
  };
  struct Cell {  // one that holds particles
    std::int64_t number = 0;
    std::int32_t begin = 0, end = 0;  // its particles
    bool near_wall = false;
    std::array<CellRange, 3> near = {};   // particles beside it: of the columns before, own, after
    std::array<CellRange, 3> later = {};  // cells up to two away: itself and later ones
  };
  struct Motion {  // the box that holds the displacements of a cell's particles
    double x_min, x_max, z_min, z_max;
  };
  struct RowBuffer {  // one block's lists before they are joined
    std::vector<std::int32_t> index, fluid_count, wall_count;  // counts by group, in indices
    std::array<std::vector<std::int32_t>, lanes> fluid, wall;  // of the present group's particles
    std::array<std::vector<int>, lanes> faces;                 // in their reach
    std::vector<std::uint8_t> listed;                          // by group
  };

  std::int32_t wall_ghost() const { return static_cast<std::int32_t>(walls_.size()); }
  bool walls_may_be_reached(Vec2 p) const { return wall_cells_.may_be_reached_from(p); }
  void place_grid(const Fluid& fluid);
  void sort_by_cell(std::int64_t cells);
  void link_cells();
  void link_layers();
  void reserve_rows(int n);
  bool bodies_among(const std::vector<int>& faces) const;
  CellRange cells_of_column(std::int64_t ix, std::int64_t z_from, std::int64_t z_to,
                            int& hint) const;
  void sort(Fluid& fluid);
  double find_faces_in_reach(Vec2 p, std::vector<int>& in_reach) const;
  void fill_block(const Fluid& fluid, int begin, int end, RowBuffer& buffer);
  void add_fluid_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                           std::vector<std::int32_t>& out) const;
  void add_wall_neighbors(const Fluid& fluid, int i, const std::vector<int>& faces,
                          std::vector<std::int32_t>& out) const;
  void join(const RowBuffer& buffer);
  void transpose_wall_rows(int n);

  const Solids& solids_;
  const WallPoints& walls_;
  const PassTable& passes_;
  double reach_, skin_, spacing_, periodic_length_;
  bool valid_ = false;

  WallCells wall_cells_;

  Grid grid_;                                       // over the fluid, renewed at each build
  std::vector<Cell> cells_;                         // ascending numbers
  std::vector<std::int64_t> number_of_;             // of a particle's layer, before the sorting
  std::vector<std::int32_t> order_, sorted_order_;  // old particle of a new one
  std::vector<std::int32_t> cell_of_;               // [n] index into cells_
  std::vector<NearRanges> ranges_;                  // of the layers of cells that hold particles
  std::vector<std::int32_t> layer_of_;              // [n] index into ranges_
  std::vector<std::uint8_t> listed_;                // [n_groups]
  std::vector<double> clearance_;  // [n] distance of the nearest face, at most the reach [m]
  std::vector<double> built_x_, built_z_;  // positions at the build

  std::vector<std::int32_t> begin_, wall_begin_, end_, index_;
  std::vector<std::int32_t> block_first_;
  std::int32_t room_ = 0;
  std::vector<std::int32_t> point_begin_, point_index_, active_, point_count_;
  int n_active_ = 0;
  std::vector<RowBuffer> buffers_;
  mutable std::vector<Motion> motion_;  // [cells] scratch of outdated()
};

}  // namespace parapet::solver
